//! Relations between answers that are made up, on two blocks beside each other:
//! λ = 1 pushes with their weight.

use super::*;
use crate::answer::{Bracket, Evidence, Observed, Outcome, Standing, Status};
use crate::mechanics::{Ceiling, CollapseState, ForceState, Mechanism};
use crate::scene::{HeadJoints, Push, Scene, Wall};

fn scene(head_joints: HeadJoints) -> Scene {
    Wall::of_cubes(2, Push::Right).scene(head_joints).unwrap()
}

fn state_at(lambda: f64) -> CollapseState {
    CollapseState {
        lambda,
        forces: Vec::new(),
        mechanism: Mechanism::default(),
    }
}

fn bound(lambda: f64) -> Outcome {
    let evidence = Evidence::Bounds {
        below: ForceState {
            lambda,
            forces: Vec::new(),
        },
        above: Ceiling {
            lambda,
            mechanism: Mechanism::default(),
        },
    };
    Outcome::with(Status::Verified, evidence)
}

fn states(lower: f64, upper: f64) -> Outcome {
    let evidence = Evidence::States {
        states: [lower, upper].map(state_at).into(),
    };
    Outcome::with(Status::Verified, evidence)
}

fn number(lambda: f64) -> Outcome {
    stating(lambda, None)
}

fn stating(lambda: f64, stated_error: Option<f64>) -> Outcome {
    let evidence = Evidence::State {
        state: state_at(lambda),
        stated_error,
    };
    Outcome::with(Status::Estimate, evidence)
}

fn seen(lower: f64, upper: f64, stated_error: Option<f64>) -> Outcome {
    let observed = Observed {
        bracket: Some(Bracket { lower, upper }),
        stated_error,
        ..Observed::default()
    };
    Outcome::with(Status::Bracketed, Evidence::Observed(observed))
}

/// The verdicts about a method.
fn verdicts(scene: &Scene, answers: &[(&str, &Outcome)], method: &str) -> Vec<Verdict> {
    let checks = cross_check(scene, answers);
    let about = checks.iter().filter(|check| check.method == method);
    about.map(|check| check.verdict).collect()
}

fn worst(answers: &[(&str, &Outcome)], method: &str) -> Option<Verdict> {
    let verdicts = verdicts(&scene(HeadJoints::Open), answers, method);
    verdicts.into_iter().max()
}

/// Without dilatancy `stands` beside a state that the judge verified is a contradiction; with
/// associative friction it is explained.
#[test]
fn stands_beside_a_verified_state() {
    let scene = scene(HeadJoints::Contact);
    let state = states(0.4, 0.4);
    for (standing, expected) in [
        (Standing::WithoutFriction, Verdict::Violated),
        (Standing::Certified { certificate: None }, Verdict::Violated),
        (Standing::Associative, Verdict::Holds),
    ] {
        let evidence = Evidence::Stands {
            standing,
            at_rest: Vec::new(),
            ray: Vec::new(),
        };
        let stands = Outcome::with(Status::Stands, evidence);
        let answers = [("one", &stands), ("other", &state)];
        assert_eq!(verdicts(&scene, &answers, "one"), [expected]);
        let doubts = conclude(&scene, &answers).doubts;
        assert_eq!(doubts.is_empty(), expected == Verdict::Holds, "{doubts:?}");
    }
    let stands = Outcome::of(Status::Stands);
    let answers = [("one", &stands), ("other", &bound(0.4))];
    assert!(verdicts(&scene, &answers, "one").is_empty());
}

#[test]
fn a_number_above_the_bound_is_none() {
    let (bound, found) = (bound(0.5), states(0.45, 0.5));
    let with = |mine: &Outcome| {
        let answers = [
            ("associative", &bound),
            ("interval", &found),
            ("mine", mine),
        ];
        worst(&answers, "mine")
    };
    assert_eq!(with(&number(0.5)), Some(Verdict::Holds));
    assert_eq!(with(&number(0.47)), Some(Verdict::Holds));
    // Four digits, or a stated error, reach a little above.
    assert_eq!(with(&number(0.50002)), Some(Verdict::Marked));
    assert_eq!(with(&stating(0.505, Some(0.02))), Some(Verdict::Marked));
    assert_eq!(with(&number(0.525)), Some(Verdict::Violated));
    assert_eq!(with(&stating(0.525, Some(0.02))), Some(Verdict::Violated));
    for absurd in [-0.1, -1e12, 1e30] {
        assert_eq!(with(&number(absurd)), Some(Verdict::Violated), "{absurd}");
    }
    // Below the lowest verified state it may be right: the search found states, and no bounds.
    assert_eq!(with(&number(0.3)), Some(Verdict::Marked));
}

#[test]
fn absurd_numbers_are_seen_without_a_bound() {
    for absurd in [-0.1, 1e30] {
        let mine = number(absurd);
        assert_eq!(worst(&[("mine", &mine)], "mine"), Some(Verdict::Violated));
    }
    assert_eq!(worst(&[("mine", &number(7.0))], "mine"), None);
}

