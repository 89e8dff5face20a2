//! What must hold on any coursed wall with gaps that stands.

use crate::scenes;

use crate::scenes::{laid, mirrored, scaled, shifted};
use crate::seeded::seeded;
use proptest::prelude::*;
use trilith::answer::{
    CollapseResidual, CollapseState, Mechanism, Outcome, StaticResidual, Status,
};
use trilith::inside::dead_power;
use trilith::judge::judge;
use trilith::method::limit::{Associative, Interval};
use trilith::method::{Method, Settings};
use trilith::scene::{Course, HeadJoints, Piece, Scene, Vector, Wall};

/// Running bond with units left out of any course but the first and the last, ends excepted; gaps
/// may lie above one another, so some of these walls fall.
fn walls(
    courses: std::ops::Range<usize>,
    units: std::ops::Range<usize>,
    gap_every: u32,
) -> impl Strategy<Value = Wall> {
    let gaps = proptest::collection::vec(0..gap_every, 400);
    (courses, units, 0.1..1.2f64, 0.8..3.0f64, 0.0..2.0f64, gaps).prop_map(
        |(courses, units, friction, length, overburden, gaps)| {
            let mut wall = scenes::running_bond(courses, units, friction);
            wall.unit_length = length;
            wall.overburden = overburden;
            let mut draw = gaps.into_iter().cycle();
            for course in &mut wall.courses[1..courses - 1] {
                leave_out(course, || draw.next() == Some(0));
            }
            wall
        },
    )
}

/// No two gaps beside each other.
fn leave_out(course: &mut Course, mut is_gap: impl FnMut() -> bool) {
    for k in 1..course.len() - 1 {
        let free = course[k] == Piece::Unit && course[k - 1] != Piece::Gap;
        if is_gap() && free {
            course[k] = Piece::Gap;
        }
    }
}

fn heads() -> impl Strategy<Value = HeadJoints> {
    prop_oneof![Just(HeadJoints::Contact), Just(HeadJoints::Open)]
}

/// With few starts: what is asserted here holds for every state that is found.
fn judged(method: &dyn Method, scene: &Scene) -> Outcome {
    let mut settings = Settings::default();
    settings.interval.starts = 4;
    let mut outcome = method.solve(scene, &settings);
    judge(scene, &mut outcome);
    outcome
}

/// λ_A, or `None` of a wall that is proved to fall.
fn multiplier(scene: &Scene) -> Option<f64> {
    let outcome = judged(&Associative, scene);
    match outcome.status {
        Status::Verified => Some(outcome.bracket().expect("verified with a bracket").upper),
        Status::Falls => None,
        status => panic!("{}: {}", status.name(), outcome.reason()),
    }
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 2e-6 * a.abs().max(1e-3)
}

/// Live power (λ = 1) of a mechanism, summed here and not by the crate.
fn live_power(scene: &Scene, mechanism: &Mechanism) -> f64 {
    let blocks = scene.blocks().iter().zip(&mechanism.motions);
    let powers = blocks.flat_map(|(block, motion)| {
        let centroid = block.shape.centroid();
        block
            .loads
            .iter()
            .map(move |load| load.live.dot(&motion.at(load.point - centroid)))
    });
    powers.sum()
}

/// Both sides of the gap of a state: Σ μN|slip| − f_D·u − λ, and Σ n·opening + Σ (μN|slip| + t·slip),
/// for f_L·u = 1.
fn gap_sides(scene: &Scene, state: &CollapseState) -> (f64, f64) {
    let unit = live_power(scene, &state.mechanism);
    let rates = state.mechanism.joint_rates(scene);
    let (mut capacity, mut violation) = (0.0, 0.0);
    for ((joint, force), rate) in scene.joints().iter().zip(&state.forces).zip(&rates) {
        let [n1, n2] = force.normal;
        let friction = joint.friction * (n1 + n2) * rate.slip.abs();
        capacity += friction;
        violation += n1 * rate.opening[0] + n2 * rate.opening[1];
        violation += friction + force.shear * rate.slip;
    }
    let dead = dead_power(scene, &state.mechanism);
    ((capacity - dead) / unit - state.lambda, violation / unit)
}

