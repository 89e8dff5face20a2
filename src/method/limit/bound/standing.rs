//! That a scene stands however hard it is pushed, although its joints need friction to carry the push.
//!
//! A ray of forces within friction leaves λ_A without limit, and proves nothing without dilatancy: a joint that
//! slips need not carry what the ray needs. Where the search finds no collapse state either, one lifted program
//! without an upper end of λ tells whether there can be any. What it excludes is
//!
//! ```text
//! (1 + 2 λ) f_L·u + f_D·u = (1 + λ) f_L·u + what friction takes > 0
//! ```
//!
//! by the balance of work f_D·u + λ f_L·u = Σ μN |slip|. That is every collapse state in which the push does work,
//! and those in which it does none and the weight does (section 7 of the science notes has two lifts for the two).

use std::sync::Arc;

use super::branches::Leaf;
use super::lift::Lift;
use super::lifted::Request;
use super::parameters::Parameters;
use super::proving::{Opened, lift_of, opening};
use super::slices::{Search, Slices};
use crate::answer::{BoundFact, Evidence, Fact, Outcome, Standing, Status, Work};
use crate::mechanics::JointForce;
use crate::method::Settings;
use crate::method::limit::own_weight::{own_weight, ray};
use crate::scene::Scene;

/// The answer where the interval has no state: its own where it settles the scene, `stands` where that is proved
/// here, else undecided.
pub(super) fn without_state(scene: &Scene, settings: &Settings, found: Outcome) -> Outcome {
    if matches!(found.status, Status::Falls | Status::Stands) {
        return found;
    }
    // Of a small scene the interval has asked already.
    let is_asked = |fact: &Fact| matches!(fact, Fact::Bound(_));
    let mut work = found.work;
    let asked = match found.facts.iter().any(is_asked) {
        true => Err(None),
        false => asked_at_any_cost(scene, settings, &mut work),
    };
    match asked {
        Ok(stands) => Outcome { work, ..stands },
        Err(why) => {
            let own = [Some(BoundFact::NoState), why];
            let own = own.into_iter().flatten().map(Fact::from);
            Outcome {
                facts: own.chain(found.facts).collect(),
                work,
                ..Outcome::of(Status::Undecided)
            }
        }
    }
}

/// What the lifted program says, however dear it is; `None` where forces do not carry every push.
fn asked_at_any_cost(
    scene: &Scene,
    settings: &Settings,
    work: &mut Work,
) -> Result<Outcome, Option<BoundFact>> {
    let at_rest = own_weight(scene, work).map_err(|_| None)?;
    let ray = ray(scene, work).ok_or(None)?;
    stands(scene, settings, f64::INFINITY, (&at_rest, ray), work)
}

/// The answer `stands` where one lifted program proves it, whose steps take no more than `most` products of numbers;
/// else why not, where there is something to say. Forces at rest and a ray within friction carry every push.
pub(in crate::method::limit) fn stands(
    scene: &Scene,
    settings: &Settings,
    most: f64,
    (at_rest, ray): (&[JointForce], Vec<JointForce>),
    work: &mut Work,
) -> Result<Outcome, Option<BoundFact>> {
    // The reaction of a support that moves is no push that grows without limit.
    if scene.reaction().is_some() {
        return Err(None);
    }
    let lift = lift_of(scene, settings, Parameters::TUNED)?;
    if leaf(&lift).face(&lift).step_work() > most {
        return Err(None);
    }
    let own = opening(scene, work).and_then(|opening| Opened::of(scene, &lift, opening));
    let own = own.ok_or(BoundFact::NoOpening)?;
    let (slices, excludes_all) = endless(&lift, &own, settings);
    work.programs += slices.programs;
    work.iterations += slices.steps;
    if !excludes_all {
        return Err(Some(slices.ended().unwrap_or(BoundFact::MayCollapse)));
    }
    let (certificate, _) = own.certificate(scene, &settings.bound, &slices);
    let evidence = Evidence::Stands {
        standing: Standing::Certified {
            certificate: Some(Arc::new(certificate)),
        },
        at_rest: at_rest.to_vec(),
        ray,
    };
    Ok(Outcome::with(Status::Stands, evidence).because(BoundFact::ExcludesAll))
}

/// One slice without an upper end, and whether it excludes every collapse state.
fn endless(lift: &Lift, own: &Opened, settings: &Settings) -> (Slices, bool) {
    let search = Search {
        lift,
        prover: Some(&own.prover),
        settings: &settings.bound,
    };
    let mut slices = Slices::default();
    let excludes_all = search.exclude_all(&mut slices);
    (slices, excludes_all)
}

/// All collapse states, with slips bounded along long ways too: without these, what rounding leaves of slips was not
/// absorbed on seven of nine walls.
fn leaf(lift: &Lift) -> Leaf {
    let mut leaf = Slices::default().leaves.0[0].clone();
    leaf.has_long_ways = lift.has_long_ways();
    leaf
}

impl Search<'_> {
    /// Whether one slice without an upper end excludes every λ ≥ 0, however far the motions go.
    fn exclude_all(&self, slices: &mut Slices) -> bool {
        let own = &self.lift.parameters;
        let mut leaf = leaf(self.lift);
        let steps = match self.steps_left(slices, &leaf.face(self.lift), 1) {
            Ok(steps) => steps.min(own.steps),
            Err(budget) => {
                slices.ended_by = Some(budget);
                return false;
            }
        };
        let request = Request {
            from: 0.0,
            to: f64::INFINITY,
            enough: own.excludes,
            most: 1.0,
            steps,
            exact: false,
            left: own.left,
        };
        let gain = self.solve(slices, &mut leaf, request);
        gain > 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::limit::walls::{bonded, small_wall, wall};
    use crate::scene::{HeadJoints, Push, Vector};

    /// Whether one slice excludes every λ, and what the certificate of it proves.
    fn excludes_all(scene: &Scene) -> bool {
        let settings = Settings::default();
        let lift = lift_of(scene, &settings, Parameters::TUNED).unwrap();
        let opening = opening(scene, &mut Work::default()).expect("it does not lock");
        let own = Opened::of(scene, &lift, opening).expect("it hangs on something");
        let (slices, excludes_all) = endless(&lift, &own, &settings);
        let (_, proved) = own.certificate(scene, &settings.bound, &slices);
        assert_eq!(proved.lower == f64::INFINITY, excludes_all);
        excludes_all
    }

    /// Walls that collapse are not excluded, whatever their head joints carry; nor are those whose weights push
    /// downwards too, until these do so beyond what friction holds.
    #[test]
    fn collapse_states_are_not_excluded() {
        let walls = [
            small_wall(HeadJoints::Contact),
            small_wall(HeadJoints::Open),
            wall(3, Push::Left),
            bonded(&["h1h", "11", "h1h"]),
        ];
        for scene in &walls {
            assert!(!excludes_all(scene));
        }
        // Friction is 0.65: a force of slope 1 / 1.5 slides, one of 1 / 1.6 does not.
        for (down, stands) in [(0.5, false), (1.5, false), (1.6, true), (3.0, true)] {
            let aslant = |weight: f64| Vector::new(weight, -down * weight);
            let scene = wall(1, Push::Right);
            let scene = scene.with_loads(|load, _| load.live = aslant(-load.dead.y));
            assert_eq!(excludes_all(&scene), stands, "{down}");
        }
    }
}
