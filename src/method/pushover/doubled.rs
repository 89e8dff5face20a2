//! What the tuned numbers are worth: each is halved and doubled, and answers must not move by more than
//! their stated error. A number on which answers hang would be a calibration. What the substep and the
//! stiffness of the contacts do is measured on every scene by its levels.

use super::parameters::Parameters;
use super::run::solve_with;
use super::tuned::Tuned;
use super::*;
use crate::scene::{HeadJoints, Wall};

/// A number, how it is scaled, and by what.
type Number = (&'static str, fn(&mut Parameters, f64), &'static [f64]);

/// Numbers of these names, each times some factors.
macro_rules! numbers {
    ($by:expr; $($field:ident),+) => {
        [$((stringify!($field), (|own, by| own.$field *= by) as fn(&mut Parameters, f64), $by)),+]
    };
}

/// Damping below is at most 1, where every dip counts, and points are foreseen no nearer than they are kept.
fn all_numbers() -> Vec<Number> {
    let both: [Number; 21] = numbers!(
        &[0.5, 2.0];
        damping_ratio, ramp, ramp_of_rest, window, patience, rests_allowed, least_patience,
        extrapolation, slow_motion, settled_speed, runaway, collapse, onset, first_increment, resting,
        seen, doubt, near, still, moving, missing
    );
    let scaled = |own: &mut Parameters, by: f64| own.slow_steps[1] = (3.0 * by).round() as usize;
    let slow_steps: Number = ("slow_steps", scaled, &[0.5, 2.0]);
    let lower: [Number; 1] = numbers!(&[0.5]; damp_below);
    let upper: [Number; 1] = numbers!(&[2.0]; recycle_distance);
    [&both[..], &[slow_steps], &lower, &upper].concat()
}

fn open(unit: [f64; 2], courses: &[&str]) -> Scene {
    Wall::laid(unit, 0.65, courses)
        .scene(HeadJoints::Open)
        .unwrap()
}

/// Scenes with their multipliers: a column that rocks (elementary statics, width over height) and the
/// paper's Wall 1 (its lowest verified state, which associative friction meets).
fn scenes() -> Vec<(&'static str, Scene, f64)> {
    let column = open([1.0, 1.0], &["1"; 12]);
    let paper_1 = open([4.0, 1.75], &["h1111h", "11111"].repeat(3));
    vec![
        ("column of 12", column, 1.0 / 12.0),
        ("paper-1", paper_1, 0.639_969),
    ]
}

/// What is wrong with an answer where one number is multiplied: it is none, or λ lies outside the range
/// that it states.
fn fault(what: &str, outcome: &Outcome, lambda: f64) -> Option<String> {
    let (Some(bracket), Some(stated)) = (outcome.bracket(), outcome.evidence.stated_error()) else {
        return Some(format!("{what}: {}", outcome.reason()));
    };
    let error = bracket.error(lambda, 1.0);
    println!("{what}: {bracket:?}, error {error:.1e}, stated {stated:.1e}");
    (error > stated).then(|| format!("{what}: {bracket:?}, error {error:.1e}"))
}

#[test]
#[ignore = "takes half a minute"]
fn answers_do_not_hang_on_tuned_numbers() {
    let mut wrong = Vec::new();
    for (name, change, factors) in all_numbers() {
        for &by in factors {
            for (of, scene, lambda) in scenes() {
                let outcome = solve_with(&scene, &PushoverSettings::default(), |mut own| {
                    change(&mut own, by);
                    own
                });
                wrong.extend(fault(&format!("{name} × {by}: {of}"), &outcome, lambda));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// A column whose top block is the lightest that moves as others do; elementary statics of rocking.
fn light_on_top() -> (&'static str, Scene, f64) {
    const LIGHT: f64 = 0.1;
    let column = open([1.0, 1.0], &["1"; 6]);
    let top = column.bounds().1.y;
    let column = column.with_loads(|load, shape| {
        if shape.bounds().1.y == top {
            load.dead *= LIGHT;
            load.live *= LIGHT;
        }
    });
    let lambda = 0.5 * (5.0 + LIGHT) / (12.5 + 5.5 * LIGHT);
    ("light on top", column, lambda)
}

/// A column that sways, so that its masses grow with the depth; width over height.
fn tall() -> (&'static str, Scene, f64) {
    ("column of 24", open([1.0, 1.0], &["1"; 24]), 1.0 / 24.0)
}

/// The same of the numbers of models and levels, and of ranges.
#[test]
#[ignore = "takes half a minute"]
fn levels_and_ranges_do_not_hang_on_tuned_numbers() {
    let settings = PushoverSettings::default();
    let mut wrong = Vec::new();
    let scenes = [scenes(), vec![light_on_top(), tall()]].concat();
    let contact = Wall::laid([4.0, 1.75], 0.65, &["h1h", "11", "h1h"]);
    let contact = contact.scene(HeadJoints::Contact).unwrap();
    let usual = answer(&contact, &Portion::default(), Asked::new(&settings));
    let usual = usual.bracket().expect("it has one");
    let contact = ("contact", contact, usual.lower.midpoint(usual.upper));
    let scenes = [scenes, vec![contact]].concat();
    for by in [0.5, 2.0] {
        for (name, mut tuned) in Tuned::TUNED.each_times(by) {
            // At 1 a trend has no end.
            tuned.shrinking = tuned.shrinking.min(0.9);
            let asked = Asked {
                tuned,
                ..Asked::new(&settings)
            };
            for (of, scene, lambda) in &scenes {
                let outcome = answer(scene, &Portion::default(), asked);
                wrong.extend(fault(&format!("{name} × {by}: {of}"), &outcome, *lambda));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
