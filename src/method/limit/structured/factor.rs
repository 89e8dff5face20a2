//! The factor L D Lᵀ of a positive definite matrix of 3 × 3 blocks, front by front (multifrontal:
//! Duff & Reid 1983), in one thread and in a fixed order.

use super::substitution::{Triple, backward, forward};
use super::symbolic::{Child, Front, Pattern, Slot};

/// A factor and what it needs to be computed again for other values.
pub(super) struct Factor {
    pattern: Pattern,
    /// Columns of all fronts, each front's below one another with `height` rows.
    entries: Vec<f64>,
    pivots: Vec<f64>,
    /// Updates that wait for their parents.
    waiting: Vec<f64>,
    /// Least pivots of one front.
    least: Vec<f64>,
    /// A vector in the order of elimination, and a front's part of it.
    ordered: Vec<f64>,
    part: Vec<f64>,
}

/// What is added to every diagonal entry, relative to it: on mechanisms that forces hardly resist
/// the entries cancel to their last digits. Refinement takes it out again.
const SHIFT: f64 = 1e-15;

/// Pivots below this share of their diagonal entry are rounding, and replaced by [`INFINITE`].
const LEAST_PIVOT: f64 = 1e-30;

/// A pivot that keeps its unknown at zero.
const INFINITE: f64 = 1e64;

impl Factor {
    /// A factor of matrices whose blocks are `pairs` and the diagonal.
    pub(super) fn new(blocks: usize, pairs: &[(usize, usize)]) -> Self {
        let pattern = Pattern::new(blocks, pairs);
        let height = pattern.fronts.iter().map(Front::height).max();
        let height = height.unwrap_or(0);
        Self {
            entries: vec![0.0; pattern.entries],
            pivots: vec![0.0; 3 * blocks],
            waiting: vec![0.0; pattern.waiting],
            least: vec![0.0; height],
            ordered: vec![0.0; 3 * blocks],
            part: vec![0.0; height],
            pattern,
        }
    }

    /// Where a block of the matrix is to be added.
    pub(super) fn slot(&self, row: usize, column: usize) -> Slot {
        self.pattern.slot(row, column)
    }

    /// The matrix, all zero, to which its blocks are to be added at their slots (of blocks on the
    /// diagonal the lower half is enough) before [`Factor::factorise`].
    pub(super) fn cleared(&mut self) -> &mut [f64] {
        self.entries.fill(0.0);
        &mut self.entries
    }

    /// Factorises the matrix in place.
    pub(super) fn factorise(&mut self) {
        let mut top = 0;
        for front in &self.pattern.fronts {
            let (width, height, below) = (front.width(), front.height(), front.below());
            let columns = &mut self.entries[front.start..front.start + width * height];
            for (j, least) in self.least[..width].iter_mut().enumerate() {
                let diagonal = &mut columns[j * height + j];
                *least = LEAST_PIVOT * *diagonal;
                *diagonal += SHIFT * *diagonal;
            }
            let (children, own) = self.waiting.split_at_mut(top);
            let update = &mut own[..below * below];
            update.fill(0.0);
            for child in &front.children {
                let waits_at = self.pattern.fronts[child.front].waits_at;
                let of_child = &children[waits_at..][..9 * child.into.len().pow(2)];
                assemble(child, of_child, front, columns, update);
            }
            let pivots = &mut self.pivots[3 * front.first..][..width];
            eliminate(columns, height, pivots, &self.least);
            reduce(columns, height, pivots, update, below);
            if front.waits_at < top {
                self.waiting
                    .copy_within(top..top + below * below, front.waits_at);
            }
            top = front.waits_at + below * below;
        }
    }

