//! Supports that move, as a case of explicit blocks has them.

use std::fmt::Write;

use super::written::{pair, quoted};
use crate::scene::{Assembly, HeadJoints, NamedJoint, Push, Side, Support, SupportMotion, beside};

/// Gives the parts of the ground that move supports of their own, and what lies between them others.
pub(super) fn with_parts(assembly: &mut Assembly, motion: &SupportMotion) {
    let parts = motion.supports.iter().filter(|part| part.blocks.is_some());
    let parts: Vec<Support> = parts
        .map(|part| Support {
            name: part.name.clone(),
            shape: part.shape.clone(),
        })
        .collect();
    if parts.is_empty() {
        return;
    }
    let ground = assembly.supports.remove(0).shape;
    let still = beside(&ground, parts.iter().map(|part| &part.shape)).into_iter();
    let still = still.map(|shape| Support {
        name: format!("ground from {:?}", shape.bounds().0.x),
        shape,
    });
    assembly.supports.extend(still.chain(parts));
    let left = |support: &Support| support.shape.bounds().0.x;
    assembly
        .supports
        .sort_by(|a, b| left(a).total_cmp(&left(b)));
    let is_base = |named: &NamedJoint| matches!(named.bodies()[0], Side::Support(_));
    let (on_ground, mut named): (Vec<NamedJoint>, Vec<NamedJoint>) = assembly
        .named_joints
        .iter()
        .partition(|named| is_base(named));
    let scene = assembly.scene(HeadJoints::Contact, Push::Right);
    for joint in scene.iter().flat_map(|scene| scene.joints()) {
        let of_block = |named: &&NamedJoint| named.bodies()[1] == Side::Block(joint.to);
        let base = matches!(joint.from, Side::Support(_));
        named.extend(
            on_ground
                .iter()
                .filter(of_block)
                .filter(|_| base)
                .map(|known| NamedJoint {
                    between: joint.bodies(),
                    ..*known
                }),
        );
    }
    assembly.named_joints = named;
}

pub(super) fn tables(motion: &SupportMotion) -> String {
    let mut text = String::new();
    for support in &motion.supports {
        let (name, way) = (quoted(&support.name), motion.sense.name());
        let direction = pair(support.away);
        let _ = writeln!(
            text,
            "\n[[move]]\nsupport = {name}\ndirection = {direction}\nmoves = \"{way}\""
        );
        let _ = match motion.about {
            Some(about) => writeln!(text, "about = {}", pair(about.coords)),
            None => writeln!(text, "rate = {:?}", support.away.norm()),
        };
        if motion.pushed != 0.0 {
            let _ = writeln!(text, "pushed = {:?}", motion.pushed);
        }
    }
    text
}
