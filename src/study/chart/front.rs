//! The Pareto front of time and error.

use super::measurement::Measurement;
use super::reference::DIGITS;

/// Errors below this count as it: the references have six digits.
pub const FLOOR: f64 = DIGITS;

/// How much smaller an error must be to be worth more time: the rest is noise of the clock.
const BETTER: f64 = 0.9;

/// Members of the front: of the entries that vouch for themselves, those that no other one beats in both
/// time and error, fastest first.
pub fn front<'a>(entries: &[&'a Measurement]) -> Vec<&'a Measurement> {
    let mut answered: Vec<(&'a Measurement, f64)> = (entries.iter())
        .filter(|entry| entry.vouches())
        .filter_map(|entry| Some((*entry, entry.error()?)))
        .collect();
    answered.sort_by(|(a, x), (b, y)| a.row.seconds.total_cmp(&b.row.seconds).then(x.total_cmp(y)));
    let mut best = f64::INFINITY;
    answered.retain(|(_, error)| {
        // What is exact to the references' digits cannot be beaten by more digits.
        let better = *error < BETTER * best && best > FLOOR;
        if better {
            best = *error;
        }
        better
    });
    answered.into_iter().map(|(entry, _)| entry).collect()
}
