//! Supports that move, as a case of explicit blocks has them.

use std::fmt::Write;

use super::written::{pair, quoted};
use crate::scene::{Assembly, Polygon, Support, SupportMotion};

/// Gives the parts of the ground that move supports of their own, and what lies between them others.
pub(super) fn with_parts(assembly: &mut Assembly, motion: &SupportMotion) {
    let parts = motion.supports.iter().filter(|part| part.blocks.is_some());
    let mut parts: Vec<Support> = parts
        .map(|part| Support {
            name: part.name.clone(),
            shape: part.shape.clone(),
        })
        .collect();
    if parts.is_empty() {
        return;
    }
    parts.sort_by(|a, b| a.shape.bounds().0.x.total_cmp(&b.shape.bounds().0.x));
    let (low, high) = assembly.supports.remove(0).shape.bounds();
    let mut from = low.x;
    for part in parts {
        let (left, right) = part.shape.bounds();
        assembly
            .supports
            .extend(ground(from, left.x, [low.y, high.y]));
        assembly.supports.push(part);
        from = right.x;
    }
    assembly
        .supports
        .extend(ground(from, high.x, [low.y, high.y]));
}

/// Ground from one place to another, where there is any.
fn ground(from: f64, to: f64, [low, high]: [f64; 2]) -> Option<Support> {
    let shape = Polygon::rectangle(from, to, low, high).ok()?;
    let name = format!("ground from {from:?}");
    Some(Support { name, shape })
}

/// The `[[move]]` tables.
pub(super) fn tables(motion: &SupportMotion) -> String {
    let mut text = String::new();
    for support in &motion.supports {
        let (name, way) = (quoted(&support.name), motion.sense.name());
        let direction = pair(support.away);
        let _ = writeln!(
            text,
            "\n[[move]]\nsupport = {name}\ndirection = {direction}\nmoves = \"{way}\""
        );
        match motion.about {
            Some(about) => {
                let _ = writeln!(text, "about = {}", pair(about.coords));
            }
            None => {
                let _ = writeln!(text, "rate = {:?}", support.away.norm());
            }
        }
        if motion.pushed != 0.0 {
            let _ = writeln!(text, "pushed = {:?}", motion.pushed);
        }
    }
    text
}
