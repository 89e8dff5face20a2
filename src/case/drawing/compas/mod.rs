//! Models of COMPAS: from the JSON of a BlockModel (compas_dem) or an Assembly (compas_assembly) to
//! closed outlines.
//!
//! ```text
//! JSON ── model ──▶ solids in space ── plane ──▶ outlines with a depth
//! ```

mod matrix;
mod model;
mod plane;
mod solid;

use super::drawn::{Drawn, shape};
use super::options::DrawingOptions;
use super::paths::Path;
use crate::case::complaint::{Complaint, Document};

use model::solids;
use plane::{Prism, prisms};
use solid::Solid;

/// Whether a file of this name is a model and no drawing.
pub(super) fn is_model(path: &str) -> bool {
    let end = std::path::Path::new(path).extension();
    end.is_some_and(|end| end.eq_ignore_ascii_case("json"))
}

/// The outlines of a model's blocks, and which of them never move.
pub(super) fn drawn(
    document: &Document,
    options: &DrawingOptions,
    remarks: &mut Vec<String>,
) -> Result<(Vec<Drawn>, Vec<bool>), Complaint> {
    if options.support.is_some() || !options.without.is_empty() || options.metres.is_some() {
        let title = "a model of COMPAS has no layers and no unit of length";
        return Err(Complaint::new(format!("{}: {title}", document.path)).help(
            "leave `support`, `without` and `units` out: blocks with `is_support` never move, and \
             lengths are taken as they are",
        ));
    }
    let solids = solids(document)?;
    let fixed = fixed(&solids)?;
    let weights = specific_weights(&solids, &fixed, remarks)?;
    let prisms = prisms(&solids, remarks)?;
    let drawn = solids.into_iter().zip(prisms).zip(weights);
    let drawn = drawn.map(|((solid, Prism { points, depth }), weight)| {
        let path = Path {
            handle: solid.guid,
            kind: "block".to_owned(),
            layer: String::new(),
            place: solid.place,
            in_space: Vec::new(),
            points,
            closed: true,
        };
        Ok(Drawn {
            shape: shape(&path)?,
            name: solid.name,
            weight: weight * depth,
            path,
        })
    });
    Ok((drawn.collect::<Result<_, Complaint>>()?, fixed))
}

/// Which blocks never move: some do, and some do not.
fn fixed(solids: &[Solid]) -> Result<Vec<bool>, Complaint> {
    let fixed: Vec<bool> = solids.iter().map(|solid| solid.is_support).collect();
    let (title, help) = match (fixed.contains(&true), fixed.contains(&false)) {
        (true, true) => return Ok(fixed),
        (false, true) => (
            "no support: which blocks never move?",
            "set `is_support = True` for those blocks and write the model again",
        ),
        (true, false) => (
            "every block is a support, and none may move",
            "set `is_support = False` for those that may move and write the model again",
        ),
        (false, false) => (
            "a model without blocks",
            "add its blocks and write it again",
        ),
    };
    let place = solids.first().map_or(0..0, |solid| solid.place.clone());
    Err(Complaint::at(place, title, "the first block of the model").help(help))
}

/// Weight over volume of every block: its material's density, where all have one, else 1.
fn specific_weights(
    solids: &[Solid],
    fixed: &[bool],
    remarks: &mut Vec<String>,
) -> Result<Vec<f64>, Complaint> {
    let moving = || solids.iter().zip(fixed).filter(|(_, fixed)| !**fixed);
    let has = |solid: &Solid| solid.density.is_some();
    if moving().all(|(solid, _)| !has(solid)) {
        remarks.push("no block has a material: a unit of volume weighs 1".to_owned());
        return Ok(vec![1.0; solids.len()]);
    }
    if let Some((without, _)) = moving().find(|(solid, _)| !has(solid)) {
        let title = format!(
            "the block `{}` has no material, and others have",
            without.name
        );
        return Err(without
            .complain(&title)
            .help("give every block a material, or none"));
    }
    remarks.push("weights: density of the material times volume, without g".to_owned());
    Ok(solids
        .iter()
        .map(|solid| solid.density.unwrap_or(1.0))
        .collect())
}
