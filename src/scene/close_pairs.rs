//! Bodies that are near enough to touch, found by a tree of boxes.

use super::polygon::{Point, Polygon, Vector};

/// Most bodies of a leaf of the tree.
const LEAF: usize = 8;

/// Pairs whose bounding boxes meet within `tolerance`: (body, block) with the body first in the
/// order supports, blocks. Sorted.
///
/// The work is that of a search in a tree for each body: it grows with the number of bodies and of
/// pairs, whichever way the bodies are spread.
pub(crate) fn close_pairs(
    tolerance: f64,
    shapes: &[&Polygon],
    supports: &[Polygon],
) -> Vec<(usize, usize)> {
    let bodies = supports.iter().chain(shapes.iter().copied());
    let grown = |shape: &Polygon| {
        let margin = Vector::repeat(tolerance * extent(shape));
        let (low, high) = shape.bounds();
        Bounds {
            low: low - margin,
            high: high + margin,
        }
    };
    let boxes: Vec<Bounds> = bodies.map(grown).collect();
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    let mut nodes = Vec::new();
    if !order.is_empty() {
        build(&boxes, &mut order, 0, &mut nodes);
    }
    let mut pairs = Vec::new();
    let mut open: Vec<usize> = Vec::new();
    // Two supports make no joint, so only blocks look for what they meet.
    for body in supports.len()..boxes.len() {
        open.extend((!nodes.is_empty()).then_some(0));
        while let Some(node) = open.pop() {
            let node: &Node = &nodes[node];
            if !node.bounds.meets(&boxes[body]) {
                continue;
            }
            match &node.inside {
                Inside::Nodes(children) => open.extend(children),
                Inside::Bodies(range) => pairs.extend(
                    (order[range.clone()].iter())
                        .filter(|&&other| other < body && boxes[other].meets(&boxes[body]))
                        .map(|&other| (other, body - supports.len())),
                ),
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

/// A box along the axes.
#[derive(Clone, Copy)]
struct Bounds {
    low: Point,
    high: Point,
}

impl Bounds {
    fn meets(&self, other: &Bounds) -> bool {
        (0..2).all(|k| self.low[k] <= other.high[k] && other.low[k] <= self.high[k])
    }

    fn with(self, other: Bounds) -> Bounds {
        Bounds {
            low: self.low.inf(&other.low),
            high: self.high.sup(&other.high),
        }
    }
}

/// A node of the tree and the box about all that is below it.
struct Node {
    bounds: Bounds,
    inside: Inside,
}

enum Inside {
    Nodes([usize; 2]),
    /// A range of the order of bodies.
    Bodies(std::ops::Range<usize>),
}

/// Builds the node of the bodies in `order`, which begin at `first` of the whole order, and all below
/// it; gives its place. The half of the bodies with the lower middles goes to one side, along the
/// axis that the middles spread over more.
fn build(boxes: &[Bounds], order: &mut [usize], first: usize, nodes: &mut Vec<Node>) -> usize {
    let middle = |body: usize, axis: usize| boxes[body].low[axis] + boxes[body].high[axis];
    let all = order.iter().map(|&body| boxes[body]);
    let node = Node {
        bounds: all.reduce(Bounds::with).expect("a node has bodies"),
        inside: Inside::Bodies(first..first + order.len()),
    };
    let place = nodes.len();
    nodes.push(node);
    if order.len() > LEAF {
        let spread = |axis: usize| {
            let middles = order.iter().map(|&body| middle(body, axis));
            middles.clone().fold(f64::NEG_INFINITY, f64::max)
                - middles.fold(f64::INFINITY, f64::min)
        };
        let axis = usize::from(spread(1) > spread(0));
        let half = order.len() / 2;
        order.select_nth_unstable_by(half, |&a, &b| {
            middle(a, axis).total_cmp(&middle(b, axis)).then(a.cmp(&b))
        });
        let (low, high) = order.split_at_mut(half);
        let low = build(boxes, low, first, nodes);
        let high = build(boxes, high, first + half, nodes);
        nodes[place].inside = Inside::Nodes([low, high]);
    }
    place
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
    fn the_tree_finds_what_comparing_all_finds() {
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
