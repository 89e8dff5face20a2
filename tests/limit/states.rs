//! `--states`: every claim can be confirmed from the JSON alone.
#![cfg(unix)]

use std::time::Duration;

use serde_json::Value;
use trilith::answer::Status;
use trilith::case;
use trilith::inside::json_with_states;
use trilith::inside::without_lower_bounds;
use trilith::inside::{AnswerFile, External};
use trilith::method::Settings;
use trilith::run::{Plan, answer, run};
use trilith::scene::{HeadJoints, Push, Scene};

/// One scene a kind of answer: states, `stands` for both laws, `falls`, pushed both ways, no case of
/// one block.
const CASES: [&str; 6] = [
    "paper-1",
    "semicircle-9",
    "press-stands",
    "overhang-falls",
    "triangle-both",
    "header-bond",
];

fn rows(names: &[&str]) -> Vec<Value> {
    let cases: Vec<_> = (names.iter())
        .flat_map(|name| case::find(name).unwrap())
        .collect();
    let mut settings = Settings::default();
    settings.interval.starts = 2;
    let plan = Plan {
        methods: without_lower_bounds(),
        settings,
        head_joints: None,
    };
    let text = json_with_states(&run(&cases, &plan, &|_| {}), None);
    serde_json::from_str(&text).unwrap()
}

/// The status that the judge gives an answer that an outside program brings.
fn judged(scene: &Scene, text: &Value) -> Status {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("answer.json");
    std::fs::write(&path, text.to_string()).unwrap();
    let program = External {
        name: "cat".to_owned(),
        command: vec!["cat".to_owned(), path.to_str().unwrap().to_owned()],
        folder: None,
        limit: Duration::from_secs(10),
    };
    let row = answer(std::slice::from_ref(scene), &program, Settings::default());
    row.outcome.status
}

/// What is proved here is proved again by whoever hands over the same numbers.
#[test]
fn every_answer_is_one_of_an_outside_program() {
    let mut kinds = Vec::new();
    for row in rows(&CASES) {
        let name = row["case"].as_str().unwrap();
        let case = case::find(name.trim_end_matches("@open"))
            .unwrap()
            .remove(0);
        let head_joints = match row["head_joints"].as_str().unwrap() {
            "contact" => HeadJoints::Contact,
            _ => HeadJoints::Open,
        };
        let sides = row["sides"].as_array().unwrap();
        assert_eq!(sides.len(), case.pushes.len(), "{name}");
        assert_eq!(sides[0]["push"], row["push"], "the row's own side is first");
        assert_eq!(sides[0]["status"], row["status"]);
        for side in sides {
            let push = match side["push"].as_str().unwrap() {
                "right" => Push::Right,
                _ => Push::Left,
            };
            let scene = case.pushed(head_joints, push);
            let exported = trilith::inside::export(&scene);
            let exported: Value = serde_json::from_str(&exported).unwrap();
            assert_eq!(side["scene"], exported, "{name}");
            for text in side["answers"].as_array().unwrap() {
                let read: AnswerFile = serde_json::from_value(text.clone()).unwrap();
                let kind = text["kind"].as_str().unwrap().to_owned();
                let what = format!("{name} {} {kind}", row["method"]);
                let status = judged(&scene, text);
                let observed = kind == "falls" && read.velocities.is_none();
                match kind.as_str() {
                    "associative" | "collapse-state" => {
                        assert_eq!(status, Status::Verified, "{what}")
                    }
                    "enclosed" => assert!(
                        matches!(status, Status::Verified | Status::Bracketed),
                        "{what}: {status:?}"
                    ),
                    "stands" | "stands-without-dilatancy" => {
                        assert_eq!(status, Status::Stands, "{what}");
                    }
                    "falls" if !observed => assert_eq!(status, Status::Falls, "{what}"),
                    _ => {}
                }
                kinds.push(kind);
            }
        }
    }
    kinds.sort();
    kinds.dedup();
    let expected = [
        "associative",
        "collapse-state",
        "enclosed",
        "estimate",
        "falls",
    ];
    for kind in expected {
        assert!(kinds.iter().any(|found| found == kind), "{kind}: {kinds:?}");
    }
    assert!(
        kinds.iter().any(|kind| kind.starts_with("stands")),
        "{kinds:?}"
    );
}

/// The interval's ends are among its states, and the numbers have all their digits.
#[test]
fn the_ends_of_an_interval_are_states() {
    for row in rows(&["paper-1"]) {
        if row["method"] != "interval" {
            continue;
        }
        let side = &row["sides"][0];
        let lambdas: Vec<&Value> = (side["answers"].as_array().unwrap().iter())
            .map(|answer| &answer["lambda"])
            .collect();
        assert!(lambdas.contains(&&side["lower"]) && lambdas.contains(&&side["upper"]));
        let nine = row["lower"].as_f64().unwrap();
        assert!((nine - side["lower"].as_f64().unwrap()).abs() < 1e-9);
    }
}

/// The scene tells what a block is called, and its own weight from what lies on it.
#[test]
fn scenes_name_their_blocks_and_tell_weight_from_overburden() {
    let scene = |name: &str| {
        let case = case::find(name).unwrap().remove(0);
        let text = trilith::inside::export(&case.scene(HeadJoints::Contact));
        serde_json::from_str::<Value>(&text).unwrap()
    };
    let wall = scene("overburden-1");
    assert_eq!(wall["case"], "overburden-1");
    let blocks = wall["blocks"].as_array().unwrap();
    assert_eq!(blocks[0]["name"], "course 1 piece 1");
    let kinds = |block: &Value| -> Vec<String> {
        let loads = block["loads"].as_array().unwrap().iter();
        loads
            .map(|load| load["kind"].as_str().unwrap().to_owned())
            .collect()
    };
    assert_eq!(kinds(&blocks[0]), ["self-weight"]);
    assert_eq!(kinds(blocks.last().unwrap()), ["self-weight", "overburden"]);
    let named = scene("line-load");
    let blocks = named["blocks"].as_array().unwrap();
    assert!(blocks.iter().all(|block| block["name"] != ""), "{named}");
    assert!(
        blocks
            .iter()
            .any(|block| kinds(block).contains(&"load".to_owned()))
    );
}
