//! The factor L D Lᵀ of a positive definite matrix of 3 × 3 blocks, front by front (multifrontal:
//! Duff & Reid 1983), in one thread and in a fixed order.
//!
//! It is compiled for vectors of four numbers too and takes those where the processor has them. The bits
//! are the same: nothing is fused, and sums are taken in the same order.

use pulp::{Arch, Simd, WithSimd};

use super::front::{assemble, eliminate, reduce};
use super::substitution::{backward, forward};
use super::symbolic::{Front, Pattern, Slot};

/// A factor and what it needs to be computed again for other values.
pub(super) struct Factor {
    pattern: Pattern,
    /// Columns of all fronts, each front's below one another with `height` rows.
    entries: Vec<f64>,
    pivots: Vec<f64>,
    /// Updates that wait for their parents, in two stores.
    waiting: [Vec<f64>; 2],
    /// Least pivots of one front.
    least: Vec<f64>,
    /// A vector in the order of elimination, and a front's part of it.
    ordered: Vec<f64>,
    part: Vec<f64>,
    /// What the processor has.
    arch: Arch,
}

/// What is added to every diagonal entry, relative to it: on mechanisms that forces hardly resist
/// the entries cancel to their last digits. Refinement takes it out again.
const SHIFT: f64 = 1e-15;

/// Pivots below this share of their diagonal entry are rounding.
const LEAST_PIVOT: f64 = 1e-30;

impl Factor {
    /// A factor of matrices whose blocks are `pairs` and the diagonal.
    pub(super) fn new(blocks: usize, pairs: &[(usize, usize)]) -> Self {
        let pattern = Pattern::new(blocks, pairs);
        let height = pattern.fronts.iter().map(Front::height).max();
        let height = height.unwrap_or(0);
        Self {
            entries: vec![0.0; pattern.entries],
            pivots: vec![0.0; 3 * blocks],
            waiting: pattern.waiting.map(|entries| vec![0.0; entries]),
            least: vec![0.0; height],
            ordered: vec![0.0; 3 * blocks],
            part: vec![0.0; height],
            pattern,
            arch: Arch::new(),
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
        self.arch.dispatch(Factorise(self));
    }

    /// Solves for a right side, three entries a block, in place.
    pub(super) fn solve(&mut self, x: &mut [f64]) {
        self.arch.dispatch(Solve(self, x));
    }
}

/// A factor that is to be computed. All that this calls is inlined, as only then it is compiled for vectors too.
struct Factorise<'a>(&'a mut Factor);

impl WithSimd for Factorise<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let factor = self.0;
        let fronts = &factor.pattern.fronts;
        let [even, odd] = &mut factor.waiting;
        for front in fronts {
            let (width, height, below) = (front.width(), front.height(), front.below());
            let columns = &mut factor.entries[front.start..front.start + width * height];
            for (j, least) in factor.least[..width].iter_mut().enumerate() {
                let diagonal = &mut columns[j * height + j];
                *least = LEAST_PIVOT * *diagonal;
                *diagonal += SHIFT * *diagonal;
            }
            let (children, own) = match front.store {
                0 => (&*odd, &mut *even),
                _ => (&*even, &mut *odd),
            };
            let update = &mut own[front.waits_at..][..below * below];
            update.fill(0.0);
            for child in &front.children {
                let waits_at = fronts[child.front].waits_at;
                let of_child = &children[waits_at..][..9 * child.into.len().pow(2)];
                assemble(child, of_child, front, columns, update);
            }
            let pivots = &mut factor.pivots[3 * front.first..][..width];
            eliminate(columns, height, pivots, &factor.least);
            reduce(columns, height, pivots, update, below);
        }
    }
}

/// A right side that is to be solved for; inlined for the same reason.
struct Solve<'a>(&'a mut Factor, &'a mut [f64]);

impl WithSimd for Solve<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Self(factor, x) = self;
        let (ordered, pattern) = (&mut factor.ordered, &factor.pattern);
        for (to, &block) in ordered.chunks_exact_mut(3).zip(&pattern.order) {
            to.copy_from_slice(&x[3 * block..3 * block + 3]);
        }
        for front in &pattern.fronts {
            forward(front, &factor.entries, ordered, &mut factor.part);
        }
        for (x, pivot) in ordered.iter_mut().zip(&factor.pivots) {
            *x /= pivot;
        }
        for front in pattern.fronts.iter().rev() {
            backward(front, &factor.entries, ordered, &mut factor.part);
        }
        for (from, &block) in ordered.chunks_exact(3).zip(&pattern.order) {
            x[3 * block..3 * block + 3].copy_from_slice(from);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};
    use pulp::Scalar;

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
        let [mut factor, mut plain] = [(); 2].map(|()| Factor::new(blocks, pairs));
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
            plain.entries.clone_from(&factor.entries);
            factor.factorise();
            Factorise(&mut plain).with_simd(Scalar::new());
        }
        let exact = DVector::from_fn(3 * blocks, |_, _| number());
        let mut found: Vec<f64> = (&whole * &exact).iter().copied().collect();
        let mut by_plain = found.clone();
        factor.solve(&mut found);
        Solve(&mut plain, &mut by_plain).with_simd(Scalar::new());
        assert_eq!(found, by_plain, "vectors change bits");
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
