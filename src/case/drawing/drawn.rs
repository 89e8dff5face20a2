//! The closed outlines of a drawing as shapes with names.

use std::collections::{BTreeMap, HashSet};

use indexmap::IndexMap;

use super::curves::Chords;
use super::entities::file;
use super::groups::{AT_THE_END, groups};
use super::options::DrawingOptions;
use super::outlines::outlines;
use super::paths::{Path, Paths, complain, same};
use super::plane::flatten;
use crate::case::complaint::{Complaint, Document};
use crate::case::heal::{holds, to_outline, without_repeats};
use crate::case::printable::printable;
use crate::scene::{Point, Polygon, PolygonError, TOUCHING, bounds};

/// A drawing this many times its own size away from the origin stands on a survey grid.
const FAR: f64 = 100.0;

/// Layers of outlines that are openings between stones.
const OPENINGS: [&str; 2] = ["opening", "openings"];

/// The outline of an opening may be drawn as far off, as a part of its size.
const ON_THE_OUTLINE: f64 = 0.01;

/// What an outline that crosses itself may have as slips of the pen, as a part of its size.
const SLIP: f64 = 1e-3;

const MOST_BLOCKS: usize = 100_000;

/// An outline with its name, and where it was drawn.
pub(super) struct Drawn {
    pub name: String,
    pub path: Path,
    pub shape: Polygon,
    /// Weight over the area of the elevation.
    pub weight: f64,
}

/// Every closed outline of the drawing, in metres where the unit is known.
pub(super) fn drawn(
    document: &Document,
    options: &DrawingOptions,
    remarks: &mut Vec<String>,
) -> Result<Vec<Drawn>, Complaint> {
    let groups = groups(document)?;
    let file = file(&groups)?;
    let mut paths = Paths {
        file: &file,
        chords: Chords(options.chord),
        without: &options.without,
        found: Vec::new(),
        left_aside: Vec::new(),
        unseen: BTreeMap::new(),
        unread: IndexMap::new(),
    };
    paths.read()?;
    if !paths.left_aside.is_empty() {
        remarks.push(format!("left aside: {}", paths.left_aside.join(", ")));
    }
    for (what, count) in &paths.unseen {
        let entities = if *count == 1 { "entity" } else { "entities" };
        remarks.push(format!(
            "left out, as nobody sees it in the drawing: {count} {entities} {what}"
        ));
    }
    flatten(&mut paths.found, remarks)?;
    let metres = options.metres.or(file.metres);
    match metres {
        Some(metres) => remarks.push(format!(
            "a drawing unit is {metres} m; lengths are in metres"
        )),
        None if options.gap.is_some() => {
            let title = "the drawing does not say its unit of length, which `gap` needs";
            let complaint = Complaint::at(AT_THE_END, title, "no unit in the header");
            return Err(complaint.help("say it with `units`"));
        }
        None => remarks.push(
            "the drawing does not say its unit of length, and is taken as it is; `units` says it"
                .to_owned(),
        ),
    }
    let scale = metres.unwrap_or(1.0);
    let per_metre = whole_if_near(1.0 / scale);
    let mut closed = outlines(paths.found, options.tolerance.max(TOUCHING), remarks)?;
    if let Some(path) = closed.get(MOST_BLOCKS) {
        let title = format!("more than {MOST_BLOCKS} outlines");
        return Err(complain(path, &title).help("leave out layers: `without` names them"));
    }
    remarks.extend(brought_near(&mut closed));
    without_openings(&mut closed, remarks);

    let mut drawn = Vec::new();
    for (index, mut path) in closed.into_iter().enumerate() {
        for point in &mut path.points {
            // Division by a thousand keeps the digits of millimetres, and times a thousandth does not.
            *point = if scale < 1.0 {
                *point / per_metre
            } else {
                *point * scale
            };
        }
        let shape = shape(&path)?;
        let name = match path.handle.as_str() {
            "" => (index + 1).to_string(),
            handle => printable(handle),
        };
        drawn.push(Drawn {
            name,
            path,
            shape,
            weight: options.specific_weight,
        });
    }
    named_apart(drawn.iter_mut().map(|d| &mut d.name));
    Ok(drawn)
}

/// Gives a mark to every name that was there before.
pub(super) fn named_apart<'a>(names: impl Iterator<Item = &'a mut String>) {
    let mut known = HashSet::new();
    for name in names {
        while !known.insert(name.clone()) {
            name.push('\'');
        }
    }
}

