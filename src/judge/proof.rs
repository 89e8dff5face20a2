//! What an answer's own forces and mechanism prove.

use super::judgement::Judgement;
use crate::answer::{Bracket, Evidence, JudgedFact, Outcome, Standing, Status, magnitude};
use crate::certificate::{Certificate, Refusal, prove};
use crate::mechanics::{
    BlockResidual, Ceiling, CollapseResidual, CollapseState, ForceState, JointForce, Mechanism,
    Recomputed, StaticResidual, VERIFIED_RESIDUAL, associative_violation, falling_violation,
    kinematic_multiplier,
};
use crate::scene::Scene;

/// Recomputes every residual of what an outcome puts forward, and sets its status to what that
/// proves.
///
/// A claim that is refuted over the whole scene has `failed`; one that only the own forces or
/// velocities of a block are too far from is `undecided`: double precision may not resolve more.
pub fn judge(scene: &Scene, outcome: &mut Outcome) -> Judgement {
    let found = match outcome.status {
        Status::Falls | Status::Stands => settled(scene, outcome.status, &outcome.evidence),
        status => multiplier(scene, status, &outcome.evidence),
    };
    match found.ruling {
        Ruling::Stays => {}
        Ruling::Is(status) => outcome.status = status,
        Ruling::Noted(status, fact) => {
            outcome.status = status;
            outcome.facts.push(fact.into());
        }
        Ruling::Taken(status, fact) => {
            outcome.status = status;
            outcome.evidence = Evidence::Nothing;
            outcome.facts.push(fact.into());
        }
    }
    if outcome.status == Status::Falls && scene.left_out() > 0 {
        let count = scene.left_out();
        outcome
            .facts
            .push(JudgedFact::OpenHeadJoints { count }.into());
    }
    Judgement {
        status: outcome.status,
        residuals: found.residuals,
    }
}

/// What was recomputed, and what becomes of the answer.
struct Found {
    residuals: Vec<Recomputed>,
    ruling: Ruling,
}

/// What becomes of an answer.
enum Ruling {
    Stays,
    /// It is worth this.
    Is(Status),
    /// It is worth this, and something is to be known of it.
    Noted(Status, JudgedFact),
    /// It is worth this, without its evidence.
    Taken(Status, JudgedFact),
}

fn refuted(why: JudgedFact) -> Ruling {
    Ruling::Taken(Status::Failed, why)
}

/// Takes the answer away where the residuals hold over the whole scene and not at one of its blocks.
/// An estimate stays one.
fn unresolved(status: Status, blocks: BlockResidual) -> Ruling {
    match status {
        Status::Estimate => Ruling::Noted(status, JudgedFact::NoProofOfBlock(blocks)),
        _ => Ruling::Taken(Status::Undecided, JudgedFact::Unresolved(blocks)),
    }
}

/// Of an answer with a multiplier, or of none.
fn multiplier(scene: &Scene, status: Status, evidence: &Evidence) -> Found {
    match evidence {
        Evidence::Number {
            bracket,
            forces: Some(forces),
            mechanism: Some(mechanism),
            ..
        } => {
            let put = Put::state(scene, forces.lambda, &forces.forces, mechanism);
            one_state(status, put.and(bracket.lower == bracket.upper))
        }
        Evidence::State { state, .. } => one_state(status, Put::of_state(scene, state)),
        Evidence::Bounds { below, above, .. } => {
            let ForceState { lambda, forces } = below;
            let put = Put::forces(scene, *lambda, forces);
            bounds(scene, status, put, *lambda, above)
        }
        Evidence::Enclosed { state, ceiling, .. } => {
            let put = Put::of_state(scene, state);
            bounds(scene, status, put, state.lambda, ceiling)
        }
        Evidence::States { states, .. } => {
            let put = states.iter().map(|state| Put::of_state(scene, state));
            let ordered = states.is_sorted_by(|a, b| a.lambda <= b.lambda);
            let put = put.fold(Put::nothing(), Put::beside);
            // Refuted where one fails.
            (put.and(!states.is_empty() && ordered)).found(status, true, Ruling::Stays)
        }
        Evidence::Bounded {
            lower: Some(lower),
            certificate,
            state,
            ..
        } => bounded(scene, status, *lower, certificate.as_deref(), state),
        Evidence::Observed(observed) => match observed.bracket {
            Some(_) if status == Status::Bracketed => Found::of(Ruling::Stays),
            _ => Found::of(without_proof(status)),
        },
        Evidence::Nothing
        | Evidence::ClosedForm { .. }
        | Evidence::Number { .. }
        | Evidence::Bounded { lower: None, .. }
        | Evidence::Falls { .. }
        | Evidence::Stands { .. } => Found::of(without_proof(status)),
    }
}

