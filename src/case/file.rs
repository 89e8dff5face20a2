//! The case file as TOML has it. Every value keeps its span, so that a complaint can point at it.

use toml::Spanned;

use super::complaint::{Complaint, Document};
use super::explain::explain;
use super::values::{Courses, Friction, Number, Pair, Whole};

/// A whole file. Which of the keys go together is judged later, where it can be said well.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File {
    pub title: Option<String>,
    pub source: Option<String>,
    pub unit: Option<Spanned<Unit>>,
    pub courses: Option<Spanned<Courses>>,
    pub repeat: Option<Spanned<Whole>>,
    pub bond: Option<Spanned<String>>,
    pub units: Option<Spanned<Whole>>,
    pub first: Option<Spanned<String>>,
    pub overlap: Option<Spanned<Number>>,
    pub overburden: Option<Spanned<Number>>,
    pub arch: Option<Spanned<Arch>>,
    pub blocks: Option<Spanned<Blocks>>,
    #[serde(default)]
    pub block: Vec<Spanned<Body>>,
    #[serde(default)]
    pub support: Vec<Spanned<Body>>,
    pub live: Option<Spanned<String>>,
    #[serde(default)]
    pub load: Vec<Spanned<Load>>,
    pub friction: Spanned<Friction>,
    pub head_joints: Option<Spanned<String>>,
    pub push: Option<Spanned<String>>,
    #[serde(default)]
    pub references: Vec<Reference>,
}

/// The keys of [`File`], to tell a key in the wrong table from one that does not exist.
pub(super) const CASE_KEYS: [&str; 20] = [
    "title",
    "source",
    "unit",
    "courses",
    "repeat",
    "bond",
    "units",
    "first",
    "overlap",
    "overburden",
    "arch",
    "blocks",
    "block",
    "support",
    "live",
    "load",
    "friction",
    "head_joints",
    "push",
    "references",
];

/// A generated arch.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "an `[arch]` table")]
pub(super) struct Arch {
    pub mean_radius: Spanned<Number>,
    pub thickness: Spanned<Number>,
    pub embrace: Spanned<Number>,
    pub voussoirs: Spanned<Whole>,
    pub specific_weight: Option<Spanned<Number>>,
}

/// What all explicit blocks share.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a `[blocks]` table")]
pub(super) struct Blocks {
    pub csv: Option<Spanned<String>>,
    #[serde(default)]
    pub supports: Vec<Spanned<String>>,
    pub specific_weight: Option<Spanned<Number>>,
    pub thickness: Option<Spanned<Number>>,
    pub tolerance: Option<Spanned<Number>>,
}

/// A block or a support.
#[derive(Debug, serde::Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a `[[block]]` or `[[support]]` table"
)]
pub(super) struct Body {
    pub name: Spanned<String>,
    pub corners: Option<Spanned<Vec<Spanned<Pair>>>>,
    pub weight: Option<Spanned<Number>>,
}

/// A force on a block.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a `[[load]]` table")]
pub(super) struct Load {
    pub block: Spanned<String>,
    pub at: Option<Spanned<Pair>>,
    pub along: Option<Spanned<Vec<Spanned<Pair>>>>,
    pub dead: Option<Spanned<Pair>>,
    pub live: Option<Spanned<Pair>>,
}

/// What every unit is like.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of the unit's size")]
pub(super) struct Unit {
    pub length: Spanned<Number>,
    pub height: Spanned<Number>,
    pub thickness: Option<Spanned<Number>>,
    pub weight: Spanned<Number>,
}

/// A value to compare with.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a `[[references]]` table")]
pub(super) struct Reference {
    pub method: Spanned<String>,
    pub head_joints: Option<Spanned<String>>,
    pub quantity: Spanned<String>,
    pub value: Spanned<Number>,
    pub tolerance: Spanned<Number>,
    pub source: String,
    pub kind: Spanned<String>,
    pub note: Option<String>,
    pub deviation: Option<String>,
}

/// Reads the text; no value in it has been judged yet.
pub(super) fn parse(document: &Document) -> Result<File, Complaint> {
    toml::from_str(&document.text).map_err(|error| explain(document, &error))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_of_keys_is_the_one_that_serde_knows() {
        let error = toml::from_str::<File>("nonsense = 1").unwrap_err();
        let known: Vec<&str> = error.message().split('`').skip(3).step_by(2).collect();
        assert_eq!(known, CASE_KEYS);
    }
}
