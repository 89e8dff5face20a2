//! The program's matrix, column by column.

use super::scale::Scale;
use crate::scene::{Scene, Side};

/// Force of one variable of a joint (0, 1: corner forces; 2: shear) in the equilibrium rows.
pub(super) fn equilibrium_column(
    scene: &Scene,
    scale: &Scale,
    j: usize,
    kind: usize,
    out: &mut Entries,
) {
    let joint = &scene.joints()[j];
    let (point, direction) = match kind {
        2 => (joint.ends[0], joint.tangent()),
        corner => (joint.ends[corner], joint.normal),
    };
    let mut bodies = [(Some(joint.to), 1.0), (None, -1.0)];
    if let Side::Block(from) = joint.from {
        bodies[1].0 = Some(from);
    }
    // Rows of a column must ascend.
    bodies.sort_by_key(|body| body.0);
    for (block, sign) in bodies {
        let Some(block) = block else { continue };
        let arm = (point - scene.blocks()[block].shape.centroid()) / scale.length;
        let wrench = [direction.x, direction.y, arm.perp(&direction)];
        for (k, value) in wrench.into_iter().enumerate() {
            if value != 0.0 {
                out.push(3 * block + k, sign * value);
            }
        }
    }
}

/// Compressed columns under construction.
pub(super) struct Entries {
    pub(super) starts: Vec<usize>,
    pub(super) rows: Vec<usize>,
    pub(super) values: Vec<f64>,
}

impl Default for Entries {
    fn default() -> Self {
        Self {
            starts: vec![0],
            rows: Vec::new(),
            values: Vec::new(),
        }
    }
}

impl Entries {
    /// Adds to the open column; returns the position of the value.
    pub(super) fn push(&mut self, row: usize, value: f64) -> usize {
        self.rows.push(row);
        self.values.push(value);
        self.values.len() - 1
    }

    pub(super) fn close_column(&mut self) {
        self.starts.push(self.rows.len());
    }
}
