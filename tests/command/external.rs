//! External methods: what they hand over is judged, what they break is a row.
#![cfg(unix)]

use crate::scenes;

use std::path::Path;
use std::process::Command;
use std::time::Duration;

use crate::skipped::skipped;
use serde_json::{Value, json};
use trilith::answer::{Fact, JointForce, Outcome, Status};
use trilith::inside::{External, SceneFile, answer_schema, export, parse, scene_schema};
use trilith::inside::{ProgramEnding, ProgramFailure};
use trilith::method::limit::{Associative, Interval};
use trilith::method::{Method, Settings};
use trilith::run::{Row, answer};
use trilith::scene::{HeadJoints, Scene};

fn program(command: &[&str], limit: f64) -> External {
    External {
        name: "mine".to_owned(),
        command: command.iter().map(|word| (*word).to_owned()).collect(),
        folder: None,
        limit: Duration::from_secs_f64(limit),
    }
}

fn ask(method: &dyn Method, scene: &Scene) -> Row {
    answer(std::slice::from_ref(scene), method, Settings::default())
}

fn paper_1(head_joints: HeadJoints) -> Scene {
    scenes::laid(&scenes::small_walls()[0].1, head_joints)
}

/// Why a program gave no answer.
fn failure(outcome: &Outcome) -> &ProgramFailure {
    match outcome.facts.as_slice() {
        [Fact::Program(failure)] => failure,
        facts => panic!("{facts:?}"),
    }
}

/// What a program answers that writes this.
fn answered(scene: &Scene, answer: &Value) -> Row {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("answer.json");
    std::fs::write(&path, answer.to_string()).unwrap();
    ask(&program(&["cat", path.to_str().unwrap()], 10.0), scene)
}

/// An outcome's proof as a program would write it.
fn written(outcome: &Outcome, kind: &str) -> Value {
    let force = |f: &JointForce| [f.normal[0], f.normal[1], f.shear];
    let forces: Vec<_> = outcome
        .evidence
        .forces()
        .unwrap()
        .1
        .iter()
        .map(force)
        .collect();
    let motions = &outcome.evidence.mechanism().unwrap().motions;
    let velocities: Vec<_> = motions
        .iter()
        .map(|m| [m.velocity.x, m.velocity.y, m.rotation])
        .collect();
    json!({
        "kind": kind,
        "lambda": outcome.bracket().unwrap().lower,
        "forces": forces,
        "velocities": velocities,
    })
}

