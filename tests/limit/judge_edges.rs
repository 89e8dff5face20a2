//! The judge on the edge: an answer that it verifies, and the same one with a single condition missed
//! by a thousandth. A block that slides, so that each condition is known by hand: λ = μ.

use crate::scenes::{laid, wall};
use trilith::answer::{Bracket, Ceiling, Evidence, ForceState, JointForce, Outcome, Status};
use trilith::judge::judge;
use trilith::method::limit::{Associative, Interval};
use trilith::method::{Method, Settings};
use trilith::scene::{HeadJoints, Scene};

const FRICTION: f64 = 0.3;

/// A thousandth.
const LITTLE: f64 = 1e-3;

/// A flat block on the ground.
fn block(friction: f64) -> Scene {
    laid(&wall(&["1"], friction), HeadJoints::Open)
}

fn answered(method: &dyn Method) -> Outcome {
    method.solve(&block(FRICTION), &Settings::default())
}

/// Forces and mechanism that bound λ_A.
fn bounds(outcome: &mut Outcome) -> (&mut ForceState, &mut Ceiling) {
    match &mut outcome.evidence {
        Evidence::Bounds { below, above, .. } => (below, above),
        other => panic!("{other:?}"),
    }
}

/// What the judge makes of an answer on a scene.
fn judged(scene: &Scene, mut outcome: Outcome) -> Status {
    judge(scene, &mut outcome);
    outcome.status
}

#[test]
fn what_is_right_is_verified() {
    for method in [&Associative as &dyn Method, &Interval] {
        let outcome = answered(method);
        let bracket = outcome.bracket().expect("a block slides");
        assert!((bracket.upper - FRICTION).abs() < 1e-9, "{bracket:?}");
        assert_eq!(judged(&block(FRICTION), outcome), Status::Verified);
    }
}

/// The same forces where the joint carries a thousandth less.
#[test]
fn a_shear_above_coulombs_law_is_refuted() {
    let smoother = block(FRICTION * (1.0 - LITTLE));
    for method in [&Associative as &dyn Method, &Interval] {
        assert_eq!(judged(&smoother, answered(method)), Status::Failed);
    }
}

/// The same mechanism where the flow rule asks for a thousandth more opening.
#[test]
fn a_mechanism_that_opens_too_little_is_refuted() {
    let scene = block(FRICTION * (1.0 + LITTLE));
    assert_eq!(judged(&scene, answered(&Associative)), Status::Failed);
}

/// The same state where a joint that slips does not take out what it can.
#[test]
fn a_slip_below_coulombs_law_is_refuted() {
    let scene = block(FRICTION * (1.0 + LITTLE));
    assert_eq!(judged(&scene, answered(&Interval)), Status::Failed);
}

/// Forces at rest and a mechanism bound λ_A, but not below what the mechanism says.
#[test]
fn an_upper_end_below_its_mechanism_is_refuted() {
    let scene = block(FRICTION);
    let mut outcome = answered(&Associative);
    let half = scene.total_weight() / 2.0;
    let mut with = |upper| {
        let (below, above) = bounds(&mut outcome);
        *below = ForceState {
            lambda: 0.0,
            forces: vec![JointForce {
                normal: [half, half],
                shear: 0.0,
            }],
        };
        above.lambda = upper;
        judged(&scene, outcome.clone())
    };
    assert_eq!(with(FRICTION * (1.0 + LITTLE)), Status::Bracketed);
    assert_eq!(with(FRICTION * (1.0 - LITTLE)), Status::Failed);
}

/// A block that is lifted at one corner by a thousandth of its weight.
#[test]
fn tension_and_loss_of_balance_are_refuted() {
    let scene = block(FRICTION);
    let weight = scene.total_weight();
    for [first, second] in [[LITTLE, -LITTLE], [-LITTLE, -LITTLE], [0.0, LITTLE]] {
        let mut outcome = answered(&Associative);
        let forces = &mut bounds(&mut outcome).0.forces;
        forces[0].normal[0] += first * weight;
        forces[0].normal[1] += second * weight;
        assert_eq!(judged(&scene, outcome), Status::Failed, "{first} {second}");
    }
    let mut outcome = answered(&Associative);
    let force = &mut bounds(&mut outcome).0.forces[0];
    let sum = force.normal[0] + force.normal[1];
    force.normal = [-LITTLE * weight, sum + LITTLE * weight];
    assert_eq!(judged(&scene, outcome), Status::Failed);
}

/// A collapse state at another multiplier than that of its forces.
#[test]
fn a_state_at_another_multiplier_is_refuted() {
    let scene = block(FRICTION);
    for factor in [1.0 - LITTLE, 1.0 + LITTLE] {
        let mut outcome = answered(&Interval);
        let Evidence::States { states, .. } = &mut outcome.evidence else {
            panic!("without states");
        };
        states[0].lambda *= factor;
        assert_eq!(judged(&scene, outcome), Status::Failed);
    }
}

/// A number that the judge could find to be a state is none where it is a range.
#[test]
fn a_state_of_two_multipliers_is_not_verified() {
    let scene = block(FRICTION);
    let outcome = answered(&Interval);
    let state = &outcome.evidence.states()[0];
    let with = |upper| {
        let evidence = Evidence::Number {
            bracket: Bracket {
                lower: state.lambda,
                upper,
            },
            stated_error: None,
            forces: Some(ForceState {
                lambda: state.lambda,
                forces: state.forces.clone(),
            }),
            mechanism: Some(state.mechanism.clone()),
        };
        judged(&scene, Outcome::with(Status::Estimate, evidence))
    };
    assert_eq!(with(state.lambda), Status::Verified);
    assert_eq!(with(state.lambda * (1.0 + LITTLE)), Status::Estimate);
}
