//! Several collapse states: a range over what nobody knows of a real wall.
//!
//! What a perpend carries before the push depends on how tightly it was closed, so with head joints
//! in contact the collapse load is not unique; nor is it where levels disagree. Direction, contact
//! stiffness and substep stand for that here.

mod head_joints;
mod joined;
mod states;

use super::parameters::{Asked, Parameters, SLIDE};
use super::portion::Portion;
use super::run::Trial;
use crate::answer::{Bracket, Outcome, PushoverFact, Variation};
use crate::scene::Scene;
use joined::Runs;

/// Contact stiffnesses, as multiples of what the substep allows.
const STIFFNESSES: [f64; 3] = [1.0, 0.5, SOFTEST];

const SOFTEST: f64 = 0.25;

/// A portion and its mirror image, whose pushovers are varied.
pub struct Varied<'a> {
    scene: &'a Scene,
    mirror: Scene,
    portion: &'a Portion,
    asked: Asked<'a>,
}

/// The conditions of one pushover of a range.
#[derive(Clone, Copy, Debug)]
struct Conditions {
    /// Contact stiffness, as a multiple of what the substep allows.
    stiffness: f64,
    /// Whether the mirror image is pushed.
    mirrored: bool,
    /// Times that the substep is halved.
    halvings: u32,
    /// What ends it.
    end: End,
    /// Where another pushover saw the collapse.
    expected: Option<Bracket>,
}

/// What a pushover of a range counts as the end.
#[derive(Clone, Copy, Debug)]
enum End {
    /// Collapse, of the scene as laid: one that drifts away has no answer.
    Collapse,
    /// Collapse, wherever the scene has slid until then.
    CollapseAnywhere,
    /// A block has left the place where it was laid.
    LeftPlace,
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

    /// λ for a λ* of 1 in this portion: what a difference of multipliers is measured by.
    fn unit(&self) -> f64 {
        self.portion.multiplier_unit(self.scene)
    }

    /// One pushover. Its variation names the stiffness in the measure of a level that is halved
    /// `level` times.
    fn run(&self, conditions: Conditions, level: u32) -> (Variation, Outcome) {
        let scene = match conditions.mirrored {
            true => &self.mirror,
            false => self.scene,
        };
        let trial = Trial {
            expected: conditions.expected,
            ..Trial::new(scene, self.portion, self.asked)
        };
        let outcome = trial.run(&|own| {
            let own = own.halved(conditions.halvings);
            let own = Parameters {
                // Stiffness goes with the square of the frequency.
                contact_frequency: own.contact_frequency * conditions.stiffness.sqrt(),
                ..own
            };
            match conditions.end {
                End::Collapse => own,
                End::CollapseAnywhere => Parameters {
                    drift: f64::INFINITY,
                    ..own
                },
                End::LeftPlace => Parameters {
                    slide: SLIDE,
                    ..own
                },
            }
        });
        // Contacts stiffen with the square of the substep.
        let times = 4f64.powi(conditions.halvings.saturating_sub(level) as i32);
        let variation = Variation {
            stiffness: conditions.stiffness * times,
            mirrored: conditions.mirrored,
        };
        (variation, outcome)
    }

    /// The pushovers that gave the ends of a range, with half the substep: what that moves them by is
    /// the error of the range.
    fn finer(&self, variants: &[Conditions], runs: &Runs, level: u32) -> Runs {
        let bracket = |index: &usize| runs[*index].1.bracket();
        let lower = |index: &usize| bracket(index).map_or(f64::INFINITY, |b| b.lower);
        let upper = |index: &usize| bracket(index).map_or(f64::INFINITY, |b| -b.upper);
        let first =
            |of: &dyn Fn(&usize) -> f64| (0..variants.len()).min_by(|a, b| of(a).total_cmp(&of(b)));
        let ends = [first(&lower), first(&upper)].into_iter().flatten();
        let mut ends: Vec<usize> = ends.collect();
        ends.dedup();
        let finer = ends.into_iter().map(|index| {
            let conditions = Conditions {
                halvings: variants[index].halvings + 1,
                expected: bracket(&index),
                ..variants[index]
            };
            self.run(conditions, level)
        });
        finer.collect()
    }
}
