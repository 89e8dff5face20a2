//! The ends of a wall's range of λ, each with the push that has it.

use crate::answer::{Bracket, Outcome, Status};
use crate::number::{above, below, nine_digits, nine_outwards, number};
use crate::scene::{Push, Reaction, Sense};

/// One end of a wall's range of λ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    pub lambda: f64,
    /// Direction of the push that has this end.
    pub push: Push,
    /// Which way it is rounded, +1 up and -1 down, where it is a proved bound and the other end is
    /// another number: printed digits must not claim more than the proof.
    pub outwards: Option<f64>,
}

impl End {
    /// With fixed decimals, rounded as it may be.
    pub fn outwards(self, decimals: usize) -> String {
        match self.outwards {
            Some(sign) if sign < 0.0 => below(self.lambda, decimals),
            Some(_) => above(self.lambda, decimals),
            None => number(self.lambda, decimals),
        }
    }

    /// As files have it: with nine digits, rounded as it may be.
    pub fn written(self) -> f64 {
        self.outwards
            .map_or(self.lambda, |sign| nine_outwards(self.lambda, sign))
    }
}

/// Lower and upper end of a wall's range of λ; `None` where nothing is known of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ends {
    /// The least of the sides' lower ends, where every side has one.
    pub lower: Option<End>,
    /// The least of the upper ends: it holds for the wall whatever the other side does.
    pub upper: Option<End>,
}

impl Ends {
    /// The range, where it has both ends.
    pub fn bracket(&self) -> Option<Bracket> {
        let (lower, upper) = (self.lower?.lambda, self.upper?.lambda);
        Some(Bracket { lower, upper })
    }

    /// The ends of the reaction that λ is the change of.
    pub(super) fn read(self, reaction: &Reaction) -> Self {
        let end = |end: End, outwards: f64| End {
            lambda: reaction.at(end.lambda),
            outwards: end.outwards.map(|_| outwards),
            ..end
        };
        let (lower, upper) = match reaction.sense {
            Sense::Against => (self.lower, self.upper),
            Sense::Away => (self.upper, self.lower),
        };
        Self {
            lower: lower.map(|lower| end(lower, -1.0)),
            upper: upper.map(|upper| end(upper, 1.0)),
        }
    }

    /// The same, where both are one number to the printed digits, which stands for both, to the nearest.
    pub(super) fn one_to_the_nearest(self) -> Self {
        let nine = |end: Option<End>| end.map(|end| nine_digits(end.lambda));
        if nine(self.lower) != nine(self.upper) {
            return self;
        }
        let nearest = |end: End| End {
            outwards: None,
            ..end
        };
        Self {
            lower: self.lower.map(nearest),
            upper: self.upper.map(nearest),
        }
    }
}

/// One side's direction and answer.
pub(super) type Side<'a> = (Push, &'a Outcome);

/// Whether a side leaves the wall without a lower end: it has no answer, and may be the weaker.
pub(super) fn is_unanswered(outcome: &Outcome) -> bool {
    outcome.bracket().is_none() && !matches!(outcome.status, Status::Stands | Status::Falls)
}

/// The wall's range: the least of the lower ends, and the least of the upper ends.
pub(super) fn ends((push, outcome): Side, other: Option<Side>) -> Ends {
    // It falls whichever way it is pushed.
    if outcome.status == Status::Falls {
        return Ends::default();
    }
    let of = |(push, outcome): Side| {
        let bracket = outcome.bracket();
        let bounds = outcome.evidence.bounds();
        let bounds = bounds.map(|is_bound| is_bound && outcome.status != Status::Estimate);
        let end = |lambda: f64, is_bound: bool, sign: f64| End {
            lambda,
            push,
            outwards: is_bound.then_some(sign),
        };
        [
            bracket.map(|b| end(b.lower, bounds[0], -1.0)),
            bracket.map(|b| end(b.upper, bounds[1], 1.0)),
        ]
    };
    let own = of((push, outcome));
    let [lower, upper] = match other {
        None => own,
        Some(other) => {
            let others = of(other);
            let unknown = [outcome, other.1].into_iter().any(is_unanswered);
            let ends = [0, 1].map(|place| least(own[place], others[place]));
            [ends[0].filter(|_| !unknown), ends[1]]
        }
    };
    Ends { lower, upper }
}

/// The least of two ends, of equal ones the first.
fn least(one: Option<End>, other: Option<End>) -> Option<End> {
    match (one, other) {
        (Some(a), Some(b)) if b.lambda < a.lambda => Some(b),
        (Some(a), _) => Some(a),
        (None, b) => b,
    }
}
