//! A sparse Cholesky factor of square tiles: one row of tiles an unknown of the motion, a tile where two
//! of them meet in a rate or elimination fills one in.

use nalgebra::DMatrix;

use super::dense;
use crate::method::at_once::each;

/// Which tiles a factor has.
pub(super) struct Pattern {
    /// Place in the order of elimination, by unknown.
    place: Vec<usize>,
    /// Places of the tiles below the diagonal, by column, ascending.
    below: Vec<Vec<usize>>,
}

impl Pattern {
    /// The pattern of so many unknowns, of which these meet. The unknown whose elimination fills in the
    /// fewest tiles is eliminated next, of these the one that meets the fewest others (minimum local fill:
    /// Tinney and Walker, Proc. IEEE 55 (1967) 1801-1809).
    pub(super) fn new(unknowns: usize, meetings: impl Iterator<Item = Vec<usize>>) -> Self {
        let mut meets = vec![vec![false; unknowns]; unknowns];
        for meeting in meetings {
            for &a in &meeting {
                for &b in &meeting {
                    meets[a][b] = a != b;
                }
            }
        }
        let mut left: Vec<usize> = (0..unknowns).collect();
        let mut place = vec![0; unknowns];
        let mut columns = Vec::new();
        while !left.is_empty() {
            let neighbours = |unknown: usize| -> Vec<usize> {
                let others = left.iter().copied();
                others.filter(|&other| meets[unknown][other]).collect()
            };
            let fill = |unknown: usize| {
                let others = neighbours(unknown);
                let missing =
                    |&a: &usize| others.iter().filter(|&&b| a < b && !meets[a][b]).count();
                let filled: usize = others.iter().map(missing).sum();
                (filled, others.len())
            };
            let chosen = (left.iter().copied().min_by_key(|&unknown| fill(unknown)))
                .expect("an unknown is left");
            let others = neighbours(chosen);
            for &a in &others {
                for &b in &others {
                    meets[a][b] = a != b;
                }
            }
            left.retain(|&unknown| unknown != chosen);
            place[chosen] = columns.len();
            columns.push(others);
        }
        let below = columns.into_iter().map(|column| {
            let mut below: Vec<usize> = column.into_iter().map(|other| place[other]).collect();
            below.sort_unstable();
            below
        });
        Self {
            below: below.collect(),
            place,
        }
    }

    /// How many products of tiles the factor takes, with one more row that meets all.
    pub(super) fn cost(&self) -> f64 {
        let counts = self.below.iter().map(|below| below.len() as f64 + 1.0);
        counts.map(|count| 1.0 / 3.0 + count + count * count).sum()
    }
}

/// A symmetric matrix of tiles, then its factor.
pub(super) struct Tiles<'a> {
    pattern: &'a Pattern,
    size: usize,
    diagonal: Vec<DMatrix<f64>>,
    below: Vec<Vec<DMatrix<f64>>>,
}

impl<'a> Tiles<'a> {
    /// Zero, of tiles of this size.
    pub(super) fn zero(pattern: &'a Pattern, size: usize) -> Self {
        let tile = || DMatrix::zeros(size, size);
        let columns = pattern.below.iter();
        Self {
            pattern,
            size,
            diagonal: columns.clone().map(|_| tile()).collect(),
            below: columns
                .map(|column| column.iter().map(|_| tile()).collect())
                .collect(),
        }
    }

    /// The tile of two unknowns, where that is on or below the diagonal.
    fn tile(&mut self, row: usize, column: usize) -> Option<&mut DMatrix<f64>> {
        let (row, column) = (self.pattern.place[row], self.pattern.place[column]);
        if row == column {
            return Some(&mut self.diagonal[row]);
        }
        let at = self.pattern.below[column].binary_search(&row).ok()?;
        Some(&mut self.below[column][at])
    }

