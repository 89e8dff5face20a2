//! What a person writes: one wall in one TOML file, with the values it is compared with.

mod arch;
mod blocks;
mod bodies;
mod check;
mod complaint;
mod corners;
mod course;
mod courses;
mod embedded;
mod explain;
mod file;
mod forces;
mod geometry;
mod library;
mod reference;
mod template;
mod values;
mod wall;
mod written;

use std::path::Path;

pub use complaint::Complaint;
pub(crate) use complaint::{Document, listed, nearest};
pub(crate) use explain::explain;
pub use geometry::Geometry;
pub(crate) use library::{Found, look};
pub use library::{collect, embedded, find, library, paper};
pub use reference::{Kind, METHOD_NAMES, Quantity, Reference};
pub use template::Template;

use crate::scene::{HeadJoints, Push, Scene, Wall};

/// Reads the file of this name in the folder of a case; the error says in words why it cannot.
pub type Beside<'a> = &'a dyn Fn(&str) -> Result<Vec<u8>, String>;

/// A wall, how it runs, and what its results are compared with.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// The file's name without `.toml`; the name in tables, snapshots and on the command line.
    pub name: String,
    /// One line for people.
    pub title: String,
    /// Where the wall comes from; may be empty.
    pub source: String,
    /// What it is made of. It can be laid: reading the case has tried.
    pub geometry: Geometry,
    /// The directions it is pushed in, one or both; the weaker side is the answer.
    pub pushes: Vec<Push>,
    /// The settings that the case runs with, in the order of its results; never empty.
    pub head_joints: Vec<HeadJoints>,
    /// Values to compare with.
    pub references: Vec<Reference>,
}

impl Case {
    /// Reads a case that stands alone from the bytes of a file; `path` names it and stands in
    /// complaints.
    ///
    /// # Errors
    /// What is wrong, where, and what to write instead: the first mistake of the file.
    pub fn read(path: &str, bytes: &[u8]) -> Result<Case, Complaint> {
        Self::read_beside(
            path,
            bytes,
            &|_| Err("nothing lies beside this case".into()),
        )
    }

    /// [`read`](Self::read) for a case that may name a file beside it, which `beside` reads.
    ///
    /// # Errors
    /// As [`read`](Self::read); also the first mistake of the file beside it.
    pub fn read_beside(path: &str, bytes: &[u8], beside: Beside) -> Result<Case, Complaint> {
        let name = case_name(path)?;
        let document = Document::read(path, bytes)?;
        check::case(&document, &name, &file::parse(&document)?, beside)
    }

    /// What every method gets, one scene a direction of the push.
    ///
    /// # Panics
    /// As [`Geometry::scene`].
    pub fn sides(&self, head_joints: HeadJoints) -> Vec<Scene> {
        let scene = |&push| self.geometry.scene(head_joints, push);
        self.pushes.iter().map(scene).collect()
    }

    /// The first of [`sides`](Self::sides).
    ///
    /// # Panics
    /// As [`Geometry::scene`], and where `pushes` is empty.
    pub fn scene(&self, head_joints: HeadJoints) -> Scene {
        self.geometry.scene(head_joints, self.pushes[0])
    }

    /// The coursed wall, where the case is one.
    pub fn wall(&self) -> Option<&Wall> {
        match &self.geometry {
            Geometry::Wall(wall) => Some(wall),
            Geometry::Blocks(_) | Geometry::Arch(_) => None,
        }
    }
}

/// The file's stem. It goes into tables, file names and `NAME@open`, so it is held to plain words.
fn case_name(path: &str) -> Result<String, Complaint> {
    let stem = Path::new(path).file_stem().unwrap_or_default();
    let stem = stem.to_string_lossy();
    let plain = |c: char| c.is_alphanumeric() || "-_.".contains(c);
    if !stem.is_empty() && stem.chars().all(plain) {
        return Ok(stem.into_owned());
    }
    let renamed: String = stem
        .chars()
        .map(|c| if plain(c) { c } else { '-' })
        .collect();
    let title = format!("{path}: a case is named by its file, and `{stem}` is not a plain word");
    Err(Complaint::new(title).help(format!(
        "use letters, digits, `-`, `_` and `.`: rename the file to `{renamed}.toml`"
    )))
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
        let wall = case.wall().unwrap();
        assert_eq!((wall.thickness, wall.overburden), (1.0, 0.0));
        assert_eq!(wall.courses.len(), 4);
        assert_eq!(case.head_joints, [HeadJoints::Contact, HeadJoints::Open]);
        let contact = case.scene(HeadJoints::Contact).joints().len();
        assert!(case.scene(HeadJoints::Open).joints().len() < contact);
    }

    #[test]
    fn a_course_that_cannot_be_laid_is_shown_in_its_string() {
        let shown = complaint(&SMALL.replace("\"11\"", "\"1g1\""));
        assert!(
            shown.contains("course 2: the block at piece 3 touches no other"),
            "{shown}"
        );
        // The caret is below the third piece, the last `1`.
        let caret =
            "2 | courses = [\"h1*1h\", \"1g1\"] # remark\n  |                        ^ in course 2";
        assert!(shown.contains(caret), "{shown}");
        let shown = complaint(&SMALL.replace("\"11\"", "\"gg11\", \"11gg\""));
        assert!(shown.contains("course 2 has nothing under it"), "{shown}");
        // Courses 1 to 3 stand; the second time round, the first lands beside the third.
        let round = SMALL.replace("h1*1h", "1ggg");
        let shown = complaint(&round.replace("11\"]", "1111\", \"ggg1\"]"));
        assert!(shown.contains("course 4 has nothing under it"), "{shown}");
        assert!(shown.contains("here, in repeat 2"), "{shown}");
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
        let template = Template::Wall.text("a");
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
