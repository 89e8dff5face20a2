//! The dense arithmetic of one front of the factor.

use super::substitution::Triple;
use super::symbolic::{Child, Front};

/// Adds the update of a child to its parent's columns and update, lower halves.
#[inline(always)]
pub(super) fn assemble(
    child: &Child,
    from: &[f64],
    front: &Front,
    columns: &mut [f64],
    update: &mut [f64],
) {
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

/// A pivot that keeps its unknown at zero.
const INFINITE: f64 = 1e64;

/// Factorises the columns of a front, three at a time: what those before give is taken from all three,
/// then what they give to each other.
#[inline(always)]
pub(super) fn eliminate(columns: &mut [f64], height: usize, pivots: &mut [f64], least: &[f64]) {
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

/// Divides a column by its pivot, its first entry, which is returned. One that is not above `least` is replaced by
/// [`INFINITE`].
#[inline(always)]
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
#[inline(always)]
fn subtract_column(column: &mut [f64], before: &[f64], row: usize, pivot: f64) {
    let share = before[row] * pivot;
    for (to, from) in column[row..].iter_mut().zip(&before[row..]) {
        *to -= share * from;
    }
}

/// Takes what a front's columns give from the rows below them, lower half.
#[inline(always)]
pub(super) fn reduce(
    columns: &[f64],
    height: usize,
    pivots: &[f64],
    update: &mut [f64],
    below: usize,
) {
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
#[inline(always)]
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