#[test]
fn who_lies_lower_is_heard() {
    let (bound, found) = (bound(0.5), states(0.45, 0.5));
    let heard = |head_joints, name: &str, outcome: &Outcome| {
        let answers = [
            ("associative", &bound),
            ("interval", &found),
            (name, outcome),
        ];
        let scene = scene(head_joints);
        let doubts = conclude(&scene, &answers).doubts;
        let marked = verdicts(&scene, &answers, "interval").contains(&Verdict::Marked);
        assert_eq!(!doubts.is_empty(), marked, "{doubts:?}");
        assert!(!verdicts(&scene, &answers, name).contains(&Verdict::Violated));
        marked
    };
    let seen = |lower, upper| seen(lower, upper, Some(0.002));
    let open = HeadJoints::Open;
    assert!(heard(open, "sequential", &stating(0.44, Some(1e-3))));
    assert!(!heard(open, "sequential", &stating(0.4499, Some(1e-3))));
    assert!(heard(open, "mine", &number(0.44)));
    assert!(!heard(open, "mine", &stating(0.44, Some(0.05))));
    assert!(heard(open, "pushover", &seen(0.4395, 0.44)));
    assert!(!heard(open, "pushover", &seen(0.44, 0.46)));
    // With head joints in contact the lower end of the range is a pushover of its own.
    assert!(heard(HeadJoints::Contact, "pushover", &seen(0.44, 0.46)));
    // A state that is verified lower is the answer.
    let lower = states(0.44, 0.44);
    let answers = [("interval", &found), ("mine", &lower)];
    assert_eq!(worst(&answers, "interval"), Some(Verdict::Marked));
    let conclusion = conclude(&scene(open), &answers);
    assert_eq!(conclusion.methods, ["mine"]);
    assert!(conclusion.is_explained());
}

/// At λ = 0 nothing is relative to λ, and an iteration is allowed what it states about itself.
#[test]
fn relations_have_a_meaning_at_zero() {
    let (bound, found) = (bound(0.0), states(-1e-12, 1e-10));
    let sequential = stating(3e-5, Some(0.0301));
    let answers = [
        ("associative", &bound),
        ("sequential", &sequential),
        ("interval", &found),
    ];
    assert_eq!(worst(&answers, "sequential"), Some(Verdict::Marked));
    assert_eq!(worst(&answers, "interval"), Some(Verdict::Holds));
    let unstated = number(3e-5);
    let answers = [("associative", &bound), ("sequential", &unstated)];
    assert_eq!(worst(&answers, "sequential"), Some(Verdict::Violated));
    // In other units of the live load the same.
    let heavy = scene(HeadJoints::Open).with_loads(|load, _| load.live *= 1e6);
    let little = stating(3e-11, Some(0.0301));
    let answers = [("associative", &bound), ("sequential", &little)];
    assert_eq!(verdicts(&heavy, &answers, "sequential"), [Verdict::Marked]);
    let much = stating(3e-8, Some(0.0301));
    let answers = [("associative", &bound), ("sequential", &much)];
    assert_eq!(
        verdicts(&heavy, &answers, "sequential"),
        [Verdict::Violated]
    );
}

#[test]
fn the_conclusion_is_the_lowest_state_and_says_what_is_explained() {
    let (bound, found) = (bound(0.407), states(0.285, 0.285));
    let pushed = seen(0.297, 0.338, Some(0.002));
    let scene = scene(HeadJoints::Contact);
    let all = [
        ("associative", &bound),
        ("interval", &found),
        ("pushover", &pushed),
    ];
    let conclusion = conclude(&scene, &all);
    assert_eq!(conclusion.basis, Basis::LowestState);
    assert_eq!(conclusion.status, Status::Verified);
    assert_eq!(conclusion.methods, ["interval"]);
    assert_eq!(conclusion.bracket, Some(Bracket::point(0.285)));
    let relative = conclusion.difference.as_ref().unwrap().relative.unwrap();
    assert!((relative - 0.428).abs() < 1e-3);
    assert!(conclusion.is_explained());
    // Less and less is known.
    for (known, basis) in [
        (vec![all[0], all[2]], Basis::UpperBound),
        (vec![all[2]], Basis::Observed),
        (vec![], Basis::Nothing),
    ] {
        let conclusion = conclude(&scene, &known);
        assert_eq!(conclusion.basis, basis);
        assert_eq!(conclusion.difference, None);
    }
    let falls = Outcome::of(Status::Falls);
    let conclusion = conclude(&scene, &[("associative", &falls), ("pushover", &falls)]);
    assert_eq!(conclusion.basis, Basis::Falls);
    assert_eq!(conclusion.methods, ["associative", "pushover"]);
    let conclusion = conclude(&scene, &[("interval", &found), ("pushover", &falls)]);
    assert!(!conclusion.is_explained());
    // A bracket outside what no multiplier exceeds is not explained.
    let above = seen(0.5, 0.5, Some(0.002));
    let answers = [all[0], all[1], ("pushover", &above)];
    assert!(!conclude(&scene, &answers).is_explained());
}
