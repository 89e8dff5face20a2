//! Which outlines of a drawing never move.

use super::drawn::{Drawn, complain};
use super::options::DrawingOptions;
use super::paths::same;
use crate::case::complaint::{Complaint, Document};
use crate::scene::extent;

/// Layers whose outlines never move, where nobody names one.
const SUPPORT_LAYERS: [&str; 4] = ["support", "supports", "ground", "fixed"];

/// Which outlines never move: those of a layer, or else the lowest wide one.
pub(super) fn supports(
    document: &Document,
    drawn: &[Drawn],
    options: &DrawingOptions,
    remarks: &mut Vec<String>,
) -> Result<Vec<bool>, Complaint> {
    let none = || {
        let end = document.text.len();
        document.complain(end..end, "no outline of a block", "nothing closed is drawn")
    };
    let Some(first) = drawn.first() else {
        return Err(none().help("draw each block as a closed polyline in model space"));
    };
    let on =
        |layer: &str| -> Vec<bool> { drawn.iter().map(|d| same(&d.path.layer, layer)).collect() };
    let is_some = |fixed: &[bool]| fixed.contains(&true);
    let layer = options.support.as_deref();
    let known = layer
        .into_iter()
        .chain(SUPPORT_LAYERS.into_iter().filter(|_| layer.is_none()));
    for layer in known {
        let fixed = on(layer);
        if is_some(&fixed) {
            if fixed.iter().all(|fixed| *fixed) {
                let title = format!("all outlines are on the layer `{layer}` of supports");
                return Err(complain(document, &first.path, &title)
                    .help("name the layer of what never moves (`support`)"));
            }
            remarks.push(format!("supports: what is on the layer `{layer}`"));
            return Ok(fixed);
        }
    }
    if let Some(layer) = layer {
        let title = format!("no closed outline on the layer `{layer}`");
        let mut layers: Vec<&str> = drawn.iter().map(|d| d.path.layer.as_str()).collect();
        layers.sort_unstable();
        layers.dedup();
        layers.truncate(20);
        return Err(complain(document, &first.path, &title).help(format!(
            "the layers with closed outlines are {}",
            crate::case::suggestion::listed(layers)
        )));
    }
    let bounds = |d: &Drawn| d.shape.bounds();
    let low = drawn
        .iter()
        .map(|d| bounds(d).0.y)
        .fold(f64::INFINITY, f64::min);
    let (left, right) = drawn
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, r), d| {
            (l.min(bounds(d).0.x), r.max(bounds(d).1.x))
        });
    let wide = |d: &Drawn| bounds(d).1.x - bounds(d).0.x >= 0.5 * (right - left);
    let lowest = drawn
        .iter()
        .position(|d| wide(d) && bounds(d).0.y <= low + 1e-6 * extent(&d.shape) && drawn.len() > 1);
    match lowest {
        Some(lowest) => {
            let name = &drawn[lowest].name;
            remarks.push(format!(
                "support: the lowest wide outline, `{name}`; `support` names the layer of another"
            ));
            Ok((0..drawn.len()).map(|i| i == lowest).collect())
        }
        None => Err(complain(
            document,
            &first.path,
            "no support: which outlines never move?",
        )
        .help(
            "draw the ground as a closed outline on a layer `support`, or name its layer \
             (`support`)",
        )),
    }
}
