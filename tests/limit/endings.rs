//! Scenes that fall under their own weight and scenes that no push collapses, each with its proof.

use crate::scenes::{arch, ground, homogeneous, mirrored, polygon, rectangle, scene};
use trilith::answer::{Evidence, JointForce, Motion, Outcome, StaticResidual, Status};
use trilith::inside::falling_violation;
use trilith::judge::judge;
use trilith::method::limit::{Associative, Interval, Sequential};
use trilith::method::{Method, Settings};
use trilith::scene::{Scene, Vector};

const METHODS: [&dyn Method; 3] = [&Associative, &Sequential, &Interval];

fn judged(method: &dyn Method, scene: &Scene) -> Outcome {
    let mut outcome = method.solve(scene, &Settings::default());
    judge(scene, &mut outcome);
    outcome
}

/// Every method says so, and the proof holds afresh, to 1e-8.
fn assert_falls(scene: &Scene) {
    for method in METHODS {
        let outcome = judged(method, scene);
        assert_eq!(
            outcome.status,
            Status::Falls,
            "{}: {}",
            method.name(),
            outcome.reason()
        );
        assert!(outcome.bracket().is_none());
        let mechanism = outcome.evidence.mechanism().expect("with a mechanism");
        assert!(falling_violation(scene, mechanism) <= 1e-8);
    }
}

/// Every method says so, and forces + λ · ray is a state for small and for large λ, to 1e-8.
fn assert_stands(scene: &Scene) {
    assert_proved_to_stand(scene, &METHODS);
}

/// Friction locks the scene: with dilatancy it is proved to stand. Without, there are mechanisms, so
/// that no ray proves it; there is no state to be found either, and the interval's certificate proves that there is
/// none.
fn assert_locks(scene: &Scene) {
    assert_proved_to_stand(scene, &[&Associative, &Interval]);
    let [by_iteration, by_search] = [METHODS[1], METHODS[2]].map(|method| judged(method, scene));
    assert_eq!(by_iteration.status, Status::Undecided);
    assert!(by_iteration.bracket().is_none());
    assert!(by_search.evidence.certificate().is_some());
}

fn assert_proved_to_stand(scene: &Scene, methods: &[&dyn Method]) {
    for method in methods {
        let outcome = judged(*method, scene);
        assert_eq!(
            outcome.status,
            Status::Stands,
            "{}: {}",
            method.name(),
            outcome.reason()
        );
        let forces = outcome.evidence.forces().expect("with forces").1;
        let Evidence::Stands { ray, .. } = &outcome.evidence else {
            panic!("without a ray");
        };
        for lambda in [0.0, 0.5, 100.0] {
            let sum = forces.iter().zip(ray).map(|(f, r)| JointForce {
                normal: [0, 1].map(|k| f.normal[k] + lambda * r.normal[k]),
                shear: f.shear + lambda * r.shear,
            });
            let sum: Vec<_> = sum.collect();
            let residual = StaticResidual::of(scene, &sum, lambda).largest();
            assert!(residual <= 1e-8 * (1.0 + lambda), "{residual}");
        }
    }
}

/// λ_A, verified.
fn multiplier(scene: &Scene) -> f64 {
    let outcome = judged(&Associative, scene);
    assert_eq!(outcome.status, Status::Verified, "{}", outcome.reason());
    outcome.bracket().expect("verified with a bracket").upper
}

/// Unit squares, each `step` further to the right than the one below.
fn leaning(step: f64, count: u32) -> Scene {
    let block = |k: u32| {
        let (x, y) = (step * f64::from(k), f64::from(k));
        homogeneous(rectangle(x, x + 1.0, y, y + 1.0))
    };
    scene((0..count).map(block).collect(), vec![ground()], 0.7)
}

/// The upper j blocks of such a stack have their centre (j + 1)/2 steps from the centre of the block
/// below, and the whole one 3/2 steps from the bottom block's; each part tips at 1/2. So the upper
/// three go first, at a step of 1/4. Exact statics.
#[test]
fn leaning_stacks_fall_beyond_a_quarter() {
    for step in [0.4, 0.251, 0.2501, 0.25 + 1e-6] {
        assert_falls(&leaning(step, 4));
        // A push to the right would hold this one.
        assert_falls(&leaning(-step, 4));
    }
    for step in [0.1, 0.249, 0.2499, 0.25 - 1e-6] {
        let part = |j: f64| (0.5 - (j + 1.0) / 2.0 * step) / (j / 2.0);
        let whole = (0.5 - 1.5 * step) / 2.0;
        let exact = whole.min(part(1.0)).min(part(2.0)).min(part(3.0));
        let lambda = multiplier(&leaning(step, 4));
        assert!((lambda - exact).abs() < 1e-8, "{lambda} {exact}");
        assert!(multiplier(&leaning(-step, 4)) > lambda);
    }
    // On the very threshold either answer is right.
    let outcome = judged(&Associative, &leaning(0.25, 4));
    assert!(matches!(outcome.status, Status::Falls | Status::Verified));
}

/// Statics: the upper block's centre is 0.1 beyond its bed.
#[test]
fn an_overhanging_block_falls() {
    let below = homogeneous(rectangle(0.0, 1.0, 0.0, 1.0));
    let above = |x: f64| homogeneous(rectangle(x, x + 1.2, 1.0, 2.0));
    assert_falls(&scene(vec![below.clone(), above(0.5)], vec![ground()], 0.7));
    let stable = scene(vec![below, above(0.3)], vec![ground()], 0.7);
    assert!(
        (multiplier(&stable) - 0.2).abs() < 1e-8,
        "the upper one tips: 0.1 / 0.5"
    );
}

