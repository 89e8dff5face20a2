//! Points of a plot as shapes.

use std::f64::consts::TAU;

use super::palette::WHITE;
use super::svg::{Path, Pixel, Style, Svg, style};
use crate::method::{Look, Mark};

/// Pixels from the middle of a disc to its edge; other shapes have about its area.
const RADIUS: f64 = 4.5;

/// How a point is filled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Filling {
    Full,
    Open,
    /// Small, thin, and seen through.
    Hollow,
}

impl Filling {
    fn radius(self) -> f64 {
        match self {
            Filling::Full | Filling::Open => RADIUS,
            Filling::Hollow => 0.72 * RADIUS,
        }
    }

    fn style(self, colour: &str) -> Style {
        match self {
            Filling::Full => style().fill(colour).fill_opacity(OPACITY),
            Filling::Open => style().fill(WHITE).stroke(colour).stroke_width(1.7),
            Filling::Hollow => style().hollow().stroke(colour).stroke_width(0.9),
        }
    }

    fn line(self) -> f64 {
        match self {
            Filling::Full => 2.4,
            Filling::Open => 1.3,
            Filling::Hollow => 0.8,
        }
    }
}

pub fn mark(svg: &mut Svg, at: Pixel, look: Look, filling: Filling) {
    let radius = filling.radius();
    let corners = match look.mark {
        Mark::Circle => return svg.circle(at, radius, filling.style(look.colour)),
        Mark::Plus => return lines(svg, [0.0, 0.25], at, look.colour, filling),
        Mark::Cross => return lines(svg, [0.125, 0.375], at, look.colour, filling),
        Mark::Square => around(at, 4, 0.125, [1.2 * radius; 2]),
        Mark::Diamond => around(at, 4, 0.0, [1.35 * radius; 2]),
        Mark::Triangle => around(at, 3, 0.25, [1.3 * radius; 2]),
        Mark::TriangleDown => around(at, 3, 0.75, [1.3 * radius; 2]),
        Mark::Star => around(at, 10, 0.25, [1.5 * radius, 0.65 * radius]),
    };
    svg.path(
        &Path::through(&corners, true),
        filling.style(look.colour),
        "",
    );
}

/// So that points on one another are seen.
const OPACITY: f64 = 0.85;

/// Corners around a point, the first of them at a part of a full turn from the right; every other
/// one is at the second of two radii.
fn around(at: Pixel, count: usize, first: f64, radii: [f64; 2]) -> Vec<Pixel> {
    let corner = |index: usize| {
        let angle = TAU * (first + index as f64 / count as f64);
        let radius = radii[index % 2];
        [at[0] + radius * angle.cos(), at[1] - radius * angle.sin()]
    };
    (0..count).map(corner).collect()
}

/// Lines through a point, each towards a part of a full turn from the right.
fn lines(svg: &mut Svg, directions: [f64; 2], at: Pixel, colour: &str, filling: Filling) {
    let mut path = Path::default();
    for direction in directions {
        path.add(
            &around(at, 2, direction, [1.2 * filling.radius(); 2]),
            false,
        );
    }
    let line = style().stroke(colour).stroke_width(filling.line());
    svg.path(&path, line, "");
}
