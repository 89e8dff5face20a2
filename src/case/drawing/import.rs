//! From a drawing to a case of explicit blocks.

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
use crate::scene::{Assembly, Forces, NamedBlock, Polygon, Support, TOUCHING, extent};

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
        let drawn = drawn(document, options, remarks)?;
        let fixed = supports(&drawn, options, remarks)?;
        (drawn, fixed)
    };
    if options.tolerance > 0.0 {
        healed(&mut drawn, options, remarks)?;
    }
    let assembly = assembled(&drawn, &fixed, options);
    sound(&drawn, &fixed, &assembly, options)?;
    Ok(assembly)
}

/// Lays edges that nearly touch on common lines, and says what was moved.
fn healed(
    drawn: &mut [Drawn],
    options: &DrawingOptions,
    remarks: &mut Vec<String>,
) -> Result<(), Complaint> {
    let shapes: Vec<Polygon> = drawn.iter().map(|d| d.shape.clone()).collect();
    let (corners, moved) = heal(&shapes, options.tolerance);
    for m in &moved {
        let part = (m.to - m.from).norm() / extent(&shapes[m.body]);
        if part > 2.0 * options.tolerance {
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
    for (body, corners) in corners.into_iter().enumerate() {
        if shapes[body].corners() != corners {
            let mut path = drawn[body].path.clone();
            path.points = corners;
            drawn[body].shape = shape(&path)?;
        }
    }
    if !moved.is_empty() {
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
            });
        }
    }
    Assembly {
        blocks,
        supports,
        friction: options.friction.unwrap_or(0.0).into(),
        forces: Forces::default(),
        tolerance: TOUCHING,
        radial: false,
        named_joints: Vec::new(),
    }
}
