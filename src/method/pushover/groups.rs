//! Only the joints of the scene carry, each with its own friction: collision groups that let
//! nothing else touch.
//!
//! Open head joints touch but carry nothing, and two blocks that meet at corners alone would start
//! to bear on each other with the smallest slip. A block is in one group and collides with the
//! groups of the blocks it has joints with; neighbours without a joint are in other groups.

use crate::answer::PushoverFact;
use crate::scene::{Joint, Point, Scene, Side};

/// The highest group: of what supports show to joints of the first coefficient.
const SUPPORTS: u32 = 31;

/// Coefficients of friction that joints with supports may have.
const SUPPORT_COEFFICIENTS: u32 = 4;

/// Groups for blocks: the rest.
const BLOCKS: u32 = SUPPORTS + 1 - SUPPORT_COEFFICIENTS;

/// Bits that decide what collides: two surfaces do where each is a member of a group that the other
/// meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Groups {
    /// Groups that the surface is in.
    pub member: u32,
    /// Groups that it collides with.
    pub meets: u32,
}

/// One collider per friction coefficient of a body's joints: rapier stores friction per collider,
/// scenes per joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Coefficient of friction.
    pub friction: f64,
    /// What it collides with.
    pub groups: Groups,
}

/// The surfaces of every body.
#[derive(Clone, Debug)]
pub struct Surfaces {
    /// Of every block, in the scene's order.
    pub blocks: Vec<Vec<Surface>>,
    /// Of every support, in the scene's order.
    pub supports: Vec<Vec<Surface>>,
}

/// Surfaces of every body, or why there are none. Neighbours are blocks that are nearer than
/// `reach`.
///
/// # Errors
/// Collision groups cannot tell the joints from other neighbours.
pub fn surfaces(scene: &Scene, reach: f64) -> Result<Surfaces, PushoverFact> {
    let on_supports = coefficients(scene.joints().iter().filter(|joint| rests(joint)));
    if on_supports.len() > SUPPORT_COEFFICIENTS as usize {
        return Err(PushoverFact::SupportFrictions {
            found: on_supports.len(),
            most: SUPPORT_COEFFICIENTS as usize,
        });
    }
    let list = List::new(scene)?;
    let joined = list.joined(scene);
    let near = list.near(&neighbours(scene, reach));
    let group = colours(&joined, &near).ok_or(PushoverFact::Crowded)?;
    let mut meets = list.meet_supports(scene, &on_supports);
    for (one, joined) in joined.iter().enumerate() {
        for &other in joined {
            meets[one] |= 1 << group[other];
        }
    }
    let surface = |&i: &usize| Surface {
        friction: list.friction[i],
        groups: Groups {
            member: 1 << group[i],
            meets: meets[i],
        },
    };
    let blocks = list.of_block.iter();
    Ok(Surfaces {
        blocks: blocks
            .map(|own| own.iter().map(surface).collect())
            .collect(),
        supports: support_surfaces(scene, &on_supports),
    })
}

/// Surfaces of every support, which all blocks may touch.
fn support_surfaces(scene: &Scene, on_supports: &[f64]) -> Vec<Vec<Surface>> {
    let of_support = (0..scene.supports().len()).map(|support| {
        let from = |joint: &&Joint| joint.from == Side::Support(support);
        let own = coefficients(scene.joints().iter().filter(from));
        let surface = |&friction: &f64| Surface {
            friction,
            groups: Groups {
                member: support_group(on_supports, friction),
                meets: (1 << BLOCKS) - 1,
            },
        };
        own.iter().map(surface).collect()
    });
    of_support.collect()
}

/// The surfaces of all blocks in one list: one for every coefficient of friction of a block's
/// joints, and one for a block without joints.
struct List {
    /// Coefficient of every surface.
    friction: Vec<f64>,
    /// Surfaces of every block.
    of_block: Vec<Vec<usize>>,
}

impl List {
    fn new(scene: &Scene) -> Result<Self, PushoverFact> {
        let mut joints_of: Vec<Vec<&Joint>> = vec![Vec::new(); scene.blocks().len()];
        for joint in scene.joints() {
            joints_of[joint.to].push(joint);
            if let Side::Block(from) = joint.from {
                joints_of[from].push(joint);
            }
        }
        let (mut friction, mut of_block) = (Vec::new(), Vec::new());
        for joints in &joints_of {
            let joints = joints.iter().copied();
            if coefficients(joints.clone().filter(|joint| rests(joint))).len() > 1 {
                return Err(PushoverFact::BlockOnTwoFrictions);
            }
            let mut all = coefficients(joints);
            if all.is_empty() {
                all.push(0.0);
            }
            of_block.push((friction.len()..friction.len() + all.len()).collect());
            friction.extend(all);
        }
        Ok(Self { friction, of_block })
    }

    /// The surface of a block with the friction of one of its joints.
    fn surface(&self, block: usize, joint: &Joint) -> usize {
        let own = &self.of_block[block];
        let same = own.iter().find(|&&i| self.friction[i] == joint.friction);
        *same.unwrap_or(&own[0])
    }

    /// For every surface those of other blocks that it has joints with.
    fn joined(&self, scene: &Scene) -> Vec<Vec<usize>> {
        let mut joined = vec![Vec::new(); self.friction.len()];
        for joint in scene.joints() {
            if let Side::Block(from) = joint.from {
                let (from, to) = (self.surface(from, joint), self.surface(joint.to, joint));
                joined[from].push(to);
                joined[to].push(from);
            }
        }
        joined
    }

