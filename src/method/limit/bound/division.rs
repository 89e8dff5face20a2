//! Which product a branch is divided by: it is tried.
//!
//! No number of a lift tells what a division by a product gains: on a wall of 17 blocks divisions by the
//! first seven products gained 1 % of the gap each, and the eighth closed it. So one is tried after the
//! other (strong branching of mixed-integer programming), those first that gained most elsewhere. What
//! gained nothing is forgotten, so that it does not double the branches that follow.

use super::branches::Leaf;
use super::slices::{Goal, Search, Slices};
use crate::answer::Budget;
use crate::certificate::{Slice, SliceProof};

/// A division that was tried.
struct Tried {
    gain: f64,
    parts: [Leaf; 2],
    /// The slices that raised its parts.
    slices: Vec<(Slice, SliceProof)>,
}

impl Search<'_> {
    /// The parts of a leaf after their first slices: of the first division that gains enough, or of the one that
    /// gains most of those that the settings allow. None where the leaf violates no product.
    pub(super) fn divide(
        &self,
        found: &mut Slices,
        leaf: &Leaf,
        goal: Goal,
    ) -> Result<Vec<Leaf>, Budget> {
        let own = &self.lift.parameters;
        if found.leaves.0.len() == 1 {
            found.undivided.clone_from(&leaf.normals);
        }
        let before = found.slices.len();
        let mut best: Option<Tried> = None;
        let order = found.gains.in_order(&leaf.violated);
        for pair in order.into_iter().take(own.divisions) {
            let mut parts = leaf.parts(pair);
            // A part takes about as many steps as its leaf did, and one part alone raises no bound.
            let left = self.steps_left(found, &leaf.face(self.lift), leaf.steps);
            let advance = |part| self.advance(found, part, goal);
            let advanced = left.and_then(|_| parts.iter_mut().try_for_each(advance));
            if let Err(budget) = advanced {
                found.slices.truncate(before);
                match best {
                    Some(_) => break,
                    None => return Err(budget),
                }
            }
            let gain =
                |part: &Leaf| ((part.lower - leaf.lower) / (goal.state - leaf.lower)).min(1.0);
            let gain = parts.iter().map(gain).sum();
            found.gains.add(pair, gain);
            let slices = found.slices.split_off(before);
            if best.as_ref().is_none_or(|best| gain > best.gain) {
                best = Some(Tried {
                    gain,
                    parts,
                    slices,
                });
            }
            if gain >= own.least_division {
                break;
            }
        }
        let Some(best) = best else {
            return Ok(Vec::new());
        };
        found.slices.extend(best.slices);
        Ok(best.parts.into())
    }
}

#[cfg(test)]
mod tests {
    use super::super::branches::Leaves;
    use super::super::lift::Lift;
    use super::super::parameters::Parameters;
    use super::*;
    use crate::certificate::{Conditions, LongestWay};
    use crate::method::Settings;
    use crate::method::limit::walls::{LOWEST_OF_SMALL_WALL as LOWEST, small_wall};
    use crate::scene::HeadJoints;

    /// A leaf whose last slice took 8 steps, divided by these corners, of which none gains enough, with so many
    /// steps allowed: its parts, and what that took.
    fn divided(by: &[usize], steps: usize) -> (Result<Vec<Leaf>, Budget>, Slices) {
        let scene = small_wall(HeadJoints::Contact);
        let conditions = Conditions::of(&scene).with_slip_bounds(&scene, LongestWay::ThreeJoints);
        let parameters = Parameters {
            least_division: 3.0,
            ..Parameters::TUNED
        };
        let lift = Lift::new(conditions, parameters).unwrap();
        let mut settings = Settings::default().bound;
        settings.lift_steps = steps;
        let search = Search {
            lift: &lift,
            prover: None,
            settings: &settings,
        };
        let goal = Goal {
            state: LOWEST,
            tolerance: 1e-4 * LOWEST,
        };
        let mut leaf = Leaves::default().0.remove(0);
        leaf.steps = 8;
        leaf.violated = by.to_vec();
        leaf.normals = vec![vec![0.5, 0.5]];
        let mut found = Slices::default();
        let parts = search.divide(&mut found, &leaf, goal);
        assert_eq!(found.undivided, leaf.normals);
        (parts, found)
    }

    /// With fewer steps than a part takes no division is begun, and of those before it the best one counts.
    #[test]
    fn a_division_is_tried_where_its_steps_are_allowed() {
        let (parts, found) = divided(&[9], 7);
        assert!(parts.is_err_and(|budget| budget == Budget::Steps));
        assert_eq!((found.programs, found.steps), (0, 0));
        let (_, first) = divided(&[9], 1000);
        let (_, both) = divided(&[9, 13], 1000);
        assert_eq!([first.programs, both.programs], [2, 4]);
        for (allowed, programs) in [(first.steps + 7, 2), (both.steps - 1, 4)] {
            let (parts, found) = divided(&[9, 13], allowed);
            assert_eq!(found.programs, programs);
            let parts = parts.expect("the first product divides it");
            assert!(parts.iter().all(|part| part.lower > 0.9 * LOWEST));
        }
    }
}
