//! From a drawing to a case of explicit blocks.

use std::collections::BTreeMap;

use super::compas;
use super::drawn::{Drawn, complain, drawn, shape};
use super::groups::document;
use super::heal::heal;
use super::options::DrawingOptions;
use super::sound::{beyond, sound};
use super::supports::supports;
use crate::case::complaint::{Complaint, Document};
use crate::case::geometry::Geometry;
use crate::case::model::Case;
use crate::case::name::plain;
use crate::case::printable::printable;
use crate::scene::{
    Assembly, Forces, NamedBlock, Point, Polygon, Support, TOUCHING, close_pairs, extent,
};

/// An outline keeps at least this part of its area.
const LEAST_LEFT: f64 = 0.5;

/// A case from a drawing, and what was done to get it.
#[derive(Clone, Debug)]
pub struct Imported {
    /// The case.
    pub case: Case,
    /// What was taken for what, and what was moved: a line each.
    pub remarks: Vec<String>,
}

impl Case {
    /// Reads a drawing: every closed outline is a block, or a support. A file `.json` is a model of
    /// COMPAS, of which every block is one.
    ///
    /// # Errors
    /// What cannot be a wall, with the entity's name, handle and layer, or the block's name.
    pub fn from_drawing(
        path: &str,
        bytes: &[u8],
        options: &DrawingOptions,
    ) -> Result<Imported, Complaint> {
        let name = plain_name(path);
        let is_model = compas::is_model(path);
        let document = match is_model {
            true => Document::read(path, bytes)?,
            false => document(path, bytes)?,
        };
        let mut remarks = vec![String::new()];
        let assembly = assembly(&document, options, &mut remarks)
            .map_err(|complaint| complaint.in_document(&document))?;
        remarks[0] = format!(
            "{} blocks and {} supports from {}",
            assembly.blocks.len(),
            assembly.supports.len(),
            if is_model {
                "a model of COMPAS"
            } else {
                "closed outlines"
            }
        );
        let file = path.rsplit('/').next().unwrap_or(path);
        Ok(Imported {
            case: Case {
                motion: None,
                title: name.clone(),
                name,
                source: format!(
                    "the {} {}",
                    ["drawing", "model"][usize::from(is_model)],
                    printable(file)
                ),
                geometry: Geometry::Blocks(assembly),
                pushes: options.pushes.clone(),
                head_joints: options.head_joints.clone(),
                references: Vec::new(),
                warnings: Vec::new(),
            },
            remarks,
        })
    }
}

/// The file's name as a case's: drawings are called with spaces and all.
fn plain_name(path: &str) -> String {
    let stem = std::path::Path::new(path).file_stem().unwrap_or_default();
    match plain(&stem.to_string_lossy()) {
        name if name.is_empty() => "drawing".to_owned(),
        name => name,
    }
}

/// The blocks and supports of a drawing, healed and sound.
fn assembly(
    document: &Document,
    options: &DrawingOptions,
    remarks: &mut Vec<String>,
) -> Result<Assembly, Complaint> {
    let (mut drawn, fixed) = if compas::is_model(&document.path) {
        compas::drawn(document, options, remarks)?
    } else {
        let mut drawn = drawn(document, options, remarks)?;
        drawn_once(&mut drawn, remarks);
        let fixed = supports(&mut drawn, options, remarks)?;
        (drawn, fixed)
    };
    if options.tolerance > 0.0 || options.gap.is_some() {
        healed(&mut drawn, options, remarks)?;
    }
    let assembly = assembled(&drawn, &fixed, options);
    sound(&drawn, &fixed, &assembly, options)?;
    Ok(assembly)
}

/// Leaves out what is drawn a second time, and says so.
fn drawn_once(drawn: &mut Vec<Drawn>, remarks: &mut Vec<String>) {
    let shapes: Vec<&Polygon> = drawn.iter().map(|d| &d.shape).collect();
    let twice: BTreeMap<usize, usize> = close_pairs(TOUCHING, &shapes, &[])
        .into_iter()
        .filter(|&(one, other)| same_outline(shapes[one], shapes[other]))
        .map(|(one, other)| (one.max(other), one.min(other)))
        .collect();
    for (again, first) in &twice {
        let [again, first] = [again, first].map(|&body| &drawn[body].name);
        remarks.push(format!(
            "left out: `{again}`, which draws the outline of `{first}` twice"
        ));
    }
    let mut body = 0..;
    drawn.retain(|_| !twice.contains_key(&body.next().expect("bodies are counted")));
}

