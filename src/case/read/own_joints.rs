//! What a case says itself of single joints: their class, their friction, and whether they are open.

use std::collections::{BTreeMap, HashMap};

use toml::Spanned;

use super::checks::{Written, choose, not_negative, unknown, whole};
use super::file::{CaseFile, JointTable, Place};
use super::missing::missing_key;
use super::values::WholeNumber;
use crate::case::complaint::Complaint;
use crate::scene::{Assembly, HeadJoints, JointClass, NamedJoint, Push, Side};

/// The joints that a file describes.
#[derive(Default)]
pub(super) struct OwnJoints {
    /// Those between two bodies.
    pub named: Vec<NamedJoint>,
    /// Coefficients of friction of the joints that courses of a wall lie on.
    pub beds: BTreeMap<usize, f64>,
}

/// The `[[joint]]` tables of a file; `courses` is how many a wall has.
pub(super) fn own_joints(
    file: &CaseFile,
    assembly: &Assembly,
    courses: Option<usize>,
) -> Result<OwnJoints, Complaint> {
    let mut own = OwnJoints::default();
    if file.joint.is_empty() {
        return Ok(own);
    }
    let bodies = Bodies::of(assembly);
    for spanned in &file.joint {
        let table = spanned.get_ref();
        match (&table.between, &table.course) {
            (Some(_), Some(course)) => {
                let complaint = course.wrong("`course` beside `between`", "which joint?");
                return Err(complaint.help("remove one of the two"));
            }
            (None, Some(course)) => {
                let (course, friction) = bed(spanned, course, courses)?;
                if own.beds.insert(course, friction).is_some() {
                    let title = format!("the bed of course {course} is described twice");
                    return Err(spanned
                        .wrong(title, "here again")
                        .help("drop one of the two"));
                }
            }
            (Some(between), None) => {
                let joint = bodies.joint(spanned, between)?;
                if own
                    .named
                    .iter()
                    .any(|known| known.bodies() == joint.bodies())
                {
                    let title = format!("the joint of {} is named twice", both(between));
                    let complaint = between.wrong(title, "named before");
                    return Err(complaint.help("drop one of the two"));
                }
                own.named.push(joint);
            }
            (None, None) if courses.is_some() => return Err(missing_key(spanned.span(), "course")),
            (None, None) => return Err(missing_key(spanned.span(), "between")),
        }
    }
    Ok(own)
}

/// The course that lies on a joint, and the joint's friction.
fn bed(
    spanned: &Spanned<JointTable>,
    course: &Spanned<WholeNumber>,
    courses: Option<usize>,
) -> Result<(usize, f64), Complaint> {
    let Some(most) = courses else {
        let complaint = course.wrong("`course` of a joint of explicit blocks", "there are none");
        return Err(complaint.help("write `between = [\"A\", \"B\"]` with the names of two bodies"));
    };
    let table = spanned.get_ref();
    for (key, span) in [("class", table.class.place()), ("open", table.open.place())] {
        if let Some(span) = span {
            let title = format!("`{key}` of the bed that a course lies on");
            let complaint = Complaint::at(span, title, "it is a bed joint");
            return Err(complaint.help(format!(
                "remove `{key}`; open head joints of a course are `open_head_joints = [2]`"
            )));
        }
    }
    let Some(friction) = &table.friction else {
        return Err(missing_key(spanned.span(), "friction"));
    };
    Ok((
        whole("course", course, most)?,
        not_negative("friction", friction)?,
    ))
}

type Between = Spanned<[Spanned<String>; 2]>;

/// The two names of a joint, for messages.
fn both(between: &Between) -> String {
    let [one, other] = between.get_ref().each_ref().map(|name| name.get_ref());
    format!("`{one}` and `{other}`")
}

/// Bodies that joints can name, and what they meet in.
struct Bodies<'a> {
    places: HashMap<&'a str, Side>,
    blocks: Vec<&'a str>,
    /// Classes of the joints of two bodies; `None` where the numbers make no scene, which is refused
    /// elsewhere.
    joints: Option<BTreeMap<[Side; 2], Vec<JointClass>>>,
}

impl<'a> Bodies<'a> {
    fn of(assembly: &'a Assembly) -> Self {
        let blocks = assembly.blocks.iter().map(|block| block.name.as_str());
        let supports = assembly.supports.iter().enumerate();
        let places = blocks.clone().enumerate();
        let places = places.map(|(place, name)| (name, Side::Block(place)));
        let scene = assembly.scene(HeadJoints::Contact, Push::Right).ok();
        Self {
            places: supports
                .map(|(place, support)| (support.name.as_str(), Side::Support(place)))
                .chain(places)
                .collect(),
            blocks: blocks.collect(),
            joints: scene.map(|scene| {
                let mut joints: BTreeMap<[Side; 2], Vec<JointClass>> = BTreeMap::new();
                for joint in scene.joints() {
                    joints.entry(joint.bodies()).or_default().push(joint.class);
                }
                joints
            }),
        }
    }

    fn named(&self, word: &Spanned<String>) -> Result<Side, Complaint> {
        let found = self.places.get(word.get_ref().as_str());
        let known = self.blocks.iter().copied();
        found.copied().ok_or_else(|| unknown("block", word, known))
    }

    /// What a table says of the joint between two bodies that touch.
    fn joint(
        &self,
        spanned: &Spanned<JointTable>,
        between: &Between,
    ) -> Result<NamedJoint, Complaint> {
        let table = spanned.get_ref();
        let [one, other] = between.get_ref();
        let words = [JointClass::Bed, JointClass::Head].map(|class| (class.name(), class));
        let class = table.class.as_ref();
        let friction = table.friction.as_ref();
        let joint = NamedJoint {
            between: [self.named(one)?, self.named(other)?],
            class: class.map(|word| choose("class", words, word)).transpose()?,
            friction: friction
                .map(|value| not_negative("friction", value))
                .transpose()?,
            open: table.open.as_ref().is_some_and(|open| *open.get_ref()),
        };
        if joint.class.is_none() && joint.friction.is_none() && !joint.open {
            let complaint = between.wrong("nothing is said of this joint", "here");
            return Err(complaint.help(
                "add `friction = 0.3`, `class = \"head\"` where it is none by its slope, or `open = true`",
            ));
        }
        let met = self
            .joints
            .as_ref()
            .map(|joints| joints.get(&joint.bodies()));
        let (names, is_base) = (both(between), matches!(joint.bodies()[0], Side::Support(_)));
        let (title, help) = match met {
            Some(None) => (
                format!("{names} share no joint"),
                "`trilith show` names the joints of a case",
            ),
            _ if is_base && (joint.class.is_some() || joint.open) => (
                format!("{names} meet in a joint of a support"),
                "of these only the `friction` can be written: they are neither bed nor head joints",
            ),
            Some(Some(classes))
                if joint.open
                    && !classes
                        .iter()
                        .any(|&c| joint.class.unwrap_or(c) == JointClass::Head) =>
            {
                (
                    format!("{names} meet in a bed joint, and only head joints can be open"),
                    "write corners that leave a gap, or `class = \"head\"` where it is one",
                )
            }
            _ => return Ok(joint),
        };
        Err(between.wrong(title, "between these two").help(help))
    }
}
