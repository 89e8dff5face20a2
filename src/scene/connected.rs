//! Which blocks hang together, and which of them with a support.

use super::joints::{Joint, Side};

/// Which of so many blocks a chain of joints connects with a support. Whatever force a joint
/// carries, the others have nothing to rest on.
pub(crate) fn connected(blocks: usize, joints: &[Joint]) -> Vec<bool> {
    let mut connected = vec![false; blocks];
    let mut beside = vec![Vec::new(); blocks];
    let mut reached = Vec::new();
    for joint in joints {
        match joint.from {
            Side::Support(_) => reached.push(joint.to),
            Side::Block(from) => {
                beside[from].push(joint.to);
                beside[joint.to].push(from);
            }
        }
    }
    while let Some(block) = reached.pop() {
        if !std::mem::replace(&mut connected[block], true) {
            reached.extend(&beside[block]);
        }
    }
    connected
}

/// For each of so many blocks the first of those that joints connect it with, supports aside.
pub(crate) fn connected_parts(blocks: usize, joints: &[Joint]) -> Vec<usize> {
    let mut part: Vec<usize> = (0..blocks).collect();
    fn root(part: &mut [usize], mut of: usize) -> usize {
        while part[of] != of {
            part[of] = part[part[of]];
            of = part[of];
        }
        of
    }
    for joint in joints {
        if let Side::Block(from) = joint.from {
            let (a, b) = (root(&mut part, from), root(&mut part, joint.to));
            part[a.max(b)] = a.min(b);
        }
    }
    (0..blocks).map(|block| root(&mut part, block)).collect()
}

#[cfg(test)]
mod tests {
    use super::super::joints::{TOUCHING, find_joints};
    use super::super::polygon::Polygon;
    use super::*;

    #[test]
    fn a_chain_may_run_down_as_well_as_up() {
        let square = |x: f64, y: f64| Polygon::rectangle(x, x + 1.0, y, y + 1.0).unwrap();
        // A tower, a block that hangs on its side, and two that touch one another alone.
        let blocks = [
            square(0.0, 0.0),
            square(0.0, 1.0),
            square(1.0, 1.0),
            square(5.0, 1.0),
            square(5.0, 2.0),
        ];
        let shapes: Vec<&Polygon> = blocks.iter().collect();
        let ground = Polygon::rectangle(-9.0, 9.0, -1.0, 0.0).unwrap();
        let joints = find_joints(TOUCHING, &shapes, &[ground]);
        let expected = [true, true, true, false, false];
        assert_eq!(connected(blocks.len(), &joints), expected);
        assert_eq!(connected_parts(blocks.len(), &joints), [0, 0, 0, 3, 3]);
    }
}
