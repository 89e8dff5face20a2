//! Dense Cholesky factors in blocks, so that nearly all work is products of matrices.

use nalgebra::DMatrix;

use super::parameters::{BLOCK, HELD_PIVOT, LOST_PIVOT};

/// Factors a symmetric matrix, of which the lower triangle is read and overwritten. Pivots that
/// rounding has taken hold their unknowns.
pub(super) fn factor(a: &mut DMatrix<f64>) {
    let n = a.nrows();
    let first: Vec<f64> = (0..n).map(|k| a[(k, k)]).collect();
    for start in (0..n).step_by(BLOCK) {
        let end = (start + BLOCK).min(n);
        if start > 0 {
            let left = a.view((start, 0), (n - start, start)).clone_owned();
            let across = a.view((start, 0), (end - start, start)).transpose();
            let mut panel = a.view_mut((start, start), (n - start, end - start));
            panel.gemm(-1.0, &left, &across, 1.0);
        }
        for j in start..end {
            let factors: Vec<f64> = (start..j).map(|p| a[(j, p)]).collect();
            subtract(
                &mut a.as_mut_slice()[start * n..],
                n,
                [j - start, j],
                &factors,
            );
            let pivot = a[(j, j)];
            let root = if pivot > LOST_PIVOT * first[j].abs() {
                pivot.sqrt()
            } else {
                HELD_PIVOT
            };
            let mut column = a.view_mut((j, j), (n - j, 1));
            column /= root;
            a[(j, j)] = root;
        }
    }
}

/// Subtracts multiples of the first columns of `n` numbers from another one, from a row on. Four at once, one
/// after the other, so that it is loaded and stored less often.
fn subtract(values: &mut [f64], n: usize, [column, row]: [usize; 2], multiples: &[f64]) {
    let (before, after) = values.split_at_mut(column * n);
    let own = &mut after[row..n];
    let other = |k: usize| &before[k * n + row..(k + 1) * n];
    let fours = multiples.chunks_exact(4);
    let ones = fours.remainder();
    for (at, m) in fours.enumerate() {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| other(4 * at + k));
        let others = a.iter().zip(b).zip(c).zip(d);
        for (own, (((a, b), c), d)) in own.iter_mut().zip(others) {
            *own = *own - m[0] * a - m[1] * b - m[2] * c - m[3] * d;
        }
    }
    for (k, m) in ones.iter().enumerate() {
        for (own, other) in own.iter_mut().zip(other(multiples.len() - ones.len() + k)) {
            *own -= m * other;
        }
    }
}

/// A lower triangle R with R Rᵀ = a symmetric matrix, but for the pivots that rounding has taken.
pub(super) fn root(mut a: DMatrix<f64>) -> DMatrix<f64> {
    factor(&mut a);
    a.fill_upper_triangle(0.0, 1);
    for k in 0..a.nrows() {
        if a[(k, k)] == HELD_PIVOT {
            a.column_mut(k).fill(0.0);
        }
    }
    a
}

/// Solves X Lᵀ = A for X in place, L being a factor, by substitution: with inverses of its diagonal blocks, which
/// are faster, a slice of paper-1 with open head joints lost its proof.
pub(super) fn solve_right(a: &mut DMatrix<f64>, factor: &DMatrix<f64>) {
    let (rows, n) = a.shape();
    for start in (0..n).step_by(BLOCK) {
        let end = (start + BLOCK).min(n);
        if start > 0 {
            let across = factor.view((start, 0), (end - start, start)).transpose();
            let (done, mut block) = a.columns_range_pair_mut(..start, start..end);
            block.gemm(-1.0, &done, &across, 1.0);
        }
        for j in start..end {
            let factors: Vec<f64> = (start..j).map(|p| factor[(j, p)]).collect();
            subtract(
                &mut a.as_mut_slice()[start * rows..],
                rows,
                [j - start, 0],
                &factors,
            );
            let mut column = a.view_mut((0, j), (rows, 1));
            column /= factor[(j, j)];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_factor_gives_the_matrix_back() {
        let n = 131;
        let root = DMatrix::from_fn(n, n, |i, j| ((i * 7 + j * 13) as f64).sin());
        let a = &root * root.transpose() + DMatrix::identity(n, n);
        let mut factored = a.clone();
        factor(&mut factored);
        let lower = factored.lower_triangle();
        assert!((&lower * lower.transpose() - &a).amax() < 1e-10);
        let mut right = root.clone();
        solve_right(&mut right, &factored);
        assert!((&right * lower.transpose() - &root).amax() < 1e-10);
    }
}
