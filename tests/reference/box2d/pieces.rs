//! Outlines as convex pieces, and the joints that lie on an edge of a piece.

use super::scene::Pair;

/// The most corners that a polygon of Box2D may have.
const MOST_CORNERS: usize = 8;

fn turn(a: Pair, b: Pair, c: Pair) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

fn apart(a: Pair, b: Pair) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The outline without corners on a straight line, as it is where it is convex and has few corners,
/// else as triangles. Every edge of the outline is an edge of one piece.
pub fn convex(corners: &[Pair]) -> Vec<Vec<Pair>> {
    let size = corners
        .iter()
        .map(|&c| apart(c, corners[0]))
        .fold(0.0, f64::max);
    let flat = 1e-9 * size * size;
    let mut outline = corners.to_vec();
    while let Some(place) = (0..outline.len()).find(|&at| around(&outline, at).abs() <= flat) {
        outline.remove(place);
    }
    let bends_in = (0..outline.len()).any(|at| around(&outline, at) < 0.0);
    if !bends_in && outline.len() <= MOST_CORNERS {
        return vec![outline];
    }
    let mut pieces = Vec::new();
    while outline.len() > 3 {
        let Some(ear) = (0..outline.len()).find(|&at| is_ear(&outline, at, flat)) else {
            return Vec::new();
        };
        let [before, after] = neighbours(&outline, ear);
        pieces.push(vec![before, outline[ear], after]);
        outline.remove(ear);
    }
    pieces.push(outline);
    pieces
}

fn neighbours(outline: &[Pair], at: usize) -> [Pair; 2] {
    let count = outline.len();
    [outline[(at + count - 1) % count], outline[(at + 1) % count]]
}

fn around(outline: &[Pair], at: usize) -> f64 {
    let [before, after] = neighbours(outline, at);
    turn(before, outline[at], after)
}

fn is_ear(outline: &[Pair], at: usize, flat: f64) -> bool {
    let [before, after] = neighbours(outline, at);
    let tip = outline[at];
    let inside = |&p: &Pair| {
        p != before
            && p != tip
            && p != after
            && turn(before, tip, p) >= 0.0
            && turn(tip, after, p) >= 0.0
            && turn(after, before, p) >= 0.0
    };
    turn(before, tip, after) > flat && !outline.iter().any(inside)
}

/// Whether the segment shares a length with an edge of the piece.
pub fn has_edge_along(piece: &[Pair], ends: [Pair; 2], tolerance: f64) -> bool {
    let length = apart(ends[0], ends[1]);
    let along = |p: Pair| {
        let unit = [
            (ends[1][0] - ends[0][0]) / length,
            (ends[1][1] - ends[0][1]) / length,
        ];
        (p[0] - ends[0][0]) * unit[0] + (p[1] - ends[0][1]) * unit[1]
    };
    let off = |p: Pair| (turn(ends[0], ends[1], p) / length).abs();
    (0..piece.len()).any(|at| {
        let (a, b) = (piece[at], piece[(at + 1) % piece.len()]);
        let (low, high) = (along(a).min(along(b)), along(a).max(along(b)));
        off(a) <= tolerance && off(b) <= tolerance && high.min(length) - low.max(0.0) > tolerance
    })
}