impl Found {
    /// Where nothing was recomputed.
    fn of(ruling: Ruling) -> Self {
        let residuals = Vec::new();
        Self { residuals, ruling }
    }
}

/// A proof that is claimed and not given.
fn without_proof(status: Status) -> Ruling {
    match status {
        Status::Verified | Status::Bracketed => refuted(JudgedFact::NothingToProve),
        _ => Ruling::Stays,
    }
}

/// What an answer puts forward, recomputed.
struct Put {
    residuals: Vec<Recomputed>,
    /// The largest violation of one block's own conditions.
    blocks: BlockResidual,
    /// Whether it holds over the whole scene.
    holds: bool,
}

impl Put {
    fn new(residual: Recomputed, blocks: BlockResidual) -> Self {
        Self {
            // Written so that a NaN does not hold.
            holds: residual.largest() <= VERIFIED_RESIDUAL,
            residuals: vec![residual],
            blocks,
        }
    }

    fn nothing() -> Self {
        Self {
            residuals: Vec::new(),
            blocks: BlockResidual::default(),
            holds: true,
        }
    }

    fn forces(scene: &Scene, lambda: f64, forces: &[JointForce]) -> Self {
        let statics = StaticResidual::of(scene, forces, lambda);
        let blocks = BlockResidual::of_forces(scene, forces, lambda);
        Self::new(Recomputed::Forces { lambda, statics }, blocks)
    }

    fn state(scene: &Scene, lambda: f64, forces: &[JointForce], mechanism: &Mechanism) -> Self {
        let residual = Recomputed::State {
            lambda,
            statics: StaticResidual::of(scene, forces, lambda),
            collapse: CollapseResidual::of(scene, forces, mechanism),
        };
        let blocks = BlockResidual::of_forces(scene, forces, lambda);
        let of_collapse = BlockResidual::of_collapse(scene, forces, mechanism);
        Self::new(residual, blocks.worse(of_collapse))
    }

    fn of_state(scene: &Scene, state: &CollapseState) -> Self {
        Self::state(scene, state.lambda, &state.forces, &state.mechanism)
    }

    /// The same, with something beside it that has to hold too.
    fn beside(self, other: Put) -> Self {
        Self {
            residuals: [self.residuals, other.residuals].concat(),
            blocks: self.blocks.worse(other.blocks),
            holds: self.holds && other.holds,
        }
    }

    fn and(self, holds: bool) -> Self {
        let holds = self.holds && holds;
        Self { holds, ..self }
    }

    /// What becomes of an answer that is `proved` where all of it holds, and refuted where it does not
    /// although that is claimed.
    fn found(self, status: Status, is_claimed: bool, proved: Ruling) -> Found {
        let Put {
            residuals,
            blocks,
            holds,
        } = self;
        let ruling = match holds {
            true if blocks.is_small() => proved,
            true => unresolved(status, blocks),
            false if is_claimed => refuted(JudgedFact::Refuted(residuals.clone())),
            false => Ruling::Noted(status, JudgedFact::NoProof(residuals.clone())),
        };
        Found { residuals, ruling }
    }
}

/// One state: `verified` where it holds at one multiplier, whatever was claimed.
fn one_state(status: Status, put: Put) -> Found {
    let proved = Ruling::Noted(Status::Verified, JudgedFact::CollapseState);
    put.found(status, status == Status::Verified, proved)
}

