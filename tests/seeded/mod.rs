//! The one configuration of property suites.

use proptest::prelude::ProptestConfig;
use proptest::test_runner::RngSeed;

/// So many cases from this seed, which is printed where a test fails: the same ones in every run,
/// because a test that fails now and then helps nobody. One that fails is kept as a test of its own.
pub fn seeded(seed: u64, cases: u32) -> ProptestConfig {
    println!("seed {seed}, {cases} cases");
    ProptestConfig {
        cases,
        rng_seed: RngSeed::Fixed(seed),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}
