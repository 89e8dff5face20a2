//! What a drawing must not have: blocks that overlap, gape or float.

use std::collections::BTreeMap;

use super::drawn::Drawn;
use super::options::DrawingOptions;
use super::paths::complain;
use crate::case::complaint::Complaint;
use crate::case::heal::{LeftOpen, Reach, holds, left_open, stay_open};
use crate::number::short;
use crate::scene::{Assembly, Polygon, Side, Unsound};

/// Mortar is no wider than this part of a stone's extent.
const WIDEST_MORTAR: f64 = 0.1;

/// Refuses what overlaps, gapes or floats, with layers, handles and coordinates; `before` are the outlines as
/// they were drawn. Says which gaps stay open where they are wider than is closed.
pub(super) fn sound(
    drawn: &[Drawn],
    fixed: &[bool],
    before: &[Polygon],
    assembly: &Assembly,
    options: &DrawingOptions,
) -> Result<Option<Complaint>, Complaint> {
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
    let mortar = mortar(before, fixed, options);
    let meant = options.reach().meant();
    let (refused, wider): (Vec<LeftOpen>, Vec<LeftOpen>) = left_open(before, &shapes, fixed, meant)
        .into_iter()
        .partition(|gap| gap.is_refused(meant));
    if let Some(gap) = refused.first() {
        let [one, other] = gap.bodies.map(|body| &drawn[body]);
        let title = format!(
            "a gap of {:.3e} ({:.2} % of the smaller one) at ({:.4}, {:.4}) between {} and {}{}",
            gap.width,
            100.0 * gap.part,
            gap.at.x,
            gap.at.y,
            near(one),
            near(other),
            if gap.has_joint {
                " stays open, which touch elsewhere"
            } else {
                ""
            }
        );
        let help = mortar.unwrap_or_else(|| beyond(options));
        return Err(complain(&other.path, &title).help(help));
    }
    let Some(Unsound::Floating { block, .. }) = unsound else {
        return Ok(stay_open(&wider, &|body| drawn[body].name.clone()));
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
        "correct the drawing there, or name another width with `gap`; no gap is closed in part, and none \
         wider than a tenth of the smaller stone"
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
    let reach = Reach::of_tolerance(WIDEST_MORTAR);
    let gaps = left_open(shapes, shapes, fixed, reach);
    let mut widest: BTreeMap<[usize; 2], f64> = BTreeMap::new();
    for gap in gaps {
        let width = widest.entry(gap.bodies).or_default();
        *width = width.max(gap.width);
    }
    let mut widths: Vec<f64> = widest.into_values().collect();
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
