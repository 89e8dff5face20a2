//! Parts of a mechanism that move as one rigid body.

use super::mechanism::Mechanism;
use crate::scene::Scene;

/// Blocks of one rigid motion.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidPart {
    /// The blocks, in the scene's order.
    pub blocks: Vec<usize>,
    /// Whether the part moves at all.
    pub moves: bool,
    pub area: f64,
}

/// Every block in exactly one part, largest area first. Blocks belong together where each moves
/// like the first of them, touching or not.
pub fn parts(scene: &Scene, mechanism: &Mechanism, threshold: f64) -> Vec<RigidPart> {
    let limit = threshold * mechanism.fastest(scene);
    let mut parts: Vec<RigidPart> = Vec::new();
    for (index, block) in scene.blocks().iter().enumerate() {
        let moves = mechanism.speed(scene, index, None) > limit;
        let area = block.shape.area();
        let alike = |part: &&mut RigidPart| {
            if part.moves {
                moves && mechanism.speed(scene, index, Some(part.blocks[0])) <= limit
            } else {
                !moves
            }
        };
        match parts.iter_mut().find(alike) {
            Some(part) => {
                part.blocks.push(index);
                part.area += area;
            }
            None => parts.push(RigidPart {
                blocks: vec![index],
                moves,
                area,
            }),
        }
    }
    // Stable, so that parts of equal area keep the order of their first blocks.
    parts.sort_by(|a, b| b.area.total_cmp(&a.area));
    parts
}
