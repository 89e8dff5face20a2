//! What the answers about one scene claim, whoever gives them: outside programs say it themselves,
//! of our own methods the table does.

use crate::answer::{Bracket, Claim, Outcome, Status, magnitude};
use crate::mechanics::VERIFIED_RESIDUAL;
use crate::method::{Kind, kind};
use crate::scene::{HeadJoints, JointClass, Scene};

/// Outcomes of one scene by method name.
pub type Answers<'a> = [(&'a str, &'a Outcome)];

/// What a multiplier is put forward as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// The range of a closed form.
    ClosedForm,
    /// Proved bounds of λ_A.
    Bounds,
    /// Bounds of λ_A that were solved too loosely to be proved.
    Loose,
    /// What an iteration converged to.
    Converged,
    /// Collapse states without dilatancy, each proved.
    States,
    /// A proved collapse state and a proved bound.
    Enclosure,
    /// What was seen.
    Observed,
    /// The number of an outside program, without a proof.
    Number,
}

/// A method that gave a multiplier.
#[derive(Clone, Copy)]
pub(super) struct Answered<'a> {
    pub name: &'a str,
    pub role: Role,
    pub bracket: Bracket,
    /// Proved lower bound of every collapse state; `bracket` is then the state above it.
    pub floor: Option<f64>,
    pub outcome: &'a Outcome,
}

impl Answered<'_> {
    /// Whether the lower end is that of a proved collapse state.
    pub fn has_state(&self) -> bool {
        match self.role {
            Role::States | Role::Enclosure => true,
            _ => {
                self.outcome.status == Status::Verified
                    && self.outcome.claim == Claim::CollapseState
            }
        }
    }

    /// Whether it comes from an outside program.
    pub fn is_outside(&self) -> bool {
        kind(self.name) == Kind::Outside
    }
}

/// All answers about one scene.
pub(super) struct Claims<'a> {
    pub answers: &'a Answers<'a>,
    /// Those with a multiplier, in their order.
    pub answered: Vec<Answered<'a>>,
    pub head_joints: HeadJoints,
    /// Whether there are head joints in contact.
    pub heads_touch: bool,
    /// [`Scene::multiplier_unit`]: λ = `unit` · λ*.
    unit: f64,
}

impl<'a> Claims<'a> {
    pub fn of(scene: &Scene, answers: &'a Answers<'a>) -> Self {
        let answered = answers.iter().filter_map(|&(name, outcome)| {
            let bracket = outcome.bracket?;
            let is_floor = kind(name) == Kind::LowerBound;
            Some(Answered {
                name,
                role: role(name, outcome),
                bracket: if is_floor {
                    Bracket::point(bracket.upper)
                } else {
                    bracket
                },
                floor: (is_floor && outcome.status != Status::Estimate).then_some(bracket.lower),
                outcome,
            })
        });
        Self {
            answers,
            answered: answered.collect(),
            head_joints: scene.head_joints(),
            heads_touch: scene.joints().iter().any(|j| j.class == JointClass::Head),
            unit: scene.multiplier_unit(),
        }
    }

    /// The answers of a role.
    pub fn of_role(&self, role: Role) -> Vec<Answered<'a>> {
        let of_role = self.answered.iter().filter(|answer| answer.role == role);
        of_role.copied().collect()
    }

    /// λ without dimensions.
    pub fn dimensionless(&self, lambda: f64) -> f64 {
        lambda / self.unit
    }

    /// How far a multiplier is above another, relative to the [`magnitude`] of that one; below where
    /// it is negative.
    pub fn excess(&self, lambda: f64, over: f64) -> f64 {
        (lambda - over) / magnitude(over, self.unit)
    }

    /// Whether a multiplier is above another by more than an error that is relative to itself.
    pub fn is_above(&self, lambda: f64, error: f64, other: f64) -> bool {
        -self.excess(other, lambda) > error
    }

    /// Whether a multiplier is below another by more than an error that is relative to itself.
    pub fn is_below(&self, lambda: f64, error: f64, other: f64) -> bool {
        self.excess(other, lambda) > error
    }

    /// How far apart, relative to `lambda`, multipliers may be that are proved to the residual of
    /// `verified`.
    pub fn proof_slack(&self, lambda: f64) -> f64 {
        1e-6 + VERIFIED_RESIDUAL * self.unit / magnitude(lambda, self.unit)
    }
}

fn role(name: &str, outcome: &Outcome) -> Role {
    use Status::{Bracketed, Undecided, Verified};
    match kind(name) {
        Kind::ClosedForm => Role::ClosedForm,
        Kind::AssociativeBounds => match outcome.status {
            Status::Estimate => Role::Loose,
            _ => Role::Bounds,
        },
        Kind::CollapseState => Role::Converged,
        Kind::CollapseStates => Role::States,
        Kind::LowerBound => match outcome.status {
            Status::Estimate => Role::Loose,
            _ => Role::States,
        },
        Kind::Observed => Role::Observed,
        Kind::Enclosure => Role::Enclosure,
        Kind::Outside => match (outcome.status, outcome.claim) {
            (Verified | Bracketed, Claim::Associative) => Role::Bounds,
            (Verified | Bracketed | Undecided, Claim::Enclosed) => Role::Enclosure,
            (Verified, Claim::CollapseState) => Role::States,
            _ => Role::Number,
        },
    }
}
