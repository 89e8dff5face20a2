//! Which blocks of a scene take part in a pushover.
//!
//! Blocks that are joined only through supports do not act on each other: every connected part is
//! a pushover of its own, with its own units, so that a light part is not measured by a heavy one.
//! Of tall walls, what lies beyond the stagger line is held fixed, which halves the work, and must
//! be shown afterwards to have had no reason to move.

use super::tuned::Tuned;
use crate::scene::{
    Block, HeadJoints, Joint, JointClass, Point, Push, Scene, Side, bounds_of, connected_parts,
    multiplier_unit,
};

/// What a block is in a pushover.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    /// It moves as it must.
    Free,
    /// It does too, between the stagger line and the blocks held fixed.
    Strip,
    /// It is held fixed.
    Fixed,
    /// It belongs to another part.
    Absent,
}

/// The role of every block, in the scene's order; by default all are free.
#[derive(Clone, Debug, Default)]
pub struct Portion(Vec<Role>);

impl Portion {
    /// The connected parts of a scene, in the order of their first blocks.
    pub fn parts(scene: &Scene) -> Vec<Self> {
        let of = connected_parts(scene.blocks().len(), scene.joints());
        let first = (0..of.len()).filter(|&block| of[block] == block);
        let part = |first: usize| {
            let role = |&other: &usize| match other == first {
                true => Role::Free,
                false => Role::Absent,
            };
            Self(of.iter().map(role).collect())
        };
        first.map(part).collect()
    }

    fn role(&self, block: usize) -> Role {
        self.0.get(block).copied().unwrap_or(Role::Free)
    }

    /// Whether a block moves as it must.
    pub fn is_free(&self, block: usize) -> bool {
        matches!(self.role(block), Role::Free | Role::Strip)
    }

    /// Whether a block belongs to another part.
    pub fn is_absent(&self, block: usize) -> bool {
        self.role(block) == Role::Absent
    }

    /// The blocks of this part, also those held fixed.
    pub fn present<'a>(&'a self, scene: &'a Scene) -> impl Iterator<Item = &'a Block> {
        let blocks = scene.blocks().iter().enumerate();
        let present = blocks.filter(|&(index, _)| !self.is_absent(index));
        present.map(|(_, block)| block)
    }

    /// Lower-left and upper-right corner of these blocks.
    pub fn bounds(&self, scene: &Scene) -> (Point, Point) {
        bounds_of(self.present(scene).map(|block| &block.shape))
    }

    /// The joints of this part.
    pub fn joints<'a>(&'a self, scene: &'a Scene) -> impl Iterator<Item = &'a Joint> + Clone {
        let joints = scene.joints().iter();
        joints.filter(|joint| !self.is_absent(joint.to))
    }

    /// Whether head joints of this part are in contact: what they carry depends on how the wall came
    /// to be. An arch has none, as its radial joints carry the thrust.
    pub fn has_range(&self, scene: &Scene) -> bool {
        let head = |joint: &Joint| joint.class == JointClass::Head;
        scene.head_joints() == HeadJoints::Contact && self.joints(scene).any(head)
    }

    /// Whether a live force acts on this part.
    pub fn is_pushed(&self, scene: &Scene) -> bool {
        self.forces(scene)[1] > 0.0
    }

    /// Sums of the magnitudes of the dead and of the live forces for λ = 1.
    pub fn forces(&self, scene: &Scene) -> [f64; 2] {
        let loads = || self.present(scene).flat_map(|block| &block.loads);
        let dead = loads().map(|load| load.dead.norm()).sum();
        [dead, loads().map(|load| load.live.norm()).sum()]
    }

    /// Multiplier at which the live loads add up to the dead ones, as that of a whole scene.
    pub fn multiplier_unit(&self, scene: &Scene) -> f64 {
        let [dead, live] = self.forces(scene);
        multiplier_unit(dead, live)
    }

    /// Whether a body is fixed: a support, or a block held fixed.
    pub fn is_fixed(&self, side: Side) -> bool {
        match side {
            Side::Support(_) => true,
            Side::Block(block) => self.role(block) == Role::Fixed,
        }
    }

    /// Whether any block is held fixed.
    pub fn holds_any(&self) -> bool {
        self.0.contains(&Role::Fixed)
    }

    /// Whether a block is in the strip that must stay still.
    pub fn is_in_strip(&self, block: usize) -> bool {
        self.role(block) == Role::Strip
    }
}

/// The part of a tall regular wall beyond the line that rises from the toe by one course for
/// each overlap. `None` where there is nothing to gain, and for irregular walls: a part with
/// openings may fail far from that line, where nothing would tell.
pub fn beyond_stagger(scene: &Scene, part: &Portion, tuned: &Tuned) -> Option<Portion> {
    if part.0.contains(&Role::Absent) {
        return None;
    }
    scene.regular().as_ref().ok()?;
    let wall = scene
        .coursing()
        .filter(|wall| wall.levels.len() as f64 >= tuned.swaying)?;
    let (low, high) = scene.bounds();
    let role = |block: &Block| {
        let (l, h) = block.shape.bounds();
        let near = match scene.push() {
            Push::Right => high.x - h.x,
            Push::Left => l.x - low.x,
        };
        let course = wall.courses_up_to(l.y - low.y) as f64 + 1.0;
        // Overlaps between the stagger line and the block's near side.
        match near / wall.overlap - course {
            beyond if beyond > tuned.margin - 0.5 => Role::Fixed,
            beyond if beyond > -0.5 => Role::Strip,
            _ => Role::Free,
        }
    };
    let part = Portion(scene.blocks().iter().map(role).collect());
    part.holds_any().then_some(part)
}
