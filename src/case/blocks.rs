//! Explicit blocks from a file and the CSV beside it.

use toml::Spanned;

use super::Beside;
use super::bodies::{Outline, Place};
use super::check::{friction, positive, within};
use super::complaint::{Complaint, Document};
use super::corners::outlines;
use super::course::MOST_BLOCKS;
use super::explain::missing_key;
use super::file::{Blocks, Body, File};
use super::forces::{coordinates, forces, unknown_block};
use super::values::Number;
use crate::scene::{
    Assembly, Forces, NamedBlock, Point, Polygon, Side, Support, TOUCHING, Unsound,
};

/// Tolerances of the joint search, fractions of the smaller block's extent.
const TOLERANCES: std::ops::RangeInclusive<f64> = 1e-9..=1e-2;

/// Farthest coordinate over the extent of the smallest block: beyond, a joint's place is lost in
/// rounding.
const FARTHEST: f64 = 1e7;

/// A body as written, and what it is.
struct Written {
    outline: Outline,
    /// The weight and its place, where it is given.
    weight: Option<(f64, Place)>,
    moves: bool,
}

/// The blocks of a file, their joints possible and every one held.
pub(super) fn assembly(
    document: &Document,
    file: &File,
    beside: Beside,
) -> Result<Assembly, Complaint> {
    let table = file.blocks.as_ref().map(Spanned::get_ref);
    let bodies = bodies(document, file, beside)?;
    let value = |key, default: f64, value: Option<&Spanned<Number>>| match value {
        None => Ok(default),
        Some(value) => positive(document, key, value),
    };
    let specific = value(
        "specific_weight",
        1.0,
        table.and_then(|t| t.specific_weight.as_ref()),
    )?;
    let thickness = value("thickness", 1.0, table.and_then(|t| t.thickness.as_ref()))?;
    let tolerance = match table.and_then(|table| table.tolerance.as_ref()) {
        None => TOUCHING,
        Some(value) => within(document, "tolerance", value, TOLERANCES)?,
    };
    let mut assembly = Assembly {
        blocks: Vec::new(),
        supports: Vec::new(),
        friction: friction(document, file)?,
        forces: Forces::default(),
        tolerance,
        radial: false,
    };
    let (mut of_block, mut of_support) = (Vec::new(), Vec::new());
    for body in &bodies {
        let shape = body.outline.shape(body.moves)?;
        let name = body.outline.name.clone();
        if body.moves {
            let given = body.weight.as_ref().map(|(weight, _)| *weight);
            of_block.push(&body.outline);
            assembly.blocks.push(NamedBlock {
                name,
                weight: given.unwrap_or(specific * thickness * shape.area()),
                centre: shape.centroid(),
                shape,
            });
        } else {
            of_support.push(&body.outline);
            assembly.supports.push(Support { name, shape });
        }
    }
    in_range(&assembly, &of_block, &of_support)?;
    sound(&assembly, &of_block, &of_support)?;
    assembly.forces = forces(document, file, &assembly)?;
    Ok(assembly)
}

