//! What an answer's own forces and mechanism prove.

use super::judgement::{Judgement, Recomputed};
use crate::answer::{
    Bracket, CeilingSlack, Evidence, JudgedFact, Outcome, Residuals, Status, magnitude,
};
use crate::certificate::{Certificate, Refusal, prove};
use crate::mechanics::{
    BlockResidual, Ceiling, CollapseResidual, CollapseState, ForceState, JointForce, Mechanism,
    StaticResidual, VERIFIED_RESIDUAL, associative_violation, falling_violation,
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
    /// It stays what it is.
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
        Status::Estimate => Ruling::Noted(status, JudgedFact::NoProof(Residuals::Block(blocks))),
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
            let residual = of_state(scene, forces.lambda, &forces.forces, mechanism);
            one_state(status, bracket.lower == bracket.upper, residual)
        }
        Evidence::State { state, .. } => one_state(status, true, OfState::new(scene, state)),
        Evidence::Bounds { below, above, .. } => {
            let residual = of_forces(scene, below);
            bounds(scene, status, residual, below.lambda, above)
        }
        Evidence::Enclosed { state, ceiling, .. } => {
            let residual = OfState::new(scene, state);
            bounds(scene, status, residual, state.lambda, ceiling)
        }
        Evidence::States { states, .. } => all_states(scene, status, states),
        Evidence::Bounded {
            lower: Some(lower),
            certificate,
            state,
            ..
        } => bounded(scene, status, *lower, certificate.as_deref(), state),
        Evidence::Observed(observed) => Found {
            residuals: Vec::new(),
            ruling: match observed.bracket {
                Some(_) if status == Status::Bracketed => Ruling::Stays,
                _ => without_proof(status),
            },
        },
        Evidence::Nothing
        | Evidence::ClosedForm { .. }
        | Evidence::Number { .. }
        | Evidence::Bounded { lower: None, .. }
        | Evidence::Falls { .. }
        | Evidence::Stands { .. } => Found {
            residuals: Vec::new(),
            ruling: without_proof(status),
        },
    }
}

/// A proof that is claimed and not given.
fn without_proof(status: Status) -> Ruling {
    match status {
        Status::Verified | Status::Bracketed => refuted(JudgedFact::NothingToProve),
        _ => Ruling::Stays,
    }
}

/// What was computed of forces, and of velocities beside them.
struct OfState {
    lambda: f64,
    statics: StaticResidual,
    /// With velocities.
    collapse: Option<CollapseResidual>,
    /// The largest violation of one block's own conditions.
    blocks: BlockResidual,
}

impl OfState {
    fn new(scene: &Scene, state: &CollapseState) -> Self {
        of_state(scene, state.lambda, &state.forces, &state.mechanism)
    }

    fn recomputed(&self) -> Recomputed {
        let (lambda, statics) = (self.lambda, self.statics);
        match self.collapse {
            Some(collapse) => Recomputed::State {
                lambda,
                statics,
                collapse,
            },
            None => Recomputed::Forces { lambda, statics },
        }
    }

    fn residuals(&self) -> Residuals {
        let statics = self.statics;
        match self.collapse {
            Some(collapse) => Residuals::State { statics, collapse },
            None => Residuals::Largest(statics.largest()),
        }
    }

    fn largest(&self) -> f64 {
        self.recomputed().largest()
    }
}

fn of_forces(scene: &Scene, of: &ForceState) -> OfState {
    OfState {
        lambda: of.lambda,
        statics: StaticResidual::of(scene, &of.forces, of.lambda),
        collapse: None,
        blocks: BlockResidual::of_forces(scene, &of.forces, of.lambda),
    }
}

fn of_state(scene: &Scene, lambda: f64, forces: &[JointForce], mechanism: &Mechanism) -> OfState {
    let blocks = BlockResidual::of_forces(scene, forces, lambda);
    OfState {
        lambda,
        statics: StaticResidual::of(scene, forces, lambda),
        collapse: Some(CollapseResidual::of(scene, forces, mechanism)),
        blocks: blocks.worse(BlockResidual::of_collapse(scene, forces, mechanism)),
    }
}

/// One state: `verified` where it holds at one multiplier, whatever was claimed.
fn one_state(status: Status, at_one: bool, state: OfState) -> Found {
    let holds = at_one && state.largest() <= VERIFIED_RESIDUAL;
    let ruling = if holds && !state.blocks.is_small() {
        unresolved(status, state.blocks)
    } else if holds {
        Ruling::Noted(Status::Verified, JudgedFact::CollapseState)
    } else if status == Status::Verified {
        refuted(JudgedFact::Refuted(state.residuals()))
    } else {
        Ruling::Noted(status, JudgedFact::NoProof(state.residuals()))
    };
    Found {
        residuals: vec![state.recomputed()],
        ruling,
    }
}

