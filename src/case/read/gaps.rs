//! Gaps between explicit blocks, closed as those of a drawing are.

use super::bodies::Body;
use super::checks::{Written, positive};
use super::file::BlocksTable;
use crate::case::complaint::Complaint;
use crate::case::heal::{CannotClose, Closed, LeftOpen, Reach, close, left_open, stay_open};
use crate::scene::{Polygon, TOUCHING};

/// The outlines of bodies. With a `gap`, and with a `tolerance` beyond that of touching edges, gaps between
/// them are closed.
///
/// # Errors
/// An outline that is none, or a gap that cannot be closed, with their rows.
pub(super) fn closed(
    bodies: &[Body],
    table: Option<&BlocksTable>,
    tolerance: f64,
    warnings: &mut Vec<Complaint>,
) -> Result<Vec<Polygon>, Complaint> {
    let drawn = bodies.iter().map(|body| body.outline.shape(body.moves));
    let drawn: Vec<Polygon> = drawn.collect::<Result<_, _>>()?;
    let gap = table.and_then(|table| table.gap.as_ref());
    let width = gap.map(|gap| positive("gap", gap)).transpose()?;
    let reach = width.map_or(Reach::of_tolerance(tolerance), Reach::of_gap);
    if width.is_none() && tolerance <= TOUCHING {
        return Ok(drawn);
    }
    let fixed: Vec<bool> = bodies.iter().map(|body| !body.moves).collect();
    let name = |body: usize| bodies[body].outline.name.clone();
    let closed = close(&drawn, &fixed, reach, &name).map_err(|CannotClose { body, why }| {
        let outline = &bodies[body].outline;
        let complaint = outline.place.complain(why, "this block");
        complaint.help(
            "move its corners, or write another `gap`: none is closed that is wider than a tenth of the \
             smaller block",
        )
    })?;
    // Blocks that lie in each other are refused as they are written.
    let Some(Closed {
        shapes,
        moved,
        doubt,
    }) = closed
    else {
        return Ok(drawn);
    };
    let (refused, wider): (Vec<LeftOpen>, Vec<LeftOpen>) =
        left_open(&drawn, &shapes, &fixed, reach.meant())
            .into_iter()
            .partition(|gap| gap.is_refused(reach.meant()));
    if let Some(open) = refused.first() {
        let [one, other] = open.bodies.map(|body| &bodies[body].outline);
        let (width, at) = (open.width, open.at);
        let title = format!(
            "a gap of {width:.3e} between `{}` and `{}` stays open at ({:.4}, {:.4})",
            one.name, other.name, at.x, at.y
        );
        let complaint = other
            .place
            .complain(title, format!("the other is at {}", one.rows()));
        return Err(complaint
            .help("move the corners there, or write another `gap`: none is closed in part"));
    }
    if let (Some(moved), Some(gap)) = (moved, gap) {
        // What a command line asks for stands in no file.
        let moved = match gap.span().is_empty() {
            true => Complaint::new(moved),
            false => gap
                .wrong(moved, "closes gaps")
                .help("`trilith convert` writes the blocks as they are now"),
        };
        warnings.push(moved.into_warning());
    }
    warnings.extend(doubt);
    warnings.extend(stay_open(&wider, &name));
    Ok(shapes)
}
