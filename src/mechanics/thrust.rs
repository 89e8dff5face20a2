//! Where forces run: lines of thrust through arches and piers, resultants on the courses of walls.

use super::state::JointForce;
use crate::scene::{Joint, JointClass, Point, Scene, Side, Vector};

/// A force and where its line crosses a stretch of bed joints without a gap: the width of a wall, or a
/// pier beside an opening.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CourseResultant {
    /// Height of the bed joints.
    pub level: f64,
    /// From where to where they reach.
    pub ends: [f64; 2],
    /// Force on what is above, from what is below.
    pub force: Vector,
    /// Where it acts; `None` where nothing presses.
    pub x: Option<f64>,
}

/// The way of the forces of one state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Thrust {
    /// Lines of thrust: each through the centres of pressure of joints, one block after the other, as
    /// far as every block has two neighbours that press on it.
    pub lines: Vec<Vec<Point>>,
    /// Resultants on the stretches of level bed joints, from the lowest, of each level from the left.
    pub courses: Vec<CourseResultant>,
}

/// Part of the largest normal force below which nothing presses.
const NOTHING: f64 = 1e-9;

/// Levels nearer than this part of the height are one.
const SAME_LEVEL: f64 = 1e-6;

/// Part of the height below which a gap between bed joints parts no piers: a joint that was left open.
const GAP: f64 = 0.01;

/// The part of a line's blocks that lie on one: shorter ones say nothing.
const SHORTEST: usize = 3;

/// Normal forces at the ends of the joints between two bodies together, and where they act.
struct Between {
    sides: (Side, Side),
    pressed: f64,
    at: Vector,
}

/// The way of forces through a scene, of which there is one a joint.
pub fn thrust(scene: &Scene, forces: &[JointForce]) -> Thrust {
    Thrust {
        lines: lines(scene, forces),
        courses: courses(scene, forces),
    }
}

fn pressed(force: &JointForce) -> f64 {
    force.normal[0] + force.normal[1]
}

/// Where the force of a joint acts, times its normal force.
fn moment(joint: &Joint, force: &JointForce) -> Vector {
    joint.ends[0].coords * force.normal[0] + joint.ends[1].coords * force.normal[1]
}

fn lines(scene: &Scene, forces: &[JointForce]) -> Vec<Vec<Point>> {
    let largest = forces.iter().map(pressed).fold(0.0, f64::max);
    let mut pairs: Vec<Between> = Vec::new();
    let mut of_block: Vec<Vec<usize>> = vec![Vec::new(); scene.blocks().len()];
    for (joint, force) in scene.joints().iter().zip(forces) {
        if pressed(force) <= NOTHING * largest || joint.class == JointClass::Guide {
            continue;
        }
        let sides = (joint.from, Side::Block(joint.to));
        // Joints of the same two bodies stand one after the other.
        match pairs.last_mut().filter(|pair| pair.sides == sides) {
            Some(pair) => {
                pair.pressed += pressed(force);
                pair.at += moment(joint, force);
            }
            None => {
                if let Side::Block(from) = joint.from {
                    of_block[from].push(pairs.len());
                }
                of_block[joint.to].push(pairs.len());
                pairs.push(Between {
                    sides,
                    pressed: pressed(force),
                    at: moment(joint, force),
                });
            }
        }
    }
    let mut used = vec![false; pairs.len()];
    let mut lines = Vec::new();
    // From a support or a block that is no link, through the links behind it.
    for start in 0..pairs.len() {
        let ends = [pairs[start].sides.0, pairs[start].sides.1];
        let is_link = |side: Side| matches!(side, Side::Block(block) if of_block[block].len() == 2);
        let begins = ends.iter().filter(|side| !is_link(**side)).count();
        if used[start] || begins == 0 {
            continue;
        }
        let mut line = vec![start];
        used[start] = true;
        let mut side = if is_link(ends[0]) { ends[0] } else { ends[1] };
        while let Side::Block(block) = side {
            let [one, other] = of_block[block][..] else {
                break;
            };
            let last = line[line.len() - 1];
            let next = if one == last { other } else { one };
            if used[next] {
                break;
            }
            used[next] = true;
            line.push(next);
            let (from, to) = pairs[next].sides;
            side = if from == side { to } else { from };
        }
        let centre = |&pair: &usize| Point::from(pairs[pair].at / pairs[pair].pressed);
        if line.len() >= SHORTEST {
            lines.push(line.iter().map(centre).collect());
        }
    }
    lines
}

/// Level joints without a gap between them.
struct Stretch {
    level: f64,
    ends: [f64; 2],
    joints: Vec<usize>,
}

/// Resultants on joints that are level, of blocks on supports or on each other, for each stretch of them
/// without a gap.
fn courses(scene: &Scene, forces: &[JointForce]) -> Vec<CourseResultant> {
    let near = SAME_LEVEL * scene.height();
    let mut level: Vec<(f64, usize)> = Vec::new();
    for (index, joint) in scene.joints().iter().enumerate() {
        let bears = !matches!(joint.class, JointClass::Head | JointClass::Guide);
        let is_level = joint.normal.x.abs() < 1e-9 && bears;
        if is_level {
            level.push((joint.ends[0].y, index));
        }
    }
    level.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let ends = |index: usize| {
        let [one, other] = scene.joints()[index].ends.map(|end| end.x);
        [one.min(other), one.max(other)]
    };
    let mut stretches: Vec<Stretch> = Vec::new();
    for of_level in level.chunk_by(|a, b| b.0 - a.0 <= near) {
        let level = of_level[0].0;
        let joints = of_level.iter().map(|&(_, index)| (ends(index), index));
        let mut joints: Vec<_> = joints.collect();
        joints.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]));
        let first = stretches.len();
        for (ends, joint) in joints {
            match stretches[first..].last_mut() {
                Some(last) if ends[0] - last.ends[1] <= GAP * scene.height() => {
                    last.ends[1] = last.ends[1].max(ends[1]);
                    last.joints.push(joint);
                }
                _ => stretches.push(Stretch {
                    level,
                    ends,
                    joints: vec![joint],
                }),
            }
        }
    }
    let resultant = |of: Stretch| {
        let (mut force, mut normal, mut turned) = (Vector::zeros(), 0.0, 0.0);
        for index in of.joints {
            let (joint, own) = (&scene.joints()[index], &forces[index]);
            // The joint's force acts on the block that its normal points into; turn it on what is above.
            let up = joint.normal.y.signum();
            force += (joint.normal * pressed(own) + joint.tangent() * own.shear) * up;
            normal += pressed(own);
            turned += moment(joint, own).x;
        }
        CourseResultant {
            level: of.level,
            ends: of.ends,
            force,
            x: (normal > 0.0).then(|| turned / normal),
        }
    };
    stretches.into_iter().map(resultant).collect()
}
