//! One method's view of one wall: title, picture, caption.

use super::crack::{self, DIMENSIONS, PUSH};
use super::frame::Frame;
use super::palette::FAINT;
use super::svg::{Px, Svg};
use super::wall::{self, Shown};
use super::{Contents, View};
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
    shown: Shown<'a>,
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
        let shown = Shown::new(scene, mechanism, &view.row.method);
        let (mut low, mut high) = shown.displaced.bounds();
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
            shown,
            contents,
            bounds: (low, high),
        }
    }

    /// Largest number of pixels a unit of length in a picture of this size.
    pub fn scale(&self, [width, height]: Px) -> f64 {
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
    pub fn draw(&self, svg: &mut Svg, corner: Px, size: Px, scale: f64) {
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
        if self.contents == Contents::Mechanism && self.shown.mechanism.is_some() {
            wall::outlines(svg, scene, &frame);
        }
        wall::blocks(svg, &frame, scene, &self.shown);
        wall::marks(svg, &frame, scene, &self.shown);
        let above = frame.at(high)[1] - 12.0;
        match self.contents {
            Contents::Forces => {
                if let Some(forces) = &outcome.forces {
                    wall::forces(svg, &frame, scene, forces);
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
    pub fn words(&self, svg: &mut Svg, [x, heading]: Px, caption: &[String], below: f64) {
        let row = self.view.row;
        let what = match self.contents {
            Contents::Mechanism => row.method.clone(),
            Contents::Forces => format!("{}, contact forces", row.method),
        };
        // Joints of an arch are neither bed joints nor perpends.
        let told = self.view.scene.coursing().is_some() || row.head_joints == HeadJoints::Open;
        let joints = match told {
            true => format!("{} head joints", row.head_joints.name()),
            false => String::new(),
        };
        svg.heading([x, heading], &what, &joints);
        for (index, line) in caption.iter().enumerate() {
            let attributes = match index {
                0 => "font-size=\"13.5\"".to_owned(),
                _ => format!("font-size=\"12\" fill=\"{FAINT}\""),
            };
            let y = below + LINE * (index + 1) as f64;
            svg.text([x, y], "start", attributes, line);
        }
    }

    /// λ, tan β, and why something that was asked for is missing; lines of no more than `width`
    /// characters.
    pub fn caption(&self, width: usize, forces: bool) -> Vec<String> {
        let (row, outcome) = (self.view.row, &self.view.row.outcome);
        let status = outcome.status.name();
        if self.contents == Contents::Forces {
            let largest = wall::largest_force(self.view.scene, outcome.forces.as_deref());
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
        let drawn = self.view.is_macro_block() || self.shown.mechanism.is_some();
        let mut missing = match (drawn, outcome.reason().as_str()) {
            (true, _) => String::new(),
            (false, "") => "no mechanism to draw".to_owned(),
            (false, reason) => format!("no mechanism to draw: {reason}"),
        };
        if forces && outcome.forces.is_none() {
            missing = format!("it gives no contact forces; {missing}");
        }
        lines.extend(wrapped(missing.trim_end_matches("; "), width, 4));
        lines
    }
}

/// Text in lines of at most `width` characters; what does not fit into `most` lines ends in `…`.
fn wrapped(text: &str, width: usize, most: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let full = lines.len() == most;
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            Some(line) if full => {
                line.push('…');
                break;
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
