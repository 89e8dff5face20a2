//! The live load: weights sideways, and forces on named blocks.

use std::collections::HashMap;

use toml::Spanned;

use super::checks::{choose, coordinates, unknown_block};
use super::file::{CaseFile, LoadTable};
use super::values::Pair;
use crate::case::complaint::{Complaint, Document};
use crate::scene::{Assembly, Force, Forces, Point, Polygon, Vector};

/// Blocks that a load can name, and supports, which it cannot.
pub(super) struct Loadable<'a> {
    blocks: Vec<(&'a str, &'a Polygon)>,
    places: HashMap<&'a str, usize>,
    supports: Vec<&'a str>,
}

impl<'a> Loadable<'a> {
    pub fn new(blocks: Vec<(&'a str, &'a Polygon)>, supports: Vec<&'a str>) -> Self {
        let places = blocks.iter().enumerate();
        Self {
            places: places.map(|(place, (name, _))| (*name, place)).collect(),
            blocks,
            supports,
        }
    }

    pub fn of(assembly: &'a Assembly) -> Self {
        let blocks = assembly.blocks.iter();
        let supports = assembly.supports.iter();
        Self::new(
            blocks
                .map(|block| (block.name.as_str(), &block.shape))
                .collect(),
            supports.map(|support| support.name.as_str()).collect(),
        )
    }
}

/// The forces of a file on these blocks.
pub(super) fn forces(
    document: &Document,
    file: &CaseFile,
    loadable: &Loadable,
) -> Result<Forces, Complaint> {
    let weight_is_live = match &file.live {
        None => true,
        Some(word) => choose(document, "live", [("weight", true), ("loads", false)], word)?,
    };
    let loads = file.load.iter();
    let extra: Vec<Force> = loads
        .map(|load| force(document, load, loadable))
        .collect::<Result<_, _>>()?;
    let pushes = extra.iter().any(|force| force.live != Vector::zeros());
    match &file.live {
        Some(word) if !weight_is_live && !pushes => Err(document
            .complain(
                word.span(),
                "nothing pushes",
                "no `[[load]]` has a live part",
            )
            .help("add a `[[load]]` with `live = [1.0, 0.0]`, or write `live = \"weight\"`")),
        _ => Ok(Forces {
            weight_is_live,
            extra,
        }),
    }
}

fn force(
    document: &Document,
    load: &Spanned<LoadTable>,
    loadable: &Loadable,
) -> Result<Force, Complaint> {
    let table = load.get_ref();
    let block = named(document, &table.block, loadable)?;
    let vector = |pair: &Option<Spanned<Pair>>| match pair {
        None => Ok(Vector::zeros()),
        Some(pair) => coordinates(document, pair, "a force").map(|p| p.coords),
    };
    let (dead, live) = (vector(&table.dead)?, vector(&table.live)?);
    if dead == Vector::zeros() && live == Vector::zeros() {
        return Err(document
            .complain(
                load.span(),
                "a load without a force",
                "neither dead nor live",
            )
            .help("add `dead = [0.0, -1.0]`, or `live = [1.0, 0.0]`"));
    }
    let (point, length) = application(document, load, loadable.blocks[block].1)?;
    Ok(Force {
        block,
        point,
        dead: dead * length,
        live: live * length,
    })
}

/// Where the resultant of a load acts on its block, and the length that its forces are multiplied
/// by: 1 for a load at a point.
fn application(
    document: &Document,
    load: &Spanned<LoadTable>,
    shape: &Polygon,
) -> Result<(Point, f64), Complaint> {
    let table = load.get_ref();
    let on_block = |pair: &Spanned<Pair>| {
        let point = coordinates(document, pair, "a point")?;
        if inside(shape, point) {
            return Ok(point);
        }
        let title = format!("the load is not on block `{}`", table.block.get_ref());
        Err(document
            .complain(pair.span(), title, "outside of its outline")
            .help(extent_of(shape)))
    };
    let wrong = |span, title, label, help| Err(document.complain(span, title, label).help(help));
    match (&table.at, &table.along) {
        (Some(at), None) => Ok((on_block(at)?, 1.0)),
        (None, Some(along)) => {
            let [from, to] = along.get_ref().as_slice() else {
                let help = "write `along = [[0.0, 1.0], [2.0, 1.0]]`";
                return wrong(along.span(), "a line load has two ends", "here", help);
            };
            let (from, to) = (on_block(from)?, on_block(to)?);
            if from == to {
                return wrong(
                    along.span(),
                    "a line load without length",
                    "both ends are one point",
                    "write two points, or `at` with a force",
                );
            }
            Ok((nalgebra::center(&from, &to), (to - from).norm()))
        }
        (Some(_), Some(along)) => wrong(
            along.span(),
            "`along` beside `at`",
            "a load is one or the other",
            "remove `at` for a line load, or `along` for a point load",
        ),
        (None, None) => wrong(
            load.span(),
            "a load that acts nowhere",
            "neither `at` nor `along`",
            "add `at = [0.5, 2.0]`, or `along` with two points for a force per length",
        ),
    }
}

/// The block of a name; a support carries no load.
fn named(
    document: &Document,
    word: &Spanned<String>,
    loadable: &Loadable,
) -> Result<usize, Complaint> {
    let name = word.get_ref().as_str();
    if let Some(block) = loadable.places.get(name) {
        return Ok(*block);
    }
    if loadable.supports.contains(&name) {
        return Err(document
            .complain(
                word.span(),
                format!("`{name}` is a support"),
                "it never moves",
            )
            .help("put the load on a block that can move"));
    }
    let known = loadable.blocks.iter().map(|(name, _)| *name);
    Err(unknown_block(document, word, known))
}

/// Whether a point lies in a shape or on its edge.
fn inside(shape: &Polygon, point: Point) -> bool {
    let (low, high) = shape.bounds();
    let tolerance = 1e-6 * (high - low).norm();
    let corners = shape.corners();
    let in_piece = |piece: Vec<usize>| {
        let next = piece.iter().cycle().skip(1);
        piece.iter().zip(next).all(|(&from, &to)| {
            let along = (corners[to] - corners[from]).normalize();
            along.perp(&(point - corners[from])) >= -tolerance
        })
    };
    shape.convex_pieces().into_iter().any(in_piece)
}

fn extent_of(shape: &Polygon) -> String {
    let (low, high) = shape.bounds();
    format!(
        "the block reaches from [{}, {}] to [{}, {}]",
        low.x, low.y, high.x, high.y
    )
}
