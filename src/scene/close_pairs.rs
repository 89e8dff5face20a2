//! Bodies that are near enough to touch, found by a sweep along the longer side of all.

use super::polygon::{Point, Polygon, Vector, bounds_of};

/// Pairs whose bounding boxes meet within `tolerance`: (body, block) with the body first in the
/// order supports, blocks. Sorted.
///
/// Each body is compared with those that begin beside it along the axis that the blocks spread over
/// more: in a square wall of n blocks with some √n others.
pub(crate) fn close_pairs(
    tolerance: f64,
    shapes: &[&Polygon],
    supports: &[Polygon],
) -> Vec<(usize, usize)> {
    let bodies = supports.iter().chain(shapes.iter().copied());
    let grown = |shape: &Polygon| {
        let margin = Vector::repeat(tolerance * extent(shape));
        let (low, high) = shape.bounds();
        (low - margin, high + margin)
    };
    let boxes: Vec<(Point, Point)> = bodies.map(grown).collect();
    let (low, high) = bounds_of(shapes.iter().copied());
    let axis = usize::from(high.y - low.y > high.x - low.x);
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    order.sort_by(|&a, &b| boxes[a].0[axis].total_cmp(&boxes[b].0[axis]));
    let mut pairs = Vec::new();
    for (place, &one) in order.iter().enumerate() {
        let (low, high) = boxes[one];
        let beside = order[place + 1..].iter();
        let beside = beside.take_while(|&&other| boxes[other].0[axis] <= high[axis]);
        for &other in beside {
            let (l, h) = boxes[other];
            let (first, last) = (one.min(other), one.max(other));
            // Two supports make no joint.
            let has_block = last >= supports.len();
            if has_block && (0..2).all(|k| low[k] <= h[k] && l[k] <= high[k]) {
                pairs.push((first, last - supports.len()));
            }
        }
    }
    pairs.sort_unstable();
    pairs
}

/// Diagonal of the bounding box.
pub(crate) fn extent(shape: &Polygon) -> f64 {
    let (low, high) = shape.bounds();
    (high - low).norm()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every pair, by comparing all with all.
    fn by_comparing_all(shapes: &[&Polygon], supports: &[Polygon]) -> Vec<(usize, usize)> {
        let bodies: Vec<&Polygon> = supports.iter().chain(shapes.iter().copied()).collect();
        let bounds = |body: usize| {
            let margin = Vector::repeat(1e-6 * extent(bodies[body]));
            let (low, high) = bodies[body].bounds();
            (low - margin, high + margin)
        };
        let mut pairs = Vec::new();
        for one in 0..bodies.len() {
            for other in supports.len().max(one + 1)..bodies.len() {
                let ((a, b), (c, d)) = (bounds(one), bounds(other));
                if (0..2).all(|k| a[k] <= d[k] && c[k] <= b[k]) {
                    pairs.push((one, other - supports.len()));
                }
            }
        }
        pairs
    }

    /// Blocks of very different size, in a row, in a tower and scattered, on two supports.
    #[test]
    fn the_sweep_finds_what_comparing_all_finds() {
        let mut state = 0x9E37_79B9_7F4A_7C15_u64;
        let mut noise = |most: f64| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            most * (state >> 11) as f64 / (1u64 << 53) as f64
        };
        let rectangle =
            |x: f64, y: f64, w: f64, h: f64| Polygon::rectangle(x, x + w, y, y + h).unwrap();
        let mut blocks = Vec::new();
        for i in 0..60 {
            let step = f64::from(i);
            blocks.push(rectangle(step, 0.0, 1.0, 1.0));
            blocks.push(rectangle(0.0, step, 1.0, 1.0));
            let (x, y, w, h) = (noise(60.0), noise(60.0), noise(9.0), noise(3.0));
            blocks.push(rectangle(x, y, w + 0.01, h + 0.01));
        }
        let shapes: Vec<&Polygon> = blocks.iter().collect();
        let supports = [
            rectangle(-5.0, -1.0, 99.0, 1.0),
            rectangle(-5.0, 0.0, 5.0, 9.0),
        ];
        let found = close_pairs(1e-6, &shapes, &supports);
        assert!(found.len() > 200, "{}", found.len());
        assert_eq!(found, by_comparing_all(&shapes, &supports));
        assert_eq!(close_pairs(1e-6, &[], &supports), []);
        assert_eq!(close_pairs(1e-6, &[], &[]), []);
    }
}
