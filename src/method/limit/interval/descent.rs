//! From a start to a collapse state, and down from there.

use super::search::{Search, State};
use super::starts::Start;
use crate::answer::SearchFailure;

/// The states that a start leads to, of the scene that is searched.
pub(super) struct Branch {
    pub(super) first: State,
    pub(super) lowest: State,
    /// The highest one of the lowest one's mechanism.
    pub(super) highest: State,
}

/// Smallest relative decrease of λ that counts as one.
const LEAST_DECREASE: f64 = 1e-7;

/// Largest number of steps without a decrease after which a descent ends, plus one.
const MAX_IDLE_STEPS: usize = 12;

/// From a start to a state, then down: the lowest state of each mechanism, and on to a neighbour of
/// that mechanism until λ stops falling or is below `stop_below`. With one start the descent ends at
/// the first mechanism; the more of the `starts` there are, the more steps each may take in vain.
pub(super) fn descend(
    search: &mut Search,
    start: Start,
    starts: usize,
    stop_below: f64,
) -> Result<Branch, SearchFailure> {
    let first = search.close(start.normal, start.approach)?;
    let mut lowest = search.extreme_of(&first, -1.0);
    let idle_limit = starts.min(MAX_IDLE_STEPS);
    let (mut idle, mut step) = (0, 0);
    while idle + 1 < idle_limit && step < 6 * idle_limit && lowest.lambda > stop_below {
        match search.neighbour(&lowest, step) {
            Some(next) if next.lambda < lowest.lambda * (1.0 - LEAST_DECREASE) => {
                lowest = next;
                idle = 0;
            }
            _ => idle += 1,
        }
        step += 1;
    }
    Ok(Branch {
        highest: search.extreme_of(&lowest, 1.0),
        first,
        lowest,
    })
}
