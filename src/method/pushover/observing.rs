//! Changes of what a pushover saw.

use crate::answer::{Observed, Outcome};

/// The outcome with a change of what was seen.
pub fn observing(mut outcome: Outcome, change: impl FnOnce(&mut Observed)) -> Outcome {
    let mut observed = outcome.evidence.into_observed();
    change(&mut observed);
    outcome.evidence = observed.into();
    outcome
}
