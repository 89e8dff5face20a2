//! From the text of a file to a case: every value judged, the geometry laid once.

use toml::Spanned;

use super::bodies::ReadFile;
use super::checks::{HEAD_JOINTS, Written, choose, positive};
use super::doubts::doubts;
use super::explain::explain;
use super::file::{BlocksTable, CaseFile};
use super::form::geometry;
use super::mistakes::all_mistakes;
use super::moves::motion;
use super::references::reference;
use super::values::Number;
use crate::case::complaint::{Complaint, Document};
use crate::case::geometry::Geometry;
use crate::case::model::Case;
use crate::case::name::case_name;
use crate::case::printable::printable;
use crate::scene::{HeadJoints, Push};

impl Case {
    /// Reads a case that stands alone from the bytes of a file; `path` names it and stands in
    /// complaints.
    ///
    /// # Errors
    /// What is wrong, where, and what to write instead: all mistakes of the file that can be told apart.
    pub fn read(path: &str, bytes: &[u8]) -> Result<Case, Complaint> {
        let no_file = |_: &str| Err("nothing lies beside this case".into());
        Self::read_with(path, bytes, &no_file)
    }

    /// [`read`](Self::read) for a case that may name a file beside it, which `read_file` reads.
    ///
    /// # Errors
    /// As [`read`](Self::read); also the first mistake of the file beside it.
    pub fn read_with(path: &str, bytes: &[u8], read_file: ReadFile) -> Result<Case, Complaint> {
        Self::read_closing(path, bytes, read_file, None)
    }

    /// [`read_with`](Self::read_with), with gaps between explicit blocks closed up to this width, as
    /// `gap` in the file does.
    ///
    /// # Errors
    /// As [`read_with`](Self::read_with).
    pub(crate) fn read_closing(
        path: &str,
        bytes: &[u8],
        read_file: ReadFile,
        gap: Option<f64>,
    ) -> Result<Case, Complaint> {
        let name = case_name(path)?;
        let document = Document::read(path, bytes)?;
        let read = |document: &Document| {
            let read = case(document, name.clone(), read_file, gap);
            read.map_err(|complaint| complaint.in_document(document))
        };
        let mut case = read(&document)
            .map_err(|first| all_mistakes(&document, first, |other| read(other).err()))?;
        let warnings = case.warnings.drain(..);
        case.warnings = warnings.map(|w| w.in_document(&document)).collect();
        Ok(case)
    }
}

/// Judges a file and makes the case of it. `read_file` reads a file beside it.
fn case(
    document: &Document,
    name: String,
    read_file: ReadFile,
    gap: Option<f64>,
) -> Result<Case, Complaint> {
    let mut file: CaseFile =
        toml::from_str(&document.text).map_err(|error| explain(document, &error))?;
    if let Some(gap) = gap {
        if file.blocks.is_none() && file.block.is_empty() {
            let title = "gaps are closed between explicit blocks, and this case has none";
            return Err(Complaint::new(title).help("leave `--gap` out"));
        }
        let none = || Spanned::new(0..0, BlocksTable::default());
        let table = file.blocks.get_or_insert_with(none);
        table.get_mut().gap = Some(Spanned::new(0..0, Number(gap)));
    }
    let mut warnings = doubts(&file);
    let geometry = geometry(document, &file, read_file, &mut warnings)?;
    let head_joints = head_joints(&file, &geometry)?;
    let references = file.references.iter();
    Ok(Case {
        title: printable(file.title.as_deref().unwrap_or(&name)),
        source: printable(file.source.as_deref().unwrap_or_default()),
        name,
        references: references
            .map(|table| reference(table, &head_joints, !file.moves.is_empty()))
            .collect::<Result<_, _>>()?,
        motion: motion(&file, &geometry)?,
        demand: demand(&file)?,
        is_weight_unsaid: file
            .unit
            .as_ref()
            .is_some_and(|unit| unit.get_ref().weight.is_none()),
        geometry,
        pushes: pushes(&file)?,
        head_joints,
        warnings,
    })
}

fn head_joints(file: &CaseFile, geometry: &Geometry) -> Result<Vec<HeadJoints>, Complaint> {
    let Some(word) = &file.head_joints else {
        return Ok(vec![HeadJoints::Contact]);
    };
    if let Geometry::Arch(_) = geometry {
        return Err(word
            .wrong("an arch has no head joints", "its joints are radial")
            .help("remove `head_joints`"));
    }
    let [contact, open] = HEAD_JOINTS.map(|one| (one.name(), vec![one]));
    let both = ("both", HEAD_JOINTS.to_vec());
    choose("head_joints", [contact, open, both], word)
}

