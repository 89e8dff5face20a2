//! The legend of drawings: what occurs in them, and nothing else.

use indexmap::IndexSet;

use super::axes::round_below;
use super::legend::Sample;
use super::palette::{
    BEFORE, CRACK, FORCE, FRICTION, INK, MACRO_CRACK, SCALE, SLIDING, STILL, SUPPORT, THRUST,
};
use super::svg::style;
use crate::number::short;

/// What a drawing holds and its legend explains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Held {
    Support,
    Still,
    /// A body in this tint.
    Tint(&'static str),
    Scale,
    Slides,
    Opens,
    /// Joints with a coefficient of friction of their own.
    Friction(f64),
    /// Outlines of the wall before it moved.
    Before,
    Crack,
    MacroCrack,
    /// A round force, and the pixels of its arrow.
    Force(f64, f64),
}

/// A length of a scene with at most so many decimals.
pub fn units_of_length(length: f64, decimals: usize) -> String {
    let length = short(length, decimals);
    let units = if length == "1" { "unit" } else { "units" };
    format!("{length} {units} of length")
}

/// The entries that explain what is there, with the length that is drawn so many pixels long.
pub fn entries(held: &[Held], scale: f64) -> Vec<(Sample, String)> {
    let tints = held.iter().filter_map(|one| match one {
        Held::Tint(tint) => Some(*tint),
        _ => None,
    });
    let tints: Vec<&str> = tints.collect::<IndexSet<_>>().into_iter().collect();
    let frictions = held.iter().filter_map(|one| match one {
        Held::Friction(friction) => Some(friction.to_string()),
        _ => None,
    });
    let frictions: IndexSet<String> = frictions.collect();
    let force = held.iter().find_map(|one| match one {
        Held::Force(force, pixels) => Some((short(*force, 9), *pixels)),
        _ => None,
    });
    let has = |one: Held| held.contains(&one);
    let line = |colour, width| Sample::Line(style().line(colour, width));
    let sliding = Sample::Haloed(style().line(SLIDING, 2.4));
    let dashes = Sample::Line(style().line(MACRO_CRACK, 1.5).dashes("7 4"));
    let ends = ["0".to_owned(), "100 %".to_owned()];
    let as_one = match tints.len() {
        1 => "moves as one body",
        _ => "a tint moves as one body",
    };
    let rough = Sample::Line(style().line(FRICTION, 2.0).dashes("5 3"));
    let of_friction: Vec<&str> = frictions.iter().map(String::as_str).collect();
    let of_friction = format!("joint with friction {}", of_friction.join(", "));
    let length = round_below(LENGTH / scale);
    let words = units_of_length(length, 9);
    let (of_force, pixels) = force.clone().unwrap_or_default();
    let of_force = format!("contact force of {of_force}, on the block that it points into");
    let of_thrust = "line of thrust";
    let all = [
        (has(Held::Support), Sample::Shade(SUPPORT, 1.0), "support"),
        (has(Held::Still), Sample::Tints(vec![STILL]), "stands still"),
        (!tints.is_empty(), Sample::Tints(tints), as_one),
        (
            has(Held::Scale),
            Sample::Scale(&SCALE, ends),
            "of the largest displacement",
        ),
        (has(Held::Slides), sliding, "joint slides"),
        (has(Held::Opens), Sample::Gap, "joint opens"),
        (!frictions.is_empty(), rough, &of_friction),
        (has(Held::Before), line(BEFORE, 1.2), "before"),
        (has(Held::Crack), line(CRACK, 1.4), "crack of c and e"),
        (has(Held::MacroCrack), dashes, "macro-block crack"),
        (force.is_some(), Sample::Arrow(FORCE, pixels), &of_force),
        (force.is_some(), line(THRUST, 1.2), of_thrust),
        (true, Sample::Length(INK, length * scale), &words),
    ];
    let there = all.into_iter().filter(|(is_there, ..)| *is_there);
    let entry = |(_, sample, words): (bool, Sample, &str)| (sample, words.to_owned());
    there.map(entry).collect()
}

/// Pixels that the length of the legend is long, at most.
const LENGTH: f64 = 60.0;
