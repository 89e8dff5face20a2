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
    let mut joints_of: Vec<Vec<&Joint>> = vec![Vec::new(); scene.blocks().len()];
    for joint in scene.joints() {
        joints_of[joint.to].push(joint);
        if let Side::Block(from) = joint.from {
            joints_of[from].push(joint);
        }
    }
    // All surfaces of blocks in one list: the block and the coefficient.
    let mut of_block: Vec<Vec<usize>> = vec![Vec::new(); scene.blocks().len()];
    let mut list: Vec<f64> = Vec::new();
    for (own, joints) in of_block.iter_mut().zip(&joints_of) {
        let joints = joints.iter().copied();
        if coefficients(joints.clone().filter(|joint| rests(joint))).len() > 1 {
            return Err(PushoverFact::BlockOnTwoFrictions);
        }
        let mut all = coefficients(joints);
        if all.is_empty() {
            all.push(0.0);
        }
        *own = (list.len()..list.len() + all.len()).collect();
        list.extend(all);
    }
    let surface = |block: usize, friction: f64| {
        let own = of_block[block].iter().copied();
        own.clone()
            .find(|&i| list[i] == friction)
            .or(own.clone().next())
    };
    let mut joined = vec![Vec::new(); list.len()];
    let mut meets = vec![0u32; list.len()];
    for joint in scene.joints() {
        let Some(to) = surface(joint.to, joint.friction) else {
            continue;
        };
        match joint.from {
            Side::Block(from) => {
                if let Some(from) = surface(from, joint.friction) {
                    joined[from].push(to);
                    joined[to].push(from);
                }
            }
            Side::Support(_) => meets[to] |= support_group(&on_supports, joint.friction),
        }
    }
    let near = neighbours(scene, reach);
    let near_surfaces: Vec<Vec<usize>> = of_block
        .iter()
        .zip(&near)
        .flat_map(|(own, near)| {
            let others: Vec<usize> = near.iter().flat_map(|&b| of_block[b].clone()).collect();
            own.iter().map(move |_| others.clone())
        })
        .collect();
    let group = colours(&joined, &near_surfaces).ok_or(PushoverFact::Crowded)?;
    for (one, joined) in joined.iter().enumerate() {
        for &other in joined {
            meets[one] |= 1 << group[other];
        }
    }
    let of_block = of_block.iter().map(|own| {
        let surface = |&i: &usize| Surface {
            friction: list[i],
            groups: Groups {
                member: 1 << group[i],
                meets: meets[i],
            },
        };
        own.iter().map(surface).collect()
    });
    let of_support = (0..scene.supports().len()).map(|support| {
        let from = |joint: &&Joint| joint.from == Side::Support(support);
        let own = coefficients(scene.joints().iter().filter(from));
        let surface = |&friction: &f64| Surface {
            friction,
            groups: Groups {
                member: support_group(&on_supports, friction),
                meets: (1 << BLOCKS) - 1,
            },
        };
        own.iter().map(surface).collect()
    });
    Ok(Surfaces {
        blocks: of_block.collect(),
        supports: of_support.collect(),
    })
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
    use crate::scene::{HeadJoints, Piece, Push, Wall};

    /// Coefficients with which two bodies collide, as the engine combines them.
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