    /// Solves for a right side, three entries a block, in place.
    pub(super) fn solve(&mut self, x: &mut [f64]) {
        let (ordered, blocks) = (&mut self.ordered, &self.pattern.order);
        for (to, &block) in ordered.chunks_exact_mut(3).zip(blocks) {
            to.copy_from_slice(&x[3 * block..3 * block + 3]);
        }
        for front in &self.pattern.fronts {
            forward(front, &self.entries, ordered, &mut self.part);
        }
        for (x, pivot) in ordered.iter_mut().zip(&self.pivots) {
            *x /= pivot;
        }
        for front in self.pattern.fronts.iter().rev() {
            backward(front, &self.entries, ordered, &mut self.part);
        }
        for (from, &block) in ordered.chunks_exact(3).zip(blocks) {
            x[3 * block..3 * block + 3].copy_from_slice(from);
        }
    }
}

/// Adds the update of a child to its parent's columns and update, lower halves.
fn assemble(child: &Child, from: &[f64], front: &Front, columns: &mut [f64], update: &mut [f64]) {
    let (height, below) = (front.height(), front.below());
    let size = 3 * child.into.len();
    for (j, &into) in child.into.iter().enumerate() {
        for c in 0..3 {
            let source = &from[(3 * j + c) * size..][..size];
            let (target, first) = match into.checked_sub(front.columns) {
                None => (&mut columns[(3 * into + c) * height..][..height], 0),
                Some(into) => (
                    &mut update[(3 * into + c) * below..][..below],
                    front.columns,
                ),
            };
            let rows = child.into[j..].iter().zip(source[3 * j..].chunks_exact(3));
            for (&row, source) in rows {
                let target = &mut target[3 * (row - first)..][..3];
                for (to, from) in target.iter_mut().zip(source) {
                    *to += from;
                }
            }
        }
    }
}

/// Factorises the columns of a front, three at a time: what those before give is taken from all three,
/// then what they give to each other.
fn eliminate(columns: &mut [f64], height: usize, pivots: &mut [f64], least: &[f64]) {
    for j in (0..pivots.len()).step_by(3) {
        let (before, own) = columns.split_at_mut(j * height);
        let (first, rest) = own.split_at_mut(height);
        let (second, third) = rest.split_at_mut(height);
        let (first, second, third) = (&mut first[j..], &mut second[j..], &mut third[j..height]);
        subtract(first, second, third, before, height, &pivots[..j]);
        pivots[j] = divide(first, least[j]);
        subtract_column(second, first, 1, pivots[j]);
        pivots[j + 1] = divide(&mut second[1..], least[j + 1]);
        subtract_column(third, first, 2, pivots[j]);
        subtract_column(third, second, 2, pivots[j + 1]);
        pivots[j + 2] = divide(&mut third[2..], least[j + 2]);
    }
}

/// Divides a column by its pivot, its first entry, which is returned.
fn divide(column: &mut [f64], least: f64) -> f64 {
    let pivot = if column[0] > least {
        column[0]
    } else {
        INFINITE
    };
    let inverse = 1.0 / pivot;
    column[1..].iter_mut().for_each(|entry| *entry *= inverse);
    pivot
}

/// Takes from a column what one before it gives, from a row on.
fn subtract_column(column: &mut [f64], before: &[f64], row: usize, pivot: f64) {
    let share = before[row] * pivot;
    for (to, from) in column[row..].iter_mut().zip(&before[row..]) {
        *to -= share * from;
    }
}

/// Takes what a front's columns give from the rows below them, lower half.
fn reduce(columns: &[f64], height: usize, pivots: &[f64], update: &mut [f64], below: usize) {
    for (j, triple) in update.chunks_exact_mut(3 * below.max(1)).enumerate() {
        let (first, rest) = triple.split_at_mut(below);
        let (second, third) = rest.split_at_mut(below);
        let (first, second, third) = (
            &mut first[3 * j..],
            &mut second[3 * j..],
            &mut third[3 * j..],
        );
        subtract(first, second, third, columns, height, pivots);
    }
}

