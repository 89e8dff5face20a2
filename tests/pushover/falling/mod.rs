//! Scenes that fall under their own weight, and scenes that nearly do, against another code.

mod piles;

use piles::{CLASSES, of_class};
use trilith::answer::{Fact, Outcome, Status};
use trilith::case::Case;
use trilith::inside::{LimitFact, falling_violation};
use trilith::judge::judge;
use trilith::method::limit::{Associative, Interval};
use trilith::method::{Method, Settings};
use trilith::scene::{HeadJoints, Scene};

fn judged(method: &dyn Method, scene: &Scene) -> Outcome {
    let mut outcome = method.solve(scene, &Settings::default());
    judge(scene, &mut outcome);
    outcome
}

/// `s` stands, `f` falls, `?` neither was proved.
fn letter(scene: &Scene) -> char {
    let outcome = judged(&Associative, scene);
    match outcome.status {
        Status::Falls => {
            let mechanism = outcome.evidence.mechanism().expect("with a mechanism");
            assert!(falling_violation(scene, mechanism) <= 1e-8);
            'f'
        }
        Status::Verified | Status::Bracketed | Status::Stands => 's',
        _ => '?',
    }
}

#[test]
fn what_falls_is_told_from_what_stands() {
    for (class, (name, truth)) in CLASSES.iter().enumerate() {
        let (mut right, mut refused, mut wrong) = (0, Vec::new(), Vec::new());
        let mut missed = Vec::new();
        for (index, truth) in truth.chars().enumerate() {
            match (letter(&of_class(class, index)), truth) {
                ('?', 'f') => missed.push(index),
                ('?', _) => refused.push(index),
                (said, truth) if said == truth || truth == '?' => right += 1,
                _ => wrong.push(index),
            }
        }
        println!(
            "{name}: {right} right, {missed:?} fall and {refused:?} stand but are refused, {wrong:?} wrong"
        );
        assert!(wrong.is_empty(), "{name}: {wrong:?}");
        // Over nine decades double precision does not resolve λ_A of many that stand.
        let (falling, standing) = if class == 2 { (2, 60) } else { (0, 1) };
        assert!(missed.len() <= falling, "{name}: {missed:?}");
        assert!(refused.len() <= standing, "{name}: {refused:?}");
    }
}

/// A unit over a gap, with and without neighbours that could hold it, and one that touches nothing.
#[test]
fn units_in_the_air_fall_and_are_named() {
    let first = |courses: &str, head_joints| {
        let text = format!(
            "unit = {{ length = 4.0, height = 1.75, weight = 1.0 }}\n\
             courses = [{courses}]\nfriction = 0.4\nhead_joints = \"both\"\n"
        );
        let case = Case::read("wall.toml", text.as_bytes()).expect("it can be laid");
        let outcome = judged(&Interval, &case.scene(head_joints));
        assert_eq!(outcome.status, Status::Falls, "{}", outcome.reason());
        match &outcome.facts[..] {
            [Fact::Limit(LimitFact::MovesUnpushed { first }), ..] => first.clone(),
            facts => panic!("{facts:?}"),
        }
    };
    for head_joints in [HeadJoints::Contact, HeadJoints::Open] {
        assert_eq!(first("'1g1', '111'", head_joints), ["course 2 piece 2"]);
        assert_eq!(
            first("'111', '1gg', '1g1'", head_joints),
            ["course 3 piece 3"]
        );
        assert_eq!(
            first("'11', 'gg11', '11gg'", head_joints),
            [2, 3]
                .map(|course| [1, 2]
                    .map(|k| format!("course {course} piece {}", k + 2 * (3 - course))))
                .concat()
        );
    }
}

/// Writes every scene for `tests/reference/falls.py`: `TRILITH_SCENES=DIR`.
#[test]
#[ignore = "writes files"]
fn export() {
    let Ok(folder) = std::env::var("TRILITH_SCENES") else {
        return;
    };
    for (class, (_, truth)) in CLASSES.iter().enumerate() {
        for index in 0..truth.len() {
            let scene = trilith::inside::export(&of_class(class, index));
            let path = format!("{folder}/{class}-{index:03}.json");
            std::fs::write(path, scene).expect("a folder that can be written");
        }
    }
}
