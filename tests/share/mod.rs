//! How much of a long test runs.

/// How many of this number of scenes a long test takes: the share that `TRILITH_SHARE` says, from 0 to 1, and
/// one at least; all of them where it is not set. `.ci/run` sets it.
pub fn share(count: usize) -> usize {
    let share: f64 = std::env::var("TRILITH_SHARE").map_or(1.0, |share| {
        share
            .parse()
            .expect("TRILITH_SHARE is a number from 0 to 1")
    });
    ((count as f64 * share).ceil() as usize).clamp(1, count)
}
