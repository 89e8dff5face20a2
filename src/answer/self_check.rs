//! Self-checks of a pushover, as data.

use std::fmt;

use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::bracket::Bracket;
use crate::number::number;
use crate::text::worded;

/// A self-check that ran: a figure, and what it must not exceed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelfCheck {
    /// The variation that it is about, where an answer rests on several.
    pub variation: Option<Variation>,
    /// What is checked, and in which unit.
    pub what: Checked,
    /// The figure.
    pub value: f64,
    /// The largest figure that passes.
    pub limit: f64,
}

/// What a self-check is about, and the unit of its figure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Checked {
    /// Joints for which the engine has no contact with the right normal.
    UnseenJoints {
        /// Joints that the engine needs.
        of: usize,
    },
    /// Displacement under the own weight alone, in course heights.
    Settlement,
    /// Speed of the settled scene, in √(g·H_c).
    SettledSpeed,
    /// Sum of all loads and of what the supports carry, over the weight, once settled.
    SettledBalance,
    /// The same at the last load at rest.
    LastBalance,
    /// Displacement from the settled scene to the last load at rest, in course heights.
    Drift,
    /// Distance to the bracket of a pushover that must agree, over λ; infinite where that has none.
    Repetition {
        /// What differs in it.
        with: Repetition,
        /// Its bracket, or in words why it has none.
        answer: Result<Bracket, String>,
    },
}

worded! {
    /// What differs in a pushover that must agree with the first.
    #[derive(Serialize, Deserialize)]
    Repetition {
        /// Half the substep.
        HalfSubstep = "with half the substep",
        /// Left and right exchanged.
        Mirrored = "on the mirrored scene",
        /// Neither kinetic damping nor extrapolation.
        Undamped = "without damping",
    }
}

/// One of the pushovers over which an answer is a range.
#[derive(Clone, Copy, Debug, Error, PartialEq, Serialize, Deserialize)]
#[error(
    "on the {} with contact stiffness × {stiffness}",
    if *.mirrored { "mirrored scene" } else { "scene as it is" }
)]
pub struct Variation {
    /// Contact stiffness, as a multiple of what the substep allows.
    pub stiffness: f64,
    /// Whether left and right are exchanged.
    pub mirrored: bool,
}

impl SelfCheck {
    /// Whether the figure is as it must be; one that is no number is not.
    pub fn passed(&self) -> bool {
        self.value <= self.limit
    }
}

impl fmt::Display for SelfCheck {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { value, limit, .. } = self;
        if let Some(variation) = self.variation {
            write!(f, "{variation}: ")?;
        }
        let supports_miss = format_args!(
            "the supports miss the loads by {value:.1e} of the weight, and at most {limit:.0e} is \
             allowed"
        );
        match &self.what {
            Checked::UnseenJoints { of } => {
                let seen = *of as f64 - value;
                write!(f, "the engine sees {seen} of {of} joints")
            }
            Checked::Settlement => write!(
                f,
                "under its own weight the scene settled by {value:.1e} course heights, and at most \
                 {limit:.1e} is allowed"
            ),
            Checked::SettledSpeed => write!(
                f,
                "after settling the scene still moves at {value:.1e} √(g·H_c), and at most {limit:.0e} is \
                 allowed"
            ),
            Checked::SettledBalance => write!(f, "after settling {supports_miss}"),
            Checked::LastBalance => write!(f, "at the last load at rest {supports_miss}"),
            Checked::Drift => write!(
                f,
                "up to the last load at rest the scene moved by {value:.1e} course heights, and at most \
                 {limit:.2} is allowed"
            ),
            Checked::Repetition {
                with,
                answer: Ok(Bracket { lower, upper }),
            } => write!(
                f,
                "{} the pushover gives {} to {}, which is {value:.1e} of λ away, and at most {limit:.0e} \
                 is allowed",
                with.name(),
                number(*lower, 5),
                number(*upper, 5)
            ),
            Checked::Repetition {
                with,
                answer: Err(reason),
            } => write!(f, "{} the pushover has no answer: {reason}", with.name()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_stand_in_the_words() {
        let check = |what, value, limit| SelfCheck {
            variation: None,
            what,
            value,
            limit,
        };
        let unseen = check(Checked::UnseenJoints { of: 56 }, 2.0, 0.0);
        assert_eq!(unseen.to_string(), "the engine sees 54 of 56 joints");
        assert!(!unseen.passed());
        let balance = SelfCheck {
            variation: Some(Variation {
                stiffness: 0.5,
                mirrored: true,
            }),
            ..check(Checked::SettledBalance, 1.2e-6, 1e-4)
        };
        assert_eq!(
            balance.to_string(),
            "on the mirrored scene with contact stiffness × 0.5: after settling the supports miss the \
             loads by 1.2e-6 of the weight, and at most 1e-4 is allowed"
        );
        assert!(balance.passed() && !check(Checked::Drift, f64::NAN, 0.1).passed());
    }
}