/// A block that touches nothing below falls, whatever pushes it.
#[test]
fn a_block_without_support_falls() {
    let block = || homogeneous(rectangle(0.0, 1.0, 0.0, 1.0));
    let side = rectangle(1.0, 2.0, 0.0, 1.0);
    assert_falls(&scene(vec![block()], vec![side], 0.7));
    assert_falls(&scene(
        vec![block()],
        vec![rectangle(0.0, 1.0, 1.0, 2.0)],
        0.7,
    ));
}

/// Between two walls every push is carried; off the ground, friction at the walls carries it too.
#[test]
fn blocks_between_supports_stand() {
    let block = || homogeneous(rectangle(0.0, 1.0, 0.0, 1.0));
    let walls = || {
        vec![
            rectangle(-1.0, 0.0, 0.0, 2.0),
            rectangle(1.0, 2.0, 0.0, 2.0),
        ]
    };
    let on_ground = [walls(), vec![ground()]].concat();
    assert_stands(&scene(vec![block()], on_ground, 0.7));
    assert_stands(&scene(vec![block()], walls(), 0.7));
    // Without friction nothing holds it between the walls.
    assert_falls(&scene(vec![block()], walls(), 0.0));
}

/// A wedge that is pushed up a plane of 60°: λ = tan(60° + φ), and for φ ≥ 30° it locks.
#[test]
fn a_wedge_climbs_until_friction_locks_it() {
    let slope = 60f64.to_radians();
    let rise = slope.tan();
    let ramp = |friction: f64| {
        let wedge = polygon(&[(0.0, 0.0), (1.0, 0.0), (1.0 + 1.0 / rise, 1.0), (0.0, 1.0)]);
        let plane = polygon(&[(1.0, 0.0), (3.0, 0.0), (3.0, 2.0 * rise)]);
        scene(vec![homogeneous(wedge)], vec![ground(), plane], friction)
    };
    for friction in [0.0, 0.2, 0.5, 0.57] {
        let lambda = multiplier(&ramp(friction));
        let exact = (slope + friction.atan()).tan();
        assert!((lambda / exact - 1.0).abs() < 1e-6, "{lambda} {exact}");
    }
    let lock = 1.0 / rise;
    for friction in [lock * (1.0 + 1e-4), 0.6, 1.0] {
        assert_locks(&ramp(friction));
    }
    // Just below, λ is large but finite.
    let lambda = multiplier(&ramp(lock * (1.0 - 1e-4)));
    let exact = (slope + (lock * (1.0 - 1e-4)).atan()).tan();
    assert!((lambda / exact - 1.0).abs() < 1e-6, "{lambda} {exact}");
}

/// A load that pushes straight down, or none, collapses nothing.
#[test]
fn a_harmless_load_leaves_the_scene_standing() {
    let mut block = homogeneous(rectangle(0.0, 1.0, 0.0, 1.0));
    for live in [Vector::new(0.0, -3.0), Vector::new(0.0, 0.0)] {
        block.loads[0].live = live;
        assert_stands(&scene(vec![block.clone()], vec![ground()], 0.7));
    }
}

/// Falling has no left and right.
#[test]
fn mirrored_scenes_end_alike() {
    assert_falls(&mirrored(&leaning(0.4, 4)));
    assert_falls(&mirrored(&arch(0.1, 180.0, 9, 10.0)));
}

fn motions_of(falling: &mut Outcome) -> &mut [Motion] {
    match &mut falling.evidence {
        Evidence::Falls { mechanism } => &mut mechanism.motions,
        other => panic!("{other:?}"),
    }
}

/// The judge takes no word for it: a spoiled mechanism or ray is refuted, none at all is undecided.
#[test]
fn the_judge_refutes_spoiled_proofs() {
    let falling = leaning(0.4, 4);
    let proof = Associative.solve(&falling, &Settings::default());
    let mut spoiled = proof.clone();
    let motions = motions_of(&mut spoiled);
    motions[3].rotation += 1e-3 * motions[3].velocity.norm();
    judge(&falling, &mut spoiled);
    assert_eq!(spoiled.status, Status::Failed);
    let mut nan = proof.clone();
    motions_of(&mut nan)[0].rotation = f64::NAN;
    judge(&falling, &mut nan);
    assert_eq!(nan.status, Status::Failed);
    let mut none = Outcome {
        evidence: Evidence::Nothing,
        ..proof
    };
    judge(&falling, &mut none);
    assert_eq!(none.status, Status::Undecided);

    let walls = vec![
        rectangle(-1.0, 0.0, 0.0, 2.0),
        rectangle(1.0, 2.0, 0.0, 2.0),
    ];
    let block = homogeneous(rectangle(0.0, 1.0, 0.0, 1.0));
    let locked = scene(vec![block], walls, 0.7);
    let proof = Associative.solve(&locked, &Settings::default());
    let mut spoiled = proof.clone();
    let Evidence::Stands { ray, .. } = &mut spoiled.evidence else {
        panic!("without a ray");
    };
    ray[1].shear += 1e-3;
    judge(&locked, &mut spoiled);
    assert_eq!(spoiled.status, Status::Failed);
    let mut none = Outcome {
        evidence: Evidence::Nothing,
        ..proof
    };
    judge(&locked, &mut none);
    assert_eq!(none.status, Status::Undecided);
}
