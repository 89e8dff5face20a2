//! The cells between lines: stones that share edges, each drawn once.

use std::collections::{BTreeMap, HashMap};

use super::paths::{Path, leads_nowhere};
use crate::case::complaint::Complaint;
use crate::scene::{Point, Vector, bounds, signed_area};

/// A straight piece of a path.
struct Piece {
    path: usize,
    from: Point,
    to: Point,
    /// Where other pieces meet it, as parts of its length.
    meets: Vec<f64>,
}

impl Piece {
    fn at(&self, part: f64) -> Point {
        match part {
            0.0 => self.from,
            1.0 => self.to,
            part => self.from + (self.to - self.from) * part,
        }
    }

    /// The nearest place to a point, where that is within reach.
    fn near(&self, p: Point, within: f64) -> Option<f64> {
        let way = self.to - self.from;
        let part = (way.dot(&(p - self.from)) / way.norm_squared()).clamp(0.0, 1.0);
        ((self.at(part) - p).norm() <= within).then_some(part)
    }
}

/// The cells that paths part the plane into. Lines meet that are within `near` of each other.
///
/// # Errors
/// A line with an end that leads nowhere.
pub(super) fn cells(paths: &[Path], near: f64) -> Result<Vec<Path>, Complaint> {
    let pieces = met(pieces(paths), near);
    let mut nodes = Nodes {
        near,
        points: Vec::new(),
        cells: HashMap::new(),
    };
    // Where lines meet comes before their ends, which may be off by a little.
    for piece in &pieces {
        for &part in &piece.meets {
            nodes.of(piece.at(part));
        }
    }
    // By each two nodes the path that leads from one to the other.
    let mut edges: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    for piece in &pieces {
        let parts = [&[0.0], piece.meets.as_slice(), &[1.0]].concat();
        let along: Vec<usize> = parts.iter().map(|part| nodes.of(piece.at(*part))).collect();
        for pair in along.windows(2).filter(|pair| pair[0] != pair[1]) {
            edges.entry((pair[0], pair[1])).or_insert(piece.path);
            edges.entry((pair[1], pair[0])).or_insert(piece.path);
        }
    }
    let mut around: Vec<Vec<usize>> = vec![Vec::new(); nodes.points.len()];
    for &(from, to) in edges.keys() {
        around[from].push(to);
    }
    for (node, others) in around.iter_mut().enumerate() {
        let at = nodes.points[node];
        if let [other] = others[..] {
            return Err(leads_nowhere(&paths[edges[&(node, other)]], at));
        }
        let turn = |other: &usize| {
            let way = nodes.points[*other] - at;
            way.y.atan2(way.x)
        };
        others.sort_by(|a, b| turn(a).total_cmp(&turn(b)));
    }
    Ok(traced(paths, &nodes.points, &edges, &around))
}

/// Each cell, counter-clockwise; what lies about all cells runs clockwise, and is none.
fn traced(
    paths: &[Path],
    points: &[Point],
    edges: &BTreeMap<(usize, usize), usize>,
    around: &[Vec<usize>],
) -> Vec<Path> {
    let mut used = std::collections::BTreeSet::new();
    let mut cells = Vec::new();
    for (&first, &path) in edges {
        let (mut edge, mut corners, mut source) = (first, Vec::new(), path);
        while used.insert(edge) {
            corners.push(points[edge.0]);
            source = source.min(edges[&edge]);
            let others = &around[edge.1];
            let back = others
                .iter()
                .position(|other| *other == edge.0)
                .expect("both ways");
            edge = (edge.1, others[(back + others.len() - 1) % others.len()]);
        }
        if corners.len() > 2 && signed_area(&corners) > 0.0 {
            cells.push(Path {
                handle: String::new(),
                kind: "a cell between lines".to_owned(),
                points: corners,
                closed: true,
                ..paths[source].clone()
            });
        }
    }
    cells
}

fn pieces(paths: &[Path]) -> Vec<Piece> {
    let mut pieces = Vec::new();
    for (index, path) in paths.iter().enumerate() {
        let closing = path.closed.then(|| path.points[0]);
        let points: Vec<Point> = path.points.iter().copied().chain(closing).collect();
        pieces.extend(
            points
                .windows(2)
                .filter(|pair| pair[0] != pair[1])
                .map(|pair| Piece {
                    path: index,
                    from: pair[0],
                    to: pair[1],
                    meets: Vec::new(),
                }),
        );
    }
    pieces.sort_by(|a, b| a.from.x.min(a.to.x).total_cmp(&b.from.x.min(b.to.x)));
    pieces
}

/// Pieces, from left to right, with the places at which they meet others.
fn met(mut pieces: Vec<Piece>, near: f64) -> Vec<Piece> {
    let boxes: Vec<(Point, Point)> = pieces.iter().map(|p| bounds(&[p.from, p.to])).collect();
    for one in 0..pieces.len() {
        for other in one + 1..pieces.len() {
            if boxes[other].0.x > boxes[one].1.x + near {
                break;
            }
            let apart = boxes[other].0.y > boxes[one].1.y + near;
            if apart || boxes[one].0.y > boxes[other].1.y + near {
                continue;
            }
            let (a, b) = (&pieces[one], &pieces[other]);
            let mut on_one: Vec<f64> = [b.from, b.to]
                .iter()
                .filter_map(|p| a.near(*p, near))
                .collect();
            let mut on_other: Vec<f64> = [a.from, a.to]
                .iter()
                .filter_map(|p| b.near(*p, near))
                .collect();
            if let Some((s, t)) =
                crossing(a, b).filter(|_| on_one.is_empty() && on_other.is_empty())
            {
                on_one.push(s);
                on_other.push(t);
            }
            pieces[one].meets.extend(on_one);
            pieces[other].meets.extend(on_other);
        }
    }
    for piece in &mut pieces {
        piece.meets.sort_by(f64::total_cmp);
    }
    pieces
}

/// Where two pieces cross, as a part of each.
fn crossing(one: &Piece, other: &Piece) -> Option<(f64, f64)> {
    let (a, b): (Vector, Vector) = (one.to - one.from, other.to - other.from);
    let sine = a.perp(&b);
    let between = other.from - one.from;
    let (s, t) = (between.perp(&b) / sine, between.perp(&a) / sine);
    let within = |part: f64| (0.0..=1.0).contains(&part);
    (sine != 0.0 && within(s) && within(t)).then_some((s, t))
}

/// Points, of which those that are near each other are one.
struct Nodes {
    near: f64,
    points: Vec<Point>,
    cells: HashMap<(i64, i64), Vec<usize>>,
}

impl Nodes {
    fn of(&mut self, p: Point) -> usize {
        let cell = |c: f64| (c / self.near).floor() as i64;
        let (x, y) = (cell(p.x), cell(p.y));
        let beside = (-1..=1).flat_map(|i| (-1..=1).map(move |j| (x + i, y + j)));
        let known = beside
            .filter_map(|key| self.cells.get(&key))
            .flatten()
            .copied();
        let known = known
            .filter(|k| (self.points[*k] - p).norm() <= self.near)
            .min();
        known.unwrap_or_else(|| {
            self.points.push(p);
            self.cells
                .entry((x, y))
                .or_default()
                .push(self.points.len() - 1);
            self.points.len() - 1
        })
    }
}
