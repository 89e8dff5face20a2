//! A key that is not known where it stands: what may be meant, or how it is said here.

use std::ops::Range;

use super::file::CASE_KEYS;
use super::not_modelled::not_modelled;
use crate::case::complaint::Complaint;
use crate::case::suggestion::{listed, nearest};

/// What people look for, by the words that they write, and how it is said here.
const SAID_OTHERWISE: [(&[&str], &str); 6] = [
    (
        &[
            "opening", "openings", "door", "doors", "window", "windows", "lintel", "lintels",
            "gap", "gaps",
        ],
        "openings are gaps in the courses, `g` one unit wide; a lintel is a piece of its own length, as in \
         `pieces = { L = { units = 3 } }` and `courses = [\"11gg11\", \"1hLh1\"]`",
    ),
    (
        &["density", "unit_weight", "gamma", "rho", "mass"],
        "leave it out: λ depends on no density, only on how weights compare. `weight` in `unit` is that of one \
         unit, and a heavier piece has its own, as in `pieces = { L = { units = 3, weight = 4.5 } }`",
    ),
    (
        &[
            "friction_angle",
            "phi",
            "mu",
            "tan_phi",
            "friction_coefficient",
        ],
        "`friction` is the tangent of the friction angle: for 33 degrees write `friction = 0.65`",
    ),
    (
        &["a_g", "ag", "pga", "ground_acceleration", "seismic"],
        "write `demand = 0.25`, the horizontal acceleration in g that your code demands: λ is the one at which \
         the wall collapses, and answers then give λ over the demand",
    ),
    (
        &["vertical", "vertical_acceleration", "uplift", "av", "a_v"],
        "write `live = { weight = [1, 0.3] }`: 0.3 of every weight upwards as it pushes",
    ),
    (
        &["wind", "wind_pressure", "wind_load"],
        "a force is a `[[load]]` on a block, with `live = [1.0, 0.0]` in it and `live = \"loads\"` for the \
         case: λ is then how often it may act; `trilith convert` writes a wall as blocks",
    ),
];

/// A complaint about a key that has no place where it stands.
pub(super) fn unknown_key(span: Range<usize>, message: &str) -> Complaint {
    // unknown field `a`, expected one of `b`, `c`: every second piece is a word.
    let words: Vec<&str> = message.split('`').skip(1).step_by(2).collect();
    let (key, known) = words.split_first().unwrap_or((&"", &[]));
    if let Some(entry) = not_modelled(key) {
        let title = format!("{} is not modelled", entry.what);
        let complaint = Complaint::at(span.clone(), title, "known, but in none of the methods");
        return complaint.help(entry.nearest).mended(span, "");
    }
    let near = nearest(key, known.iter().copied());
    let help = if CASE_KEYS.contains(key) {
        format!("move `{key}` up, above the first line that begins with `[`")
    } else if let Some((_, help)) = SAID_OTHERWISE.iter().find(|(words, _)| words.contains(key)) {
        (*help).to_owned()
    } else if let Some(near) = near {
        format!("did you mean `{near}`?")
    } else {
        format!("the keys here are {}", listed(known.iter().copied()))
    };
    // What is said otherwise names the key first, where it is another one.
    let sound = near.or_else(|| {
        let first = help.strip_prefix('`')?.split('`').next()?;
        known.iter().find(|known| **known == first).copied()
    });
    let sound = sound.unwrap_or_default().to_owned();
    Complaint::at(
        span.clone(),
        format!("unknown key `{key}`"),
        "no such key here",
    )
    .help(help)
    .mended(span, sound)
}
