//! Methods that lie below the lowest verified state: a search finds states and no bounds, so that a
//! lower state may exist wherever somebody says so.

use super::claims::{Answered, Claims, Role};
use super::outside::{excluding, is_impossible};

/// An answer below the lowest state that another verifies.
#[derive(Clone, Debug, PartialEq)]
pub struct LowerState {
    /// Who gave it.
    pub by: String,
    /// Its multiplier.
    pub lambda: f64,
    /// Decimals that it holds.
    pub decimals: usize,
    /// How far below the lowest verified state that is, relative to that one.
    pub below: f64,
    /// Whether it is verified too: then a lower state does exist.
    pub is_verified: bool,
}

/// Error of a number without a proof that states none: what four digits hold.
pub(super) const UNSTATED_ERROR: f64 = 1e-4;

/// What an iteration that has converged may still be off by, below: λ moved by no more than 1e-4 in
/// each of its last three steps. What it states beyond that is a bias upwards.
pub(super) const CONVERGED_ERROR: f64 = 3e-4;

/// Every answer below `lowest` by more than its stated error.
pub(super) fn lower_states(claims: &Claims, lowest: &Answered) -> Vec<LowerState> {
    let others = claims.answered.iter();
    let others = others.filter(|other| other.name != lowest.name);
    // What no multiplier can be tells of no state.
    let others =
        others.filter(|other| !is_impossible(claims, other) && excluding(claims, other).is_none());
    let heard = others.filter_map(|other| {
        let (lambda, error) = heard(claims, other)?;
        let least = lowest.bracket.lower;
        claims.is_below(lambda, error, least).then(|| LowerState {
            by: other.name.to_owned(),
            lambda,
            decimals: match other.role {
                Role::Converged | Role::Number => 4,
                _ => 5,
            },
            below: -claims.excess(lambda, least),
            is_verified: other.has_state(),
        })
    });
    heard.collect()
}

/// The collapse multiplier that an answer speaks of, and its error relative to that; `None` where it
/// speaks of none.
fn heard(claims: &Claims, answer: &Answered) -> Option<(f64, f64)> {
    let (bracket, stated) = (answer.bracket, answer.outcome.evidence.stated_error());
    if answer.has_state() {
        return Some((bracket.lower, claims.proof_slack(bracket.lower)));
    }
    match answer.role {
        Role::Converged => Some((bracket.upper, CONVERGED_ERROR)),
        Role::Number => Some((bracket.upper, stated.unwrap_or(UNSTATED_ERROR))),
        // With head joints in contact it is a range over several pushovers, of which the weakest
        // collapsed at its lower end; else the load that collapsed is the upper end.
        Role::Observed => Some(match claims.heads_touch {
            true => (bracket.lower, stated?),
            false => (bracket.upper, stated?),
        }),
        Role::ClosedForm | Role::Bounds | Role::Loose | Role::States | Role::Enclosure => None,
    }
}
