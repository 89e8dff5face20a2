//! Whether a support that moves leaves the wall: the reaction of one that only presses into it, or
//! that carries nothing, would be a number without a meaning.

use toml::Spanned;

use super::checks::Written;
use super::file::MoveTable;
use crate::case::complaint::Complaint;
use crate::scene::{Joint, MovingSupport, Point, Scene, Side, SupportMotion, Vector};

/// Part of the support's speed below which a joint neither opens nor closes.
const STILL: f64 = 1e-9;

/// Every support of a motion carries a block, and does not only press into the wall as it leaves.
/// One that moves along its joints, as a springing that spreads, is accepted.
pub(super) fn leaves_the_wall(
    tables: &[Spanned<MoveTable>],
    motion: &SupportMotion,
    scene: &Scene,
) -> Result<(), Complaint> {
    for (table, support) in tables.iter().zip(&motion.supports) {
        let joints = scene.joints().iter();
        let own = joints.filter(|joint| is_of(joint, support));
        let openings: Vec<f64> = own
            .flat_map(|joint| openings(joint, motion, support))
            .collect();
        let name = &support.name;
        if openings.is_empty() {
            let complaint = table.wrong(format!("no block touches `{name}`"), "it carries nothing");
            return Err(complaint.help("name a support that blocks rest on or lean against"));
        }
        let still = STILL * support.away.norm();
        let opens = openings.iter().any(|&opening| opening > still);
        if !opens && openings.iter().any(|&opening| opening < -still) {
            let title = format!("a direction that presses `{name}` into the wall");
            let direction = &table.get_ref().direction;
            let complaint = direction.wrong(title, "none of its joints opens this way");
            return Err(complaint.help(
                "write the way that leads away from the wall, and `moves = \"against\"` where it is pushed in",
            ));
        }
    }
    Ok(())
}

fn is_of(joint: &Joint, support: &MovingSupport) -> bool {
    let blocks = support.blocks.as_ref();
    joint.from == Side::Support(support.support)
        && blocks.is_none_or(|blocks| blocks.contains(&joint.to))
}

/// How fast a joint opens at both ends as the support moves away and the block stays.
fn openings(joint: &Joint, motion: &SupportMotion, support: &MovingSupport) -> [f64; 2] {
    let velocity = |at: Point| -> Vector {
        match motion.about {
            Some(_) => motion.first_at(at),
            None => support.away,
        }
    };
    joint.ends.map(|end| -velocity(end).dot(&joint.normal))
}
