//! A mechanism as it is drawn: rigid parts in tints, or blocks by how far they move; joints that open
//! and slide.

use super::frame::{Displacement, Frame};
use super::palette::{BLOCK_LINE, LARGEST, OPENING, PARTS, SCALE, SLIDING, STILL, WHITE};
use super::path::{Path, Pixel};
use super::svg::{Svg, style};
use super::tints::tints;
use super::wall::line_width;
use crate::mechanics::{JointRate, Mechanism, Moved};
use crate::scene::{Joint, JointClass, Scene, Side};

/// Bodies that move from which on tints say nothing any more: blocks are coloured by how far they move.
const MANY: usize = 20;

/// A mechanism as it is drawn.
pub struct DrawnMechanism<'a> {
    /// The mechanism, where there is one.
    pub mechanism: Option<&'a Mechanism>,
    /// Where it takes every point.
    pub displacement: Displacement<'a>,
    /// Blocks of one colour each, in the order in which they are drawn.
    groups: Vec<Group>,
    /// Whether colours tell how far blocks move.
    pub by_displacement: bool,
    /// Rate below which a joint is at rest.
    at_rest: f64,
}

/// Blocks of one colour.
struct Group {
    fill: &'static str,
    blocks: Vec<usize>,
    words: String,
}

/// Marks of a mechanism that a drawing holds.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Occurring {
    /// Blocks that stand still.
    pub still: bool,
    /// Tints of bodies.
    pub tints: Vec<&'static str>,
    /// Colours by displacement.
    pub scale: bool,
    /// Joints that slide.
    pub slides: bool,
    /// Joints that open.
    pub opens: bool,
}

impl<'a> DrawnMechanism<'a> {
    /// A mechanism, or the wall at rest. `threshold` is the relative motion, as a part of the fastest,
    /// below which nothing moves.
    pub fn new(scene: &'a Scene, mechanism: Option<&'a Mechanism>, threshold: f64) -> Self {
        let still = Mechanism {
            motions: vec![Default::default(); scene.blocks().len()],
        };
        let moved = Moved::new(scene, mechanism.unwrap_or(&still), threshold);
        let parts = moved.parts();
        let count = parts.iter().filter(|part| part.moves).count();
        let tints = (count <= MANY)
            .then(|| tints(scene, parts, PARTS.len() + 1))
            .flatten();
        let by_displacement = tints.is_none();
        let groups = match tints {
            Some(tints) => of_parts(&moved, &tints),
            None => of_displacement(&moved),
        };
        Self {
            mechanism,
            displacement: Displacement::new(scene, mechanism),
            groups,
            by_displacement,
            at_rest: threshold * mechanism.map_or(0.0, |mechanism| mechanism.fastest(scene)),
        }
    }

    /// The colour of every block.
    pub fn fills(&self) -> Vec<&'static str> {
        let count = self.groups.iter().map(|group| group.blocks.len()).sum();
        let mut fills = vec![STILL; count];
        for group in &self.groups {
            for &block in &group.blocks {
                fills[block] = group.fill;
            }
        }
        fills
    }

    /// What of a mechanism occurs in the drawing.
    pub fn occurring(&self, scene: &Scene) -> Occurring {
        let Some(mechanism) = self.mechanism else {
            return Occurring::default();
        };
        let fills = self.groups.iter().map(|group| group.fill);
        let moving = || fills.clone().filter(|fill| *fill != STILL);
        let mut tints: Vec<&'static str> = Vec::new();
        if !self.by_displacement {
            for fill in moving() {
                if !tints.contains(&fill) {
                    tints.push(fill);
                }
            }
        }
        let rates: Vec<JointRate> = rates(scene, mechanism).map(|(_, rate)| rate).collect();
        Occurring {
            still: fills.clone().any(|fill| fill == STILL),
            tints,
            scale: self.by_displacement,
            slides: rates.iter().any(|rate| rate.slip.abs() > self.at_rest),
            opens: rates
                .iter()
                .any(|rate| rate.opening[0].max(rate.opening[1]) > self.at_rest),
        }
    }
}

fn of_parts(moved: &Moved, tints: &[Option<usize>]) -> Vec<Group> {
    let groups = moved.parts().iter().zip(tints).map(|(part, tint)| Group {
        fill: match tint {
            None => STILL,
            Some(0) => LARGEST,
            Some(other) => PARTS[other - 1],
        },
        blocks: part.blocks.clone(),
        words: moved.in_figures(part),
    });
    groups.collect()
}

