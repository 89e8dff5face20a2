//! The program's matrix, column by column, and its right side.

use std::ops::Range;

use super::scale::Scale;
use crate::scene::Scene;

/// Three columns a joint: two corner forces and the shear. Returns where the joint's four friction
/// coefficients stand: rows ±t, columns n1 and n2.
pub(super) fn joint_columns(scene: &Scene, scale: &Scale, out: &mut Entries) -> Vec<[usize; 4]> {
    let rows_of_blocks = 3 * scene.blocks().len();
    let columns = scene.joints().iter().enumerate().map(|(j, joint)| {
        let first = rows_of_blocks + 4 * j;
        let mut at = [0; 4];
        for corner in 0..2 {
            equilibrium_column(scene, scale, j, corner, out);
            out.push(first + corner, -1.0);
            at[corner] = out.push(first + 2, -joint.friction);
            at[2 + corner] = out.push(first + 3, -joint.friction);
            out.close_column();
        }
        equilibrium_column(scene, scale, j, 2, out);
        out.push(first + 2, 1.0);
        out.push(first + 3, -1.0);
        out.close_column();
        at
    });
    columns.collect()
}

/// The column of λ*: the live loads.
pub(super) fn multiplier_column(scene: &Scene, scale: &Scale, out: &mut Entries) {
    let units = wrench_units(scale);
    for (i, block) in scene.blocks().iter().enumerate() {
        for (k, live) in block.live().into_iter().enumerate() {
            if live != 0.0 {
                out.push(3 * i + k, live * scale.multiplier / units[k]);
            }
        }
    }
    out.close_column();
}

/// The column of the slack, which all `inequalities` share.
pub(super) fn slack_column(inequalities: Range<usize>, out: &mut Entries) {
    for row in inequalities {
        out.push(row, 1.0);
    }
    out.close_column();
}

/// What the joints have to balance in the equilibrium rows: dead loads and `lambda` (in the case's
/// unit) times the live ones, turned round.
pub(super) fn right_side(scene: &Scene, scale: &Scale, lambda: f64) -> Vec<f64> {
    let units = wrench_units(scale);
    let balanced = scene.blocks().iter().flat_map(|block| {
        let loads = block.loads_at(lambda);
        [0, 1, 2].map(|k| -loads[k] / units[k])
    });
    balanced.collect()
}

fn wrench_units(scale: &Scale) -> [f64; 3] {
    [scale.force, scale.force, scale.force * scale.length]
}

/// Force of one variable of a joint (0, 1: corner forces; 2: shear) in the equilibrium rows.
fn equilibrium_column(scene: &Scene, scale: &Scale, j: usize, kind: usize, out: &mut Entries) {
    let joint = &scene.joints()[j];
    let (point, direction) = match kind {
        2 => (joint.ends[0], joint.tangent()),
        corner => (joint.ends[corner], joint.normal),
    };
    let mut blocks = joint.blocks();
    let mut bodies = [blocks.next(), blocks.next()];
    // Rows of a column must ascend.
    bodies.sort_by_key(|body| body.map(|(block, _)| block));
    for (block, sign) in bodies.into_iter().flatten() {
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

/// Entries of a joint's three columns at most: each in three rows of two blocks, and eight in the
/// inequalities.
const OF_A_JOINT: usize = 3 * 6 + 8;

impl Entries {
    /// No column yet, and room for those of so many joints.
    pub(super) fn for_joints(joints: usize) -> Self {
        let mut starts = Vec::with_capacity(3 * joints + 2);
        starts.push(0);
        Self {
            starts,
            rows: Vec::with_capacity(OF_A_JOINT * joints),
            values: Vec::with_capacity(OF_A_JOINT * joints),
        }
    }

    /// Adds to the open column; returns the position of the value.
    fn push(&mut self, row: usize, value: f64) -> usize {
        self.rows.push(row);
        self.values.push(value);
        self.values.len() - 1
    }

    fn close_column(&mut self) {
        self.starts.push(self.rows.len());
    }
}
