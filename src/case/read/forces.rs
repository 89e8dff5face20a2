//! The live load: weights sideways, and forces on named blocks.

use std::collections::HashMap;

use toml::Spanned;

use super::checks::{Written, choose, coordinates, unknown};
use super::file::{CaseFile, LoadTable};
use super::values::{LiveValue, Pair};
use crate::case::complaint::Complaint;
use crate::scene::{Assembly, Force, Forces, Point, Polygon, Vector};

/// Blocks that a load can name, and supports, which it cannot.
pub(super) struct Loadable<'a> {
    blocks: Vec<(&'a str, &'a Polygon)>,
    places: HashMap<&'a str, usize>,
    supports: Vec<&'a str>,
}

impl<'a> Loadable<'a> {
    pub fn of(assembly: &'a Assembly) -> Self {
        let blocks = assembly.blocks.iter();
        let blocks: Vec<_> = blocks.map(|b| (b.name.as_str(), &b.shape)).collect();
        let places = blocks.iter().enumerate();
        Self {
            places: places.map(|(place, (name, _))| (*name, place)).collect(),
            supports: assembly.supports.iter().map(|s| s.name.as_str()).collect(),
            blocks,
        }
    }

    /// The block of a name; a support carries no load.
    fn named(&self, word: &Spanned<String>) -> Result<usize, Complaint> {
        let name = word.get_ref().as_str();
        if let Some(block) = self.places.get(name) {
            return Ok(*block);
        }
        if self.supports.contains(&name) {
            let complaint = word.wrong(format!("`{name}` is a support"), "it never moves");
            return Err(complaint.help("put the load on a block that can move"));
        }
        let known = self.blocks.iter().map(|(name, _)| *name);
        Err(unknown("block", word, known))
    }
}

pub(super) fn forces(file: &CaseFile, loadable: &Loadable) -> Result<Forces, Complaint> {
    let live = file.live.as_ref();
    let of_weight = live.map_or(Ok(Forces::default().of_weight), of_weight)?;
    let loads = file.load.iter();
    let extra: Vec<Force> = loads
        .map(|load| force(load, loadable))
        .collect::<Result<_, _>>()?;
    let pushes = extra.iter().any(|force| force.live != Vector::zeros());
    match live {
        Some(word) if of_weight == Vector::zeros() && !pushes => Err(word
            .wrong("nothing pushes", "no `[[load]]` has a live part")
            .help("add a `[[load]]` with `live = [1.0, 0.0]`, or write `live = \"weight\"`")),
        _ => Ok(Forces { of_weight, extra }),
    }
}

/// The live part of every weight over the weight, along the push and upwards.
fn of_weight(live: &Spanned<LiveValue>) -> Result<Vector, Complaint> {
    let table = match live.get_ref() {
        LiveValue::Word(word) => {
            let words = [
                ("weight", Forces::default().of_weight),
                ("loads", Vector::zeros()),
            ];
            return choose("live", words, &Spanned::new(live.span(), word.clone()));
        }
        LiveValue::OfWeight(table) => table,
    };
    let part = coordinates(&table.weight, "the live part of weights")?.coords;
    if part.x < 0.0 {
        let complaint = table
            .weight
            .wrong("weights that act against the push", "x is along it");
        return Err(
            complaint.help("write `push = \"left\"` and a positive x, as in `weight = [1, 0.3]`")
        );
    }
    Ok(part)
}

fn force(load: &Spanned<LoadTable>, loadable: &Loadable) -> Result<Force, Complaint> {
    let table = load.get_ref();
    let block = loadable.named(&table.block)?;
    let vector = |pair: &Option<Spanned<Pair>>| match pair {
        None => Ok(Vector::zeros()),
        Some(pair) => coordinates(pair, "a force").map(|p| p.coords),
    };
    let (dead, live) = (vector(&table.dead)?, vector(&table.live)?);
    if dead == Vector::zeros() && live == Vector::zeros() {
        return Err(load
            .wrong("a load without a force", "neither dead nor live")
            .help("add `dead = [0.0, -1.0]`, or `live = [1.0, 0.0]`"));
    }
    let (point, length) = application(load, loadable.blocks[block].1)?;
    Ok(Force {
        block,
        point,
        dead: dead * length,
        live: live * length,
    })
}

/// Where the resultant of a load acts on its block, and the length that its forces are multiplied
/// by: 1 for a load at a point.
fn application(load: &Spanned<LoadTable>, shape: &Polygon) -> Result<(Point, f64), Complaint> {
    let table = load.get_ref();
    let on_block = |pair: &Spanned<Pair>| {
        let point = coordinates(pair, "a point")?;
        if inside(shape, point) {
            return Ok(point);
        }
        let title = format!("the load is not on block `{}`", table.block.get_ref());
        let complaint = pair.wrong(title, "outside of its outline");
        Err(complaint.help(extent_of(shape)))
    };
    match (&table.at, &table.along) {
        (Some(at), None) => Ok((on_block(at)?, 1.0)),
        (None, Some(along)) => {
            let [from, to] = along.get_ref().as_slice() else {
                let complaint = along.wrong("a line load has two ends", "here");
                return Err(complaint.help("write `along = [[0.0, 1.0], [2.0, 1.0]]`"));
            };
            let (from, to) = (on_block(from)?, on_block(to)?);
            if from == to {
                return Err(along
                    .wrong("a line load without length", "both ends are one point")
                    .help("write two points, or `at` with a force"));
            }
            Ok((nalgebra::center(&from, &to), (to - from).norm()))
        }
        (Some(_), Some(along)) => Err(along
            .wrong("`along` beside `at`", "a load is one or the other")
            .help("remove `at` for a line load, or `along` for a point load")),
        (None, None) => Err(load
            .wrong("a load that acts nowhere", "neither `at` nor `along`")
            .help("add `at = [0.5, 2.0]`, or `along` with two points for a force per length")),
    }
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
