//! From the text of a file to a case: every value judged, the geometry laid once.

use super::bodies::ReadFile;
use super::checks::{HEAD_JOINTS, choose};
use super::doubts::doubts;
use super::file::{CaseFile, parse};
use super::form::geometry;
use super::references::reference;
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
    /// What is wrong, where, and what to write instead: the first mistake of the file.
    pub fn read(path: &str, bytes: &[u8]) -> Result<Case, Complaint> {
        let no_file = |_: &str| Err("nothing lies beside this case".into());
        Self::read_with(path, bytes, &no_file)
    }

    /// [`read`](Self::read) for a case that may name a file beside it, which `read_file` reads.
    ///
    /// # Errors
    /// As [`read`](Self::read); also the first mistake of the file beside it.
    pub fn read_with(path: &str, bytes: &[u8], read_file: ReadFile) -> Result<Case, Complaint> {
        let name = case_name(path)?;
        let document = Document::read(path, bytes)?;
        case(&document, &name, &parse(&document)?, read_file)
    }
}

/// Judges a file and makes the case of it. `read_file` reads a file beside it.
fn case(
    document: &Document,
    name: &str,
    file: &CaseFile,
    read_file: ReadFile,
) -> Result<Case, Complaint> {
    let mut warnings = doubts(document, file);
    let geometry = geometry(document, file, read_file, &mut warnings)?;
    let head_joints = head_joints(document, file, &geometry)?;
    let references = file.references.iter();
    Ok(Case {
        name: name.to_owned(),
        title: printable(file.title.as_deref().unwrap_or(name)),
        source: printable(file.source.as_deref().unwrap_or_default()),
        references: references
            .map(|table| reference(document, table, &head_joints))
            .collect::<Result<_, _>>()?,
        geometry,
        pushes: pushes(document, file)?,
        head_joints,
        warnings,
    })
}

fn head_joints(
    document: &Document,
    file: &CaseFile,
    geometry: &Geometry,
) -> Result<Vec<HeadJoints>, Complaint> {
    let Some(word) = &file.head_joints else {
        return Ok(vec![HeadJoints::Contact]);
    };
    if let Geometry::Arch(_) = geometry {
        let title = "an arch has no head joints";
        return Err(document
            .complain(word.span(), title, "its joints are radial")
            .help("remove `head_joints`"));
    }
    let [contact, open] = HEAD_JOINTS.map(|one| (one.name(), vec![one]));
    let both = ("both", HEAD_JOINTS.to_vec());
    choose(document, "head_joints", [contact, open, both], word)
}

fn pushes(document: &Document, file: &CaseFile) -> Result<Vec<Push>, Complaint> {
    let Some(word) = &file.push else {
        return Ok(vec![Push::Right]);
    };
    let words = [
        ("right", vec![Push::Right]),
        ("left", vec![Push::Left]),
        ("both", vec![Push::Right, Push::Left]),
    ];
    choose(document, "push", words, word)
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
            ("[\"h1*1h\", \"11\"]", "6", "add `bond = \"running\"`"),
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

    /// Deterministic noise (xorshift): the same mutations in every run.
    fn noise(state: &mut u64) -> usize {
        *state ^= *state << 13;
        *state ^= *state >> 7;
        *state ^= *state << 17;
        (*state >> 16) as usize
    }

    #[test]
    fn broken_bytes_are_complained_about_and_never_panic() {
        let template = include_str!("../templates/wall.toml").replace("NAME", "a");
        let odd = b"\"'[]{}=#*,.-+0919hg1x_ \n\r\t\\\0\x7f\xc3\xa9\xff";
        let mut state = 0x9E37_79B9_7F4A_7C15;
        let mut complaints = 0;
        for round in 0..4000 {
            let text = if round % 2 == 0 { SMALL } else { &template };
            let mut bytes = text.as_bytes().to_vec();
            for _ in 0..=noise(&mut state) % 3 {
                let at = noise(&mut state) % bytes.len();
                let new = odd[noise(&mut state) % odd.len()];
                match noise(&mut state) % 4 {
                    0 => bytes[at] = new,
                    1 => bytes.insert(at, new),
                    2 => drop(bytes.remove(at)),
                    _ if round % 5 == 0 => bytes.truncate(at + 1),
                    _ => bytes.swap(at, 0),
                }
            }
            if let Err(complaint) = Case::read("a.toml", &bytes) {
                complaints += 1;
                assert!(complaint.to_string().contains("help: "));
                assert!(complaint.line().is_some());
            }
        }
        assert!(complaints > 1000, "{complaints}");
    }
}
