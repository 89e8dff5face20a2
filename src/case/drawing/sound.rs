//! What a drawing must not have: blocks that overlap, gape or float.

use super::drawn::{Drawn, complain};
use super::heal::{Gap, gaps};
use super::options::DrawingOptions;
use crate::case::complaint::Complaint;
use crate::number::short;
use crate::scene::{Assembly, Polygon, Side, TOUCHING, Unsound};

/// Gaps wider than this part of a block's extent are meant.
const WIDEST_GAP: f64 = 0.015;

/// Mortar is no wider than this part of a stone's extent.
const WIDEST_MORTAR: f64 = 0.1;

/// Refuses what overlaps, gapes or floats, with layers, handles and coordinates.
pub(super) fn sound(
    drawn: &[Drawn],
    fixed: &[bool],
    assembly: &Assembly,
    options: &DrawingOptions,
) -> Result<(), Complaint> {
    let shapes: Vec<Polygon> = drawn.iter().map(|d| d.shape.clone()).collect();
    let of = |side: Side| {
        let (wanted, place) = match side {
            Side::Support(place) => (true, place),
            Side::Block(place) => (false, place),
        };
        let bodies = drawn.iter().zip(fixed);
        let mut same = bodies.filter(|(_, fixed)| **fixed == wanted);
        same.nth(place).expect("every body was drawn").0
    };
    let near = |d: &Drawn| {
        let at = d.shape.centroid();
        let layer = match d.path.layer.as_str() {
            "" => String::new(),
            layer => format!("layer `{layer}`, "),
        };
        format!("`{}` ({layer}at {:.4}, {:.4})", d.name, at.x, at.y)
    };
    let unsound = assembly.check().err();
    if let Some(Unsound::Overlap { one, other, depth }) = unsound {
        let (one, other) = (of(one), of(Side::Block(other)));
        let names = format!("{} and {}", near(one), near(other));
        let title = format!("{names} overlap, {depth:.3e} deep");
        return Err(complain(&other.path, &title).help(beyond(options)));
    }
    let mortar = mortar(&shapes, options);
    // What was to be closed and stayed open is refused however wide it is.
    let (part, width) = match options.gap {
        Some(width) => (WIDEST_MORTAR, width),
        None => (WIDEST_GAP, f64::INFINITY),
    };
    let mut wide = gaps(&shapes, TOUCHING, part).into_iter();
    let between = |gap: &Gap| gap.width <= width && gap.bodies.iter().any(|&body| !fixed[body]);
    if let Some(gap) = wide.find(between) {
        let [one, other] = gap.bodies.map(|body| &drawn[body]);
        let title = format!(
            "a gap of {:.3e} ({:.2} % of the smaller one) at ({:.4}, {:.4}) between {} and {}",
            gap.width,
            100.0 * gap.part,
            gap.at.x,
            gap.at.y,
            near(one),
            near(other)
        );
        let help = mortar.unwrap_or_else(|| beyond(options));
        return Err(complain(&other.path, &title).help(help));
    }
    let Some(Unsound::Floating { block, .. }) = unsound else {
        return Ok(());
    };
    let block = of(Side::Block(block));
    let name = near(block);
    let title = format!("{name} floats: no joints lead from it to a support");
    let help = mortar.unwrap_or_else(|| {
        "let an edge of it lie on an edge of a block that is held, or leave its layer out: \
         `without` names it"
            .to_owned()
    });
    Err(complain(&block.path, &title).help(help))
}

/// What to do about outlines that are further apart than is healed.
pub(super) fn beyond(options: &DrawingOptions) -> String {
    if options.gap.is_some() {
        "correct the drawing there, or name another width with `gap`, which closes gaps between edges \
         that face each other along more than twice that width, and not along bent beds"
            .to_owned()
    } else if options.tolerance < 0.01 {
        format!(
            "correct the drawing, or heal more with a `tolerance` of 0.01 (a part of the smaller block's \
             extent; now {}); mortar between stones is closed by `gap`, the width up to which",
            options.tolerance
        )
    } else {
        "correct the drawing: more than 1 % of a block is not healed; mortar between stones is closed by \
         `gap`, the width up to which"
            .to_owned()
    }
}

/// What to do where most stones stand apart: the width that closes their gaps.
fn mortar(shapes: &[Polygon], options: &DrawingOptions) -> Option<String> {
    if options.gap.is_some() {
        return None;
    }
    let gaps = gaps(shapes, TOUCHING, WIDEST_MORTAR);
    let mut widths: Vec<f64> = gaps.iter().map(|gap| gap.width).collect();
    widths.sort_by(f64::total_cmp);
    // Fewer gaps than stones are slips of the pen.
    if widths.len() + 1 < shapes.len() {
        return None;
    }
    let [few, most] = [0.1, 0.9].map(|part| widths[(part * (widths.len() - 1) as f64) as usize]);
    let digits = (2.0 - most.log10()).ceil().clamp(0.0, 9.0) as usize;
    let [few, most, enough] = [few, most, 1.2 * most].map(|width| short(width, digits));
    Some(format!(
        "gaps of {few} to {most} stand between most stones (in metres where the drawing says its unit): \
         close them with `gap`, here {enough}"
    ))
}
