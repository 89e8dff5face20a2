//! What the tuned numbers are worth: each is halved and doubled, and answers must not move by more than
//! their stated error. A number on which answers hang would be a calibration. What the substep and the
//! stiffness of the contacts do is measured on every scene by its levels.

use super::parameters::Parameters;
use super::single::solve_with;
use super::tests::wall;
use super::*;
use crate::scene::HeadJoints;

/// A number, how it is scaled, and by what.
type Tuned = (&'static str, fn(&mut Parameters, f64), &'static [f64]);

const BOTH: &[f64] = &[0.5, 2.0];

const TUNED: [Tuned; 16] = [
    ("damping ratio", |p, by| p.damping_ratio *= by, BOTH),
    ("ramp", |p, by| p.ramp *= by, BOTH),
    ("ramp of the first rest", |p, by| p.ramp_of_rest *= by, BOTH),
    ("window", |p, by| p.window *= by, BOTH),
    ("patience", |p, by| p.patience *= by, BOTH),
    ("rests allowed", |p, by| p.rests_allowed *= by, BOTH),
    ("least patience", |p, by| p.least_patience *= by, BOTH),
    (
        "slow steps",
        |p, by| p.slow_steps[1] = (3.0 * by).round() as usize,
        BOTH,
    ),
    // It is at most 1, where every dip counts.
    ("damping below", |p, by| p.damp_below *= by, &[0.5]),
    ("extrapolation", |p, by| p.extrapolation *= by, BOTH),
    ("slow motion", |p, by| p.slow_motion *= by, BOTH),
    ("settled speed", |p, by| p.settled_speed *= by, BOTH),
    ("runaway", |p, by| p.runaway *= by, BOTH),
    ("collapse", |p, by| p.collapse *= by, BOTH),
    ("points kept", |p, by| p.recycle_distance *= by, &[2.0]),
    (
        "first increment",
        |p, by| p.first_increment = (p.first_increment as f64 * by) as u64,
        BOTH,
    ),
];

fn open(unit: [f64; 2], courses: &[&str]) -> Scene {
    wall(unit, 0.65, courses).scene(HeadJoints::Open).unwrap()
}

/// Scenes with their multipliers: a column that rocks (elementary statics, width over height) and the
/// paper's Wall 1 (its lowest verified state, which associative friction meets).
fn scenes() -> Vec<(&'static str, Scene, f64)> {
    vec![
        ("column of 12", open([1.0, 1.0], &["1"; 12]), 1.0 / 12.0),
        (
            "paper-1",
            open([4.0, 1.75], &["h1111h", "11111"].repeat(3)),
            0.639_969,
        ),
    ]
}

/// How far the answers of the scenes move, as a part of λ, and which are outside the stated error.
fn moved((name, change, factors): Tuned) -> Vec<String> {
    let mut wrong = Vec::new();
    for (of, scene, lambda) in scenes() {
        for &by in factors {
            let outcome = solve_with(&scene, &PushoverSettings::default(), |mut own| {
                change(&mut own, by);
                own
            });
            let (Some(bracket), Some(stated)) = (outcome.bracket, outcome.stated_error) else {
                wrong.push(format!("{name} × {by}: {of} {}", outcome.reason()));
                continue;
            };
            let error = bracket.error(lambda, 1.0);
            println!("{name} × {by}: {of} {bracket:?}, error {error:.1e}, stated {stated:.1e}");
            if error > stated {
                wrong.push(format!(
                    "{name} × {by}: {of} {bracket:?}, error {error:.1e}"
                ));
            }
        }
    }
    wrong
}

#[test]
#[ignore = "takes half a minute"]
fn answers_do_not_hang_on_tuned_numbers() {
    let wrong: Vec<String> = TUNED.into_iter().flat_map(moved).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}