/// Shifts a drawing in the coordinates of a survey grid, of which the digits of a joint would be lost, by
/// whole units to where it begins; what is drawn near the origin stays.
fn brought_near(outlines: &mut [Path]) -> Option<String> {
    let corners = outlines.iter().flat_map(|path| &path.points);
    let corners: Vec<Point> = corners.copied().collect();
    if corners.is_empty() {
        return None;
    }
    let (low, high) = bounds(&corners);
    if low.coords.norm() <= FAR * (high - low).norm() {
        return None;
    }
    let shift = low.coords.map(f64::floor);
    for point in outlines.iter_mut().flat_map(|path| &mut path.points) {
        *point -= shift;
    }
    Some(format!(
        "shifted by ({}, {}) drawing units, to the origin",
        -shift.x, -shift.y
    ))
}

/// Takes out the outlines of openings and what lies within them, and says so.
fn without_openings(outlines: &mut Vec<Path>, remarks: &mut Vec<String>) {
    let is_opening = |path: &Path| OPENINGS.iter().any(|layer| same(layer, &path.layer));
    let all = std::mem::take(outlines).into_iter();
    let (openings, stones): (Vec<Path>, Vec<Path>) = all.partition(is_opening);
    let within = |path: &Path| openings.iter().any(|opening| is_within(path, opening));
    let (inside, stones): (Vec<Path>, Vec<Path>) = stones.into_iter().partition(within);
    if !openings.is_empty() {
        remarks.push(format!(
            "left out: {} openings, on a layer of that name, and {} outlines within them",
            openings.len(),
            inside.len()
        ));
    }
    *outlines = stones;
}

/// Whether an outline lies in an opening: the middles of its edges do, or stand on its outline.
fn is_within(path: &Path, opening: &Path) -> bool {
    let points = &path.points;
    let mut middles =
        (0..points.len()).map(|k| nalgebra::center(&points[k], &points[(k + 1) % points.len()]));
    let (low, high) = bounds(&opening.points);
    let near = ON_THE_OUTLINE * (high - low).norm();
    let corners = &opening.points;
    middles.all(|p| holds(corners, p) || to_outline(p, corners) <= near)
}

fn whole_if_near(number: f64) -> f64 {
    let whole = number.round();
    if (number - whole).abs() < 1e-9 * whole {
        whole
    } else {
        number
    }
}

/// Points without those that are nearer than `near` to the one before, and without ways that lead out and
/// back.
fn without_spikes(mut points: Vec<Point>, near: f64) -> Vec<Point> {
    let is_spike = |a: Point, p: Point, b: Point| {
        let (there, back) = (p - a, b - p);
        there.norm() <= near
            || (there.dot(&back) < 0.0 && there.perp(&back).abs() <= near * back.norm())
    };
    let spike = |points: &[Point]| {
        let count = points.len();
        let at = |k: usize| points[k % count];
        (0..count).find(|&k| is_spike(at(k + count - 1), at(k), at(k + 1)))
    };
    while let Some(k) = spike(&points).filter(|_| points.len() > 2) {
        points.remove(k);
    }
    points
}

/// An outline as a shape. A circle's last point may repeat its first.
pub(super) fn shape(path: &Path) -> Result<Polygon, Complaint> {
    let mut points = path.points.clone();
    let (low, high) = bounds(&points);
    // Points that a program wrote twice, but for rounding.
    let near = 1e-7 * (high - low).norm();
    without_repeats(&mut points, near);
    let simple = Polygon::new(points.clone()).or_else(|error| {
        let tidied = without_spikes(points.clone(), SLIP * (high - low).norm());
        Polygon::new(tidied).map_err(|_| error)
    });
    simple.map_err(|error| {
        let (title, at) = match error {
            PolygonError::NotSimple(corner) => (
                "an outline that crosses or touches itself".to_owned(),
                points.get(corner),
            ),
            PolygonError::TooFewCorners(count) => {
                (format!("an outline of {count} corners"), points.first())
            }
            PolygonError::NotFinite(_) | PolygonError::Sliver { .. } => {
                ("an outline without area".to_owned(), points.first())
            }
        };
        let title = match at {
            Some(at) => format!("{title}, at ({}, {})", at.x, at.y),
            None => title,
        };
        complain(path, &title).help("draw it again, or leave its layer out: `without` names it")
    })
}
