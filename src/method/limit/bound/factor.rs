//! A sparse Cholesky factor of square tiles: one row of tiles an unknown of the motion, a tile where two
//! of them meet in a rate or elimination fills one in. Below them it may have one more row, the border.
//!
//! It is worked on group by group (supernodes: Liu, Ng and Peyton, SIAM J. Matrix Anal. Appl. 14 (1993) 242-252),
//! so that its products are of large matrices.

use std::sync::Mutex;

use nalgebra::{DMatrix, DMatrixView, DMatrixViewMut, DVector, DVectorView};

use super::dense;
use super::parameters::PIECE;
use super::pattern::{Done, Pattern, Rows};
use crate::certificate::Entry;
use crate::method::at_once::{both, each};

/// A symmetric matrix of tiles.
pub(super) struct Tiles<'a> {
    pattern: &'a Pattern,
    size: usize,
    groups: Vec<Group>,
}

/// The tiles of a group of columns.
#[derive(Default)]
struct Group {
    /// Of its own rows; the lower triangle counts.
    diagonal: DMatrix<f64>,
    /// Of the rows of each group below, then of the border where there is one.
    below: Vec<DMatrix<f64>>,
}

/// What a group to the left gives to one: the tiles of this one's rows, transposed, each from a column of this
/// one on; those of neighbours are one matrix.
struct Across {
    before: usize,
    transposed: Vec<(usize, DMatrix<f64>)>,
}

impl Across {
    /// Takes from some rows, up to a column, what those rows of the group to the left give.
    fn take(&self, mut rows: DMatrixViewMut<f64>, before: DMatrixView<f64>, end: usize) {
        for (column, transposed) in &self.transposed {
            let width = transposed.ncols().min(end.saturating_sub(*column));
            let mut target = rows.columns_mut(*column, width);
            target.gemm(-1.0, &before, &transposed.columns(0, width), 1.0);
        }
    }
}

/// Does something small to each of them, some of it on other threads where those are free.
fn in_pieces<T: Send>(items: &mut [T], work: &(impl Fn(&mut T) + Sync)) {
    let mut pieces: Vec<_> = items.chunks_mut(PIECE).collect();
    each(&mut pieces, &|piece| piece.iter_mut().for_each(work));
}

