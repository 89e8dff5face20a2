//! Solving with the factor, front by front.

use super::symbolic::Front;

/// L y = x over one front, in place.
#[inline(always)]
pub(super) fn forward(front: &Front, entries: &[f64], x: &mut [f64], part: &mut [f64]) {
    let (width, height) = (front.width(), front.height());
    let columns = &entries[front.start..front.start + width * height];
    let part = &mut part[..height];
    part[..width].copy_from_slice(&x[3 * front.first..][..width]);
    part[width..].fill(0.0);
    for (j, triple) in columns.chunks_exact(3 * height).enumerate() {
        let Triple { a, b, c } = Triple::new(triple, height, 3 * j);
        let (own, rest) = part[3 * j..].split_at_mut(3);
        own[1] -= a[1] * own[0];
        own[2] -= a[2] * own[0] + b[2] * own[1];
        let below = a[3..].iter().zip(&b[3..]).zip(&c[3..]);
        for (to, ((a, b), c)) in rest.iter_mut().zip(below) {
            *to -= own[0] * a + own[1] * b + own[2] * c;
        }
    }
    x[3 * front.first..][..width].copy_from_slice(&part[..width]);
    for (&row, part) in front.rows.iter().zip(part[width..].chunks_exact(3)) {
        for (to, from) in x[3 * row..3 * row + 3].iter_mut().zip(part) {
            *to += from;
        }
    }
}

/// Lᵀ y = x over one front, in place.
#[inline(always)]
pub(super) fn backward(front: &Front, entries: &[f64], x: &mut [f64], part: &mut [f64]) {
    let (width, height) = (front.width(), front.height());
    let columns = &entries[front.start..front.start + width * height];
    let part = &mut part[..height];
    part[..width].copy_from_slice(&x[3 * front.first..][..width]);
    for (&row, part) in front.rows.iter().zip(part[width..].chunks_exact_mut(3)) {
        part.copy_from_slice(&x[3 * row..3 * row + 3]);
    }
    for (j, triple) in columns.chunks_exact(3 * height).enumerate().rev() {
        let Triple { a, b, c } = Triple::new(triple, height, 3 * j);
        let (own, rest) = part[3 * j..].split_at_mut(3);
        let sums = sums([&a[3..], &b[3..], &c[3..]], rest);
        own[2] -= sums[2];
        own[1] -= sums[1] + b[2] * own[2];
        own[0] -= sums[0] + a[1] * own[1] + a[2] * own[2];
    }
    x[3 * front.first..][..width].copy_from_slice(&part[..width]);
}

/// Sums that are taken side by side.
const SUMS: usize = 4;

/// The products of three columns with a vector.
#[inline(always)]
fn sums(columns: [&[f64]; 3], x: &[f64]) -> [f64; 3] {
    let [a, b, c] = columns;
    let mut sums = [[0.0; SUMS]; 3];
    let (x, last) = x.as_chunks::<SUMS>();
    let ((a, last_a), (b, last_b), (c, last_c)) = (
        a.as_chunks::<SUMS>(),
        b.as_chunks::<SUMS>(),
        c.as_chunks::<SUMS>(),
    );
    for (x, ((a, b), c)) in x.iter().zip(a.iter().zip(b).zip(c)) {
        for k in 0..SUMS {
            sums[0][k] += x[k] * a[k];
            sums[1][k] += x[k] * b[k];
            sums[2][k] += x[k] * c[k];
        }
    }
    for (k, x) in last.iter().enumerate() {
        sums[0][k] += x * last_a[k];
        sums[1][k] += x * last_b[k];
        sums[2][k] += x * last_c[k];
    }
    sums.map(|sums| (sums[0] + sums[1]) + (sums[2] + sums[3]))
}

/// Three columns from the diagonal of the first one on.
pub(super) struct Triple<'a> {
    pub(super) a: &'a [f64],
    pub(super) b: &'a [f64],
    pub(super) c: &'a [f64],
}

impl<'a> Triple<'a> {
    pub(super) fn new(columns: &'a [f64], height: usize, row: usize) -> Self {
        let (a, rest) = columns.split_at(height);
        let (b, c) = rest.split_at(height);
        Self {
            a: &a[row..],
            b: &b[row..],
            c: &c[row..],
        }
    }
}
