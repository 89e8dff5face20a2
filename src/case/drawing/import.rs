//! From a drawing to a case of explicit blocks.

use std::collections::BTreeMap;

use super::compas;
use super::drawn::{Drawn, drawn};
use super::groups::document;
use super::heal::{heal, to_segment};
use super::options::DrawingOptions;
use super::paths::complain;
use super::sound::{beyond, sound};
use super::supports::supports;
use crate::case::complaint::{Complaint, Document};
use crate::case::geometry::Geometry;
use crate::case::model::Case;
use crate::case::name::plain;
use crate::case::printable::printable;
use crate::scene::{
    Assembly, Forces, NamedBlock, Point, Polygon, Support, TOUCHING, close_pairs, extent,
    signed_area,
};

/// An outline keeps at least this part of its area.
const LEAST_LEFT: f64 = 0.5;

/// What is said of one that does not.
const SWALLOWED: &str = "closing the gaps beside it would swallow this outline, or turn it over";

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
                demand: None,
                is_weight_unsaid: false,
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
        drawn_once(&mut drawn, options, remarks);
        let fixed = supports(&mut drawn, options, remarks)?;
        (drawn, fixed)
    };
    if options.tolerance > 0.0 || options.gap.is_some() {
        healed(&mut drawn, &fixed, options, remarks)?;
    }
    let assembly = assembled(&drawn, &fixed, options);
    sound(&drawn, &fixed, &assembly, options)?;
    Ok(assembly)
}

/// Leaves out what is drawn a second time, with corners off by no more than the tolerance, and says so.
fn drawn_once(drawn: &mut Vec<Drawn>, options: &DrawingOptions, remarks: &mut Vec<String>) {
    let shapes: Vec<&Polygon> = drawn.iter().map(|d| &d.shape).collect();
    let tolerance = options.tolerance.max(TOUCHING);
    let twice: BTreeMap<usize, usize> = close_pairs(tolerance, &shapes, &[])
        .into_iter()
        .filter(|&(one, other)| same_outline(shapes[one], shapes[other], tolerance))
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

/// Whether the corners of each outline lie on the other.
fn same_outline(one: &Polygon, other: &Polygon, tolerance: f64) -> bool {
    let near = tolerance * extent(one).min(extent(other));
    let all_on = |one: &Polygon, other: &Polygon| {
        let mut corners = one.corners().iter();
        corners.all(|p| to_outline(*p, other.corners()) <= near)
    };
    all_on(one, other) && all_on(other, one)
}

/// Closes the gaps within reach, and says how far corners were moved.
fn healed(
    drawn: &mut [Drawn],
    fixed: &[bool],
    options: &DrawingOptions,
    remarks: &mut Vec<String>,
) -> Result<(), Complaint> {
    let shapes: Vec<Polygon> = drawn.iter().map(|d| d.shape.clone()).collect();
    let reach = options.reach();
    let Some(outlines) = heal(&shapes, fixed, reach) else {
        // Bodies lie in each other, which is refused as it is drawn.
        return Ok(());
    };
    let (mut ways, mut bodies) = (Vec::new(), 0);
    for (body, corners) in outlines.iter().enumerate() {
        let (old, size) = (&shapes[body], extent(&shapes[body]));
        if old.corners() == corners.as_slice() {
            continue;
        }
        let path = &drawn[body].path;
        if corners.len() < 3 || signed_area(corners) < LEAST_LEFT * old.area() {
            return Err(complain(path, SWALLOWED).help(beyond(options)));
        }
        let farthest = 2.0 * reach.width.min(reach.part * size);
        let far = |p: &&Point, others: &[Point]| to_outline(**p, others) > farthest;
        let left = old.corners().iter().find(|p| far(p, corners));
        if let Some(at) = left.or_else(|| corners.iter().find(|p| far(p, old.corners()))) {
            let (x, y) = (at.x, at.y);
            let part = 100.0 * farthest / size;
            let title = format!(
                "a corner at ({x:.4}, {y:.4}) would have to move by more than {part:.2} % of its block to \
                 touch its neighbours"
            );
            return Err(complain(path, &title).help(beyond(options)));
        }
        let moved = old.corners().iter().map(|p| {
            let near = corners.iter().map(|new| (new - p).norm());
            let near = near.fold(f64::INFINITY, f64::min);
            // Where a joint became straight, no corner is left.
            (
                if near > farthest {
                    to_outline(*p, corners)
                } else {
                    near
                },
                body,
            )
        });
        let before = ways.len();
        ways.extend(moved.filter(|(way, _)| *way > 0.0));
        bodies += usize::from(ways.len() > before);
        let Ok(closed) = Polygon::new(corners.clone()) else {
            return Err(complain(path, SWALLOWED).help(beyond(options)));
        };
        drawn[body].shape = closed;
    }
    ways.sort_by(|a, b| a.0.total_cmp(&b.0));
    if let Some((farthest, body)) = ways.last() {
        let (count, median) = (ways.len(), ways[ways.len() / 2].0);
        let name = &drawn[*body].name;
        remarks.push(format!(
            "moved {count} corners of {bodies} outlines so that neighbours touch, half of them by at most \
             {median:.3e}, the farthest, of `{name}`, by {farthest:.3e}"
        ));
    }
    Ok(())
}

/// How far a point is from an outline.
fn to_outline(p: Point, corners: &[Point]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    let edges = corners.iter().zip(next);
    edges
        .map(|(from, to)| to_segment(p, *from, *to))
        .fold(f64::INFINITY, f64::min)
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
        layers: (drawn.iter().filter(|body| !body.path.layer.is_empty()))
            .map(|body| (body.name.clone(), printable(&body.path.layer)))
            .collect(),
    }
}
