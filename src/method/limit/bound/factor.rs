//! A sparse Cholesky factor of square tiles: one row of tiles an unknown of the motion, a tile where two
//! of them meet in a rate or elimination fills one in.

use std::sync::Mutex;

use nalgebra::DMatrix;

use super::dense;
use super::pattern::{Done, Pattern};
use crate::certificate::Entry;
use crate::method::at_once::{both, each};

/// A symmetric matrix of tiles.
pub(super) struct Tiles<'a> {
    pattern: &'a Pattern,
    size: usize,
    columns: Vec<Column>,
}

/// The tiles of a column on and below the diagonal.
#[derive(Default)]
struct Column {
    diagonal: DMatrix<f64>,
    below: Vec<DMatrix<f64>>,
}

impl<'a> Tiles<'a> {
    /// The sum of parts of this size, each at every two of its unknowns times both of their values.
    pub(super) fn sum(
        pattern: &'a Pattern,
        size: usize,
        parts: &[(&[Entry], &DMatrix<f64>)],
    ) -> Self {
        let mut sums: Vec<_> = pattern.below.iter().map(|_| Vec::new()).collect();
        for (row, part) in parts {
            for &(p, x) in *row {
                for &(q, y) in *row {
                    let [row, column] = [pattern.place[p], pattern.place[q]];
                    if row >= column {
                        sums[column].push((row, x * y, *part));
                    }
                }
            }
        }
        let mut columns: Vec<_> = sums
            .into_iter()
            .enumerate()
            .map(|(column, sums)| (column, sums, Column::default()))
            .collect();
        each(&mut columns, &|(column, sums, own)| {
            let rows = &pattern.below[*column];
            let tile = || DMatrix::zeros(size, size);
            own.diagonal = tile();
            own.below = rows.iter().map(|_| tile()).collect();
            for (row, value, part) in sums {
                let tile = if row == column {
                    &mut own.diagonal
                } else {
                    let at = rows.binary_search(row);
                    &mut own.below[at.expect("the unknowns meet")]
                };
                for (target, part) in tile.iter_mut().zip(*part) {
                    *target += *value * part;
                }
            }
        });
        Self {
            pattern,
            size,
            columns: columns.into_iter().map(|(.., own)| own).collect(),
        }
    }

    /// Adds a share of each diagonal entry and a share of the largest one, and factors.
    pub(super) fn factor(mut self, share: f64, floor: f64, held: f64) -> Self {
        let diagonals = self.columns.iter().map(|own| own.diagonal.diagonal());
        let largest = diagonals.map(|own| own.amax()).fold(0.0, f64::max);
        for Column { diagonal, .. } in &mut self.columns {
            for k in 0..self.size {
                diagonal[(k, k)] += share * diagonal[(k, k)] + floor * largest + held;
            }
        }
        let given = std::mem::take(&mut self.columns).into_iter();
        let given: Vec<_> = given.map(Mutex::new).collect();
        self.columns = self.pattern.upwards(&|column, done: &Done<Column>| {
            let given = given[column].lock();
            let given = std::mem::take(&mut *given.expect("no thread panics with it"));
            self.factored(column, given, done)
        });
        self
    }

    /// A column of the factor: what was given less the products of those to the left, in their order.
    fn factored(&self, column: usize, mut own: Column, done: &Done<Column>) -> Column {
        let left = self.pattern.left[column].iter();
        let mut across: Vec<_> = left.map(|&left| (left, DMatrix::zeros(0, 0))).collect();
        each(&mut across, &|((before, at), transposed)| {
            *transposed = done.of(*before).below[*at].transpose();
        });
        let take = |row: usize, tile: &mut DMatrix<f64>| {
            for &((before, at), ref transposed) in &across {
                if let Ok(further) = self.pattern.below[before][at..].binary_search(&row) {
                    let other = &done.of(before).below[at + further];
                    tile.gemm(-1.0, other, transposed, 1.0);
                }
            }
        };
        let rows = self.pattern.below[column].iter().copied();
        let mut below: Vec<_> = rows.zip(&mut own.below).collect();
        both(
            || {
                take(column, &mut own.diagonal);
                dense::factor(&mut own.diagonal);
            },
            || each(&mut below, &|(row, tile)| take(*row, tile)),
        );
        each(&mut own.below, &|tile| {
            dense::solve_right(tile, &own.diagonal)
        });
        own
    }

    /// Solves with the lower triangle for right sides in the order of the unknowns. The solution is in the
    /// order of elimination, a part for each unknown.
    pub(super) fn forward(&self, right: &DMatrix<f64>) -> Vec<DMatrix<f64>> {
        let is_zero = |part: &DMatrix<f64>| part.iter().all(|value| *value == 0.0);
        self.pattern.upwards(&|column, done| {
            let start = self.pattern.unknown[column] * self.size;
            let mut own = right.rows(start, self.size).clone_owned();
            for &(before, at) in &self.pattern.left[column] {
                let part = done.of(before);
                if !is_zero(part) {
                    own.gemm(-1.0, &self.columns[before].below[at], part, 1.0);
                }
            }
            if !is_zero(&own) {
                let diagonal = &self.columns[column].diagonal;
                diagonal.solve_lower_triangular_mut(&mut own);
            }
            own
        })
    }

    /// Solves with its transpose for parts in the order of elimination. The solution is in the order of the
    /// unknowns.
    pub(super) fn backward(&self, parts: &[DMatrix<f64>]) -> DMatrix<f64> {
        let solved = self.pattern.downwards(&|column, done| {
            let Column { diagonal, below } = &self.columns[column];
            let mut own = parts[column].clone();
            for (tile, &row) in below.iter().zip(&self.pattern.below[column]) {
                own.gemm_tr(-1.0, tile, done.of(row), 1.0);
            }
            diagonal.tr_solve_lower_triangular_mut(&mut own);
            own
        });
        let mut solution = DMatrix::zeros(self.size * parts.len(), parts[0].ncols());
        for (unknown, &at) in self.pattern.place.iter().enumerate() {
            let mut rows = solution.rows_mut(unknown * self.size, self.size);
            rows.copy_from(&solved[at]);
        }
        solution
    }
}