/// The states that an interval rests on: refuted where one fails.
fn all_states(scene: &Scene, status: Status, states: &[CollapseState]) -> Found {
    let of_states = states.iter().map(|state| OfState::new(scene, state));
    let of_states: Vec<OfState> = of_states.collect();
    let largest = of_states.iter().map(OfState::largest).fold(0.0, f64::max);
    let blocks = of_states.iter().map(|of| of.blocks);
    let blocks = blocks.fold(BlockResidual::default(), BlockResidual::worse);
    let ordered = states.is_sorted_by(|a, b| a.lambda <= b.lambda);
    let proved = !states.is_empty() && ordered && largest <= VERIFIED_RESIDUAL;
    let ruling = if !proved {
        refuted(JudgedFact::Refuted(Residuals::Largest(largest)))
    } else if !blocks.is_small() {
        unresolved(status, blocks)
    } else {
        Ruling::Stays
    };
    Found {
        residuals: of_states.iter().map(OfState::recomputed).collect(),
        ruling,
    }
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
    let upper = state.lambda;
    let of = OfState::new(scene, state);
    // Written so that a NaN refutes.
    let holds = of.largest() <= VERIFIED_RESIDUAL;
    let ruling = if !holds {
        refuted(JudgedFact::Refuted(of.residuals()))
    } else if status == Status::Estimate {
        Ruling::Stays
    } else if lower < 0.0 {
        refuted(JudgedFact::Uncertified(Refusal::Nothing { claimed: lower }))
    } else if let Err(refusal) = certified(scene, lower, certificate) {
        refuted(JudgedFact::Uncertified(refusal))
    } else if !of.blocks.is_small() {
        unresolved(status, of.blocks)
    } else if (Bracket { lower, upper }).is_one_number(scene.multiplier_unit()) {
        Ruling::Is(Status::Verified)
    } else {
        Ruling::Is(Status::Bracketed)
    };
    Found {
        residuals: vec![of.recomputed()],
        ruling,
    }
}

/// Whether the certificate proves the lower end. One at 0 needs none: a push begins there.
fn certified(scene: &Scene, lower: f64, certificate: Option<&Certificate>) -> Result<(), Refusal> {
    if lower == 0.0 {
        return Ok(());
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
fn bounds(scene: &Scene, status: Status, below: OfState, lower: f64, above: &Ceiling) -> Found {
    let unit = scene.multiplier_unit();
    let upper = above.lambda;
    let ceiling = CeilingSlack {
        flow_rule: associative_violation(scene, &above.mechanism),
        multiplier: kinematic_multiplier(scene, &above.mechanism),
    };
    let own = ceiling.multiplier;
    let proof = Recomputed::Ceiling {
        lambda: own,
        flow_rule: ceiling.flow_rule,
        // Written so that a NaN refutes.
        bounds: upper >= own && lower <= own + 1e-9 * magnitude(own, unit),
    };
    let flow = BlockResidual::of_flow(scene, &above.mechanism);
    let blocks = below.blocks.worse(flow);
    let holds = below.largest().max(proof.largest()) <= VERIFIED_RESIDUAL;
    let residuals = Residuals::Bounds {
        statics: below.statics,
        collapse: below.collapse,
        ceiling: Some(ceiling),
    };
    let ruling = if holds && !blocks.is_small() {
        unresolved(status, blocks)
    } else if holds {
        Ruling::Is(match status {
            Status::Undecided => Status::Undecided,
            _ if (Bracket { lower, upper }).is_one_number(unit) => Status::Verified,
            _ => Status::Bracketed,
        })
    } else if status == Status::Estimate {
        Ruling::Noted(status, JudgedFact::NoProof(residuals))
    } else {
        refuted(JudgedFact::Refuted(residuals))
    };
    Found {
        residuals: vec![below.recomputed(), proof],
        ruling,
    }
}

/// What proves `falls` (a mechanism) or `stands` (forces at λ = 0 and a ray, without friction where
/// it is not about associative friction): the status is refuted where that fails, and `undecided`
/// where nothing is given.
fn settled(scene: &Scene, status: Status, evidence: &Evidence) -> Found {
    let (residuals, blocks) = match (status, evidence) {
        (Status::Falls, Evidence::Falls { mechanism }) => {
            let flow_rule = falling_violation(scene, mechanism);
            let blocks = BlockResidual::of_flow(scene, mechanism);
            (vec![Recomputed::Falling { flow_rule }], blocks)
        }
        (
            Status::Stands,
            Evidence::Stands {
                associative,
                at_rest,
                ray,
            },
        ) => {
            // Without dilatancy a joint may slip where the ray needs its friction, so that only a
            // ray without friction proves that nothing collapses.
            let smooth = scene.clone().with_friction(|_, _| 0.0);
            let pushed = if *associative { scene } else { &smooth };
            let (lambda, statics) = (0.0, StaticResidual::of(scene, at_rest, 0.0));
            let of_ray = StaticResidual::of_ray(pushed, ray);
            let blocks = BlockResidual::of_forces(scene, at_rest, 0.0);
            let residuals = vec![
                Recomputed::Forces { lambda, statics },
                Recomputed::Ray { statics: of_ray },
            ];
            (residuals, blocks.worse(BlockResidual::of_ray(pushed, ray)))
        }
        // Seen, not proved.
        (Status::Falls, Evidence::Observed(_)) => {
            return Found {
                residuals: Vec::new(),
                ruling: Ruling::Stays,
            };
        }
        _ => {
            return Found {
                residuals: Vec::new(),
                ruling: Ruling::Taken(Status::Undecided, JudgedFact::NoCertificate(status)),
            };
        }
    };
    let largest = residuals.iter().map(Recomputed::largest);
    let largest = largest.fold(0.0, f64::max);
    // Written so that a NaN refutes.
    let holds = residuals.iter().all(|of| of.largest() <= VERIFIED_RESIDUAL);
    let ruling = if !holds {
        refuted(JudgedFact::Refuted(Residuals::Largest(largest)))
    } else if !blocks.is_small() {
        unresolved(status, blocks)
    } else {
        Ruling::Stays
    };
    Found { residuals, ruling }
}