/// A state and a certificate: refuted where that does not prove the lower end. An estimate claims no
/// certificate.
fn bounded(
    scene: &Scene,
    status: Status,
    lower: f64,
    certificate: Option<&Certificate>,
    state: &CollapseState,
) -> Found {
    let put = Put::of_state(scene, state);
    let ruling = if put.holds && status == Status::Estimate {
        Some(Ruling::Stays)
    } else if put.holds {
        let refusal = certified(scene, lower, certificate).err();
        refusal.map(|refusal| refuted(JudgedFact::Uncertified(refusal)))
    } else {
        None
    };
    if let Some(ruling) = ruling {
        let residuals = put.residuals;
        return Found { residuals, ruling };
    }
    let upper = state.lambda;
    let proved = match (Bracket { lower, upper }).is_one_number(scene.multiplier_unit()) {
        true => Status::Verified,
        false => Status::Bracketed,
    };
    put.found(status, true, Ruling::Is(proved))
}

/// Whether the certificate proves the lower end. One at 0 needs none: a push begins there.
fn certified(scene: &Scene, lower: f64, certificate: Option<&Certificate>) -> Result<(), Refusal> {
    if lower == 0.0 {
        return Ok(());
    }
    if lower < 0.0 {
        return Err(Refusal::Nothing { claimed: lower });
    }
    let proved = prove(scene, certificate.ok_or(Refusal::Missing)?)?.lower;
    if lower <= proved {
        Ok(())
    } else {
        Err(Refusal::Less {
            claimed: lower,
            proved,
        })
    }
}

/// Both ends proved: `verified` where they are one number, else `bracketed`, or `undecided` where
/// the method says that its bracket is no answer. An estimate is never downgraded.
fn bounds(scene: &Scene, status: Status, below: Put, lower: f64, above: &Ceiling) -> Found {
    let unit = scene.multiplier_unit();
    let (own, upper) = (kinematic_multiplier(scene, &above.mechanism), above.lambda);
    let ceiling = Recomputed::Ceiling {
        lambda: own,
        flow_rule: associative_violation(scene, &above.mechanism),
        // Written so that a NaN refutes.
        bounds: upper >= own && lower <= own + 1e-9 * magnitude(own, unit),
    };
    let flow = BlockResidual::of_flow(scene, &above.mechanism);
    let put = below.beside(Put::new(ceiling, flow));
    let proved = match status {
        Status::Undecided => Status::Undecided,
        _ if (Bracket { lower, upper }).is_one_number(unit) => Status::Verified,
        _ => Status::Bracketed,
    };
    put.found(status, status != Status::Estimate, Ruling::Is(proved))
}

/// What proves `falls` (a mechanism) or `stands` (forces at λ = 0 and a ray, without friction or with a certificate
/// where it is not about associative friction): the status is refuted where that fails, and `undecided`
/// where nothing is given.
fn settled(scene: &Scene, status: Status, evidence: &Evidence) -> Found {
    let put = match (status, evidence) {
        (Status::Falls, Evidence::Falls { mechanism }) => {
            let flow_rule = falling_violation(scene, mechanism);
            let blocks = BlockResidual::of_flow(scene, mechanism);
            Put::new(Recomputed::Falling { flow_rule }, blocks)
        }
        (
            Status::Stands,
            Evidence::Stands {
                standing,
                at_rest,
                ray,
            },
        ) => {
            let pushed = match standing {
                Standing::Associative => scene.clone(),
                // Without dilatancy a joint may slip where the ray needs its friction, so that only a ray without
                // friction proves that nothing collapses, or a certificate.
                Standing::WithoutFriction => scene.clone().with_friction(|_, _| 0.0),
                Standing::Certified { certificate } => {
                    let proof = certified(scene, f64::INFINITY, certificate.as_deref());
                    if let Err(refusal) = proof {
                        return Found::of(refuted(JudgedFact::Uncertified(refusal)));
                    }
                    scene.clone()
                }
            };
            let statics = StaticResidual::of_ray(&pushed, ray);
            let blocks = BlockResidual::of_ray(&pushed, ray);
            let ray = Put::new(Recomputed::Ray { statics }, blocks);
            Put::forces(scene, 0.0, at_rest).beside(ray)
        }
        // Seen, not proved.
        (Status::Falls, Evidence::Observed(_)) => return Found::of(Ruling::Stays),
        _ => {
            let unproved = JudgedFact::NoCertificate(status);
            return Found::of(Ruling::Taken(Status::Undecided, unproved));
        }
    };
    put.found(status, true, Ruling::Stays)
}
