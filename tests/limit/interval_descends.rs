//! Starts of the interval's search are followed down: few of them reach the lowest states that an
//! independent code found with many.

use crate::scenes::{laid, small_walls};
use trilith::judge::judge;
use trilith::method::limit::Interval;
use trilith::method::{Method, Settings};
use trilith::scene::HeadJoints;

/// Lowest collapse states with head joints in contact: HiGHS, `tests/reference/recompute.py`.
const LOWEST: [(&str, f64); 2] = [("paper-1", 0.638982), ("paper-2", 0.557416)];

#[test]
fn eight_starts_reach_the_lowest_known_states() {
    for (name, known) in LOWEST {
        let walls = small_walls();
        let (_, wall) = walls
            .iter()
            .find(|(of, _)| *of == name)
            .expect("it is small");
        let scene = laid(wall, HeadJoints::Contact);
        let mut settings = Settings::default();
        settings.interval.starts = 8;
        let mut outcome = Interval.solve(&scene, &settings);
        judge(&scene, &mut outcome);
        let lower = outcome.bracket().expect("states are found").lower;
        let error = (lower - known).abs() / known;
        assert!(error <= 1e-5, "{name}: {lower} for {known}");
    }
}
