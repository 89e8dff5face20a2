//! What the answers about one scene claim, whoever gives them: outside programs say it themselves,
//! of our own methods the table does.

use crate::answer::{BoundFact, Bracket, Evidence, Fact, Outcome, Status, magnitude};
use crate::mechanics::VERIFIED_RESIDUAL;
use crate::method::{Kind, kind};
use crate::scene::{HeadJoints, JointClass, Push, Reaction, Scene};

/// Outcomes of one scene by method name.
pub type Answers<'a> = [(&'a str, &'a Outcome)];

/// What a multiplier is put forward as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    ClosedForm,
    /// Proved bounds of λ_A.
    Bounds,
    /// Bounds of λ_A that were solved too loosely to be proved.
    Loose,
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
    /// Whether that holds of every collapse, however far it moves and whatever the push does.
    pub is_whole: bool,
    pub outcome: &'a Outcome,
}

impl Answered<'_> {
    /// Whether the lower end is that of a proved collapse state.
    pub fn has_state(&self) -> bool {
        match self.role {
            Role::States | Role::Enclosure => true,
            _ => {
                let single = matches!(
                    self.outcome.evidence,
                    Evidence::State { .. } | Evidence::Number { .. }
                );
                single && self.outcome.status == Status::Verified
            }
        }
    }

    /// Error that it states, relative to λ, or this one where it states none.
    pub fn stated_error(&self, unstated: f64) -> f64 {
        self.outcome.evidence.stated_error().unwrap_or(unstated)
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
    pub push: Push,
    /// Whether there are head joints in contact.
    pub heads_touch: bool,
    /// [`Scene::multiplier_unit`]: λ = `unit` · λ*.
    unit: f64,
    /// Where a support moves, what λ says of its reaction.
    pub reaction: Option<Reaction>,
}

impl<'a> Claims<'a> {
    pub fn of(scene: &Scene, answers: &'a Answers<'a>) -> Self {
        let answered = answers.iter().filter_map(|&(name, outcome)| {
            let bracket = outcome.bracket()?;
            let is_floor = matches!(outcome.evidence, Evidence::Bounded { .. });
            Some(Answered {
                name,
                role: role(name, outcome),
                bracket: if is_floor {
                    Bracket::point(bracket.upper)
                } else {
                    bracket
                },
                floor: (is_floor && outcome.status != Status::Estimate).then_some(bracket.lower),
                is_whole: is_whole(outcome),
                outcome,
            })
        });
        Self {
            answers,
            answered: answered.collect(),
            head_joints: scene.head_joints(),
            push: scene.push(),
            heads_touch: scene.joints().iter().any(|j| j.class == JointClass::Head),
            unit: scene.multiplier_unit(),
            reaction: scene.reaction().cloned(),
        }
    }

    pub fn of_role(&self, role: Role) -> Vec<Answered<'a>> {
        let of_role = self.answered.iter().filter(|answer| answer.role == role);
        of_role.copied().collect()
    }

    /// The answers that the judge has verified as collapse states.
    pub fn verified_states(&self) -> impl Iterator<Item = &Answered<'a>> {
        self.answered.iter().filter(|answer| answer.has_state())
    }

    /// The scene's unit of λ.
    pub fn unit(&self) -> f64 {
        self.unit
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

/// Whether a lower bound is proved of every collapse: without a cap, and where nothing falls on which
/// the push does no work.
fn is_whole(outcome: &Outcome) -> bool {
    let uncapped = outcome.proved().is_some_and(|proved| proved.cap.is_none());
    let push_moves = Fact::from(BoundFact::PushMoves);
    uncapped && outcome.facts.contains(&push_moves)
}

fn role(name: &str, outcome: &Outcome) -> Role {
    let is_outside = kind(name) == Kind::Outside;
    let is_estimate = outcome.status == Status::Estimate;
    match outcome.evidence {
        Evidence::ClosedForm { .. } => Role::ClosedForm,
        Evidence::Bounds { .. } | Evidence::Bounded { .. } if is_estimate => Role::Loose,
        Evidence::Bounds { .. } => Role::Bounds,
        Evidence::States { .. } | Evidence::Bounded { .. } => Role::States,
        Evidence::Enclosed { .. } => Role::Enclosure,
        Evidence::Observed(_) => Role::Observed,
        Evidence::State { .. } | Evidence::Number { .. }
            if is_outside && outcome.status == Status::Verified =>
        {
            Role::States
        }
        Evidence::State { .. } if !is_outside => Role::Converged,
        Evidence::State { .. }
        | Evidence::Number { .. }
        // Without a multiplier, so that nobody asks.
        | Evidence::Nothing
        | Evidence::Falls { .. }
        | Evidence::Stands { .. } => Role::Number,
    }
}