/// Takes from the last rows of three columns what columns before them give. Three by three, so that what is
/// loaded is used three times; arguments of their own, so that the compiler knows them apart.
fn subtract(
    first: &mut [f64],
    second: &mut [f64],
    third: &mut [f64],
    before: &[f64],
    height: usize,
    pivots: &[f64],
) {
    let length = first.len();
    let row = height - length;
    let (second, third) = (&mut second[..length], &mut third[..length]);
    let triples = before.chunks_exact(3 * height).zip(pivots.chunks_exact(3));
    for (triple, pivots) in triples {
        let Triple { a, b, c } = Triple::new(triple, height, row);
        let [p, q, r] = [pivots[0], pivots[1], pivots[2]];
        let shares = [
            [a[0] * p, b[0] * q, c[0] * r],
            [a[1] * p, b[1] * q, c[1] * r],
            [a[2] * p, b[2] * q, c[2] * r],
        ];
        let (a, b, c) = (&a[..length], &b[..length], &c[..length]);
        for i in 0..length {
            let (x, y, z) = (a[i], b[i], c[i]);
            first[i] -= shares[0][0] * x + shares[0][1] * y + shares[0][2] * z;
            second[i] -= shares[1][0] * x + shares[1][1] * y + shares[1][2] * z;
            third[i] -= shares[2][0] * x + shares[2][1] * y + shares[2][2] * z;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};

    /// Blocks in courses, each joined to its neighbours, and some far pairs.
    fn pairs(courses: usize, units: usize) -> Vec<(usize, usize)> {
        let blocks = courses * units;
        let beside = (0..blocks)
            .filter(|b| (b + 1) % units != 0)
            .map(|b| (b, b + 1));
        let above = (units..blocks).map(|b| (b - units, b));
        let crossing = (units + 1..blocks).map(|b| (b, b - units - 1));
        let far = (0..blocks / 7).map(|b| (b, blocks - 1 - b));
        let all = beside.chain(above).chain(crossing).chain(far);
        all.filter(|(a, b)| a != b).collect()
    }

    fn assert_solves(blocks: usize, pairs: &[(usize, usize)]) {
        let mut state = 7u32;
        let mut number = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(state >> 8) / f64::from(1 << 24) - 0.5
        };
        let mut factor = Factor::new(blocks, pairs);
        let mut whole = DMatrix::<f64>::zeros(3 * blocks, 3 * blocks);
        // Twice, so that nothing of the first matrix stays.
        for _ in 0..2 {
            whole.fill(0.0);
            factor.cleared();
            let diagonal = (0..blocks).map(|b| (b, b));
            for (a, b) in diagonal.chain(pairs.iter().copied()) {
                // A square over both blocks, so that the whole is positive definite.
                let root = DMatrix::from_fn(6, 3, |_, _| number());
                let square = &root * root.transpose();
                for (at, (row, column)) in [(a, a), (b, b), (a, b)].into_iter().enumerate() {
                    let corner = [(0, 0), (3, 3), (0, 3)][at];
                    let mut block = square.view(corner, (3, 3)).into_owned();
                    if a == b {
                        if at > 0 {
                            continue;
                        }
                        block += DMatrix::identity(3, 3);
                    }
                    let slot = factor.slot(row, column);
                    let stored = if slot.transposed {
                        block.transpose()
                    } else {
                        block.clone()
                    };
                    for c in 0..3 {
                        for r in 0..3 {
                            factor.entries[slot.at + c * slot.stride + r] += stored[(r, c)];
                        }
                    }
                    let mut target = whole.view_mut((3 * row, 3 * column), (3, 3));
                    target += &block;
                    if row != column {
                        let mut target = whole.view_mut((3 * column, 3 * row), (3, 3));
                        target += block.transpose();
                    }
                }
            }
            factor.factorise();
        }
        let exact = DVector::from_fn(3 * blocks, |_, _| number());
        let mut found: Vec<f64> = (&whole * &exact).iter().copied().collect();
        factor.solve(&mut found);
        let error = found.iter().zip(exact.iter()).map(|(a, b)| (a - b).abs());
        assert!(error.fold(0.0, f64::max) < 1e-9, "{blocks}: {pairs:?}");
    }

    #[test]
    fn it_solves_what_a_dense_product_gives() {
        for (courses, units) in [(1, 1), (1, 2), (2, 2), (5, 4), (9, 3), (12, 12), (3, 40)] {
            assert_solves(courses * units, &pairs(courses, units));
        }
        // Blocks without neighbours.
        assert_solves(2, &[]);
    }
}