/// Whether every corner of one outline is a corner of the other.
fn same_outline(one: &Polygon, other: &Polygon) -> bool {
    let near = TOUCHING * extent(one);
    let on = |p: &Point| other.corners().iter().any(|q| (p - q).norm() <= near);
    one.corners().len() == other.corners().len() && one.corners().iter().all(on)
}

/// Lays edges that nearly touch on common lines, and says what was moved.
fn healed(
    drawn: &mut [Drawn],
    options: &DrawingOptions,
    remarks: &mut Vec<String>,
) -> Result<(), Complaint> {
    let shapes: Vec<Polygon> = drawn.iter().map(|d| d.shape.clone()).collect();
    let reach = options.reach();
    let (corners, moved) = heal(&shapes, reach);
    for m in &moved {
        let part = (m.to - m.from).norm() / extent(&shapes[m.body]);
        if part > 2.0 * reach.part || (m.to - m.from).norm() > 2.0 * reach.width {
            let path = &drawn[m.body].path;
            let title = format!(
                "a corner at ({}, {}) would have to move by {:.2} % of its block to touch its neighbours",
                m.from.x,
                m.from.y,
                100.0 * part
            );
            return Err(complain(path, &title).help(beyond(options)));
        }
    }
    for (body, corners) in corners.iter().enumerate() {
        if shapes[body].corners() != corners.as_slice() {
            let mut path = drawn[body].path.clone();
            let left = signed_area(corners) / shapes[body].area();
            if left < LEAST_LEFT {
                let title =
                    "closing the gaps beside it would swallow this outline, or turn it over";
                return Err(complain(&path, title).help(beyond(options)));
            }
            path.points.clone_from(corners);
            drawn[body].shape = shape(&path)?;
        }
    }
    if options.gap.is_some() {
        remarks.extend(how_far(&shapes, &corners));
    } else if !moved.is_empty() {
        let mut bodies: Vec<usize> = moved.iter().map(|m| m.body).collect();
        bodies.dedup();
        remarks.push(format!(
            "moved {} corners of {} outlines, so that edges within {} of a block's extent touch:",
            moved.len(),
            bodies.len(),
            options.tolerance
        ));
        remarks.extend(moved.iter().map(|m| {
            let way = m.to - m.from;
            format!(
                "  `{}` at ({}, {}) by ({:.3e}, {:.3e})",
                drawn[m.body].name, m.from.x, m.from.y, way.x, way.y
            )
        }));
    }
    Ok(())
}

/// How far the corners of outlines went, each measured to the nearest corner that its outline has now.
fn how_far(shapes: &[Polygon], corners: &[Vec<Point>]) -> Option<String> {
    let way = |old: &Point, new: &[Point]| {
        let all = new.iter().map(|new| (new - old).norm());
        all.fold(f64::INFINITY, f64::min)
    };
    let bodies = shapes.iter().zip(corners);
    let ways = bodies.flat_map(|(shape, new)| shape.corners().iter().map(move |old| way(old, new)));
    let mut ways: Vec<f64> = ways.filter(|way| *way > 0.0).collect();
    ways.sort_by(f64::total_cmp);
    let (median, largest) = (ways.get(ways.len() / 2)?, ways.last()?);
    Some(format!(
        "closed gaps: {} corners moved, half of them by at most {median:.3e}, the farthest by {largest:.3e}",
        ways.len()
    ))
}

/// The area within corners, positive where they run counter-clockwise.
fn signed_area(corners: &[Point]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    let twice = corners
        .iter()
        .zip(next)
        .map(|(a, b)| a.coords.perp(&b.coords));
    twice.sum::<f64>() / 2.0
}

fn assembled(drawn: &[Drawn], fixed: &[bool], options: &DrawingOptions) -> Assembly {
    let (mut blocks, mut supports) = (Vec::new(), Vec::new());
    for (body, fixed) in drawn.iter().zip(fixed) {
        let (name, shape) = (body.name.clone(), body.shape.clone());
        if *fixed {
            supports.push(Support { name, shape });
        } else {
            blocks.push(NamedBlock {
                name,
                weight: body.weight * shape.area(),
                centre: shape.centroid(),
                shape,
                friction: None,
            });
        }
    }
    Assembly {
        blocks,
        supports,
        friction: options.friction.unwrap_or(0.0).into(),
        forces: Forces::default(),
        overburden: 0.0,
        tolerance: TOUCHING,
        radial: false,
        named_joints: Vec::new(),
    }
}