/// Blocks that stand still, and the others by the displacement of their centroids, from small to large.
fn of_displacement(moved: &Moved) -> Vec<Group> {
    let mut classes: Vec<Vec<usize>> = vec![Vec::new(); SCALE.len()];
    let mut still = Vec::new();
    for part in moved.parts() {
        for &block in &part.blocks {
            if part.moves {
                let share = moved.mechanism.motions[block].velocity.norm() / moved.fastest;
                let class = (share * SCALE.len() as f64).ceil() as usize;
                classes[class.clamp(1, SCALE.len()) - 1].push(block);
            } else {
                still.push(block);
            }
        }
    }
    let group = |(class, blocks): (usize, Vec<usize>)| {
        let [from, to] = [class, class + 1].map(|end| 100 * end / SCALE.len());
        Group {
            words: format!(
                "{} blocks move by {from} to {to} % of the largest displacement",
                blocks.len()
            ),
            fill: SCALE[class],
            blocks,
        }
    };
    let still = Group {
        fill: STILL,
        words: format!("{} blocks stand still", still.len()),
        blocks: still,
    };
    let moving = classes.into_iter().enumerate().map(group);
    let groups = std::iter::once(still).chain(moving);
    groups.filter(|group| !group.blocks.is_empty()).collect()
}

/// Blocks where the mechanism takes them, each group in its colour.
pub fn blocks(svg: &mut Svg, frame: &Frame, scene: &Scene, drawn: &DrawnMechanism) {
    let outline = |group: &Group| {
        let mut path = Path::default();
        for &block in &group.blocks {
            let corners = drawn.displacement.corners(block);
            let corners: Vec<Pixel> = corners.map(|p| frame.at(p)).collect();
            path.add(&corners, true);
        }
        path
    };
    let line = style().class("blocks").stroke(BLOCK_LINE);
    svg.open(line.stroke_width(line_width(scene, frame)), "");
    for group in &drawn.groups {
        let words = match drawn.mechanism {
            Some(_) => &group.words,
            None => "",
        };
        let style = style().class("part").fill(group.fill);
        svg.path(&outline(group), style, words);
    }
    svg.close();
}

/// The joints, and how they open and slip; what guides a support is none to look at.
fn rates<'a>(
    scene: &'a Scene,
    mechanism: &Mechanism,
) -> impl Iterator<Item = (&'a Joint, JointRate)> {
    let rates = scene.joints().iter().zip(mechanism.joint_rates(scene));
    rates.filter(|(joint, _)| joint.class != JointClass::Guide)
}

/// Marks on the joints that open (the gap filled) and on those that slide (a strong line), with how
/// many there are of each. Both stand on white, so that they are seen on any tint.
pub fn marks(svg: &mut Svg, frame: &Frame, scene: &Scene, drawn: &DrawnMechanism) {
    let Some(mechanism) = drawn.mechanism else {
        return;
    };
    let (mut open, mut slide) = (Path::default(), Path::default());
    let mut counts = [0; 2];
    for (joint, rate) in rates(scene, mechanism) {
        let ([a, b], [c, d]) = sides(joint, frame, drawn);
        if rate.opening[0].max(rate.opening[1]) > drawn.at_rest {
            open.add(&[a, b, d, c], true);
            counts[0] += 1;
        }
        if rate.slip.abs() > drawn.at_rest {
            let middle = |p: Pixel, q: Pixel| [(p[0] + q[0]) / 2.0, (p[1] + q[1]) / 2.0];
            slide.add(&[middle(a, c), middle(b, d)], false);
            counts[1] += 1;
        }
    }
    let width = (2.2 * line_width(scene, frame)).clamp(0.6, 2.0);
    svg.path(&open, style().fill(WHITE), "");
    let gap = style().class("opening").fill(OPENING).fill_opacity(0.5);
    let gap = gap.stroke(OPENING).stroke_width(width).dashes("1 2");
    svg.path(&open, gap, &counted(counts[0], "open"));
    let white = style().hollow().stroke(WHITE).stroke_width(2.2 * width);
    svg.path(&slide, white.round_ends(), "");
    let line = style().class("sliding").hollow().stroke(SLIDING);
    let line = line.stroke_width(width).round_ends();
    svg.path(&slide, line, &counted(counts[1], "slide"));
}

/// The ends of a joint on both of its sides, where the mechanism takes them.
fn sides(joint: &Joint, frame: &Frame, drawn: &DrawnMechanism) -> ([Pixel; 2], [Pixel; 2]) {
    let on = |side: Side| {
        joint
            .ends
            .map(|end| frame.at(drawn.displacement.on(side, end)))
    };
    (on(joint.from), on(Side::Block(joint.to)))
}

fn counted(joints: usize, verb: &str) -> String {
    match joints {
        1 => format!("1 joint {verb}s"),
        _ => format!("{joints} joints {verb}"),
    }
}
