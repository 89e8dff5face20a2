//! Doors and windows of a wall of blocks that are boxes: what its blocks leave open between them.

use crate::scene::{Point, Scene};

/// Part of the blocks that must be boxes, and of a block's box that it then fills.
const BOXES: f64 = 0.8;
const FILLED: f64 = 0.98;

/// Part of the smallest side of a block within which edges lie on one line.
const NEAR: f64 = 0.05;

/// Part of a block's mean area below which what is open is a joint.
const SMALLEST: f64 = 0.25;

/// Cells of the grid beyond which openings are not looked for.
const CELLS: usize = 4_000_000;

/// An opening with masonry on both sides and above.
#[derive(Clone, Debug, PartialEq)]
pub struct Opening {
    /// Lower-left and upper-right corner.
    pub low: Point,
    pub high: Point,
    /// What it is called: "the left window".
    pub name: String,
}

type Box = [Point; 2];

/// The openings, in rows of those beside each other from the lowest, each from the left.
pub fn openings(scene: &Scene) -> Vec<Vec<Opening>> {
    let shapes = scene.blocks().iter().map(|block| &block.shape);
    let is_box = |[low, high]: &Box, area: f64| {
        let size = high - low;
        area >= FILLED * size.x * size.y
    };
    let bounds = |(low, high): (Point, Point)| [low, high];
    let boxes: Vec<(Box, f64)> = shapes.map(|s| (bounds(s.bounds()), s.area())).collect();
    let count = boxes.iter().filter(|(of, area)| is_box(of, *area)).count();
    if (count as f64) < BOXES * boxes.len() as f64 {
        return Vec::new();
    }
    let area: f64 = boxes.iter().map(|(_, area)| area).sum();
    let supports = scene.supports().iter().map(|s| bounds(s.bounds()));
    let blocks = boxes.iter().map(|(of, _)| *of);
    let found = voids(&blocks.collect::<Vec<_>>(), &supports.collect::<Vec<_>>());
    let least = SMALLEST * area / boxes.len() as f64;
    let mut rows: Vec<Vec<Opening>> = Vec::new();
    for ([low, high], on_ground) in found {
        let size = high - low;
        if size.x * size.y < least {
            continue;
        }
        let name = match (on_ground, size.y > size.x) {
            (true, true) => "door",
            (true, false) => "opening",
            (false, _) => "window",
        };
        let name = name.to_owned();
        let beside = |row: &&mut Vec<Opening>| {
            let mut row = row.iter();
            row.any(|of| of.low.y < high.y && low.y < of.high.y)
        };
        let opening = Opening { low, high, name };
        match rows.iter_mut().find(beside) {
            Some(row) => row.push(opening),
            None => rows.push(vec![opening]),
        }
    }
    for row in &mut rows {
        row.sort_by(|a, b| a.low.x.total_cmp(&b.low.x));
    }
    rows.sort_by(|a, b| a[0].low.y.total_cmp(&b[0].low.y));
    give_names(&mut rows);
    rows
}

/// Which of its kind each is: by its row where there are several, and by its place in it.
fn give_names(rows: &mut [Vec<Opening>]) {
    let kinds: Vec<Vec<String>> = (rows.iter())
        .map(|row| row.iter().map(|of| of.name.clone()).collect())
        .collect();
    for (storey, row) in rows.iter_mut().enumerate() {
        for (place, opening) in row.iter_mut().enumerate() {
            let kind = &kinds[storey][place];
            let beside: Vec<usize> = (0..kinds[storey].len())
                .filter(|&other| kinds[storey][other] == *kind)
                .collect();
            let own = beside.iter().position(|&other| other == place);
            let side = place_words(own.unwrap_or(0), beside.len());
            let of_kind = kinds.iter().filter(|row| row.contains(kind)).count();
            let level = if of_kind > 1 {
                storey_words(storey, kinds.len())
            } else {
                String::new()
            };
            opening.name = format!("the {level}{side}{kind}");
        }
    }
}

/// Which of so many beside each other, before a noun; empty for the only one.
pub fn place_words(place: usize, count: usize) -> String {
    match (place, count) {
        (_, 1) => String::new(),
        (0, _) => "left ".to_owned(),
        (_, count) if place + 1 == count => "right ".to_owned(),
        (_, 3) => "middle ".to_owned(),
        (1, _) => "2nd ".to_owned(),
        (2, _) => "3rd ".to_owned(),
        _ => format!("{}th ", place + 1),
    }
}

/// Which of so many rows above each other, before a noun; empty for the only one.
pub fn storey_words(storey: usize, count: usize) -> String {
    match (storey, count) {
        (_, 1) => String::new(),
        (0, _) => "lower ".to_owned(),
        (_, count) if storey + 1 == count => "upper ".to_owned(),
        (_, 3) => "middle ".to_owned(),
        _ => format!("storey-{} ", storey + 1),
    }
}

/// What is open with blocks left, right and above: its box, and whether it reaches the ground.
fn voids(blocks: &[Box], supports: &[Box]) -> Vec<(Box, bool)> {
    let sides = blocks.iter().map(|[low, high]| high - low);
    let near = NEAR * sides.fold(f64::INFINITY, |least, size| least.min(size.x).min(size.y));
    let lines = |along: fn(&Point) -> f64| {
        let mut all: Vec<f64> = blocks.iter().flatten().map(along).collect();
        all.sort_by(f64::total_cmp);
        all.dedup_by(|next, kept| *next - *kept <= near);
        all
    };
    let (x, y) = (lines(|p| p.x), lines(|p| p.y));
    let (across, up) = (x.len() - 1, y.len() - 1);
    if across.saturating_mul(up) > CELLS {
        return Vec::new();
    }
    let mut taken = vec![false; across * up];
    for [low, high] in blocks.iter().chain(supports) {
        let first = |lines: &[f64], at: f64| lines.partition_point(|&line| line < at - near);
        for row in first(&y, low.y)..first(&y, high.y).min(up) {
            let of_row = first(&x, low.x)..first(&x, high.x).min(across);
            of_row.for_each(|cell| taken[row * across + cell] = true);
        }
    }
    let mut found = Vec::new();
    for start in 0..taken.len() {
        if taken[start] {
            continue;
        }
        taken[start] = true;
        let (mut open, mut at) = (vec![start], 0);
        while let Some(&cell) = open.get(at) {
            at += 1;
            let (row, column) = (cell / across, cell % across);
            let beside = [
                (column > 0).then(|| cell - 1),
                (column + 1 < across).then_some(cell + 1),
                (row > 0).then(|| cell.wrapping_sub(across)),
                (row + 1 < up).then_some(cell + across),
            ];
            for next in beside.into_iter().flatten() {
                if !taken[next] {
                    taken[next] = true;
                    open.push(next);
                }
            }
        }
        let ends = |of: fn(usize, usize) -> usize| {
            let all = open.iter().map(|&cell| of(cell, across));
            all.fold((usize::MAX, 0), |(low, high), at| {
                (low.min(at), high.max(at))
            })
        };
        let ((left, right), (bottom, top)) = (ends(|cell, n| cell % n), ends(|cell, n| cell / n));
        if left > 0 && right + 1 < across && top + 1 < up {
            let corners = [
                Point::new(x[left], y[bottom]),
                Point::new(x[right + 1], y[top + 1]),
            ];
            found.push((corners, bottom == 0));
        }
    }
    found
}
