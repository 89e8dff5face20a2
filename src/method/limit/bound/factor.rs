//! A sparse Cholesky factor of square tiles: one row of tiles a block of the scene, a tile where two
//! blocks share a joint or elimination fills one in.

use nalgebra::DMatrix;

use super::dense;
use crate::method::at_once::each;

/// Which tiles a factor has.
pub(super) struct Pattern {
    /// Place in the order of elimination, by block.
    place: Vec<usize>,
    /// Places of the tiles below the diagonal, by column, ascending.
    below: Vec<Vec<usize>>,
    /// Whether every pair of blocks has a tile.
    pub(super) is_full: bool,
}

impl Pattern {
    /// The pattern of so many blocks of which these pairs are neighbours. The block with the fewest
    /// neighbours left is eliminated next: on scenes of at most some hundred blocks that is as good
    /// as any order.
    pub(super) fn new(blocks: usize, pairs: impl Iterator<Item = (usize, usize)>) -> Self {
        let mut next: Vec<Vec<bool>> = vec![vec![false; blocks]; blocks];
        for (a, b) in pairs {
            next[a][b] = true;
            next[b][a] = true;
        }
        let mut place = vec![usize::MAX; blocks];
        let mut columns = Vec::new();
        for at in 0..blocks {
            let left = |block: &usize| place[*block] == usize::MAX;
            let degree =
                |block: &usize| (0..blocks).filter(|b| left(b) && next[*block][*b]).count();
            let chosen = (0..blocks).filter(left).min_by_key(degree);
            let chosen = chosen.expect("a block is left");
            place[chosen] = at;
            let neighbours: Vec<usize> = (0..blocks)
                .filter(|&b| place[b] == usize::MAX && next[chosen][b])
                .collect();
            for &a in &neighbours {
                for &b in &neighbours {
                    next[a][b] = a != b;
                }
            }
            columns.push(neighbours);
        }
        let below = columns.into_iter().map(|column| {
            let mut below: Vec<usize> = column.into_iter().map(|block| place[block]).collect();
            below.sort_unstable();
            below
        });
        let below: Vec<Vec<usize>> = below.collect();
        Self {
            is_full: below.iter().map(Vec::len).sum::<usize>() == blocks * (blocks - 1) / 2,
            below,
            place,
        }
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

    /// The tile of a row block and a column block, where that is on or below the diagonal.
    fn tile(&mut self, row: usize, column: usize) -> Option<&mut DMatrix<f64>> {
        let (row, column) = (self.pattern.place[row], self.pattern.place[column]);
        if row == column {
            return Some(&mut self.diagonal[row]);
        }
        let at = self.pattern.below[column].binary_search(&row).ok()?;
        Some(&mut self.below[column][at])
    }

    /// Adds value × part, where `part` stands at the unknowns `rows` and `columns` of two blocks.
    pub(super) fn add(
        &mut self,
        [row_block, column_block]: [usize; 2],
        [row, column]: [usize; 2],
        value: f64,
        part: &DMatrix<f64>,
    ) {
        let n = part.nrows();
        if let Some(tile) = self.tile(row_block, column_block) {
            for k in 0..n {
                let mut target = tile.column_mut(column * n + k);
                let mut target = target.rows_mut(row * n, n);
                target.axpy(value, &part.column(k), 1.0);
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

    /// Solves for one right side or several, in the order of the blocks.
    pub(super) fn solve(&self, right: &DMatrix<f64>) -> DMatrix<f64> {
        let (size, place) = (self.size, &self.pattern.place);
        let mut parts = vec![DMatrix::zeros(0, 0); place.len()];
        for (block, &at) in place.iter().enumerate() {
            parts[at] = right.rows(block * size, size).clone_owned();
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
        for (block, &at) in place.iter().enumerate() {
            solution.rows_mut(block * size, size).copy_from(&parts[at]);
        }
        solution
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_are_solved_as_the_whole_matrix() {
        let (blocks, size) = (5, 6);
        let pairs = [(0, 1), (1, 2), (2, 3), (3, 4), (4, 0), (1, 3)];
        let pattern = Pattern::new(blocks, pairs.into_iter());
        let mut tiles = Tiles::zero(&pattern, size);
        let mut whole = DMatrix::zeros(blocks * size, blocks * size);
        let part = DMatrix::from_fn(2, 2, |i, j| 1.0 / (1.0 + i as f64 + j as f64));
        for (n, &(a, b)) in pairs.iter().enumerate() {
            let row: Vec<(usize, f64)> = [a, b]
                .iter()
                .flat_map(|&block| {
                    (0..3).map(move |k| (3 * block + k, ((n + 3 * k + block) as f64).cos()))
                })
                .collect();
            for &(p, x) in &row {
                for &(q, y) in &row {
                    tiles.add([p / 3, q / 3], [p % 3, q % 3], x * y, &part);
                    let mut view = whole.view_mut((2 * p, 2 * q), (2, 2));
                    view += &part * (x * y);
                }
            }
        }
        whole += DMatrix::identity(30, 30);
        for block in 0..blocks {
            for k in 0..3 {
                tiles.add([block, block], [k, k], 1.0, &DMatrix::identity(2, 2));
            }
        }
        let right = DMatrix::from_fn(30, 2, |i, j| (i + 5 * j) as f64);
        let solution = tiles.factor(0.0, 0.0, 0.0).solve(&right);
        assert!((whole * solution - right).amax() < 1e-10);
    }
}
