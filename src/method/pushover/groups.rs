//! Only the joints of the scene carry: collision groups that let no other neighbours touch.
//!
//! Open head joints touch but carry nothing, and two blocks that meet at corners alone would start
//! to bear on each other with the smallest slip. A block is in one group and collides with the
//! groups of the blocks it has joints with; neighbours without a joint are in other groups.

use crate::scene::{Point, Scene, Side};

/// The group of all supports.
const SUPPORTS: u32 = 31;

/// Bits that decide what a body collides with: two bodies do where each is a member of a group
/// that the other meets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Groups {
    /// Groups that the body is in.
    pub member: u32,
    /// Groups that it collides with.
    pub meets: u32,
}

impl Groups {
    /// Groups of a support.
    pub const SUPPORT: Self = Self {
        member: 1 << SUPPORTS,
        meets: u32::MAX,
    };
}

/// Groups of every block in the scene's order, or `None` where 31 are too few. Neighbours are
/// blocks that are nearer than `reach`.
pub fn groups(scene: &Scene, reach: f64) -> Option<Vec<Groups>> {
    let count = scene.blocks.len();
    let mut joined = vec![Vec::new(); count];
    let mut meets = vec![0u32; count];
    for joint in &scene.joints {
        match joint.from {
            Side::Block(from) => {
                joined[from].push(joint.to);
                joined[joint.to].push(from);
            }
            Side::Support(_) => meets[joint.to] |= 1 << SUPPORTS,
        }
    }
    let group = colours(&joined, &neighbours(scene, reach))?;
    for (block, joined) in joined.iter().enumerate() {
        for &other in joined {
            meets[block] |= 1 << group[other];
        }
    }
    let groups = group.iter().zip(meets).map(|(&group, meets)| Groups {
        member: 1 << group,
        meets,
    });
    Some(groups.collect())
}

/// For every block the blocks whose bounding boxes are nearer than `reach`.
fn neighbours(scene: &Scene, reach: f64) -> Vec<Vec<usize>> {
    let boxes: Vec<(Point, Point)> = scene.blocks.iter().map(|b| b.shape.bounds()).collect();
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

/// A number below [`SUPPORTS`] for every block, such that no neighbour without a joint has the
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
        if free >= SUPPORTS {
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

    fn collide(a: Groups, b: Groups) -> bool {
        a.member & b.meets != 0 && b.member & a.meets != 0
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
        let groups = groups(&scene, 0.2).unwrap();
        for (a, near) in neighbours(&scene, 0.2).iter().enumerate() {
            for &b in near {
                let pair = |j: &crate::scene::Joint| {
                    (j.from, j.to) == (Side::Block(a), b) || (j.from, j.to) == (Side::Block(b), a)
                };
                assert_eq!(collide(groups[a], groups[b]), scene.joints.iter().any(pair));
            }
            let rests = |j: &crate::scene::Joint| (j.from, j.to) == (Side::Support(0), a);
            assert_eq!(
                collide(groups[a], Groups::SUPPORT),
                scene.joints.iter().any(rests)
            );
        }
    }
}
