//! What the bounds of a scene are proved with, and what is claimed of them.

use std::sync::Arc;

use super::lift::Lift;
use super::parameters::Parameters;
use super::slices::Slices;
use crate::answer::{BoundFact, Fact, LimitFact, Outcome, Work};
use crate::certificate::{Certificate, Conditions, LongestWay, Proved, Prover, Unknown};
use crate::method::limit::ending::Ending;
use crate::method::limit::program::Program;
use crate::method::limit::scale::Scale;
use crate::method::settings::BoundSettings;
use crate::method::{Settings, SoFar};
use crate::scene::Scene;

/// The lift of a scene, or why there is none: it is too large, or a block hangs on nothing.
pub(super) fn lift_of(
    scene: &Scene,
    settings: &Settings,
    parameters: Parameters,
) -> Result<Lift, BoundFact> {
    let conditions = Conditions::of(scene);
    let most = settings.bound.lift_unknowns;
    let unknowns = conditions.free_forces() * conditions.velocities();
    if unknowns > most {
        return Err(BoundFact::TooLarge { unknowns, most });
    }
    let conditions = conditions.with_slip_bounds(scene, LongestWay::ThreeJoints);
    Lift::new(conditions, parameters).ok_or(BoundFact::NoState)
}

/// A scene whose joints can all open at once, so that its bounds can be proved.
pub(super) struct Opened {
    pub(super) prover: Prover,
    /// A motion that opens every joint.
    opening: Vec<f64>,
}

impl Opened {
    /// None where the motion does not open every joint, or a block hangs on nothing.
    pub(super) fn of(scene: &Scene, lift: &Lift, opening: Vec<f64>) -> Option<Self> {
        let prover = Prover::new(scene, lift.conditions.clone(), &opening).ok()?;
        Some(Self { prover, opening })
    }

    /// The certificate of the slices so far, and what it proves.
    pub(super) fn certificate(
        &self,
        scene: &Scene,
        settings: &BoundSettings,
        slices: &Slices,
    ) -> (Certificate, Proved) {
        slices.certificate(scene, &self.prover, settings.lift_cap, self.opening.clone())
    }

    /// The certificate, and what is claimed of states below this one, which a search has found.
    pub(super) fn claim(
        &self,
        scene: &Scene,
        settings: &BoundSettings,
        slices: &Slices,
        (found, state): (&Outcome, f64),
    ) -> (Option<Certificate>, Vec<Fact>) {
        let (certificate, proved) = self.certificate(scene, settings, slices);
        // A state that moves farther than the cap may lie below what is proved up to the cap.
        let lower = proved.lower.min(state);
        let proved = Fact::from(BoundFact::Proved(Proved { lower, ..proved }));
        let push_moves = push_moves(found).map(Fact::from);
        let facts = [proved].into_iter().chain(push_moves);
        (Some(certificate), facts.collect())
    }

    /// What the slices prove so far of states below this one.
    pub(super) fn so_far(
        &self,
        scene: &Scene,
        settings: &BoundSettings,
        slices: &Slices,
        state: f64,
    ) -> SoFar {
        let (certificate, proved) = self.certificate(scene, settings, slices);
        SoFar {
            push: scene.push(),
            of_reaction: scene.reaction().is_some(),
            proved: Proved {
                lower: proved.lower.min(state),
                ..proved
            },
            state,
            certificate: Arc::new(certificate),
        }
    }
}

/// That nothing falls on which the push does no work, where forces without friction at some λ prove it:
/// by virtual work f_D·u ≤ −λ f_L·u = 0 for every motion that closes no joint.
fn push_moves(found: &Outcome) -> Option<BoundFact> {
    let frictionless = |fact: &Fact| {
        matches!(
            fact,
            Fact::Limit(LimitFact::FoundNoBounds {
                frictionless: Some(_)
            })
        )
    };
    let proves = found.facts.iter().any(frictionless);
    proves.then_some(BoundFact::PushMoves)
}

/// A motion that opens every joint by 1 beyond μ times its slip (the lengths over the height), so
/// that all forces together are as small as can be shown; `None` where none is found, as in scenes that can lock. One
/// on which the push does no work bounds forces alike at every λ; where a push can be carried without limit there is
/// no such motion, but one on which it works.
pub(super) fn opening(scene: &Scene, work: &mut Work) -> Option<Vec<f64>> {
    // What guides a support stays closed.
    let mut opens = vec![0.0; scene.joints().len()];
    opens[..scene.contacts().len()].fill(-1.0);
    let without_work = Program::new(scene);
    let with_work = || Program::at_multiplier(scene, 0.0, Scale::of(scene));
    let programs = [without_work]
        .into_iter()
        .chain(std::iter::once_with(with_work));
    programs.into_iter().find_map(|mut program| {
        program.set_cost(0.0, &opens);
        match program.solve_counted(work) {
            Ending::Solved(solution) => Some(Unknown::of(scene).velocities(&solution.velocity)),
            _ => None,
        }
    })
}
