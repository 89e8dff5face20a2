//! The record: the one text form of a case's results, for the terminal and for `snapshots/`.
//!
//! It holds no time and no iteration counts, and no digit that is not vouched for, so that it reads
//! the same on every machine.

mod lines;
mod snapshot;

pub(crate) use lines::{LEGEND, Note, fixed_width, heading, lines, notes};
pub(crate) use snapshot::{Difference, compare, records_beside};

use crate::judge::{Check, Verdict};
use crate::number::short;
use crate::run::CaseResult;
use crate::scene::{HeadJoints, JointClass, Scene};

/// The whole record of a case: geometry, one line a method, what is to be known of the answers, one line
/// a check, one line a head-joint setting for what it all comes to.
pub fn record(result: &CaseResult) -> String {
    let mut all = vec![format!("{}: {}", result.case.name, result.case.title)];
    all.extend(result.partial());
    let scenes = result.scenes.iter();
    all.extend(scenes.map(|(head_joints, sides)| fingerprint(*head_joints, &sides[0])));
    all.extend([String::new(), heading()]);
    all.extend(lines(result));
    let notes = notes(result);
    if !notes.is_empty() {
        all.push("\nnotes".to_owned());
    }
    all.extend(notes.iter().map(|note| {
        let joints = note.joints().join(", ");
        format!("  {:<12} {joints:<14} {}", note.method, note.text)
    }));
    all.push("\nchecks".to_owned());
    all.extend(result.checks.iter().map(|check| {
        let (verdict, joints) = (check.verdict.name(), check.head_joints.name());
        format!("  {verdict:<12} {joints:<8} {}", check.text)
    }));
    all.push("\nanswer".to_owned());
    let conclusions = result.conclusions.iter();
    all.extend(conclusions.map(|one| format!("  {:<8} {one}", one.head_joints.name())));
    all.join("\n") + "\n"
}

/// Counts and sums that change with the geometry.
pub fn fingerprint(head_joints: HeadJoints, scene: &Scene) -> String {
    let (low, high) = scene.bounds();
    let classes = [JointClass::Base, JointClass::Bed, JointClass::Head];
    let parts = classes.map(|class| {
        let of_class = scene.joints().iter().filter(|joint| joint.class == class);
        let (count, length) = of_class.fold((0, 0.0), |(n, sum), j| (n + 1, sum + j.length()));
        format!("{count} {} {}", class.name(), short(length, 3))
    });
    format!(
        "{:<8} {} blocks, {} joints ({}), {} x {}, weight {}",
        head_joints.name(),
        scene.blocks().len(),
        scene.joints().len(),
        parts.join(", "),
        short(high.x - low.x, 3),
        short(high.y - low.y, 3),
        short(scene.weight(), 3),
    )
}

/// How many checks ended how, in words: what the terminal says where nothing is wrong.
pub fn tally(checks: &[Check]) -> String {
    let count = |verdict| checks.iter().filter(|c| c.verdict == verdict).count();
    let mut text = format!("{} of {} checks hold", count(Verdict::Holds), checks.len());
    for verdict in [
        Verdict::Marked,
        Verdict::Deviates,
        Verdict::NotDecided,
        Verdict::Violated,
    ] {
        let number = count(verdict);
        if number > 0 {
            text.push_str(&format!(", {number} {}", verdict.name()));
        }
    }
    text
}
