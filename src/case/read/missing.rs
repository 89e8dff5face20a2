//! What to write for a key that must be there.

use std::ops::Range;

use crate::case::complaint::Complaint;

/// A key that must be there; an empty span stands for the whole file.
pub(super) fn missing_key(span: Range<usize>, key: &str) -> Complaint {
    // Of what is marked, the first line is shown.
    let (span, words) = match span.is_empty() {
        true => (0..usize::MAX, format!("{}\n", example(key))),
        false => (span, String::new()),
    };
    let complaint = Complaint::at(span.clone(), format!("missing key `{key}`"), "not in here");
    let place = if words.is_empty() { span } else { 0..0 };
    complaint
        .help(format!("add `{}`", example(key)))
        .mended(place, words)
}

/// What is written for a key that has to be there, or is a list.
const EXAMPLES: [(&str, &str); 33] = [
    ("unit", "{ length = 4.0, height = 1.75, weight = 1.0 }"),
    ("courses", "[\"h1111h\", \"11111\"]"),
    ("friction", "0.65"),
    ("heights", "[0.2, 0.2, 0.3]"),
    ("open_head_joints", "[2, 4]"),
    ("joints", "[{ course = 3, friction = 0.3 }]"),
    ("between", "[\"A\", \"B\"]"),
    ("length", "4.0"),
    ("height", "1.75"),
    ("weight", "1.0"),
    ("method", "\"associative\""),
    ("quantity", "\"lambda\""),
    ("value", "0.6429"),
    ("tolerance", "0.00005"),
    ("source", "\"Table 1\""),
    ("kind", "\"published\""),
    ("mean_radius", "10.0"),
    ("thickness", "1.5"),
    ("embrace", "180.0"),
    ("voussoirs", "27"),
    ("name", "\"A\""),
    ("block", "\"A\""),
    ("corners", "[[0, 0], [4, 0], [4, 1.75], [0, 1.75]]"),
    ("along", "[[0.0, 1.0], [2.0, 1.0]]"),
    ("supports", "[\"ground\"]"),
    ("support", "\"right\""),
    ("units", "\"5-8\""),
    ("direction", "[0.0, -1.0]"),
    ("moves", "\"away\""),
    ("course", "1"),
    ("piece", "1"),
    ("bed", "0.65"),
    ("pieces", "{ L = { units = 2.5 }, s = { length = 0.6 } }"),
];

/// A key with a value.
pub(super) fn example(key: &str) -> String {
    match EXAMPLES.iter().find(|(known, _)| *known == key) {
        Some((_, value)) => format!("{key} = {value}"),
        None => key.to_owned(),
    }
}
