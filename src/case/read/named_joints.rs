//! Joints that a case calls bed or head joints itself, whichever way they run.

use toml::Spanned;

use super::checks::{Written, choose, unknown_block};
use super::file::{CaseFile, JointTable};
use crate::case::complaint::Complaint;
use crate::scene::{Assembly, HeadJoints, JointClass, NamedJoint, Push, Side};

/// The joints of a file that have a class of their own. Each is between two blocks that touch.
pub(super) fn named_joints(
    file: &CaseFile,
    assembly: &Assembly,
) -> Result<Vec<NamedJoint>, Complaint> {
    if file.joint.is_empty() {
        return Ok(Vec::new());
    }
    // Numbers that make no scene are refused elsewhere.
    let scene = assembly.scene(HeadJoints::Contact, Push::Right).ok();
    let touch = |between: [usize; 2]| {
        scene.as_ref().is_none_or(|scene| {
            scene.joints().iter().any(|joint| match joint.from {
                Side::Block(from) => [from, joint.to] == between || [joint.to, from] == between,
                Side::Support(_) => false,
            })
        })
    };
    let mut named: Vec<NamedJoint> = Vec::new();
    for table in &file.joint {
        let joint = named_joint(table.get_ref(), assembly)?;
        let [one, other] = table.get_ref().between.get_ref().each_ref();
        let names = format!("`{}` and `{}`", one.get_ref(), other.get_ref());
        if !touch(joint.between) {
            let title = format!("{names} share no joint");
            let complaint = table
                .get_ref()
                .between
                .wrong(title, "no edges of them touch");
            return Err(complaint.help("`trilith show` names the joints of a case"));
        }
        let same = |known: &&NamedJoint| {
            let [a, b] = known.between;
            joint.between == [a, b] || joint.between == [b, a]
        };
        if named.iter().find(same).is_some() {
            let title = format!("the joint of {names} is named twice");
            let complaint = table.get_ref().between.wrong(title, "named before");
            return Err(complaint.help("drop one of the two"));
        }
        named.push(joint);
    }
    Ok(named)
}

fn named_joint(table: &JointTable, assembly: &Assembly) -> Result<NamedJoint, Complaint> {
    let names = || assembly.blocks.iter().map(|block| block.name.as_str());
    let place = |word: &Spanned<String>| {
        let found = names().position(|name| name == word.get_ref());
        found.ok_or_else(|| unknown_block(word, names()))
    };
    let [one, other] = table.between.get_ref();
    let classes = [JointClass::Bed, JointClass::Head].map(|class| (class.name(), class));
    Ok(NamedJoint {
        between: [place(one)?, place(other)?],
        class: choose("class", classes, &table.class)?,
    })
}
