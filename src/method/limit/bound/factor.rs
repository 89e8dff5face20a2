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
    /// The pattern of so many unknowns, of which these meet. The unknown that meets the fewest others
    /// is eliminated next (minimum degree: Tinney and Walker, Proc. IEEE 55 (1967) 1801-1809).
    pub(super) fn new(unknowns: usize, meetings: impl Iterator<Item = Vec<usize>>) -> Self {
        let mut next: Vec<Vec<bool>> = vec![vec![false; unknowns]; unknowns];
        for meeting in meetings {
            for &a in &meeting {
                for &b in &meeting {
                    next[a][b] = a != b;
                }
            }
        }
        let mut degree: Vec<usize> = (next.iter())
            .map(|row| row.iter().filter(|next| **next).count())
            .collect();
        let mut place = vec![usize::MAX; unknowns];
        let mut columns = Vec::new();
        for at in 0..unknowns {
            let left = (0..unknowns).filter(|&unknown| place[unknown] == usize::MAX);
            let chosen = left.min_by_key(|&unknown| degree[unknown]);
            let chosen = chosen.expect("an unknown is left");
            place[chosen] = at;
            let neighbours: Vec<usize> = (0..unknowns)
                .filter(|&b| place[b] == usize::MAX && next[chosen][b])
                .collect();
            for &a in &neighbours {
                for &b in &neighbours {
                    if a != b && !next[a][b] {
                        next[a][b] = true;
                        degree[a] += 1;
                    }
                }
                degree[a] -= 1;
            }
            columns.push(neighbours);
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

    /// How many products of tiles the factor takes.
    pub(super) fn cost(&self) -> f64 {
        let counts = self.below.iter().map(|below| below.len() as f64);
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

    /// Solves for one right side or several, in the order of the unknowns.
    pub(super) fn solve(&self, right: &DMatrix<f64>) -> DMatrix<f64> {
        let (size, place) = (self.size, &self.pattern.place);
        let mut parts = vec![DMatrix::zeros(0, 0); place.len()];
        for (unknown, &at) in place.iter().enumerate() {
            parts[at] = right.rows(unknown * size, size).clone_owned();
        }
        for column in 0..parts.len() {
            let mut own = std::mem::take(&mut parts[column]);
            self.diagonal[column].solve_lower_triangular_mut(&mut own);
            for (tile, &row) in self.below[column].iter().zip(&self.pattern.below[column]) {
                parts[row].gemm(-1.0, tile, &own, 1.0);
            }
            parts[column] = own;
        }
        for column in (0..parts.len()).rev() {
            let mut own = std::mem::take(&mut parts[column]);
            for (tile, &row) in self.below[column].iter().zip(&self.pattern.below[column]) {
                own.gemm_tr(-1.0, tile, &parts[row], 1.0);
            }
            self.diagonal[column].tr_solve_lower_triangular_mut(&mut own);
            parts[column] = own;
        }
        let mut solution = DMatrix::zeros(right.nrows(), right.ncols());
        for (unknown, &at) in place.iter().enumerate() {
            solution
                .rows_mut(unknown * size, size)
                .copy_from(&parts[at]);
        }
        solution
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_are_solved_as_the_whole_matrix() {
        let (unknowns, size) = (9, 4);
        let meetings = [
            vec![0, 1, 5],
            vec![2, 3],
            vec![3, 4, 8],
            vec![7, 0],
            vec![1, 3, 6],
        ];
        let pattern = Pattern::new(unknowns, meetings.iter().cloned());
        let mut tiles = Tiles::zero(&pattern, size);
        let mut whole = DMatrix::zeros(unknowns * size, unknowns * size);
        let part = DMatrix::from_fn(size, size, |i, j| 1.0 / (1.0 + i as f64 + j as f64));
        let mut add = |p: usize, q: usize, value: f64, part: &DMatrix<f64>| {
            tiles.add(p, q, value, part);
            let mut view = whole.view_mut((size * p, size * q), (size, size));
            view += part * value;
        };
        for (n, meeting) in meetings.iter().enumerate() {
            let value = |unknown: usize| ((3 * n + unknown) as f64).cos();
            for &p in meeting {
                for &q in meeting {
                    add(p, q, value(p) * value(q), &part);
                }
            }
        }
        for unknown in 0..unknowns {
            add(unknown, unknown, 1.0, &DMatrix::identity(size, size));
        }
        let right = DMatrix::from_fn(unknowns * size, 2, |i, j| (i + 5 * j) as f64);
        let solution = tiles.factor(0.0, 0.0, 0.0).solve(&right);
        assert!((whole * solution - right).amax() < 1e-10);
    }
}