/// All bodies, those of the CSV first; at least one moves and one does not.
fn bodies(document: &Document, file: &File, beside: Beside) -> Result<Vec<Written>, Complaint> {
    let table = file.blocks.as_ref();
    let mut bodies: Vec<Written> = Vec::new();
    let csv = table.and_then(|table| table.get_ref().csv.as_ref());
    if let Some(csv) = csv {
        let outlines = outlines(&neighbour(document, csv, beside)?)?;
        bodies.extend(outlines.into_iter().map(|outline| Written {
            outline,
            weight: None,
            moves: true,
        }));
    }
    let inline = (file.block.iter().map(|body| (body, true)))
        .chain(file.support.iter().map(|body| (body, false)));
    for (body, moves) in inline {
        add(document, &mut bodies, body.get_ref(), moves)?;
    }
    if let Some(table) = table {
        hold(document, &mut bodies, table.get_ref())?;
    }
    if bodies.len() > MOST_BLOCKS {
        return Err(bodies[MOST_BLOCKS]
            .outline
            .place
            .complain(
                format!("more than {MOST_BLOCKS} blocks"),
                "the first too many",
            )
            .help("write fewer blocks"));
    }
    for body in &bodies {
        if let (false, Some((_, place))) = (body.moves, &body.weight) {
            return Err(place
                .complain(
                    format!("`{}` is a support", body.outline.name),
                    "its weight is never used",
                )
                .help("remove the weight"));
        }
    }
    let place = |moves: bool| bodies.iter().find(|body| body.moves == moves);
    match (place(true), place(false)) {
        (Some(_), Some(_)) => Ok(bodies),
        (Some(body), None) => Err(body
            .outline
            .place
            .complain("no support", "this block, as all others, may move")
            .help(
                "add a `[[support]]` with corners, or name blocks that never move: \
                 `supports = [\"ground\"]` in `[blocks]`",
            )),
        (None, Some(body)) => Err(body
            .outline
            .place
            .complain(
                "no block may move",
                "this body, as all others, is a support",
            )
            .help("add a `[[block]]`, or take one out of `supports`")),
        (None, None) => {
            let place = table.map_or(0..0, Spanned::span);
            Err(document
                .complain(place, "no blocks", "neither a CSV nor `[[block]]`")
                .help("add `csv = \"blocks.csv\"` to `[blocks]`, or a `[[block]]` with corners"))
        }
    }
}

/// The CSV beside the case.
fn neighbour(
    document: &Document,
    csv: &Spanned<String>,
    beside: Beside,
) -> Result<Document, Complaint> {
    let name = csv.get_ref().as_str();
    let complain = |title: String, help: &str| {
        let complaint = document.complain(csv.span(), title, "here");
        Err(complaint.help(help))
    };
    if name.is_empty() || name.contains(['/', '\\']) || name.starts_with('.') {
        let title = format!("`{name}` is no file beside the case");
        return complain(
            title,
            "put the CSV into the folder of the case and write its bare name",
        );
    }
    let path = match document.path.rfind(['/', '\\']) {
        Some(folder) => format!("{}{name}", &document.path[..=folder]),
        None => name.to_owned(),
    };
    match beside(name) {
        Ok(bytes) => Document::read(&path, &bytes),
        Err(why) => complain(
            format!("cannot read {path}: {why}"),
            "put the CSV into the folder of the case; it holds rows `block,x,y`",
        ),
    }
}

/// Adds an inline body, or its weight to the one of the CSV.
fn add(
    document: &Document,
    bodies: &mut Vec<Written>,
    body: &Body,
    moves: bool,
) -> Result<(), Complaint> {
    let name = body.name.get_ref().trim();
    if name.is_empty() || name.chars().any(char::is_control) || name.chars().count() > 60 {
        return Err(document
            .complain(body.name.span(), "a name that names nothing", "here")
            .help("write a short name, such as `\"A\"`"));
    }
    let weight = match &body.weight {
        None => None,
        Some(value) => {
            let weight = positive(document, "weight", value)?;
            Some((weight, Place::new(document, value.span())))
        }
    };
    let known = bodies.iter().position(|known| known.outline.name == name);
    match (&body.corners, known) {
        (Some(_), Some(known)) => {
            let rows = bodies[known].outline.rows();
            Err(document
                .complain(
                    body.name.span(),
                    format!("two bodies are named `{name}`"),
                    "here again",
                )
                .help(format!("rename one; the other is at {rows}")))
        }
        (None, Some(known)) if bodies[known].weight.is_none() && weight.is_some() => {
            bodies[known].weight = weight;
            Ok(())
        }
        (None, Some(_)) => Err(document
            .complain(
                body.name.span(),
                format!("`{name}` is there already"),
                "here again",
            )
            .help("without corners this table may give the block of the CSV its weight, once")),
        (None, None) if bodies.is_empty() => {
            Err(missing_key(document, body.name.span(), "corners"))
        }
        (None, None) => {
            let known = bodies.iter().map(|body| body.outline.name.as_str());
            Err(unknown_block(document, &body.name, known))
        }
        (Some(corners), None) => {
            let points = corners.get_ref().iter();
            let corners: Vec<Point> = points
                .clone()
                .map(|pair| coordinates(document, pair, "a corner"))
                .collect::<Result<_, _>>()?;
            bodies.push(Written {
                outline: Outline {
                    name: name.to_owned(),
                    place: Place::new(document, body.name.span()),
                    corners,
                    places: points
                        .map(|pair| Place::new(document, pair.span()))
                        .collect(),
                },
                weight,
                moves,
            });
            Ok(())
        }
    }
}

