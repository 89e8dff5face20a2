//! A mechanism as it is drawn: rigid parts in tints, or blocks by how far they move; joints that open
//! and slide.

use super::frame::{Displacement, Frame};
use super::key::Held;
use super::palette::{BLOCK_LINE, OPENING, PARTS, SCALE, SLIDING, STILL, SUPPORT, WHITE};
use super::svg::{Anchor, Path, Pixel, Svg, style};
use super::wall::line_width;
use super::words::{fitting, text_width};
use crate::mechanics::{JointRate, Mechanism, Moved};
use crate::scene::{Joint, JointClass, Scene, Side};

/// Font sizes of the names of blocks.
const LETTERS: [f64; 6] = [10.0, 8.5, 7.0, 5.5, 4.0, 2.5];

pub struct DrawnMechanism<'a> {
    pub mechanism: Option<&'a Mechanism>,
    /// Where it takes every point.
    pub displacement: Displacement<'a>,
    /// In the order in which they are drawn.
    groups: Vec<Group>,
    /// Whether colours tell how far blocks move.
    by_displacement: bool,
    /// Rate below which a joint is at rest.
    at_rest: f64,
}

struct Group {
    fill: &'static str,
    blocks: Vec<usize>,
    words: String,
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
        // A tint for each: where there are more bodies, blocks are coloured by how far they move.
        let by_displacement = count > PARTS.len();
        let mut groups = match by_displacement {
            false => of_parts(&moved),
            true => of_displacement(&moved),
        };
        let supports = (0..scene.blocks().len()).filter(|&block| scene.is_moving_support(block));
        let supports: Vec<usize> = supports.collect();
        for group in &mut groups {
            group.blocks.retain(|block| !supports.contains(block));
        }
        groups.retain(|group| !group.blocks.is_empty());
        if !supports.is_empty() {
            groups.push(Group {
                fill: SUPPORT,
                words: "support: moves".to_owned(),
                blocks: supports,
            });
        }
        Self {
            mechanism,
            displacement: Displacement::new(scene, mechanism),
            groups,
            by_displacement,
            at_rest: threshold * mechanism.map_or(0.0, |mechanism| mechanism.fastest(scene)),
        }
    }

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
    pub fn held(&self, scene: &Scene) -> Vec<Held> {
        let Some(mechanism) = self.mechanism else {
            return Vec::new();
        };
        let groups = self.groups.iter().map(|group| match group.fill {
            STILL => Held::Still,
            SUPPORT => Held::Support,
            _ if self.by_displacement => Held::Scale,
            tint => Held::Tint(tint),
        });
        let mut held: Vec<Held> = groups.collect();
        for (_, rate) in rates(scene, mechanism) {
            held.extend(self.slides(&rate).then_some(Held::Slides));
            held.extend(self.opens(&rate).then_some(Held::Opens));
        }
        held
    }

    fn slides(&self, rate: &JointRate) -> bool {
        rate.slip.abs() > self.at_rest
    }

    fn opens(&self, rate: &JointRate) -> bool {
        rate.opening[0].max(rate.opening[1]) > self.at_rest
    }
}

/// The largest part first.
fn of_parts(moved: &Moved) -> Vec<Group> {
    let mut tints = PARTS.into_iter();
    let parts = moved.parts().iter().enumerate();
    let groups = parts.map(|(index, part)| Group {
        fill: match part.moves {
            true => tints.next().expect("a tint for each part that moves"),
            false => STILL,
        },
        blocks: part.blocks.clone(),
        words: moved.in_figures(index),
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
    let line = style().class("blocks").stroke(BLOCK_LINE);
    svg.open(line.stroke_width(line_width(scene, frame)), "");
    for group in &drawn.groups {
        let mut outline = Path::default();
        for &block in &group.blocks {
            let corners = drawn.displacement.corners(block);
            outline.add(&corners.map(|p| frame.at(p)).collect::<Vec<_>>(), true);
        }
        let words = drawn.mechanism.map_or("", |_| &group.words);
        let style = style().class("part").fill(group.fill);
        svg.path(&outline, style, words);
    }
    svg.close();
}

/// The names of blocks, each in as large letters as fit into its block.
pub fn names(svg: &mut Svg, frame: &Frame, scene: &Scene, drawn: &DrawnMechanism) {
    for (index, block) in scene.blocks().iter().enumerate() {
        let (low, high) = block.shape.bounds();
        let room = [0.92, 0.96].map(|part| part * frame.scale);
        let (wide, tall) = (room[0] * (high.x - low.x), room[1] * (high.y - low.y));
        let name = scene.block_name(index);
        let sizes = LETTERS.map(|size| (size, fitting(&name, size, wide)));
        let fits = |(size, lines): &&(f64, Vec<String>)| {
            let width = lines.iter().map(|line| text_width(line, *size));
            1.1 * size * lines.len() as f64 <= tall && width.fold(0.0, f64::max) <= wide
        };
        let (size, lines) = sizes.iter().find(fits).unwrap_or(&sizes[LETTERS.len() - 1]);
        let middle = drawn
            .displacement
            .on(Side::Block(index), block.shape.centroid());
        let [x, y] = frame.at(middle);
        let first = y + size * (0.35 - 0.55 * (lines.len() as f64 - 1.0));
        for (line, words) in lines.iter().enumerate() {
            let at = [x, first + 1.1 * size * line as f64];
            svg.text(at, Anchor::Middle, style().font_size(*size), words);
        }
    }
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
        // The ends on both sides, where the mechanism takes them.
        let on = |side| (joint.ends).map(|end| frame.at(drawn.displacement.on(side, end)));
        let ([a, b], [c, d]) = (on(joint.from), on(Side::Block(joint.to)));
        if drawn.opens(&rate) {
            open.add(&[a, b, d, c], true);
            counts[0] += 1;
        }
        if drawn.slides(&rate) {
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
    let white = style().line(WHITE, 2.2 * width);
    svg.path(&slide, white.round_ends(), "");
    let line = style().class("sliding").line(SLIDING, width).round_ends();
    svg.path(&slide, line, &counted(counts[1], "slide"));
}

fn counted(joints: usize, verb: &str) -> String {
    match joints {
        1 => format!("1 joint {verb}s"),
        _ => format!("{joints} joints {verb}"),
    }
}
