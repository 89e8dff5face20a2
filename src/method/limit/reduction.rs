//! Certified reduction: blocks that the crack cannot reach are held fixed, the smaller scene is
//! solved, and its answer is then completed to one of the whole scene.
//!
//! The completion is no assumption. The mechanism is at rest beyond the part, and forces for the
//! fixed blocks are found by a program of their own, under the forces that the part puts on them.
//! The judge sees the whole scene only.

use super::ending::Ending;
use super::program::{Margins, Program};
use super::scale::Scale;
use crate::answer::Work;
use crate::mechanics::{JointForce, Mechanism, Motion};
use crate::scene::{Joint, Load, Push, Scene, Side};

/// A part of a scene; all other blocks are supports in it.
pub(super) struct ScenePart {
    /// The part as a scene of its own.
    pub(super) scene: Scene,
    /// Block of the whole scene by block of the part.
    blocks: Vec<usize>,
    /// Joint of the whole scene by joint of the part.
    pub(super) joints: Vec<usize>,
}

/// Scenes of fewer blocks are solved whole: there is nothing to gain.
const LEAST_BLOCKS: usize = 200;

/// How far beyond the stagger line the parts reach, in units' lengths, one after the other.
const REACHES: [f64; 2] = [1.0, 4.0];

/// Parts to try, from small to large; none where the whole scene is as good.
///
/// A crack that starts at the toe is not flatter than the stagger (paper, section 2.1.1), so the
/// parts follow the stagger line from the toe upwards.
pub(super) fn parts(scene: &Scene) -> Vec<ScenePart> {
    let Some(coursing) = scene
        .coursing()
        .filter(|_| scene.blocks().len() >= LEAST_BLOCKS)
    else {
        return Vec::new();
    };
    let (low, high) = scene.bounds();
    let mut parts: Vec<ScenePart> = Vec::new();
    for reach in REACHES {
        let kept: Vec<bool> = scene
            .blocks()
            .iter()
            .map(|block| {
                let (l, h) = block.shape.bounds();
                let distance = match scene.push() {
                    Push::Right => high.x - h.x,
                    Push::Left => l.x - low.x,
                };
                let line = coursing.courses_up_to(h.y - low.y) as f64 * coursing.overlap;
                distance < line + reach * 2.0 * coursing.overlap
            })
            .collect();
        let count = kept.iter().filter(|&&kept| kept).count();
        if count * 5 < scene.blocks().len() * 4 {
            parts.push(ScenePart::new(scene, &kept));
        }
    }
    parts
}

impl ScenePart {
    /// The blocks that are `kept`, in order; all others are supports.
    pub(super) fn new(scene: &Scene, kept: &[bool]) -> Self {
        let mut place = vec![Side::Block(0); scene.blocks().len()];
        let mut supports = scene.supports().to_vec();
        let mut blocks = Vec::new();
        for (i, block) in scene.blocks().iter().enumerate() {
            if kept[i] {
                place[i] = Side::Block(blocks.len());
                blocks.push(i);
            } else {
                place[i] = Side::Support(supports.len());
                supports.push(block.shape.clone());
            }
        }
        let (mut joints, mut of_joint) = (Vec::new(), Vec::new());
        for (j, joint) in scene.joints().iter().enumerate() {
            if let Some(joint) = placed(joint, &place) {
                joints.push(joint);
                of_joint.push(j);
            }
        }
        let kept = blocks.iter().map(|&i| scene.blocks()[i].clone());
        let scene = scene.with_bodies(kept.collect(), supports, joints);
        Self {
            scene,
            blocks,
            joints: of_joint,
        }
    }

    /// The mechanism of the part, everything else at rest.
    pub(super) fn extend(&self, whole: &Scene, mechanism: &Mechanism) -> Mechanism {
        let mut motions = vec![Motion::default(); whole.blocks().len()];
        for (&i, motion) in self.blocks.iter().zip(&mechanism.motions) {
            motions[i] = *motion;
        }
        Mechanism { motions }
    }

    /// The forces of the part at λ, completed by forces that hold the rest in equilibrium within
    /// friction; `None` where no such forces are found, so that the part is too small.
    pub(super) fn complete(
        &self,
        whole: &Scene,
        lambda: f64,
        forces: &[JointForce],
        work: &mut Work,
    ) -> Option<Vec<JointForce>> {
        let mut kept = vec![false; whole.blocks().len()];
        for &i in &self.blocks {
            kept[i] = true;
        }
        let others: Vec<bool> = kept.iter().map(|kept| !kept).collect();
        let mut rest = ScenePart::new(whole, &others);
        let mut all = vec![JointForce::default(); whole.joints().len()];
        for (&j, force) in self.joints.iter().zip(forces) {
            all[j] = *force;
        }
        rest.take_boundary(whole, &kept, &all);
        let scale = Scale::of(whole);
        let mut program = Program::at_multiplier(&rest.scene, lambda, scale);
        program.set_margins(Margins::OF_FORCES);
        let Ending::Solved(solution) = program.solve_counted(work) else {
            return None;
        };
        for (&j, force) in rest.joints.iter().zip(scale.forces(&solution.forces)) {
            all[j] = force;
        }
        Some(all)
    }

    /// Turns joints with `fixed` blocks, whose forces are known, into dead loads of the part.
    fn take_boundary(&mut self, whole: &Scene, fixed: &[bool], forces: &[JointForce]) {
        let known = |joint: &Joint| {
            let from = matches!(joint.from, Side::Block(i) if fixed[i]);
            from || fixed[joint.to]
        };
        let (mut joints, mut of_joint) = (Vec::new(), Vec::new());
        let mut blocks = self.scene.blocks().to_vec();
        for (joint, &j) in self.scene.joints().iter().zip(&self.joints) {
            if !known(&whole.joints()[j]) {
                joints.push(joint.clone());
                of_joint.push(j);
                continue;
            }
            let JointForce { normal, shear } = forces[j];
            let parts = [
                (
                    joint.ends[0],
                    joint.normal * normal[0] + joint.tangent() * shear,
                ),
                (joint.ends[1], joint.normal * normal[1]),
            ];
            let loads = parts.map(|(point, dead)| Load {
                point,
                dead,
                live: dead * 0.0,
            });
            blocks[joint.to].loads.extend(loads);
        }
        let supports = self.scene.supports().to_vec();
        self.scene = self.scene.with_bodies(blocks, supports, joints);
        self.joints = of_joint;
    }
}

/// A joint between the bodies' new places, turned round where its block has become a support;
/// `None` between two supports. Forces keep their values: normal and tangent turn together.
fn placed(joint: &Joint, place: &[Side]) -> Option<Joint> {
    let from = match joint.from {
        Side::Block(i) => place[i],
        support @ Side::Support(_) => support,
    };
    match (from, place[joint.to]) {
        (from, Side::Block(to)) => Some(Joint {
            from,
            to,
            ..joint.clone()
        }),
        (Side::Block(to), from @ Side::Support(_)) => Some(Joint {
            from,
            to,
            normal: -joint.normal,
            ..joint.clone()
        }),
        (Side::Support(_), Side::Support(_)) => None,
    }
}