    /// For every surface the groups of supports that it collides with.
    fn meet_supports(&self, scene: &Scene, on_supports: &[f64]) -> Vec<u32> {
        let mut meets = vec![0; self.friction.len()];
        for joint in scene.joints().iter().filter(|joint| rests(joint)) {
            let group = support_group(on_supports, joint.friction);
            meets[self.surface(joint.to, joint)] |= group;
        }
        meets
    }

    /// For every surface those of neighbouring blocks.
    fn near(&self, neighbours: &[Vec<usize>]) -> Vec<Vec<usize>> {
        let of_blocks = self.of_block.iter().zip(neighbours);
        let near = of_blocks.flat_map(|(own, near)| {
            let others = near.iter().flat_map(|&block| self.of_block[block].clone());
            let others: Vec<usize> = others.collect();
            own.iter().map(move |_| others.clone())
        });
        near.collect()
    }
}

fn rests(joint: &Joint) -> bool {
    matches!(joint.from, Side::Support(_))
}

/// Different coefficients of friction, in the order of the joints.
fn coefficients<'a>(joints: impl Iterator<Item = &'a Joint>) -> Vec<f64> {
    let mut all = Vec::new();
    for joint in joints {
        if !all.contains(&joint.friction) {
            all.push(joint.friction);
        }
    }
    all
}

fn support_group(coefficients: &[f64], friction: f64) -> u32 {
    let place = coefficients.iter().position(|&known| known == friction);
    place.map_or(0, |place| 1 << (SUPPORTS - place as u32))
}

/// For every block the blocks whose bounding boxes are nearer than `reach`.
fn neighbours(scene: &Scene, reach: f64) -> Vec<Vec<usize>> {
    let boxes: Vec<(Point, Point)> = scene.blocks().iter().map(|b| b.shape.bounds()).collect();
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    order.sort_by(|&a, &b| boxes[a].0.y.total_cmp(&boxes[b].0.y));
    let mut near = vec![Vec::new(); boxes.len()];
    for (k, &a) in order.iter().enumerate() {
        let (low, high) = boxes[a];
        let above = order[k + 1..]
            .iter()
            .take_while(|&&b| boxes[b].0.y < high.y + reach);
        for &b in above {
            if boxes[b].0.x < high.x + reach && low.x < boxes[b].1.x + reach {
                near[a].push(b);
                near[b].push(a);
            }
        }
    }
    near
}

/// A number below [`BLOCKS`] for every surface, such that no neighbour without a joint has the
/// number of one with a joint.
fn colours(joined: &[Vec<usize>], near: &[Vec<usize>]) -> Option<Vec<u32>> {
    let mut apart = vec![Vec::new(); joined.len()];
    for (joined, near) in joined.iter().zip(near) {
        for &other in near.iter().filter(|other| !joined.contains(other)) {
            for &one in joined {
                apart[one].push(other);
                apart[other].push(one);
            }
        }
    }
    let mut colour: Vec<u32> = Vec::with_capacity(joined.len());
    for apart in &apart {
        let taken = apart.iter().filter_map(|&other| colour.get(other));
        let taken = taken.fold(0u32, |taken, &colour| taken | 1 << colour);
        let free = taken.trailing_ones();
        if free >= BLOCKS {
            return None;
        }
        colour.push(free);
    }
    Some(colour)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{HeadJoints, OfBlocks, Piece, Push, Wall};

    /// Coefficients with which two bodies collide, as rapier combines them.
    fn meeting(one: &[Surface], other: &[Surface]) -> Vec<f64> {
        let collide = |a: Groups, b: Groups| a.member & b.meets != 0 && b.member & a.meets != 0;
        let pairs = one.iter().flat_map(|a| other.iter().map(move |b| (a, b)));
        let met = pairs.filter(|(a, b)| collide(a.groups, b.groups));
        met.map(|(a, b)| a.friction.min(b.friction)).collect()
    }

    #[test]
    fn exactly_the_joined_neighbours_collide() {
        use Piece::{Half, Unit};
        let wall = Wall {
            unit_length: 4.0,
            unit_height: 1.75,
            thickness: 1.0,
            unit_weight: 1.0,
            courses: (0..8)
                .map(|course| match course % 2 {
                    0 => vec![Half, Unit, Half, Half, Half],
                    _ => vec![Unit, Unit, Half, Half],
                })
                .collect(),
            friction: 0.65.into(),
            overburden: 0.0,
            push: Push::Right,
            of_blocks: OfBlocks::default(),
        };
        let scene = wall.scene(HeadJoints::Open).unwrap();
        let uneven = scene.clone().with_friction(|i, _| [0.5, 0.7][(i / 3) % 2]);
        for scene in [scene, uneven] {
            let surfaces = surfaces(&scene, 0.2).unwrap();
            for (a, near) in neighbours(&scene, 0.2).iter().enumerate() {
                for &b in near {
                    let ends = [(Side::Block(a), b), (Side::Block(b), a)];
                    let joint = scene
                        .joints()
                        .iter()
                        .find(|j| ends.contains(&(j.from, j.to)));
                    let met = meeting(&surfaces.blocks[a], &surfaces.blocks[b]);
                    assert_eq!(
                        met,
                        joint.map(|j| j.friction).into_iter().collect::<Vec<_>>()
                    );
                }
                let joint = scene.joints().iter();
                let joint = joint.filter(|j| (j.from, j.to) == (Side::Support(0), a));
                let met = meeting(&surfaces.supports[0], &surfaces.blocks[a]);
                assert_eq!(met, joint.map(|j| j.friction).collect::<Vec<_>>());
            }
        }
    }
}
