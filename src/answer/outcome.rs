//! What a method answers. It holds no time, so no time can reach a snapshot.

use std::ops::Add;

use super::fact::{self, Fact};
use super::{Crack, Mechanism};

/// What a result may be used for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Proved to a residual of 1e-8 by the judge.
    Verified,
    /// λ lies between lower and upper by the method's own evidence, the width is not negligible.
    Bracketed,
    /// A number with no proof behind it.
    Estimate,
    /// No multiplier is too large.
    Stands,
    /// The scene does not stand under its own weight.
    Falls,
    /// The scene is outside the method's limits of validity.
    NotApplicable,
    /// No honest answer; the reason says why.
    Undecided,
    /// The method broke, or the judge refutes it.
    Failed,
}

impl Status {
    /// Every status.
    pub const ALL: [Status; 8] = [
        Status::Verified,
        Status::Bracketed,
        Status::Estimate,
        Status::Stands,
        Status::Falls,
        Status::NotApplicable,
        Status::Undecided,
        Status::Failed,
    ];

    /// The word that tables, CSV and JSON use.
    pub fn name(self) -> &'static str {
        match self {
            Status::Verified => "verified",
            Status::Bracketed => "bracketed",
            Status::Estimate => "estimate",
            Status::Stands => "stands",
            Status::Falls => "falls",
            Status::NotApplicable => "not-applicable",
            Status::Undecided => "undecided",
            Status::Failed => "failed",
        }
    }
}

/// What an answer's forces and mechanism are put forward as; the judge proves that and nothing else.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Claim {
    /// A collapse state without dilatancy: forces and mechanism satisfy every condition together.
    #[default]
    CollapseState,
    /// Bounds of λ_A: `forces` are admissible at `bracket.lower`, `mechanism` by associative
    /// friction, and its own multiplier is no larger than `bracket.upper`.
    Associative,
    /// A collapse state at `bracket.lower`, and `ceiling` as in `Associative` for `bracket.upper`.
    Enclosed,
    /// Something seen, not proved, as in an experiment.
    Observed,
}

/// Lower and upper value of a collapse multiplier; what each means is the method's to say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bracket {
    /// Lower value.
    pub lower: f64,
    /// Upper value.
    pub upper: f64,
}

impl Bracket {
    /// Both ends at one value.
    pub fn point(lambda: f64) -> Self {
        Self {
            lower: lambda,
            upper: lambda,
        }
    }

    /// Width relative to max(|λ|, 1e-3).
    pub fn relative_width(&self) -> f64 {
        (self.upper - self.lower) / self.upper.abs().max(1e-3)
    }

    /// Largest distance of either end from a reference, relative to max(|reference|, 1e-3).
    pub fn error(&self, reference: f64) -> f64 {
        let distance = |end: f64| (end - reference).abs();
        distance(self.lower).max(distance(self.upper)) / reference.abs().max(1e-3)
    }
}

/// Forces of one joint, in the case's force unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct JointForce {
    /// Normal force at each end of the joint, compression positive.
    pub normal: [f64; 2],
    /// Shear on the block that the normal points into, along the joint's tangent.
    pub shear: f64,
}

/// A non-associative collapse state: forces and mechanism that satisfy every condition together.
#[derive(Clone, Debug)]
pub struct CollapseState {
    /// Multiplier of the forces.
    pub lambda: f64,
    /// Forces of every joint.
    pub forces: Vec<JointForce>,
    /// Velocities of every block.
    pub mechanism: Mechanism,
}

/// Effort in counts that do not depend on the machine's speed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Blocks that were modelled as movable; 0 where the method does not count them.
    pub modelled: usize,
    /// Linear programs solved.
    pub programs: usize,
    /// Interior-point iterations over all programs.
    pub iterations: usize,
    /// Time steps of the pushover, times the blocks that can move.
    pub block_steps: usize,
}

impl Add for Work {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            modelled: self.modelled + other.modelled,
            programs: self.programs + other.programs,
            iterations: self.iterations + other.iterations,
            block_steps: self.block_steps + other.block_steps,
        }
    }
}

/// The answer of one method for one scene.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// What the answer is worth; the judge may lower it.
    pub status: Status,
    /// What forces and mechanism are to prove.
    pub claim: Claim,
    /// The multiplier, where there is one to vouch for.
    pub bracket: Option<Bracket>,
    /// Error that the method states for its bracket, relative to λ; `None` where it states none.
    pub stated_error: Option<f64>,
    /// Crack slope of a closed form (no mechanism behind it) or of the mechanism.
    pub crack: Option<Crack>,
    /// Velocities of every block at collapse; with the status `falls`, under the dead load alone.
    pub mechanism: Option<Mechanism>,
    /// Forces of every joint at the multiplier `bracket.lower`; with the status `stands`, at λ = 0.
    pub forces: Option<Vec<JointForce>>,
    /// With the status `stands`: forces within friction that balance the live load for λ = 1 and
    /// nothing else, so that `forces` + λ · `ray` is a state for every λ ≥ 0.
    pub ray: Option<Vec<JointForce>>,
    /// With the claim [`Claim::Enclosed`]: a mechanism with dilatancy, whose multiplier bounds every
    /// collapse multiplier from above.
    pub ceiling: Option<Mechanism>,
    /// Every collapse state that the answer rests on, lowest λ first; only the interval has them.
    pub states: Vec<CollapseState>,
    /// On request, displacements of every block since the scene settled, at times a constant step
    /// apart from the last rest to the end of the collapse.
    pub recording: Vec<Mechanism>,
    /// Effort.
    pub work: Work,
    /// Self-checks that ran, with their figures, in words.
    pub checks: Vec<String>,
    /// Why this status, and what is to be known of the answer; may be empty when all went as hoped.
    pub facts: Vec<Fact>,
}

impl Outcome {
    /// An answer without a number.
    pub fn without_number(status: Status, fact: impl Into<Fact>) -> Self {
        Self {
            status,
            claim: Claim::default(),
            bracket: None,
            stated_error: None,
            crack: None,
            mechanism: None,
            forces: None,
            ray: None,
            ceiling: None,
            states: Vec::new(),
            recording: Vec::new(),
            work: Work::default(),
            checks: Vec::new(),
            facts: vec![fact.into()],
        }
    }

    /// The facts as one text; empty where there is nothing to say.
    pub fn reason(&self) -> String {
        fact::sentence(&self.facts)
    }
}