proptest! {
    #![proptest_config(seeded(2026, 24))]

    /// λ(μ = 0) ≤ lowest ≤ highest ≤ λ_A, every state to 1e-8, the gap identity to 1e-9
    /// or the work of what is left of equilibrium. A state may
    /// lie above λ_A by what its residual allows: 1e-8 of the unit of λ, beside 1e-6 of λ_A.
    #[test]
    fn intervals_lie_between_their_bounds(wall in walls(3..7, 3..6, 6), head in heads()) {
        let scene = laid(&wall, head);
        let Some(highest) = multiplier(&scene) else {
            prop_assert_eq!(judged(&Interval, &scene).status, Status::Falls);
            return Ok(());
        };
        let smooth = laid(&Wall { friction: 0.0.into(), ..wall }, head);
        let outcome = judged(&Interval, &scene);
        prop_assert_eq!(outcome.status, Status::Verified, "{}", outcome.reason());
        let bracket = outcome.bracket().expect("verified with a bracket");
        prop_assert!(bracket.lower <= bracket.upper);
        let slack = 1e-6 * highest + 1e-8 * scene.multiplier_unit();
        prop_assert!(bracket.upper <= highest + slack, "{bracket:?} above {highest}");
        // Without friction a standing wall may fall; then there is nothing to compare.
        if let Some(lowest) = multiplier(&smooth) {
            prop_assert!(bracket.lower >= lowest - 1e-9, "{bracket:?} below {lowest}");
        }
        for state in outcome.evidence.states() {
            let statics = StaticResidual::of(&scene, &state.forces, state.lambda).largest();
            let collapse = CollapseResidual::of(&scene, &state.forces, &state.mechanism).largest();
            prop_assert!(statics <= 1e-8 && collapse <= 1e-8, "{statics} {collapse}");
            let (left, right) = gap_sides(&scene, state);
            // The sides differ by the work of what is left of equilibrium.
            let motions = state.mechanism.motions.iter();
            let speeds = motions.map(|m| m.velocity.norm() + m.rotation.abs() * scene.height());
            let live = live_power(&scene, &state.mechanism);
            let work = statics * scene.total_weight() * speeds.sum::<f64>() / live;
            prop_assert!((left - right).abs() <= work.max(1e-9), "{left} {right} {work}");
            prop_assert!(left.abs() <= 1e-8);
        }
    }

    #[test]
    fn units_place_and_side_leave_any_wall(wall in walls(2..7, 2..6, 5), head in heads(), length in -3i32..4, weight in -6i32..7, far in -1e6..1e6f64) {
        let scene = laid(&wall, head);
        let one = multiplier(&scene);
        let others = [
            mirrored(&scene),
            scaled(&scene, 10f64.powi(length), 10f64.powi(weight)),
            shifted(&scene, Vector::new(far, -far)),
        ];
        for other in others {
            match (one, multiplier(&other)) {
                (Some(a), Some(b)) => prop_assert!(close(a, b), "{a} {b}"),
                (a, b) => prop_assert_eq!(a, b),
            }
        }
    }

    /// More friction or more joints never lower λ_A, nor let a standing wall fall.
    #[test]
    fn friction_and_joints_only_add(wall in walls(2..7, 2..6, 5), more in 1.0..2.0f64) {
        let of = |wall: &Wall, head| multiplier(&laid(wall, head)).unwrap_or(f64::NEG_INFINITY);
        let lambda = of(&wall, HeadJoints::Contact);
        prop_assert!(of(&wall, HeadJoints::Open) <= lambda * (1.0 + 2e-6));
        let rougher = Wall { friction: wall.friction.times(more), ..wall };
        prop_assert!(of(&rougher, HeadJoints::Contact) >= lambda * (1.0 - 2e-6));
    }
}

proptest! {
    #![proptest_config(seeded(2026, 5))]

    /// A part of a wall of 200 and more blocks gives the same λ_A as the whole of it, to 1e-6, and
    /// its forces and mechanism are judged on the whole.
    #[test]
    fn reduction_gives_the_answer_of_the_whole(wall in walls(10..13, 22..28, 12)) {
        let scene = laid(&wall, HeadJoints::Open);
        prop_assert!(scene.blocks().len() >= 200);
        // Without the coursing there is no stagger line to cut along.
        let whole = scene.clone().without_wall();
        let (a, b) = (judged(&Associative, &scene), judged(&Associative, &whole));
        prop_assert_eq!(a.status, b.status);
        if let (Some(a), Some(b)) = (a.bracket(), b.bracket()) {
            prop_assert!(close(a.upper, b.upper), "{a:?} {b:?}");
        }
        prop_assert_eq!(b.status == Status::Falls || b.work.modelled == whole.blocks().len(), true);
        let outcome = judged(&Interval, &scene);
        prop_assert!(outcome.status == a.status || outcome.status == Status::Undecided, "{}", outcome.reason());
    }
}
