//! What a drawing must not have: blocks that overlap, gape or float.

use super::drawn::Drawn;
use super::heal::{Reach, gaps, holds};
use super::options::DrawingOptions;
use super::paths::complain;
use crate::case::complaint::Complaint;
use crate::number::short;
use crate::scene::{Assembly, Polygon, Side, TOUCHING, Unsound};

/// Gaps wider than this part of a block's extent are meant.
const WIDEST_GAP: f64 = 0.015;

/// Gaps that are to be closed, wider than this part of a stone's extent, are openings.
const WIDEST_MEANT: f64 = 0.3;

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
    let unsound = assembly.check().err();
    if let Some(Unsound::Overlap { one, other, depth }) = unsound {
        return Err(overlapping(
            [of(one), of(Side::Block(other))],
            depth,
            options,
        ));
    }
    let mortar = mortar(&shapes, fixed, options);
    // What was to be closed and stayed open is refused however wide it is.
    let reach = match options.gap {
        Some(width) => Reach {
            part: WIDEST_MEANT,
            width,
        },
        None => Reach {
            part: WIDEST_GAP,
            width: f64::INFINITY,
        },
    };
    let mut wide = gaps(&shapes, fixed, reach).into_iter();
    if let Some(gap) = wide.find(|gap| gap.part > TOUCHING) {
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

/// An outline's name, and where it is.
fn near(d: &Drawn) -> String {
    let at = d.shape.centroid();
    let layer = match d.path.layer.as_str() {
        "" => String::new(),
        layer => format!("layer `{layer}`, "),
    };
    format!("`{}` ({layer}at {:.4}, {:.4})", d.name, at.x, at.y)
}

/// Two outlines that overlap, or of which one is a hole in the other.
fn overlapping([one, other]: [&Drawn; 2], depth: f64, options: &DrawingOptions) -> Complaint {
    for (outer, inner) in [(one, other), (other, one)] {
        let (outline, mut corners) = (outer.shape.corners(), inner.shape.corners().iter());
        if corners.all(|corner| holds(outline, *corner)) {
            let title = format!("{} lies within {}: a hole", near(inner), near(outer));
            return complain(&inner.path, &title).help(
                "stones have no holes: cut the outer one in two stones about it, or leave the layer of the \
                 inner one out: `without` names it",
            );
        }
    }
    let title = format!(
        "{} and {} overlap, {depth:.3e} deep",
        near(one),
        near(other)
    );
    complain(&other.path, &title).help(beyond(options))
}

/// What to do about outlines that are further apart than is healed.
pub(super) fn beyond(options: &DrawingOptions) -> String {
    if options.gap.is_some() {
        "correct the drawing there, or name another width with `gap`; no gap is closed that is wider than a \
         tenth of the smaller stone"
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
fn mortar(shapes: &[Polygon], fixed: &[bool], options: &DrawingOptions) -> Option<String> {
    if options.gap.is_some() {
        return None;
    }
    let reach = Reach {
        part: WIDEST_MORTAR,
        width: f64::INFINITY,
    };
    let gaps = gaps(shapes, fixed, reach);
    let open = gaps.iter().filter(|gap| gap.part > TOUCHING);
    let mut widths: Vec<f64> = open.map(|gap| gap.width).collect();
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