/// λ_A of the small walls by HiGHS agrees with Clarabel's to 1e-6, and is proved.
#[test]
fn highs_earns_verified_on_the_small_walls() {
    let has = Command::new("python3")
        .args(["-c", "import scipy.optimize"])
        .output();
    if !has.is_ok_and(|output| output.status.success()) {
        skipped("python3 with SciPy is not here");
        return;
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/external");
    let path = folder.join("methods.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let highs = parse(path.to_str().unwrap(), &text).unwrap().remove(0);
    for (name, wall) in scenes::small_walls() {
        for head_joints in [HeadJoints::Contact, HeadJoints::Open] {
            let scene = scenes::laid(&wall, head_joints);
            let ours = ask(&Associative, &scene).outcome.bracket().unwrap();
            let theirs = ask(&highs, &scene);
            let status = theirs.outcome.status;
            assert_eq!(
                status,
                Status::Verified,
                "{name}: {}",
                theirs.outcome.reason()
            );
            let bracket = theirs.outcome.bracket().unwrap();
            assert!(bracket.error(ours.lower, 1.0) < 1e-6, "{name}: {bracket:?}");
            assert!(
                bracket.relative_width(1.0).abs() < 1e-6,
                "{name}: {bracket:?}"
            );
            assert!(theirs.residual().unwrap() <= 1e-8);
            assert!(theirs.seconds > 0.01, "an interpreter takes time");
        }
    }
}

#[test]
fn proofs_are_judged_whoever_brings_them() {
    let scene = paper_1(HeadJoints::Contact);
    let bound = Associative.solve(&scene, &Settings::default());
    let state = Interval.solve(&scene, &Settings::default());
    for (outcome, kind) in [(&bound, "associative"), (&state, "collapse-state")] {
        let right = written(outcome, kind);
        let answer = answered(&scene, &right);
        assert_eq!(answer.outcome.status, Status::Verified, "{kind}");
        assert!(answer.residual().unwrap() <= 1e-8);
        // The same as an estimate: a collapse state is found out to be one, bounds are none.
        let mut modest = right.clone();
        modest["kind"] = "estimate".into();
        let status = answered(&scene, &modest).outcome.status;
        let expected = match kind {
            "associative" => Status::Estimate,
            _ => Status::Verified,
        };
        assert_eq!(status, expected, "{kind} as an estimate");
        // Claims that the forces or the velocities do not bear out are refuted.
        let mut high = right.clone();
        high["lambda"] = (1.001 * outcome.bracket().unwrap().lower).into();
        let mut spoiled = right.clone();
        spoiled["velocities"][3][2] = 1e3.into();
        for wrong in [high, spoiled] {
            let answer = answered(&scene, &wrong);
            assert_eq!(answer.outcome.status, Status::Failed, "{kind}");
            assert_eq!(answer.outcome.bracket(), None);
        }
    }
    // One kind of proof is not the other.
    let swapped = answered(&scene, &written(&state, "associative"));
    assert_eq!(swapped.outcome.status, Status::Failed);
}

#[test]
fn numbers_alone_are_estimates_and_nonsense_fails() {
    let scene = paper_1(HeadJoints::Open);
    let number = answered(
        &scene,
        &json!({"kind": "estimate", "lambda": 0.6, "upper": 0.7}),
    );
    assert_eq!(number.outcome.status, Status::Estimate);
    assert_eq!(number.outcome.bracket().unwrap().upper, 0.7);
    let declined = answered(
        &scene,
        &json!({"kind": "not-applicable", "reason": "too tall"}),
    );
    assert_eq!(declined.outcome.status, Status::NotApplicable);
    assert_eq!(declined.outcome.reason(), "too tall");
    let claims = answered(&scene, &json!({"kind": "falls"}));
    assert_eq!(claims.outcome.status, Status::Undecided);
    let short = json!({
        "kind": "associative", "lambda": 0.6, "forces": [[1.0, 1.0, 0.0]], "velocities": []
    });
    for (answer, expected) in [
        (
            json!({"kind": "associative", "lambda": 0.6}),
            "a number alone is an `estimate`",
        ),
        (json!({"kind": "estimate"}), "needs `lambda`"),
        (
            json!({"kind": "estimate", "lambda": 0.7, "upper": 0.6}),
            "above `upper`",
        ),
        (
            json!({"kind": "guess", "lambda": 0.7}),
            "unknown variant `guess`",
        ),
        (
            json!({"kind": "estimate", "lamda": 0.7}),
            "unknown field `lamda`",
        ),
        (json!({"kind": "estimate", "lambda": "0.7"}), "invalid type"),
        (json!([1, 2]), "no answer"),
    ] {
        let outcome = answered(&scene, &answer).outcome;
        assert_eq!(outcome.status, Status::Failed, "{answer}");
        assert!(outcome.reason().contains(expected), "{}", outcome.reason());
    }
    let outcome = answered(&scene, &short).outcome;
    assert_eq!(outcome.status, Status::Failed);
    let expected = ProgramFailure::WrongLength {
        key: "velocities".into(),
        entries: 0,
        expected: 33,
        of: "blocks".into(),
    };
    assert_eq!(failure(&outcome), &expected);
}

#[test]
fn programs_that_break_are_rows() {
    let scene = paper_1(HeadJoints::Open);
    for (command, expected) in [
        (vec!["/nowhere/at/all"], "cannot start"),
        (vec!["sh", "-c", "echo NaN"], "no answer"),
        (
            vec!["sh", "-c", r#"echo '{"kind":"estimate","lambda":NaN}'"#],
            "no answer",
        ),
        (
            vec!["sh", "-c", r#"echo '{"kind":"estimate","lambda":1e999}'"#],
            "no answer",
        ),
        (vec!["true"], "wrote nothing"),
        (vec!["cat"], "it begins with `{\"format\""),
    ] {
        let outcome = ask(&program(&command, 10.0), &scene).outcome;
        assert_eq!(outcome.status, Status::Failed, "{command:?}");
        assert!(outcome.reason().contains(expected), "{}", outcome.reason());
        assert_eq!(outcome.bracket(), None);
    }
    for (script, ending, messages) in [
        (
            "echo lost >&2; exit 3",
            ProgramEnding::ExitStatus(3),
            "lost",
        ),
        ("kill -SEGV $$", ProgramEnding::Signal(11), ""),
    ] {
        let outcome = ask(&program(&["sh", "-c", script], 10.0), &scene).outcome;
        assert_eq!(outcome.status, Status::Failed, "{script}");
        let messages = messages.to_owned();
        assert_eq!(
            failure(&outcome),
            &ProgramFailure::Ended { ending, messages }
        );
        assert_eq!(outcome.bracket(), None);
    }
}

/// The limit ends the program and its children; one that works until then is charged for it.
#[test]
fn programs_that_hang_are_stopped_with_their_children() {
    let scene = paper_1(HeadJoints::Open);
    let folder = tempfile::tempdir().unwrap();
    let told = folder.path().join("child");
    let script = format!("sleep 60 & echo $! >{}; sleep 60", told.display());
    let sleeps = ask(&program(&["sh", "-c", &script], 0.3), &scene);
    let ending = ProgramEnding::TimeLimit { seconds: 0.3 };
    let messages = String::new();
    assert_eq!(
        failure(&sleeps.outcome),
        &ProgramFailure::Ended { ending, messages }
    );
    let child = std::fs::read_to_string(told).expect("the program has told its child");
    assert!(has_ended(child.trim()), "{child} still runs");
    assert!(
        sleeps.seconds < 0.2,
        "sleep costs no CPU time: {}",
        sleeps.seconds
    );
    let works = ask(&program(&["sh", "-c", "while :; do :; done"], 0.5), &scene);
    assert_eq!(works.outcome.status, Status::Failed);
    assert!(
        works.seconds > sleeps.seconds,
        "work does: {}",
        works.seconds
    );
}

/// Whether a process is gone, or waits for nothing but to be asked how it ended.
fn has_ended(process: &str) -> bool {
    let state = Command::new("ps")
        .args(["-o", "stat=", "-p", process])
        .output();
    let state = String::from_utf8(state.expect("there is a ps").stdout).unwrap();
    state.trim().is_empty() || state.starts_with('Z')
}

/// The schemas come from the types that are written and read, and say nothing else.
#[test]
fn the_schemas_describe_what_is_written_and_read() {
    let scene = paper_1(HeadJoints::Contact);
    let text = export(&scene);
    let back: SceneFile = serde_json::from_str(&text).unwrap();
    assert_eq!(
        back,
        SceneFile::from(&scene),
        "numbers come back to the last bit"
    );
    let written: Value = serde_json::from_str(&text).unwrap();
    let schema = scene_schema();
    fits(&written, schema.as_value(), schema.as_value(), "scene");
    let schema = answer_schema();
    let proof = Associative.solve(&scene, &Settings::default());
    let right = self::written(&proof, "associative");
    fits(&right, schema.as_value(), schema.as_value(), "answer");
    // Without it, a number is an estimate.
    let kind = &schema.as_value()["properties"]["kind"];
    assert_eq!(kind["default"], json!("estimate"));
    let falls = json!({"kind": "falls", "velocity": []});
    assert!(
        answered(&scene, &falls)
            .outcome
            .reason()
            .contains("unknown field")
    );
}

/// Every key of `value` is described, every required one is there; all the way down.
fn fits(value: &Value, schema: &Value, root: &Value, place: &str) {
    if let Some(name) = schema["$ref"].as_str() {
        let name = name.rsplit('/').next().unwrap();
        return fits(value, &root["$defs"][name], root, place);
    }
    if let (Some(object), Some(known)) = (value.as_object(), schema["properties"].as_object()) {
        assert_eq!(schema["additionalProperties"], json!(false), "{place}");
        for key in schema["required"].as_array().into_iter().flatten() {
            assert!(
                object.contains_key(key.as_str().unwrap()),
                "{place} needs {key}"
            );
        }
        for (key, inner) in object {
            assert!(known.contains_key(key), "{place} does not know {key}");
            assert!(
                !known[key].get("description").is_none_or(Value::is_null),
                "{place}.{key}"
            );
            fits(inner, &known[key], root, &format!("{place}.{key}"));
        }
    }
    for inner in value.as_array().into_iter().flatten() {
        fits(inner, &schema["items"], root, place);
    }
}
