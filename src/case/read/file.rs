//! The case file as TOML has it. Every value keeps its span, so that a complaint can point at it.

use toml::Spanned;

use super::explain::explain;
use super::values::{CoursesValue, Entries, FrictionValue, Number, Pair, WholeNumber};
use crate::case::complaint::{Complaint, Document};

/// A whole file. Which of the keys go together is judged later, where it can be said well.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CaseFile {
    pub title: Option<String>,
    pub source: Option<String>,
    pub unit: Option<Spanned<UnitTable>>,
    pub courses: Option<Spanned<CoursesValue>>,
    pub repeat: Option<Spanned<WholeNumber>>,
    pub pieces: Option<Spanned<Entries<PieceTable>>>,
    pub bond: Option<Spanned<String>>,
    pub units: Option<Spanned<WholeNumber>>,
    pub first: Option<Spanned<String>>,
    pub overlap: Option<Spanned<Number>>,
    pub overburden: Option<Spanned<Number>>,
    pub arch: Option<Spanned<ArchTable>>,
    pub blocks: Option<Spanned<BlocksTable>>,
    #[serde(default)]
    pub block: Vec<Spanned<BodyTable>>,
    #[serde(default)]
    pub support: Vec<Spanned<BodyTable>>,
    pub live: Option<Spanned<String>>,
    #[serde(default)]
    pub load: Vec<Spanned<LoadTable>>,
    pub friction: Spanned<FrictionValue>,
    pub head_joints: Option<Spanned<String>>,
    pub push: Option<Spanned<String>>,
    #[serde(default)]
    pub references: Vec<ReferenceTable>,
}

/// A generated arch.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "an `[arch]` table")]
pub(super) struct ArchTable {
    pub mean_radius: Spanned<Number>,
    pub thickness: Spanned<Number>,
    pub embrace: Spanned<Number>,
    pub voussoirs: Spanned<WholeNumber>,
    pub specific_weight: Option<Spanned<Number>>,
}

/// What all explicit blocks share.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a `[blocks]` table")]
pub(super) struct BlocksTable {
    pub csv: Option<Spanned<String>>,
    #[serde(default)]
    pub supports: Vec<Spanned<String>>,
    pub specific_weight: Option<Spanned<Number>>,
    pub thickness: Option<Spanned<Number>>,
    pub tolerance: Option<Spanned<Number>>,
    pub radial: Option<bool>,
}

/// A piece of a coursed wall that has a letter of its own.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of a piece")]
pub(super) struct PieceTable {
    pub units: Option<Spanned<Number>>,
    pub length: Option<Spanned<Number>>,
    pub gap: Option<bool>,
    pub weight: Option<Spanned<Number>>,
}

/// A block or a support; in a coursed wall, what a block of a course has of its own.
#[derive(Debug, serde::Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a `[[block]]` or `[[support]]` table"
)]
pub(super) struct BodyTable {
    pub name: Option<Spanned<String>>,
    pub corners: Option<Spanned<Vec<Spanned<Pair>>>>,
    pub weight: Option<Spanned<Number>>,
    pub centre: Option<Spanned<Pair>>,
    pub course: Option<Spanned<WholeNumber>>,
    pub piece: Option<Spanned<WholeNumber>>,
}

/// A force on a block.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a `[[load]]` table")]
pub(super) struct LoadTable {
    pub block: Spanned<String>,
    pub at: Option<Spanned<Pair>>,
    pub along: Option<Spanned<Vec<Spanned<Pair>>>>,
    pub dead: Option<Spanned<Pair>>,
    pub live: Option<Spanned<Pair>>,
}

/// What every unit is like.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of the unit's size")]
pub(super) struct UnitTable {
    pub length: Spanned<Number>,
    pub height: Spanned<Number>,
    pub thickness: Option<Spanned<Number>>,
    pub weight: Spanned<Number>,
}

/// A value to compare with.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a `[[references]]` table")]
pub(super) struct ReferenceTable {
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
pub(super) fn parse(document: &Document) -> Result<CaseFile, Complaint> {
    toml::from_str(&document.text).map_err(|error| explain(document, &error))
}

#[cfg(test)]
mod tests {
    use super::super::keys::CASE_KEYS;
    use super::*;

    #[test]
    fn the_list_of_keys_is_the_one_that_serde_knows() {
        let error = toml::from_str::<CaseFile>("nonsense = 1").unwrap_err();
        let known: Vec<&str> = error.message().split('`').skip(3).step_by(2).collect();
        assert_eq!(known, CASE_KEYS);
    }

    fn shown(text: &str) -> String {
        let document = Document {
            path: "a.toml".into(),
            text: text.into(),
        };
        parse(&document).unwrap_err().to_string()
    }

    #[test]
    fn decimal_commas_are_found_in_tables_too() {
        let text = "unit = { length = 4,0, height = 1.75 }";
        assert!(shown(text).contains("write a decimal point: `4.0`"));
        let text = "unit = { length = 4.0, height = 1,75 }";
        assert!(shown(text).contains("write a decimal point: `1.75`"));
        assert!(shown("friction = 0,65").contains("`0.65`"));
        assert!(shown("friction = \"0,65\"").contains("no quotes: `0.65`"));
        assert!(!shown("courses = [1,2\nunit = {}").contains("decimal"));
    }

    #[test]
    fn common_slips_get_help() {
        for (text, help) in [
            ("push = right", "put words in quotes: `\"right\"`"),
            ("friction =", "write a value behind the `=`"),
            ("friction = .5", "both sides of the decimal point"),
            ("friction = 1e999", "up to 1e12"),
            ("repeat = 3.0", "such as `3`"),
            ("[references]\nmethod = 'a'", "write `[[references]]`"),
            ("unit = 4", "write `unit = {"),
            ("title = 4", "put it in quotes: `\"4\"`"),
            ("[[references]]\npush = 'left'", "move `push` up"),
            ("[unit]\nlenght = 1", "did you mean `length`?"),
            ("[unit]\nlength = 1", "add `height = 1.75`"),
            ("[arch]\nthickness = 1", "add `mean_radius = "),
            ("[[block]]\nname = 'A'\ncorners = 3", "write `corners = [["),
            ("[block]\nname = 'A'", "write `[[block]]`"),
            ("[blocks]\nsupports = 'A'", "write `supports = ["),
            ("friction = ['a']", "write `friction = 0.65`, or"),
            ("friction = { bad = 1 }", "did you mean `bed`?"),
            ("friction = { head = 1 }", "add `bed = 0.65`"),
            ("arch = 3", "write `[arch]`"),
            ("block = [3]", "write the key in two brackets"),
            ("[[load]]\nblock = 'A'\nat = 3", "write `at = [1.0, 0.0]`"),
            ("", "add `friction = 0.65`"),
        ] {
            let shown = shown(text);
            assert!(shown.contains(help), "{text:?} gives\n{shown}");
        }
    }
}
