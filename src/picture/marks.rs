//! Points of a plot as shapes.

use std::f64::consts::TAU;

use super::path::{Path, Pixel};
use super::svg::{Svg, style};
use crate::method::{Look, Mark};

/// Pixels from the middle of a disc to its edge; other shapes have about its area.
const RADIUS: f64 = 4.5;

/// Draws one point.
pub fn mark(svg: &mut Svg, at: Pixel, look: Look) {
    let corners = match look.mark {
        Mark::Circle => {
            let fill = style().fill(look.colour).fill_opacity(OPACITY);
            return svg.circle(at, RADIUS, fill);
        }
        Mark::Plus => return lines(svg, [0.0, 0.25], at, look.colour),
        Mark::Cross => return lines(svg, [0.125, 0.375], at, look.colour),
        Mark::Square => around(at, 4, 0.125, [1.2; 2]),
        Mark::Diamond => around(at, 4, 0.0, [1.35; 2]),
        Mark::Triangle => around(at, 3, 0.25, [1.3; 2]),
        Mark::TriangleDown => around(at, 3, 0.75, [1.3; 2]),
        Mark::Star => around(at, 10, 0.25, [1.5, 0.65]),
    };
    let fill = style().fill(look.colour).fill_opacity(OPACITY);
    svg.path(&Path::through(&corners, true), fill, "");
}

/// So that points on one another are seen.
const OPACITY: f64 = 0.85;

/// Corners around a point, the first of them at a part of a full turn from the right; every other
/// one is at the second of two radii.
fn around(at: Pixel, count: usize, first: f64, radii: [f64; 2]) -> Vec<Pixel> {
    let corner = |index: usize| {
        let angle = TAU * (first + index as f64 / count as f64);
        let radius = RADIUS * radii[index % 2];
        [at[0] + radius * angle.cos(), at[1] - radius * angle.sin()]
    };
    (0..count).map(corner).collect()
}

/// Lines through a point, each towards a part of a full turn from the right.
fn lines(svg: &mut Svg, directions: [f64; 2], at: Pixel, colour: &str) {
    let mut path = Path::default();
    for direction in directions {
        path.add(&around(at, 2, direction, [1.2; 2]), false);
    }
    svg.path(&path, style().stroke(colour).stroke_width(1.8), "");
}
