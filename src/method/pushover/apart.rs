//! Which faces may meet: collision groups that differ wherever joints lie close together.
//!
//! A pair of faces has one group of the lower half and one of the upper half: the first face is in the
//! one and meets the other, the second the other way round. So 16 × 16 pairs can be told apart, and
//! joints that are far from each other share them.

use crate::answer::PushoverFact;
use crate::scene::Point;

/// Groups in each half of rapier's 32 bits.
const HALF: usize = 16;

/// Bits that decide what collides: two faces do where each is a member of a group that the other
/// meets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Groups {
    /// The group that the face is in.
    pub member: u32,
    /// The group that it collides with.
    pub meets: u32,
}

impl Groups {
    /// Of both faces of a pair with this number.
    fn of_pair(number: usize) -> [Self; 2] {
        let (one, other) = (1 << (number % HALF), 1 << (HALF + number / HALF));
        let groups = |member, meets| Self { member, meets };
        [groups(one, other), groups(other, one)]
    }
}

/// The groups of both faces of every joint, from the boxes about them: others than those of any joint
/// whose box is nearer than `reach`.
///
/// # Errors
/// More joints lie close together than there are groups for.
pub fn groups(boxes: &[(Point, Point)], reach: f64) -> Result<Vec<[Groups; 2]>, PushoverFact> {
    let mut numbers: Vec<usize> = Vec::with_capacity(boxes.len());
    for near in near(boxes, reach) {
        let mut taken = [false; HALF * HALF];
        for other in near {
            taken[numbers[other]] = true;
        }
        let free = taken.iter().position(|taken| !taken);
        numbers.push(free.ok_or(PushoverFact::Crowded { most: taken.len() })?);
    }
    Ok(numbers.into_iter().map(Groups::of_pair).collect())
}

/// For every box those before it that are nearer than `reach`.
fn near(boxes: &[(Point, Point)], reach: f64) -> Vec<Vec<usize>> {
    let mut order: Vec<usize> = (0..boxes.len()).collect();
    order.sort_by(|&a, &b| boxes[a].0.y.total_cmp(&boxes[b].0.y));
    let mut near = vec![Vec::new(); boxes.len()];
    for (k, &a) in order.iter().enumerate() {
        let (low, high) = boxes[a];
        let above = order[k + 1..].iter();
        for &b in above.take_while(|&&b| boxes[b].0.y < high.y + reach) {
            if boxes[b].0.x < high.x + reach && low.x < boxes[b].1.x + reach {
                near[a.max(b)].push(a.min(b));
            }
        }
    }
    near
}

#[cfg(test)]
mod tests {
    use super::*;

    fn collide(a: Groups, b: Groups) -> bool {
        a.member & b.meets != 0 && b.member & a.meets != 0
    }

    fn square(x: f64, y: f64) -> (Point, Point) {
        (Point::new(x, y), Point::new(x + 1.0, y + 1.0))
    }

    /// A grid of boxes that touch, and of all faces that lie close together only both of one joint meet.
    #[test]
    fn only_both_faces_of_a_joint_meet() {
        let boxes: Vec<_> = (0..100)
            .map(|i| square(f64::from(i % 10), f64::from(i / 10)))
            .collect();
        let groups = groups(&boxes, 0.5).unwrap();
        for (a, near) in near(&boxes, 0.5).iter().enumerate() {
            assert!(collide(groups[a][0], groups[a][1]) && collide(groups[a][1], groups[a][0]));
            for &b in near {
                let others = groups[b];
                let meets = |one: &Groups| others.iter().any(|other| collide(*one, *other));
                assert!(!groups[a].iter().any(meets));
            }
        }
    }

    #[test]
    fn more_joints_in_one_place_than_groups_are_refused() {
        let boxes = vec![square(0.0, 0.0); 257];
        assert!(groups(&boxes[..256], 1.0).is_ok());
        assert!(matches!(
            groups(&boxes, 1.0),
            Err(PushoverFact::Crowded { most: 256 })
        ));
    }
}
