//! From a drawing to a case of explicit blocks.

use std::collections::BTreeMap;

use super::compas;
use super::drawn::{Drawn, drawn};
use super::groups::document;
use super::options::DrawingOptions;
use super::paths::complain;
use super::sound::{beyond, sound};
use super::supports::supports;
use crate::case::complaint::{Complaint, Document};
use crate::case::geometry::Geometry;
use crate::case::heal::{CannotClose, close, to_outline};
use crate::case::model::Case;
use crate::case::name::plain;
use crate::case::printable::printable;
use crate::scene::{Assembly, Forces, NamedBlock, Polygon, Support, TOUCHING, close_pairs, extent};

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
        let mut warnings = Vec::new();
        let assembly = assembly(&document, options, &mut remarks, &mut warnings)
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
                warnings,
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
    warnings: &mut Vec<Complaint>,
) -> Result<Assembly, Complaint> {
    let (mut drawn, fixed) = if compas::is_model(&document.path) {
        compas::drawn(document, options, remarks)?
    } else {
        let mut drawn = drawn(document, options, remarks)?;
        drawn_once(&mut drawn, options, remarks);
        let fixed = supports(&mut drawn, options, remarks)?;
        (drawn, fixed)
    };
    let before: Vec<Polygon> = drawn.iter().map(|d| d.shape.clone()).collect();
    if options.tolerance > 0.0 || options.gap.is_some() {
        warnings.extend(healed(&mut drawn, &fixed, options, remarks)?);
    }
    let assembly = assembled(&drawn, &fixed, options);
    warnings.extend(sound(&drawn, &fixed, &before, &assembly, options)?);
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
) -> Result<Option<Complaint>, Complaint> {
    let shapes: Vec<Polygon> = drawn.iter().map(|d| d.shape.clone()).collect();
    let closed = close(&shapes, fixed, options.reach(), &|body| {
        drawn[body].name.clone()
    });
    let closed = closed.map_err(|CannotClose { body, why }| {
        complain(&drawn[body].path, &why).help(beyond(options))
    })?;
    // Bodies that lie in each other are refused as they are drawn.
    let Some(closed) = closed else {
        return Ok(None);
    };
    for (body, shape) in drawn.iter_mut().zip(closed.shapes) {
        body.shape = shape;
    }
    remarks.extend(closed.moved);
    Ok(closed.doubt)
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
