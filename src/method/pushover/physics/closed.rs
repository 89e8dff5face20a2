//! Joints that open while the scene settles are closed again.
//!
//! Beds are springs, and courses that settle on them part the units between: by a hundred thousandth of a
//! course, but all along their joint, which so carries nothing until the units have leant together. The
//! scene as laid, of which limit analysis speaks, has it closed from the start.

use super::Physics;
use crate::method::pushover::faces::DEPTH;
use rapier2d::math::{Pose, Rotation, Vector as Vec2};
use rapier2d::prelude::{Collider, ColliderHandle};

/// Course heights that rounding may part faces by.
const ROUNDING: f64 = 1e-9;

impl Physics<'_> {
    /// Brings faces together again that have come apart all along their joint, as those of head joints do
    /// while courses settle. None of them carries, so that a scene at rest stays so. Says how many there were.
    pub fn close_joints(&mut self) -> usize {
        let faces = self.world.colliders.iter();
        let mut faces: Vec<(u128, ColliderHandle)> = faces
            .map(|(handle, face)| (face.user_data, handle))
            .collect();
        faces.sort_unstable_by_key(|&(id, _)| id);
        let mut count = 0;
        // Every joint has two, one after the other.
        for pair in faces.chunks_exact(2) {
            let closed = closed([0, 1].map(|of| &self.world.colliders[pair[of].1]));
            let Some((which, place)) = closed else {
                continue;
            };
            if let Some(face) = self.world.colliders.get_mut(pair[which].1) {
                face.set_position_wrt_parent(place);
                count += 1;
            }
        }
        count
    }
}

/// Where on its body one of two faces, the first or the second, has to lie to touch the other, if
/// nothing of either does.
fn closed(faces: [&Collider; 2]) -> Option<(usize, Pose)> {
    let [one, other] = faces.map(|face| *face.position());
    let between = one.inv_mul(&other);
    let [long, reach] =
        faces.map(|face| face.shape().as_cuboid().map_or(0.0, |of| of.half_extents.x));
    let Vec2 { x, y } = between.translation;
    let (slope, side) = (between.rotation.angle(), y.signum());
    let gap = |at: f64| side * (y + (at - x) * slope) - DEPTH;
    // Faces overlap on their joint only.
    let ends = [(-long).max(x - reach), long.min(x + reach)];
    if ends.into_iter().any(|end| gap(end) <= ROUNDING) {
        return None;
    }
    let touching = Pose::from_parts(Vec2::new(x, side * DEPTH), Rotation::IDENTITY);
    let (which, place) = match faces[1].parent() {
        Some(_) => (1, one * touching),
        None => (0, other * touching.inverse()),
    };
    // The body's place is its face's, less the face's place on it.
    let body = *faces[which].position() * faces[which].position_wrt_parent()?.inverse();
    Some((which, body.inv_mul(&place)))
}

#[cfg(test)]
mod tests {
    use crate::method::PushoverSettings;
    use crate::method::pushover::hold::{Held, Hold};
    use crate::method::pushover::measure;
    use crate::method::pushover::model::Model;
    use crate::method::pushover::parameters::{Asked, Parameters};
    use crate::method::pushover::physics::Physics;
    use crate::method::pushover::portion::Portion;
    use crate::scene::{HeadJoints, Wall};

    /// Courses that settle open the head joints between their units; once closed, they stay closed.
    #[test]
    fn head_joints_that_opened_are_closed_once() {
        let wall = Wall::laid([4.0, 1.75], 0.65, &["h11h", "111", "h11h"]);
        let scene = wall.scene(HeadJoints::Contact).unwrap();
        let settings = PushoverSettings::default();
        let asked = Asked::new(&settings);
        let whole = Portion::default();
        let model = Model::new(&scene, &whole, &asked.tuned).unwrap();
        let parameters = Parameters::new(&model, &asked);
        let mut physics = Physics::new(&model, &parameters);
        let settle = |physics: &mut Physics| {
            let held = Hold::new(&model, &parameters).settle(physics, 0.0);
            assert_eq!(held, Held::Rest);
            physics.states()
        };
        let before = settle(&mut physics);
        assert!(physics.close_joints() > 0);
        let after = settle(&mut physics);
        assert_eq!(physics.close_joints(), 0);
        assert!(measure::displacement(&model, &before, &after) < 1e-6);
    }
}
