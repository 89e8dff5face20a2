//! Crack slopes of the pushover beside those of verified mechanisms, on random coursed walls.

use crate::random::Random;
use crate::share::share;
use trilith::answer::{Bracket, Crack, Status};
use trilith::judge::judge;
use trilith::method::limit::{Associative, Interval};
use trilith::method::pushover::Pushover;
use trilith::method::{Method, Settings};
use trilith::scene::{HeadJoints, Own, Piece, Push, Scene, Wall};

/// A wall in running bond, with an opening or an overburden in every third.
fn wall(seed: u64) -> Scene {
    let mut random = Random(seed.wrapping_mul(0x2545_F491_4F6C_DD1D));
    let units = 2 + random.below(5);
    let courses = 3 + random.below(10);
    let opening = random.one_in(3) && units >= 4 && courses >= 5;
    let gap = 1 + random.below(units.max(3) - 2);
    let sill = 1 + random.below(courses - 2);
    let course = |course: usize| {
        let odd = course % 2 == 1;
        let open = opening && !odd && (sill..courses - 2).contains(&course);
        let pieces = (0..units - usize::from(odd)).map(|at| match open && at == gap {
            true => Piece::Gap,
            false => Piece::Unit,
        });
        let ends = odd.then_some(Piece::Half);
        ends.into_iter().chain(pieces).chain(ends).collect()
    };
    let wall = Wall {
        courses: (0..courses).map(course).collect(),
        unit_length: random.between(1.0, 4.0),
        unit_height: 1.0,
        thickness: 1.0,
        unit_weight: 1.0,
        friction: random.between(0.2, 0.9).into(),
        overburden: match random.one_in(3) {
            true => random.between(0.1, 10.0) / courses as f64,
            false => 0.0,
        },
        push: Push::Right,
        own: Own::default(),
    };
    wall.scene(HeadJoints::Open)
        .expect("whole units fill every course")
}

/// Whether two cracks have the same c and e, or neither method has one.
fn agree(one: Option<Crack>, other: Option<Crack>) -> bool {
    let near = |a: Option<f64>, b: Option<f64>| match (a, b) {
        (Some(a), Some(b)) => (a - b).abs() < 1e-6,
        (a, b) => a == b,
    };
    match (one, other) {
        (Some(one), Some(other)) => near(one.c, other.c) && near(one.e, other.e),
        (one, other) => one.is_none() && other.is_none(),
    }
}

/// Asserts that on nine in ten of these walls c and e are those of the verified mechanism, and on
/// nine in ten of the walls that rock, where there is one multiplier and not a range.
fn assert_cracks(seeds: std::ops::Range<u64>) {
    let settings = Settings::default();
    let (mut walls, mut same, mut rocking, mut same_rocking) = (0, 0, 0, 0);
    for seed in seeds {
        let scene = wall(seed);
        let judged = |method: &dyn Method| {
            let mut outcome = method.solve(&scene, &settings);
            judge(&scene, &mut outcome);
            (outcome.status == Status::Verified).then_some(outcome)
        };
        let (Some(state), Some(above)) = (judged(&Interval), judged(&Associative)) else {
            continue;
        };
        let [lower, upper] = [&state, &above].map(|of| of.bracket().map_or(f64::NAN, |b| b.lower));
        let narrow = upper - lower <= 0.01 * upper;
        let seen = Pushover.solve(&scene, &settings);
        let (Some(Bracket { .. }), true) = (seen.bracket(), narrow) else {
            continue;
        };
        let agrees = agree(seen.evidence.crack(&scene), state.evidence.crack(&scene));
        if !agrees {
            println!(
                "{seed}: {:?} for {:?}",
                seen.evidence.crack(&scene),
                state.evidence.crack(&scene)
            );
        }
        let rocks = state.evidence.crack(&scene).is_some();
        walls += 1;
        same += usize::from(agrees);
        rocking += usize::from(rocks);
        same_rocking += usize::from(agrees && rocks);
    }
    println!("{same} of {walls} walls agree, {same_rocking} of {rocking} that rock");
    assert!(10 * same >= 9 * walls, "{same} of {walls}");
    assert!(
        10 * same_rocking >= 9 * rocking,
        "{same_rocking} of {rocking}"
    );
    assert!(rocking > 0 && rocking < walls, "{rocking} of {walls} rock");
}

#[test]
fn cracks_are_those_of_verified_mechanisms() {
    assert_cracks(10..30);
}

#[test]
#[ignore = "minutes"]
fn cracks_of_many_walls_are_those_of_verified_mechanisms() {
    // With fewer than fifty, fewer than ten rock, of which nine in ten are all.
    assert_cracks(100..100 + share(100).max(50) as u64);
}
