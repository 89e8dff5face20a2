//! One method's view of one wall: title, picture, caption.

use super::crack::{self, DIMENSIONS, PUSH};
use super::forces;
use super::frame::Frame;
use super::mechanism::{self, DrawnMechanism};
use super::palette::FAINT;
use super::path::Pixel;
use super::svg::{Anchor, Svg, style};
use super::view::{Contents, View};
use super::wall;
use super::words::first_lines;
use crate::number::{number, short};
use crate::run::column;
use crate::scene::{HeadJoints, Point, Push, Vector};

/// Pixels for the heading above a picture.
pub const HEADING: f64 = 26.0;

/// Pixels for a line of the caption.
pub const LINE: f64 = 17.0;

/// Pixels around the picture where nothing else asks for room.
const MARGIN: f64 = 10.0;

/// What a view shows, before it is known how large.
pub struct Panel<'a> {
    view: &'a View<'a>,
    drawn: DrawnMechanism<'a>,
    contents: Contents,
    /// Lower-left and upper-right corner of all that the picture holds.
    bounds: (Point, Point),
}

impl<'a> Panel<'a> {
    /// What there is to show.
    pub fn new(view: &'a View<'a>, contents: Contents) -> Self {
        let (scene, outcome) = (view.scene, &view.row.outcome);
        let mechanism = match contents {
            Contents::Mechanism => outcome.mechanism.as_ref(),
            Contents::Forces => None,
        };
        let drawn = DrawnMechanism::new(scene, mechanism, &view.row.method);
        let (mut low, mut high) = drawn.displacement.bounds();
        if view.is_macro_block() {
            let reach = crack::TURN * scene.height();
            high.y += reach;
            match scene.push() {
                Push::Right => high.x += reach,
                Push::Left => low.x -= reach,
            }
        }
        Self {
            view,
            drawn,
            contents,
            bounds: (low, high),
        }
    }

    /// Largest number of pixels a unit of length in a picture of this size.
    pub fn scale(&self, [width, height]: [f64; 2]) -> f64 {
        let (low, high) = self.bounds;
        let free = [
            width - PUSH - 2.0 * MARGIN,
            height - DIMENSIONS - 2.0 * MARGIN,
        ];
        (free[0] / (high.x - low.x)).min(free[1] / (high.y - low.y))
    }

    /// Pixels that the picture takes above its lower edge, supports included.
    pub fn height(&self, scale: f64) -> f64 {
        let (low, high) = self.bounds;
        scale * (high.y - low.y) + DIMENSIONS + 2.0 * MARGIN
    }

    /// Draws the picture into the box from `corner` to `corner + size`, its base on the lower edge.
    pub fn draw(&self, svg: &mut Svg, corner: Pixel, size: [f64; 2], scale: f64) {
        let (scene, outcome) = (self.view.scene, &self.view.row.outcome);
        let (low, high) = self.bounds;
        let [left, right] = match scene.push() {
            Push::Right => [PUSH, 0.0],
            Push::Left => [0.0, PUSH],
        };
        let spare = size[0] - left - right - scale * (high.x - low.x);
        let base = corner[1] + size[1] - MARGIN;
        let origin = [corner[0] + left + spare / 2.0, base];
        let frame = Frame {
            scale,
            corner: (low, origin),
        };
        let reach = Vector::new(MARGIN + 4.0, MARGIN - 2.0) / scale;
        let top = Point::new(high.x + reach.x, high.y + reach.y);
        wall::supports(svg, scene, &frame, [low - reach, top]);
        if self.contents == Contents::Mechanism && self.drawn.mechanism.is_some() {
            wall::outlines(svg, scene, &frame);
        }
        mechanism::blocks(svg, &frame, scene, &self.drawn);
        mechanism::marks(svg, &frame, scene, &self.drawn);
        let above = frame.at(high)[1] - 12.0;
        match self.contents {
            Contents::Forces => {
                if let Some(forces) = &outcome.forces {
                    forces::forces(svg, &frame, scene, forces);
                    forces::lines_of_thrust(svg, &frame, scene, forces);
                }
            }
            Contents::Mechanism => {
                if self.view.is_macro_block() {
                    let tan_beta = outcome.crack.map(|crack| crack.tan_beta);
                    tan_beta.inspect(|&t| crack::turned_macro_block(svg, &frame, scene, t));
                }
                if let Some(tan_beta) = self.view.macro_slope {
                    crack::macro_crack(svg, &frame, scene, tan_beta);
                }
                if let Some(found) = &outcome.crack {
                    crack::crack(svg, &frame, scene, found, above);
                }
            }
        }
        crack::push(svg, &frame, scene);
    }

    /// Heading, with its baseline at `heading`, and the caption below the picture.
    pub fn words(&self, svg: &mut Svg, [x, heading]: Pixel, caption: &[String], below: f64) {
        let row = self.view.row;
        let what = match self.contents {
            Contents::Mechanism => row.method.clone(),
            Contents::Forces => format!("{}, contact forces", row.method),
        };
        // Joints of an arch are neither bed joints nor perpends.
        let has_head_joints =
            self.view.scene.coursing().is_some() || row.head_joints == HeadJoints::Open;
        let joints = if has_head_joints {
            format!("{} head joints", row.head_joints.name())
        } else {
            String::new()
        };
        svg.heading([x, heading], &what, &joints);
        for (index, line) in caption.iter().enumerate() {
            let style = match index {
                0 => style().font_size(13.5),
                _ => style().font_size(12.0).fill(FAINT),
            };
            let y = below + LINE * (index + 1) as f64;
            svg.text([x, y], Anchor::Start, style, line);
        }
    }

    /// λ, tan β, and why something that was asked for is missing; lines of no more than `width`
    /// characters.
    pub fn caption(&self, width: usize, forces: bool) -> Vec<String> {
        let (row, outcome) = (self.view.row, &self.view.row.outcome);
        let status = outcome.status.name();
        if self.contents == Contents::Forces {
            let largest = forces::largest(self.view.scene, outcome.forces.as_deref());
            let lambda = outcome.bracket.map_or(0.0, |bracket| bracket.lower);
            return vec![
                format!("at λ = {}", number(lambda, 5)),
                format!("largest force {}", short(largest, 4)),
            ];
        }
        let mut lines = match outcome.bracket {
            Some(_) => vec![format!(
                "λ = {}, {status}",
                (column("lambda").value)(row).shown()
            )],
            None => vec![format!("no multiplier: {status}")],
        };
        if let Some(crack) = &outcome.crack {
            let about = if crack.sharp { "=" } else { "≈" };
            let mut slope = format!("tan β {about} {}", number(crack.tan_beta, 4));
            if let (Some(c), Some(e)) = (crack.c, crack.e) {
                slope.push_str(&format!(", c = {}, e = {}", short(c, 3), short(e, 3)));
            }
            lines.push(slope);
        }
        let is_drawn = self.view.is_macro_block() || self.drawn.mechanism.is_some();
        let mut missing = match (is_drawn, outcome.reason().as_str()) {
            (true, _) => String::new(),
            (false, "") => "no mechanism to draw".to_owned(),
            (false, reason) => format!("no mechanism to draw: {reason}"),
        };
        if forces && outcome.forces.is_none() {
            missing = format!("it gives no contact forces; {missing}");
        }
        lines.extend(first_lines(missing.trim_end_matches("; "), width, 4));
        lines
    }
}
