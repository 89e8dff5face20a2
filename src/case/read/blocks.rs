//! Explicit blocks from a file and the CSV beside it.

use toml::Spanned;

use super::bodies::{ReadFile, bodies};
use super::checks::{Written, not_negative, positive_or_one, within};
use super::file::CaseFile;
use super::forces::{Loadable, forces};
use super::friction::friction;
use super::gaps::closed;
use super::outline::Outline;
use super::own_joints::own_joints;
use crate::case::complaint::{Complaint, Document};
use crate::scene::{
    Assembly, Forces, HeadJoints, NamedBlock, Point, Push, Side, Support, TOUCHING, Unsound, extent,
};

/// Edges touch within these fractions of the smaller block's extent.
const TOLERANCES: std::ops::RangeInclusive<f64> = 1e-9..=1e-2;

/// Farthest coordinate over the extent of the smallest block: beyond, a joint's place is lost in
/// rounding.
const FARTHEST: f64 = 1e7;

/// The blocks of a file, their joints possible and every one held.
pub(super) fn assembly(
    document: &Document,
    file: &CaseFile,
    read_file: ReadFile,
    warnings: &mut Vec<Complaint>,
) -> Result<Assembly, Complaint> {
    let table = file.blocks.as_ref().map(Spanned::get_ref);
    let bodies = bodies(document, file, read_file, warnings)?;
    let specific = table.and_then(|table| table.specific_weight.as_ref());
    let specific = positive_or_one("specific_weight", specific)?;
    let thickness = table.and_then(|table| table.thickness.as_ref());
    let thickness = positive_or_one("thickness", thickness)?;
    let tolerance = table.and_then(|table| table.tolerance.as_ref());
    let tolerance =
        tolerance.map_or(Ok(TOUCHING), |value| within("tolerance", value, TOLERANCES))?;
    let mut assembly = Assembly {
        blocks: Vec::new(),
        supports: Vec::new(),
        friction: friction(file)?,
        forces: Forces::default(),
        overburden: 0.0,
        tolerance: tolerance.min(TOUCHING),
        radial: table.and_then(|table| table.radial).unwrap_or(false),
        named_joints: Vec::new(),
        layers: bodies
            .iter()
            .filter(|body| !body.layer.is_empty())
            .map(|body| (body.outline.name.clone(), body.layer.clone()))
            .collect(),
    };
    let shapes = closed(&bodies, table, tolerance, warnings)?;
    let (mut of_block, mut of_support) = (Vec::new(), Vec::new());
    for (body, shape) in bodies.iter().zip(shapes) {
        let name = body.outline.name.clone();
        if body.moves {
            let given = body.weight.as_ref().map(|(weight, _)| *weight);
            let specific = body
                .specific_weight
                .as_ref()
                .map_or(specific, |(specific, _)| *specific);
            of_block.push(&body.outline);
            assembly.blocks.push(NamedBlock {
                name,
                weight: given.unwrap_or(specific * thickness * shape.area()),
                centre: body.centre.unwrap_or(shape.centroid()),
                friction: body.friction.as_ref().map(|(friction, _)| *friction),
                shape,
            });
        } else {
            of_support.push(&body.outline);
            assembly.supports.push(Support { name, shape });
        }
    }
    in_range(&assembly, &of_block, &of_support)?;
    sound(&assembly, &of_block, &of_support)?;
    assembly.named_joints = own_joints(file, &assembly, None)?.named;
    assembly.forces = forces(file, &Loadable::of(&assembly))?;
    assembly.overburden = overburden(file, &assembly)?;
    Ok(assembly)
}