    /// Adds value × part at two unknowns.
    pub(super) fn add(&mut self, row: usize, column: usize, value: f64, part: &DMatrix<f64>) {
        if let Some(tile) = self.tile(row, column) {
            for (target, part) in tile.iter_mut().zip(part) {
                *target += value * part;
            }
        }
    }

    /// Adds a share of each diagonal entry and a share of the largest one, and factors.
    pub(super) fn factor(mut self, share: f64, floor: f64, held: f64) -> Self {
        let largest = self.diagonal.iter().map(|tile| tile.diagonal().amax());
        let largest = largest.fold(0.0, f64::max);
        for tile in &mut self.diagonal {
            for k in 0..self.size {
                tile[(k, k)] += share * tile[(k, k)] + floor * largest + held;
            }
        }
        for column in 0..self.diagonal.len() {
            dense::factor(&mut self.diagonal[column]);
            let mut below = std::mem::take(&mut self.below[column]);
            each(&mut below, &|tile| {
                dense::solve_right(tile, &self.diagonal[column]);
            });
            self.eliminate(column, &below);
            self.below[column] = below;
        }
        self
    }

    /// Takes the tiles below a factored one from those to its right, a column at a time.
    fn eliminate(&mut self, column: usize, below: &[DMatrix<f64>]) {
        let places = &self.pattern.below[column];
        let columns = self.diagonal.iter_mut().zip(&mut self.below).enumerate();
        let mut columns: Vec<_> = columns
            .filter_map(|(across, tiles)| {
                let first = places.binary_search(&across).ok()?;
                Some((across, first, tiles))
            })
            .collect();
        each(&mut columns, &|(across, first, (diagonal, tiles))| {
            let transposed = below[*first].transpose();
            for (tile, row) in below.iter().zip(places).skip(*first) {
                let target = if row == across {
                    &mut **diagonal
                } else {
                    let at = self.pattern.below[*across].binary_search(row);
                    &mut tiles[at.expect("elimination filled it in")]
                };
                target.gemm(-1.0, tile, &transposed, 1.0);
            }
        });
    }

    /// Solves with the lower triangle for right sides in the order of the unknowns. The solution is in the
    /// order of elimination, a part for each unknown.
    pub(super) fn forward(&self, right: &DMatrix<f64>) -> Vec<DMatrix<f64>> {
        let (size, place) = (self.size, &self.pattern.place);
        let mut parts = vec![DMatrix::zeros(0, 0); place.len()];
        for (unknown, &at) in place.iter().enumerate() {
            parts[at] = right.rows(unknown * size, size).clone_owned();
        }
        for column in 0..parts.len() {
            let mut own = std::mem::take(&mut parts[column]);
            if own.iter().any(|value| *value != 0.0) {
                self.diagonal[column].solve_lower_triangular_mut(&mut own);
                for (tile, &row) in self.below[column].iter().zip(&self.pattern.below[column]) {
                    parts[row].gemm(-1.0, tile, &own, 1.0);
                }
            }
            parts[column] = own;
        }
        parts
    }

    /// Solves with its transpose for parts in the order of elimination. The solution is in the order of the
    /// unknowns.
    pub(super) fn backward(&self, mut parts: Vec<DMatrix<f64>>) -> DMatrix<f64> {
        for column in (0..parts.len()).rev() {
            let mut own = std::mem::take(&mut parts[column]);
            for (tile, &row) in self.below[column].iter().zip(&self.pattern.below[column]) {
                own.gemm_tr(-1.0, tile, &parts[row], 1.0);
            }
            self.diagonal[column].tr_solve_lower_triangular_mut(&mut own);
            parts[column] = own;
        }
        let mut solution = DMatrix::zeros(self.size * parts.len(), parts[0].ncols());
        for (unknown, &at) in self.pattern.place.iter().enumerate() {
            let mut rows = solution.rows_mut(unknown * self.size, self.size);
            rows.copy_from(&parts[at]);
        }
        solution
    }
}