/// Turns the blocks of `supports` into supports.
fn hold(document: &Document, bodies: &mut [Written], table: &Blocks) -> Result<(), Complaint> {
    for word in &table.supports {
        let named = |body: &Written| body.outline.name == *word.get_ref();
        let Some(body) = bodies.iter().position(named) else {
            let known = bodies.iter().map(|body| body.outline.name.as_str());
            return Err(unknown_block(document, word, known));
        };
        if !std::mem::replace(&mut bodies[body].moves, false) {
            let title = format!("`{}` is a support already", word.get_ref());
            return Err(document
                .complain(word.span(), title, "here again")
                .help("name each support once"));
        }
    }
    Ok(())
}

/// Refuses blocks so far from the origin, for their size, that joints are lost in rounding.
fn in_range(
    assembly: &Assembly,
    of_block: &[&Outline],
    of_support: &[&Outline],
) -> Result<(), Complaint> {
    let extent = |shape: &Polygon| {
        let (low, high) = shape.bounds();
        (high - low).norm()
    };
    let blocks = assembly.blocks.iter().map(|block| extent(&block.shape));
    let smallest = blocks.fold(f64::INFINITY, f64::min);
    for outline in of_block.iter().chain(of_support) {
        let far = |p: &Point| p.x.abs().max(p.y.abs()) > FARTHEST * smallest;
        if let Some(corner) = outline.corners.iter().position(far) {
            return Err(outline.places[corner]
                .complain(
                    format!(
                        "a corner of `{}` is too far away for the smallest block",
                        outline.name
                    ),
                    format!("that block is {smallest:e} in extent"),
                )
                .help(format!(
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
    let Err(unsound) = assembly.check() else {
        return Ok(());
    };
    Err(match unsound {
        Unsound::Overlap { one, other, depth } => {
            let (one, other) = (outline(one), outline(Side::Block(other)));
            other
                .place
                .complain(
                    format!(
                        "`{}` and `{}` overlap, {depth:.3e} deep",
                        one.name, other.name
                    ),
                    format!("the other is at {}", one.rows()),
                )
                .help("move or cut one of the two; where they only touch, correct the last digits")
        }
        Unsound::NearMiss { one, other, needed } => {
            let (one, other) = (outline(one), outline(Side::Block(other)));
            let title = format!(
                "`{}` and `{}` nearly touch and have no joint",
                one.name, other.name
            );
            other
                .place
                .complain(title, format!("the other is at {}", one.rows()))
                .help(format!(
                    "write more digits, or `tolerance = {needed:e}` in `[blocks]` (a fraction of \
                     the smaller block's extent; now {:e})",
                    assembly.tolerance
                ))
        }
        Unsound::Floating { block } => {
            let outline = outline(Side::Block(block));
            outline
                .place
                .complain(
                    format!("`{}` floats: no joints lead from it to a support", outline.name),
                    "here",
                )
                .help("let an edge of it lie on an edge of a block that is held; corners alone do not hold")
        }
    })
}
