//! A factor of tiles, and what couples all unknowns as a border of it.
//!
//! The live load's power is a sum over all blocks. As a term of the tiles it would couple each of them with
//! every other one; so it is kept apart: with K = L Lᵀ of all other rates and p pᵀ ⊗ R Rᵀ of the power,
//!
//! ```text
//! (K + p pᵀ ⊗ R Rᵀ)⁻¹ = L⁻ᵀ (1 − V (1 + Vᵀ V)⁻¹ Vᵀ) L⁻¹    with V = L⁻¹ (p ⊗ R)
//! ```
//!
//! (Woodbury). The corner 1 + Vᵀ V is a sum of squares, so that nothing cancels in it.

use nalgebra::{DMatrix, DVector};

use super::dense;
use super::factor::Tiles;
use crate::method::at_once::each;

/// Columns of the border that one thread solves for at once.
const COLUMNS: usize = 32;

/// The factor with its border.
pub(super) struct Bordered<'a> {
    tiles: Tiles<'a>,
    /// V, a part for each unknown in the order of elimination; none where there is no border.
    border: Vec<DMatrix<f64>>,
    /// The factor of 1 + Vᵀ V.
    corner: DMatrix<f64>,
}

impl<'a> Bordered<'a> {
    /// Of factored tiles, and of the power's row p and part R Rᵀ where that is not in them.
    pub(super) fn new(tiles: Tiles<'a>, power: &DVector<f64>, part: Option<DMatrix<f64>>) -> Self {
        let root = part.map_or(DMatrix::zeros(0, 0), dense::root);
        let size = root.nrows();
        let mut border = Vec::new();
        let mut corner = DMatrix::identity(size, size);
        if size > 0 {
            let starts = (0..size).step_by(COLUMNS);
            let mut columns: Vec<_> = starts
                .map(|start| root.columns(start, COLUMNS.min(size - start)).into_owned())
                .map(|columns| (columns, Vec::new()))
                .collect();
            each(&mut columns, &|(columns, solved)| {
                *solved = tiles.forward(&power.kronecker(&*columns));
            });
            for unknown in 0..power.len() {
                let parts: Vec<_> = columns.iter().map(|(_, solved)| &solved[unknown]).collect();
                let columns = parts.iter().flat_map(|part| part.column_iter());
                let part = DMatrix::from_columns(&columns.collect::<Vec<_>>());
                corner.gemm(1.0, &part.transpose(), &part, 1.0);
                border.push(part);
            }
            dense::factor(&mut corner);
        }
        Self {
            tiles,
            border,
            corner,
        }
    }

    /// Solves for one right side, a column an unknown.
    pub(super) fn solve(&self, right: &DMatrix<f64>) -> DMatrix<f64> {
        let (size, unknowns) = right.shape();
        let long = DMatrix::from_column_slice(size * unknowns, 1, right.as_slice());
        let mut parts = self.tiles.forward(&long);
        if !self.border.is_empty() {
            let mut across = DMatrix::zeros(size, 1);
            for (border, part) in self.border.iter().zip(&parts) {
                across.gemm_tr(1.0, border, part, 1.0);
            }
            self.corner.solve_lower_triangular_mut(&mut across);
            self.corner.tr_solve_lower_triangular_mut(&mut across);
            for (border, part) in self.border.iter().zip(&mut parts) {
                part.gemm(-1.0, border, &across, 1.0);
            }
        }
        let solved = self.tiles.backward(&parts);
        DMatrix::from_column_slice(size, unknowns, solved.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Dyn;

    use super::super::pattern::Pattern;
    use super::*;
    use crate::certificate::Entry;

    /// With and without a border, whose part is one that rounding leaves singular.
    #[test]
    fn tiles_and_border_are_solved_as_the_whole_matrix() {
        let (unknowns, size) = (9, 40);
        let meetings = [
            vec![0, 1, 5],
            vec![2, 3],
            vec![3, 4, 8],
            vec![7, 0],
            vec![1, 3, 6],
        ];
        let pattern = Pattern::new(unknowns, meetings.iter().cloned());
        let root = DMatrix::from_fn(size, size / 2, |i, j| ((3 * i + i * j) as f64).sin());
        let part = &root * root.transpose();
        let power = DVector::from_fn(unknowns, |k, _| (1.0 + k as f64).cos());
        for border in [None, Some(1e6 * &part)] {
            let value = |n: usize, unknown: usize| ((3 * n + unknown) as f64).cos();
            let row = |n: usize| meetings[n].iter().map(|&p| (p, value(n, p))).collect();
            let rows: Vec<Vec<Entry>> = (0..meetings.len()).map(row).collect();
            let alone: Vec<Entry> = (0..unknowns).map(|unknown| (unknown, 1.0)).collect();
            let one = DMatrix::identity(size, size);
            let mut parts: Vec<_> = rows.iter().map(|row| (&row[..], &part)).collect();
            parts.extend(alone.chunks(1).map(|row| (row, &one)));
            let tiles = Tiles::sum(&pattern, size, &parts);
            let mut whole = DMatrix::zeros(unknowns * size, unknowns * size);
            for (row, part) in parts {
                let mut column = DVector::zeros(unknowns);
                for &(p, value) in row {
                    column[p] = value;
                }
                whole += (&column * column.transpose()).kronecker(part);
            }
            if let Some(part) = &border {
                whole += (&power * power.transpose()).kronecker(part);
            }
            let bordered = Bordered::new(tiles.factor(0.0, 0.0, 0.0), &power, border);
            let right = DMatrix::from_fn(size, unknowns, |i, k| (i as f64 + 5.0 * k as f64).sin());
            let solution = bordered.solve(&right);
            let largest = whole.amax();
            let left = whole * solution.reshape_generic(Dyn(size * unknowns), Dyn(1))
                - right.reshape_generic(Dyn(size * unknowns), Dyn(1));
            assert!(left.amax() < largest * 1e-12, "{}", left.amax());
        }
    }
}
