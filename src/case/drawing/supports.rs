//! Which outlines of a drawing never move.

use super::drawn::{Drawn, shape};
use super::groups::AT_THE_END;
use super::options::DrawingOptions;
use super::paths::complain;
use super::paths::same;
use crate::case::complaint::Complaint;
use crate::case::suggestion::listed;
use crate::scene::{Point, bounds, extent};

/// Layers whose outlines never move, where nobody names one.
const SUPPORT_LAYERS: [&str; 4] = ["support", "supports", "ground", "fixed"];

/// What the ground is called that a drawing has not.
const GROUND: &str = "ground";

/// Which outlines never move: those of a layer, or else the lowest wide one; ground is laid
/// under the lowest edges where there is none.
pub(super) fn supports(
    drawn: &mut Vec<Drawn>,
    options: &DrawingOptions,
    remarks: &mut Vec<String>,
) -> Result<Vec<bool>, Complaint> {
    let Some(first) = drawn.first() else {
        let (title, label) = ("no outline of a block", "nothing closed is drawn");
        let complaint = Complaint::at(AT_THE_END, title, label);
        return Err(complaint.help("draw each block as a closed polyline in model space"));
    };
    let layer = options.support.as_deref();
    let known = layer.map_or(SUPPORT_LAYERS.to_vec(), |layer| vec![layer]);
    for layer in known {
        let on = |d: &Drawn| same(&d.path.layer, layer);
        let fixed: Vec<bool> = drawn.iter().map(on).collect();
        if fixed.contains(&true) {
            if !fixed.contains(&false) {
                let title = format!("all outlines are on the layer `{layer}` of supports");
                return Err(complain(&first.path, &title)
                    .help("name the layer of what never moves with `support`"));
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
        let help = format!("the layers with closed outlines are {}", listed(layers));
        return Err(complain(&first.path, &title).help(help));
    }
    let boxes = drawn.iter().map(|d| d.shape.bounds());
    let corners: Vec<Point> = boxes.flat_map(|(low, high)| [low, high]).collect();
    let (low, high) = bounds(&corners);
    let is_lowest = |d: &Drawn| {
        let (from, to) = d.shape.bounds();
        let wide = to.x - from.x >= 0.5 * (high.x - low.x);
        wide && from.y <= low.y + 1e-6 * extent(&d.shape) && drawn.len() > 1
    };
    let Some(lowest) = drawn.iter().position(is_lowest) else {
        let Some(ground) = ground(drawn, options)? else {
            let complaint = complain(&first.path, "no support: which outlines never move?");
            return Err(complaint.help(
                "draw the ground as a closed outline on a layer `support`, or name its layer with \
                 `support`",
            ));
        };
        remarks.push(format!(
            "support: `{GROUND}`, which the drawing has not and which is laid under the lowest edges, at \
             {}; `support` names the layer of another",
            low.y
        ));
        let mut fixed = vec![false; drawn.len()];
        drawn.push(ground);
        fixed.push(true);
        return Ok(fixed);
    };
    let name = &drawn[lowest].name;
    remarks.push(format!(
        "support: the lowest wide outline, `{name}`; `support` names the layer of another"
    ));
    Ok((0..drawn.len()).map(|i| i == lowest).collect())
}

/// Level ground under the lowest edges, where edges lie there that are as long as what is healed is wide.
fn ground(drawn: &[Drawn], options: &DrawingOptions) -> Result<Option<Drawn>, Complaint> {
    let corners = drawn.iter().flat_map(|d| d.shape.corners());
    let (low, high) = bounds(&corners.copied().collect::<Vec<_>>());
    let reach = options.reach();
    let lies = |d: &&Drawn| {
        let near = (reach.part * extent(&d.shape)).min(reach.width);
        let mut edges = d.shape.edges();
        edges.any(|(from, to)| {
            from.y.max(to.y) <= low.y + near && (to.x - from.x).abs() > 2.0 * near
        })
    };
    let Some(first) = drawn.iter().find(lies) else {
        return Ok(None);
    };
    let beside = 0.1 * (high.x - low.x);
    let mut path = first.path.clone();
    (path.handle, path.layer) = (String::new(), SUPPORT_LAYERS[0].to_owned());
    let (left, right) = (low.x - beside, high.x + beside);
    path.points = [
        (left, low.y - beside),
        (right, low.y - beside),
        (right, low.y),
        (left, low.y),
    ]
    .map(|(x, y)| Point::new(x, y))
    .to_vec();
    let mut name = GROUND.to_owned();
    while drawn.iter().any(|d| d.name == name) {
        name.push('\'');
    }
    Ok(Some(Drawn {
        name,
        shape: shape(&path)?,
        path,
        weight: first.weight,
    }))
}