/// The overburden ratio, which needs level faces at the top that nothing lies on.
fn overburden(file: &CaseFile, assembly: &Assembly) -> Result<f64, Complaint> {
    let Some(value) = &file.overburden else {
        return Ok(0.0);
    };
    let ratio = not_negative("overburden", value)?;
    let faces = assembly.top_faces();
    // Numbers that make no scene are refused elsewhere.
    let scene = assembly.scene(HeadJoints::Contact, Push::Right).ok();
    let mut joints = scene.iter().flat_map(|scene| scene.joints());
    let covered = joints.find(|joint| {
        let on_top = matches!(joint.from, Side::Support(_)) && joint.normal.y < 0.0;
        on_top && faces.iter().any(|face| face.0 == joint.to)
    });
    let (title, help) = match covered {
        _ if ratio == 0.0 => return Ok(0.0),
        None if !faces.is_empty() => return Ok(ratio),
        None => (
            "no block has a level face at the top".to_owned(),
            "write the load as `[[load]]`s, each with `along` the line that it lies on",
        ),
        Some(joint) => (
            format!("a support lies on `{}`", assembly.blocks[joint.to].name),
            "the overburden needs a free face at the top; write `[[load]]`s instead",
        ),
    };
    Err(value.wrong(title, "on what does it lie?").help(help))
}

/// Refuses blocks so far from the origin, for their size, that joints are lost in rounding.
fn in_range(
    assembly: &Assembly,
    of_block: &[&Outline],
    of_support: &[&Outline],
) -> Result<(), Complaint> {
    let blocks = assembly.blocks.iter().map(|block| extent(&block.shape));
    let smallest = blocks.fold(f64::INFINITY, f64::min);
    for outline in of_block.iter().chain(of_support) {
        let far = |p: &Point| p.x.abs().max(p.y.abs()) > FARTHEST * smallest;
        if let Some(corner) = outline.corners.iter().position(far) {
            let name = &outline.name;
            let title = format!("a corner of `{name}` is too far away for the smallest block");
            let label = format!("that block is {smallest:.3e} in extent");
            let complaint = outline.places[corner].complain(title, label);
            return Err(complaint.help(format!(
                "keep coordinates below {FARTHEST:e} times the extent of the smallest block"
            )));
        }
    }
    Ok(())
}

/// Names what overlaps, nearly touches or floats, with its rows.
fn sound(
    assembly: &Assembly,
    of_block: &[&Outline],
    of_support: &[&Outline],
) -> Result<(), Complaint> {
    let outline = |side| match side {
        Side::Support(support) => of_support[support],
        Side::Block(block) => of_block[block],
    };
    let both = |one, other: usize, what: String| {
        let (one, other) = (outline(one), of_block[other]);
        let title = format!("`{}` and `{}` {what}", one.name, other.name);
        let label = format!("the other is at {}", one.rows());
        other.place.complain(title, label)
    };
    let Err(unsound) = assembly.check() else {
        return Ok(());
    };
    Err(match unsound {
        Unsound::Overlap { one, other, depth } => {
            both(one, other, format!("overlap, {depth:.3e} deep"))
                .help("move or cut one of the two; where they only touch, correct the last digits")
        }
        Unsound::NearMiss { one, other, needed } => {
            both(one, other, "nearly touch and have no joint".to_owned()).help(format!(
                "write more digits, or `tolerance = {needed:.0e}` in `[blocks]` (a fraction of \
                     the smaller block's extent; now {:e})",
                assembly.tolerance
            ))
        }
        Unsound::Floating { block, touches } => floating(of_block[block], touches.map(outline)),
    })
}

/// A block that is not held, and the one that it touches at a corner.
fn floating(block: &Outline, touches: Option<&Outline>) -> Complaint {
    let name = &block.name;
    let title = match touches {
        Some(other) => format!(
            "`{name}` touches `{}` at a corner alone, and floats",
            other.name
        ),
        None => format!("`{name}` floats: no joints lead from it to a support"),
    };
    let complaint = block.place.complain(title, "here");
    complaint.help(
        "let an edge of it lie on an edge of a block that is held; gaps, as of mortar, are closed by `gap` in \
         `[blocks]`, the width up to which",
    )
}
