//! One method's view of one wall: title, picture, caption.

use super::crack::{self, DIMENSIONS, PUSH};
use super::forces;
use super::frame::Frame;
use super::key::{Held, units_of_length};
use super::mechanism::{self, DrawnMechanism};
use super::palette::FAINT;
use super::svg::{Anchor, Pixel, Svg, style};
use super::view::{Contents, View};
use super::wall;
use super::words::fitting;
use crate::answer::Evidence;
use crate::number::{number, short};
use crate::scene::{HeadJoints, JointClass, Point, Push, Vector};

/// Pixels for the heading above a picture.
pub const HEADING: f64 = 26.0;

/// Pixels for a line of the caption.
pub const LINE: f64 = 17.0;

/// Font sizes of the first line of the caption and of the others.
const FIRST: f64 = 13.5;
const FURTHER: f64 = 12.0;

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
    pub fn new(view: &'a View<'a>, contents: Contents) -> Self {
        let (scene, outcome) = (view.scene, &view.row.outcome);
        let mechanism = match contents {
            Contents::Mechanism => outcome.evidence.mechanism(),
            Contents::Forces => None,
        };
        let drawn = DrawnMechanism::new(scene, mechanism, outcome.evidence.still());
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
    pub fn draw(&self, svg: &mut Svg, corner: Pixel, size: [f64; 2], scale: f64, labels: bool) {
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
        wall::frictions(svg, scene, &frame);
        mechanism::marks(svg, &frame, scene, &self.drawn);
        if labels {
            mechanism::names(svg, &frame, scene, &self.drawn);
        }
        let above = frame.at(high)[1] - 12.0;
        match self.contents {
            Contents::Forces => {
                if let Some((_, forces)) = outcome.evidence.forces() {
                    forces::forces(svg, &frame, scene, forces);
                    forces::lines_of_thrust(svg, &frame, scene, forces);
                }
            }
            Contents::Mechanism => {
                if self.view.is_macro_block() {
                    let tan_beta = outcome.evidence.crack(scene).map(|crack| crack.tan_beta);
                    tan_beta.inspect(|&t| crack::turned_macro_block(svg, &frame, scene, t));
                }
                if let Some(tan_beta) = self.view.macro_slope {
                    crack::macro_crack(svg, &frame, scene, tan_beta);
                }
                if let Some(found) = &outcome.evidence.crack(scene) {
                    crack::crack(svg, &frame, scene, found, above);
                }
            }
        }
        if scene.reaction().is_none() {
            crack::push(svg, &frame, scene);
        }
    }

    /// Heading, with its baseline at `heading`, and the caption below the picture.
    pub fn words(&self, svg: &mut Svg, [x, heading]: Pixel, caption: &[String], below: f64) {
        let row = &self.view.row;
        let what = match self.contents {
            Contents::Mechanism => row.method.clone(),
            Contents::Forces => format!("{}, contact forces", row.method),
        };
        let of = match self.contents {
            Contents::Mechanism => joints(self.view),
            Contents::Forces => String::new(),
        };
        svg.heading([x, heading], &what, &of);
        for (index, line) in caption.iter().enumerate() {
            let style = match index {
                0 => style().font_size(FIRST),
                _ => style().font_size(FURTHER).fill(FAINT),
            };
            let y = below + LINE * (index + 1) as f64;
            svg.text([x, y], Anchor::Start, style, line);
        }
    }

    /// Whether there is a mechanism or a macro-block to see.
    pub fn shows_something(&self) -> bool {
        self.view.is_macro_block() || self.drawn.mechanism.is_some()
    }

    /// What the picture holds at so many pixels for a unit of length.
    pub fn held(&self, scale: f64) -> Vec<Held> {
        let (scene, evidence) = (self.view.scene, &self.view.row.outcome.evidence);
        let mut held = self.drawn.held(scene);
        let supports = (!scene.supports().is_empty()).then_some(Held::Support);
        let before = self.drawn.mechanism.map(|_| Held::Before);
        held.extend(supports.into_iter().chain(before));
        let frictions = wall::own_frictions(scene).into_iter();
        held.extend(frictions.map(|(friction, _)| Held::Friction(friction)));
        match self.contents {
            Contents::Mechanism => {
                let crack = self.view.row.crack.filter(|_| scene.coursing().is_some());
                let lines = crack.filter(|crack| crack.c.is_some() && crack.e.is_some());
                held.extend(lines.map(|_| Held::Crack));
                held.extend(self.view.macro_slope.map(|_| Held::MacroCrack));
            }
            Contents::Forces => {
                let forces = evidence.forces();
                let round = forces.and_then(|(_, all)| forces::round_force(scene, all, scale));
                held.extend(round.map(|(force, pixels)| Held::Force(force, pixels)));
            }
        }
        held
    }

    /// The method and what became of it, for what is not drawn.
    pub fn in_a_line(&self) -> String {
        let row = &self.view.row;
        format!(
            "{}, {}: {}",
            row.method,
            joints(self.view),
            self.sentences().join("; ")
        )
        .replace(", : ", ": ")
    }

    /// How far what moves is drawn from where it is.
    fn amplification(&self) -> Option<String> {
        let (scene, drawn) = (self.view.scene, &self.drawn);
        let fastest = drawn.mechanism?.fastest(scene);
        let factor = drawn.displacement.factor;
        let largest = units_of_length(factor * fastest, 3);
        Some(match self.view.row.outcome.evidence {
            Evidence::Observed(_) => format!(
                "displacements × {}, the largest drawn as {largest}",
                significant(factor)
            ),
            Evidence::Nothing
            | Evidence::ClosedForm { .. }
            | Evidence::Number { .. }
            | Evidence::State { .. }
            | Evidence::Bounds { .. }
            | Evidence::States { .. }
            | Evidence::Enclosed { .. }
            | Evidence::Bounded { .. }
            | Evidence::Falls { .. }
            | Evidence::Stands { .. } => {
                format!("velocities, the largest drawn as {largest}")
            }
        })
    }

    /// λ, tan β, how far movements are amplified, and why something that was asked for is missing;
    /// lines of no more than `width` pixels.
    pub fn caption(&self, width: f64, forces: bool) -> Vec<String> {
        let mut sentences = self.sentences();
        if self.contents == Contents::Mechanism {
            sentences.extend(self.amplification());
            if forces && self.view.row.outcome.evidence.forces().is_none() {
                sentences.push("it gives no contact forces".to_owned());
            }
        }
        let lines = sentences.iter().enumerate().flat_map(|(index, sentence)| {
            let size = if index == 0 { FIRST } else { FURTHER };
            fitting(sentence, size, width)
        });
        lines.collect()
    }

    fn sentences(&self) -> Vec<String> {
        let (row, outcome) = (&*self.view.row, &self.view.row.outcome);
        let status = outcome.status.name();
        let what = row.reaction.as_ref().map_or("λ =", |_| "reaction");
        if self.contents == Contents::Forces {
            let (lambda, forces) = outcome.evidence.forces().unzip();
            let lambda = lambda.unwrap_or(0.0);
            let largest = forces::largest(self.view.scene, forces);
            return vec![
                format!("at {what} {}", number(row.reads(lambda), 5)),
                format!("largest force {}", short(largest, 4)),
            ];
        }
        let mut lines = match outcome.bracket() {
            Some(_) => vec![format!("{what} {}, {status}", row.value("lambda").shown())],
            None => vec![format!("no multiplier: {status}")],
        };
        if let [lowest, ..] = outcome.evidence.states() {
            let lambda = number(row.reads(lowest.lambda), 5);
            // Where the answer is that one number, nothing else could be drawn.
            if !lines[0].contains(&format!("{what} {lambda},")) {
                let which = row
                    .reaction
                    .as_ref()
                    .map_or("lowest state", |_| "state reached first");
                lines.push(format!("drawn: the {which}, {what} {lambda}"));
            }
        }
        if let Some(crack) = &row.crack {
            let about = if crack.sharp { "=" } else { "≈" };
            let mut slope = format!("tan β {about} {}", number(crack.tan_beta, 4));
            if let (Some(c), Some(e)) = (crack.c, crack.e) {
                slope.push_str(&format!(", c = {}, e = {}", short(c, 3), short(e, 3)));
            }
            lines.push(slope);
        }
        match (self.shows_something(), outcome.reason().as_str()) {
            (true, _) => {}
            (false, "") => lines.push("no mechanism to draw".to_owned()),
            (false, reason) => lines.push(format!("no mechanism to draw: {reason}")),
        }
        lines
    }
}

fn significant(factor: f64) -> String {
    let decimals = (1.0 - factor.log10().floor()).clamp(0.0, 9.0);
    short(factor, decimals as usize)
}

/// The head joints, and where the wall is pushed; an arch has neither bed joints nor perpends, and a support
/// that moves is no push.
fn joints(view: &View) -> String {
    let head_joints = view.row.head_joints;
    let open = view.scene.left_out();
    let mut all = view.scene.joints().iter();
    let has_heads = all.any(|joint| joint.class == JointClass::Head);
    let joints = if head_joints == HeadJoints::Contact && open > 0 {
        let joints = head_joints.in_words();
        Some(format!("head joints {joints}, {open} of them open"))
    } else if head_joints == HeadJoints::Open || has_heads {
        Some(format!("head joints {}", head_joints.in_words()))
    } else {
        None
    };
    let pushed = view.scene.reaction().is_none();
    let push = pushed.then(|| format!("pushed to the {}", view.scene.push().name()));
    joints
        .into_iter()
        .chain(push)
        .collect::<Vec<_>>()
        .join(", ")
}