fn demand(file: &CaseFile) -> Result<Option<f64>, Complaint> {
    let Some(value) = &file.demand else {
        return Ok(None);
    };
    if !file.moves.is_empty() {
        let complaint = value.wrong("a demand, and a support that moves", "of what push?");
        return Err(complaint.help(
            "remove `demand`: it is the λ that a push has to reach, and here the answer is a reaction",
        ));
    }
    positive("demand", value).map(Some)
}

fn pushes(file: &CaseFile) -> Result<Vec<Push>, Complaint> {
    let Some(word) = &file.push else {
        return Ok(vec![Push::Right]);
    };
    let [right, left] = [Push::Right, Push::Left].map(|one| (one.name(), vec![one]));
    let both = ("both", vec![Push::Right, Push::Left]);
    choose("push", [right, left, both], word)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SMALL: &str = "\
unit = { length = 4.0, height = 1.75, weight = 1.0 }
courses = [\"h1*1h\", \"11\"] # remark
repeat = 2
friction = 0.65
head_joints = \"both\"

[[references]]
method = \"associative\"
head_joints = \"open\"
quantity = \"lambda\"
value = 0.6
tolerance = 1e-3
source = \"nowhere\"
kind = \"independent\"
";

    fn complaint(text: &str) -> String {
        Case::read("a.toml", text.as_bytes())
            .unwrap_err()
            .to_string()
    }

    #[test]
    fn defaults_are_the_documented_ones() {
        let case = Case::read("walls/a.toml", SMALL.as_bytes()).unwrap();
        assert_eq!((case.name.as_str(), case.title.as_str()), ("a", "a"));
        let Geometry::Wall(wall) = &case.geometry else {
            panic!("{case:?}");
        };
        assert_eq!((wall.thickness, wall.overburden), (1.0, 0.0));
        assert_eq!(wall.courses.len(), 4);
        assert_eq!(case.head_joints, [HeadJoints::Contact, HeadJoints::Open]);
        let contact = case.scene(HeadJoints::Contact).joints().len();
        assert!(case.scene(HeadJoints::Open).joints().len() < contact);
    }

    #[test]
    fn a_course_that_cannot_be_laid_is_shown_in_its_string() {
        let shown = complaint(&SMALL.replace("\"11\"", "\"gg\""));
        assert!(shown.contains("course 2 holds no block"), "{shown}");
        let caret =
            "2 | courses = [\"h1*1h\", \"gg\"] # remark\n  |                     ^^^^ in course 2";
        assert!(shown.contains(caret), "{shown}");
    }

    /// Units without anything under them are no mistake of the file: they fall, and the methods say
    /// which.
    #[test]
    fn a_wall_with_units_in_the_air_is_laid() {
        for courses in ["\"1g1\"", "\"gg11\", \"11gg\""] {
            let case = Case::read("a.toml", SMALL.replace("\"11\"", courses).as_bytes());
            assert!(case.is_ok(), "{courses}");
        }
    }

    #[test]
    fn settings_that_do_not_go_together_are_refused() {
        for (from, to, expected) in [
            ("repeat = 2", "bond = \"stack\"", "remove `bond`"),
            ("repeat = 2", "units = 3", "remove `units`"),
            ("repeat = 2", "repeat = 0", "from 1 to"),
            ("repeat = 2", "repeat = 99999", "more than 100000 blocks"),
            ("\"both\"", "\"contact\"", "never compared with a result"),
            (
                "\"both\"",
                "\"bth\"",
                "did you mean `head_joints = \"both\"`?",
            ),
            ("length = 4.0", "length = 4e6", "times longer"),
            ("length = 4.0", "length = 0", "`length` is zero"),
            ("weight = 1.0", "weight = 1e13", "absurdly large"),
            ("weight = 1.0", "weight = 1e-13", "absurdly small"),
            (
                "\"lambda\"",
                "\"lamda\"",
                "did you mean `quantity = \"lambda\"`?",
            ),
        ] {
            let shown = complaint(&SMALL.replace(from, to));
            assert!(shown.contains(expected), "{to} gives\n{shown}");
        }
    }
}
