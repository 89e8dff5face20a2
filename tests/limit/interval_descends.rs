//! Starts of the interval's search are followed down: few of them reach the lowest states that an
//! independent code found with many.

use crate::scenes::{laid, running_bond, small_walls};
use trilith::answer::Status;
use trilith::judge::judge;
use trilith::method::limit::Interval;
use trilith::method::{Method, Settings};
use trilith::scene::{HeadJoints, Own, Piece, Push, Wall};

/// Lowest collapse states with head joints in contact: HiGHS, `tests/reference/recompute.py`.
const LOWEST: [(&str, f64); 2] = [("paper-1", 0.638982), ("paper-2", 0.557416)];

/// The lowest state of a wall that so many starts reach, which is verified.
fn lowest(wall: &Wall, head_joints: HeadJoints, starts: usize) -> f64 {
    let scene = laid(wall, head_joints);
    let mut settings = Settings::default();
    settings.interval.starts = starts;
    let mut outcome = Interval.solve(&scene, &settings);
    judge(&scene, &mut outcome);
    assert_eq!(outcome.status, Status::Verified, "{}", outcome.reason());
    outcome.bracket().expect("a state is found").lower
}

/// 24 courses of 16 units, whose crack by the macro-block model (0.7513) is about as flat as the stagger
/// (0.75): the gap of the first start fell to 1.6e-7 in 40 programs, none of 11 starts closed it, and nothing was
/// found. A pushover collapses between 0.38640 and 0.38670 with 0.5 % stated; λ_A is 0.38798.
#[test]
fn a_gap_that_closes_slowly_is_closed() {
    let courses = [vec![Piece::Unit; 16], {
        let units = vec![Piece::Unit; 15];
        [vec![Piece::Half], units, vec![Piece::Half]].concat()
    }];
    let wall = Wall {
        unit_length: 1.5,
        unit_height: 1.0,
        thickness: 1.0,
        unit_weight: 1.0,
        courses: courses.iter().cycle().take(24).cloned().collect(),
        friction: 0.752.into(),
        overburden: 0.0,
        push: Push::Right,
        own: Own::default(),
    };
    let lower = lowest(&wall, HeadJoints::Open, 1);
    assert!((0.3864..0.387_98).contains(&lower), "{lower}");
}

/// 34 courses of 18 units of 1.5 x 1: the gap of the first start falls by less than half at a time, down to 4e-9, and
/// was open after 150 frozen programs, as those of 15 more starts were. States are known from 0.36999 to 0.37296; λ_A is
/// 0.37327.
#[test]
fn a_gap_that_falls_by_less_than_half_is_closed() {
    let wall = Wall {
        unit_length: 1.5,
        ..running_bond(34, 18, 0.7)
    };
    let lower = lowest(&wall, HeadJoints::Open, 1);
    assert!((0.3699..0.373_27).contains(&lower), "{lower}");
}

/// 36 courses of 18 units of 2 x 1: in the part that the crack can reach no start closed its gap, and the search
/// ended there. 36 courses of 16 and of 20 units have their lowest states at 0.421344 and 0.421345.
#[test]
fn a_larger_part_is_searched_where_a_part_closes_no_gap() {
    let wall = Wall {
        unit_length: 2.0,
        ..running_bond(36, 18, 0.65)
    };
    let lower = lowest(&wall, HeadJoints::Open, 4);
    assert!((lower - 0.421_344_5).abs() < 1e-5, "{lower}");
}

#[test]
fn eight_starts_reach_the_lowest_known_states() {
    for (name, known) in LOWEST {
        let walls = small_walls();
        let (_, wall) = walls
            .iter()
            .find(|(of, _)| *of == name)
            .expect("it is small");
        let lower = lowest(wall, HeadJoints::Contact, 8);
        let error = (lower - known).abs() / known;
        assert!(error <= 1e-5, "{name}: {lower} for {known}");
    }
}
