//! Several collapse states: a range over what nobody knows of a real wall.
//!
//! What a perpend carries before the push depends on how tightly it was closed, so with head joints
//! in contact the collapse load is not unique: the scene and its mirror image, whose contacts are solved
//! in another order, may meet different states. Nor is it unique where levels of an open scene disagree;
//! there direction, contact stiffness and substep are varied.

mod head_joints;
mod joined;
mod states;

use super::parameters::Asked;
use super::portion::Portion;
use crate::answer::PushoverFact;
use crate::scene::Scene;

/// A portion and its mirror image, whose pushovers are varied.
pub struct Varied<'a> {
    scene: &'a Scene,
    mirror: Scene,
    portion: &'a Portion,
    asked: Asked<'a>,
}

impl<'a> Varied<'a> {
    /// A portion of a scene, and of its mirror image.
    ///
    /// # Errors
    /// The scene has no mirror image.
    pub fn new(
        scene: &'a Scene,
        portion: &'a Portion,
        asked: Asked<'a>,
    ) -> Result<Self, PushoverFact> {
        let mirror = scene.mirrored().map_err(|_| PushoverFact::NoMirror)?;
        Ok(Self {
            scene,
            mirror,
            portion,
            asked,
        })
    }

    /// The scene, or its mirror image.
    fn of(&self, mirrored: bool) -> &Scene {
        if mirrored { &self.mirror } else { self.scene }
    }

    /// λ for a λ* of 1 in this portion: what a difference of multipliers is measured by.
    fn unit(&self) -> f64 {
        self.portion.multiplier_unit(self.scene)
    }
}