/// Neighbours among some places that are neighbours among others, which contain them: where they begin in
/// either, and how many they are.
fn runs(some: &[usize], others: &[usize]) -> Vec<[usize; 3]> {
    let mut runs: Vec<[usize; 3]> = Vec::new();
    for (at, place) in some.iter().enumerate() {
        let of_others = others.binary_search(place).expect("others contain some");
        match runs.last_mut() {
            Some([_, first, count]) if *first + *count == of_others => *count += 1,
            _ => runs.push([at, of_others, 1]),
        }
    }
    runs
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
                        sums[pattern.group[column]].push((row, column, x * y, *part));
                    }
                }
            }
        }
        let mut groups: Vec<_> = sums
            .into_iter()
            .enumerate()
            .map(|(group, sums)| (group, sums, Group::default()))
            .collect();
        each(&mut groups, &|(group, sums, own)| {
            let (columns, below) = (&pattern.groups[*group], &pattern.below[*group]);
            let width = columns.len() * size;
            let tiles = |rows: &Rows| DMatrix::zeros(rows.places.len() * size, width);
            own.diagonal = DMatrix::zeros(width, width);
            own.below = below.iter().map(tiles).collect();
            for (row, column, value, part) in sums {
                let column = (*column - columns.start) * size;
                let mut tile = if columns.contains(row) {
                    let row = (*row - columns.start) * size;
                    own.diagonal.view_mut((row, column), (size, size))
                } else {
                    let at = below.binary_search_by_key(&pattern.group[*row], |rows| rows.group);
                    let at = at.expect("the unknowns meet");
                    let row = below[at].places.binary_search(row).expect("so do these");
                    own.below[at].view_mut((row * size, column), (size, size))
                };
                for (mut target, part) in tile.column_iter_mut().zip(part.column_iter()) {
                    target.axpy(*value, &part, 1.0);
                }
            }
        });
        Self {
            pattern,
            size,
            groups: groups.into_iter().map(|(.., own)| own).collect(),
        }
    }

    /// With the border `row` ⊗ `root`ᵀ.
    pub(super) fn with_border(mut self, row: &DVector<f64>, root: &DMatrix<f64>) -> Self {
        let root = root.transpose();
        for (group, columns) in self.groups.iter_mut().zip(&self.pattern.groups) {
            let unknowns = columns.clone().map(|place| self.pattern.unknown[place]);
            let values: Vec<f64> = unknowns.map(|unknown| row[unknown]).collect();
            (group.below).push(DVector::from_vec(values).transpose().kronecker(&root));
        }
        self
    }

    /// Adds a share of each diagonal entry and a share of the largest one, and factors.
    pub(super) fn factor(mut self, [share, floor]: [f64; 2], held: f64) -> Self {
        let diagonals = self.groups.iter().map(|own| own.diagonal.diagonal());
        let largest = diagonals.map(|own| own.amax()).fold(0.0, f64::max);
        for Group { diagonal, .. } in &mut self.groups {
            for k in 0..diagonal.nrows() {
                diagonal[(k, k)] += share * diagonal[(k, k)] + floor * largest + held;
            }
        }
        let given = std::mem::take(&mut self.groups).into_iter();
        let given: Vec<_> = given.map(Mutex::new).collect();
        self.groups = self.pattern.upwards(&|group, done: &Done<Group>| {
            let given = given[group].lock();
            let given = std::mem::take(&mut *given.expect("no thread panics with it"));
            self.factored(group, given, done)
        });
        self
    }

    /// A group of the factor: what was given less the products of those to the left, in their order.
    fn factored(&self, group: usize, mut own: Group, done: &Done<Group>) -> Group {
        let (size, columns) = (self.size, self.pattern.groups[group].clone());
        let across = self.across(group, done);
        let below = &self.pattern.below[group];
        // Takes from the tiles of some rows, or of the border, what those of all groups to the left give.
        let take = |rows: Option<&Rows>, tiles: &mut DMatrix<f64>, is_diagonal: bool| {
            for across in &across {
                let below = &self.pattern.below[across.before];
                let (at, runs) = match rows {
                    None => (below.len(), vec![[0, 0, 1]]),
                    Some(rows) => match below.binary_search_by_key(&rows.group, |own| own.group) {
                        Ok(at) => (at, runs(&below[at].places, &rows.places)),
                        Err(_) => continue,
                    },
                };
                let before = &done.of(across.before).below[at];
                for [from, to, count] in runs {
                    let (rows, width) = (count * size, tiles.ncols());
                    let end = if is_diagonal { to * size + rows } else { width };
                    let target = tiles.rows_mut(to * size, rows);
                    across.take(target, before.rows(from * size, rows), end);
                }
            }
        };
        let places = columns.collect();
        let mut each_below: Vec<_> = own.below.iter_mut().enumerate().collect();
        both(
            || {
                take(Some(&Rows { group, places }), &mut own.diagonal, true);
                dense::factor(&mut own.diagonal);
            },
            || {
                each(&mut each_below, &|(at, tiles)| {
                    take(below.get(*at), tiles, false)
                })
            },
        );
        each(&mut own.below, &|tiles| {
            dense::solve_right(tiles, &own.diagonal)
        });
        own
    }

    /// What the groups to the left give to one, in their order.
    fn across(&self, group: usize, done: &Done<Group>) -> Vec<Across> {
        let columns: Vec<usize> = self.pattern.groups[group].clone().collect();
        let left = self.pattern.left[group].iter();
        let mut across: Vec<_> = left.map(|&left| (left, Vec::new())).collect();
        each(&mut across, &|((before, at), transposed)| {
            let tiles = &done.of(*before).below[*at];
            let runs = runs(&self.pattern.below[*before][*at].places, &columns);
            let of_runs = runs.into_iter().map(|[from, to, count]| {
                let rows = tiles.rows(from * self.size, count * self.size);
                (to * self.size, rows.transpose())
            });
            *transposed = of_runs.collect();
        });
        let across = across.into_iter();
        across
            .map(|((before, _), transposed)| Across { before, transposed })
            .collect()
    }

    /// The border's tiles, group by group.
    pub(super) fn borders(&self) -> impl Iterator<Item = &DMatrix<f64>> {
        let groups = self.groups.iter().zip(&self.pattern.below);
        groups.filter_map(|(group, below)| group.below.get(below.len()))
    }

    /// Solves with the lower triangle for a right side in the order of the unknowns. The solution is in the
    /// order of elimination, a part for each group.
    pub(super) fn forward(&self, right: &DVector<f64>) -> Vec<DVector<f64>> {
        let size = self.size;
        self.pattern.upwards(&|group, done| {
            let columns = &self.pattern.groups[group];
            let unknowns = columns.clone().map(|place| self.pattern.unknown[place]);
            let parts = unknowns.map(|unknown| right.rows(unknown * size, size));
            let values = parts.flat_map(|part| part.iter().copied().collect::<Vec<_>>());
            let mut own = DVector::from_iterator(columns.len() * size, values);
            let left = self.pattern.left[group].iter();
            let mut given: Vec<_> = left.map(|&left| (left, DVector::zeros(0))).collect();
            in_pieces(&mut given, &|((before, at), given)| {
                *given = &self.groups[*before].below[*at] * done.of(*before);
            });
            for ((before, at), given) in given {
                let places = &self.pattern.below[before][at].places;
                for (place, given) in places.iter().zip(given.as_slice().chunks(size)) {
                    let mut target = own.rows_mut((place - columns.start) * size, size);
                    target -= DVectorView::from_slice(given, size);
                }
            }
            let diagonal = &self.groups[group].diagonal;
            diagonal.solve_lower_triangular_mut(&mut own);
            own
        })
    }

    /// Solves with its transpose for parts in the order of elimination. The solution is in the order of the
    /// unknowns.
    pub(super) fn backward(&self, parts: &[DVector<f64>]) -> DVector<f64> {
        let size = self.size;
        let solved = self.pattern.downwards(&|group, done: &Done<DVector<f64>>| {
            let Group {
                diagonal, below, ..
            } = &self.groups[group];
            let below = below.iter().zip(&self.pattern.below[group]);
            let mut taken: Vec<_> = below.map(|below| (below, DVector::zeros(0))).collect();
            in_pieces(&mut taken, &|((tiles, rows), taken)| {
                let (of_rows, start) = (done.of(rows.group), self.pattern.groups[rows.group].start);
                let parts = rows.places.iter().map(|place| (place - start) * size);
                let parts = parts.flat_map(|start| &of_rows.as_slice()[start..start + size]);
                *taken = tiles.tr_mul(&DVector::from_iterator(tiles.nrows(), parts.copied()));
            });
            let mut own = parts[group].clone();
            taken.iter().for_each(|(_, taken)| own -= taken);
            diagonal.tr_solve_lower_triangular_mut(&mut own);
            own
        });
        let in_order: Vec<_> = solved
            .iter()
            .flat_map(|part| part.iter().copied())
            .collect();
        let parts = self.pattern.place.iter();
        let parts = parts.flat_map(|place| &in_order[place * size..(place + 1) * size]);
        DVector::from_iterator(in_order.len(), parts.copied())
    }
}
