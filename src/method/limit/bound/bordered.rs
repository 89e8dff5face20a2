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

/// The factor with its border.
pub(super) struct Bordered<'a> {
    /// With Vᵀ as the border.
    tiles: Tiles<'a>,
    /// The factor of 1 + Vᵀ V; none where there is no border.
    corner: Option<DMatrix<f64>>,
}

impl<'a> Bordered<'a> {
    /// Of tiles, and of the power's row p and part R Rᵀ where that is not in them. [`Tiles::factor`] says what
    /// `regular` and `held` are.
    pub(super) fn new(
        tiles: Tiles<'a>,
        power: &DVector<f64>,
        part: Option<DMatrix<f64>>,
        regular: [f64; 2],
        held: f64,
    ) -> Self {
        let tiles = match part.map(dense::root) {
            Some(root) => tiles.with_border(power, &root),
            None => tiles,
        };
        let tiles = tiles.factor(regular, held);
        let mut corner: Option<DMatrix<f64>> = None;
        for border in tiles.borders() {
            let size = border.nrows();
            let corner = corner.get_or_insert_with(|| DMatrix::identity(size, size));
            corner.gemm(1.0, border, &border.transpose(), 1.0);
        }
        if let Some(corner) = &mut corner {
            dense::factor(corner);
        }
        Self { tiles, corner }
    }

    /// Solves for one right side, a column an unknown.
    pub(super) fn solve(&self, right: &DMatrix<f64>) -> DMatrix<f64> {
        let (size, unknowns) = right.shape();
        let mut parts = (self.tiles).forward(&DVector::from_column_slice(right.as_slice()));
        if let Some(corner) = &self.corner {
            let mut across = DVector::zeros(size);
            for (border, part) in self.tiles.borders().zip(&parts) {
                across.gemv(1.0, border, part, 1.0);
            }
            corner.solve_lower_triangular_mut(&mut across);
            corner.tr_solve_lower_triangular_mut(&mut across);
            for (border, part) in self.tiles.borders().zip(&mut parts) {
                part.gemv_tr(-1.0, border, &across, 1.0);
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
        let meetings = [
            vec![0, 1, 5],
            vec![2, 3],
            vec![3, 4, 8],
            vec![7, 0],
            vec![1, 3, 6],
        ];
        assert_solved(9, 40, &meetings);
        // A grid, the corners of each square of which meet.
        let at = |row: usize, column: usize| 7 * row + column;
        let squares = (0..5).flat_map(|row| (0..6).map(move |column| (row, column)));
        let squares = squares.map(|(row, column)| {
            let corners = [(0, 0), (0, 1), (1, 0), (1, 1)];
            corners
                .map(|(down, right)| at(row + down, column + right))
                .to_vec()
        });
        let groups = assert_solved(42, 5, &squares.collect::<Vec<_>>());
        assert!(groups < 42, "some group has several columns");
    }

    /// Asserts that systems of so many unknowns, of which these meet, are solved; the number of their groups.
    fn assert_solved(unknowns: usize, size: usize, meetings: &[Vec<usize>]) -> usize {
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
            let bordered = Bordered::new(tiles, &power, border, [0.0; 2], 0.0);
            let right = DMatrix::from_fn(size, unknowns, |i, k| (i as f64 + 5.0 * k as f64).sin());
            let solution = bordered.solve(&right);
            let largest = whole.amax();
            let left = whole * solution.reshape_generic(Dyn(size * unknowns), Dyn(1))
                - right.reshape_generic(Dyn(size * unknowns), Dyn(1));
            assert!(left.amax() < largest * 1e-12, "{}", left.amax());
        }
        pattern.groups.len()
    }
}
