//! How far a joint can slip: no farther than the joints along another way between its two sides let it.
//!
//! Around a closed chain of joints all relative motions add up to zero, so that a slip is
//! Σ c · rate over the other joints of the chain, with c of both signs. Its forward part g⁺ = max(slip, 0)
//! is at most the sum of the terms that add to it:
//!
//! ```text
//! g⁺ ≤ P = Σ over c > 0 of c · rate    where slip = P − Q, P ≥ 0 and Q ≥ 0;
//! g⁻ ≤ Q says the same
//! ```
//!
//! (c · slip of another joint is c g⁺ − c g⁻.) This needs that no slip has both parts, which the products
//! of forces and rates alone do not tell of a joint without pressure: there g⁺ and g⁻ could grow together
//! without limit, and with them what the lift allows.

use std::collections::HashSet;

use super::conditions::{Conditions, Entry, SlipBound, relative};
use super::sum::Sum;
use super::types::LongestWay;
use crate::scene::{Scene, Side};

/// One joint of a way, and whether it leads from its `to` back to its `from`.
type Leg = (usize, bool);

impl Conditions {
    /// The same with bounds of slips along the other ways between the sides of a joint: all those of up to two
    /// joints and, of the `longest`, the first way of three joints of each joint that has none of these. The
    /// bounds along ways of three joints stand last. They make the linear systems of the lift two to three times
    /// as dear; on a wall of 17 blocks those of joints that have shorter ways too gained less than they cost.
    pub(crate) fn with_slip_bounds(mut self, scene: &Scene, longest: LongestWay) -> Self {
        let ways = Ways::of(scene);
        let joints = 0..self.joints.len();
        let of_joint = |joint| ways.short(joint).into_iter().map(move |way| (joint, way));
        let mut chosen: Vec<(usize, Vec<Leg>)> = joints.clone().flat_map(of_joint).collect();
        if longest == LongestWay::ThreeJoints {
            let has_short: HashSet<usize> = chosen.iter().map(|(joint, _)| *joint).collect();
            let without = joints.filter(|joint| !has_short.contains(joint));
            let first = |joint| Some((joint, ways.of_length(joint, 3).into_iter().next()?));
            chosen.extend(without.filter_map(first));
        }
        let bounds = chosen.iter();
        let bounds = bounds.map(|(joint, way)| bound(scene, &self, *joint, way));
        self.slip_bounds = bounds.collect();
        self
    }
}

/// The joints of every body; all supports are one, behind the blocks.
struct Ways {
    bodies: Vec<[usize; 2]>,
    legs: Vec<Vec<(Leg, usize)>>,
}

impl Ways {
    fn of(scene: &Scene) -> Self {
        let ground = scene.blocks().len();
        let bodies = scene.contacts().iter().map(|joint| match joint.from {
            Side::Block(from) => [from, joint.to],
            Side::Support(_) => [ground, joint.to],
        });
        let bodies: Vec<[usize; 2]> = bodies.collect();
        let mut legs = vec![Vec::new(); ground + 1];
        for (joint, &[from, to]) in bodies.iter().enumerate() {
            legs[from].push(((joint, false), to));
            legs[to].push(((joint, true), from));
        }
        Self { bodies, legs }
    }

    /// The ways of up to two joints from a joint's `from` to its `to` without it, in the order of their first
    /// joints.
    fn short(&self, joint: usize) -> Vec<Vec<Leg>> {
        let mut short = [1, 2].map(|length| self.of_length(joint, length)).concat();
        short.sort_by_key(|way| way[0].0);
        short
    }

    /// The ways of so many joints from a joint's `from` to its `to` without it.
    fn of_length(&self, joint: usize, length: usize) -> Vec<Vec<Leg>> {
        let [from, to] = self.bodies[joint];
        // Each with the bodies that it leads through.
        let mut ways: Vec<(Vec<Leg>, Vec<usize>)> = vec![(Vec::new(), vec![from])];
        for step in 1..=length {
            let longer = ways.iter().flat_map(|(way, through)| {
                let at = *through.last().expect("it begins somewhere");
                let next = self.legs[at].iter().filter(move |(leg, body)| {
                    let arrives = *body == to;
                    leg.0 != joint && !through.contains(body) && arrives == (step == length)
                });
                next.map(|&(leg, body)| {
                    (
                        [&way[..], &[leg]].concat(),
                        [&through[..], &[body]].concat(),
                    )
                })
            });
            ways = longer.collect();
        }
        ways.into_iter().map(|(way, _)| way).collect()
    }
}

/// Shares smaller than this are rounding.
const SMALL: f64 = 1e-15;

/// The bound of a joint's slip along a way.
fn bound(scene: &Scene, conditions: &Conditions, joint: usize, way: &[Leg]) -> SlipBound {
    let own = &scene.contacts()[joint];
    let direction = own.tangent();
    let mut shares = Vec::new();
    // What is left of the slip, by velocity.
    let mut left: Vec<(usize, Sum)> = Vec::new();
    let mut add = |row: &[Entry], factor: f64| {
        for &(k, value) in row {
            let at = left.iter().position(|(other, _)| *other == k);
            let at = at.unwrap_or_else(|| {
                left.push((k, Sum::default()));
                left.len() - 1
            });
            left[at].1.add_product(factor, value);
        }
    };
    add(&conditions.joints[joint].rates[2], 1.0);
    for &(other, is_back) in way {
        let sign = if is_back { -1.0 } else { 1.0 };
        for (rate, [x, y, _]) in relative(scene, other, own.ends[0], sign) {
            let share = direction.x * x + direction.y * y;
            if share.abs() <= SMALL {
                continue;
            }
            let kind = rate % 4;
            add(&conditions.joints[other].rates[kind], -share);
            if share > 0.0 {
                shares.push((rate, share));
            } else if kind == 2 {
                shares.push((rate + 1, -share));
            }
        }
    }
    let rounding = left.into_iter().map(|(k, sum)| (k, sum.largest(64.0)));
    SlipBound {
        joint,
        is_long: way.len() > 2,
        shares,
        rounding: rounding.collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{HeadJoints, Wall};

    fn wall(courses: &[&str]) -> Scene {
        let wall = Wall::laid([4.0, 1.75], 0.65, courses);
        wall.scene(HeadJoints::Contact).unwrap()
    }

    /// A unit on two halves: it slips on the one no farther than on the other and what their head joint
    /// opens at its upper end.
    #[test]
    fn a_unit_slips_on_one_half_as_on_the_other() {
        let scene = wall(&["hh", "1"]);
        let conditions = Conditions::of(&scene).with_slip_bounds(&scene, LongestWay::ThreeJoints);
        let is_bed = |joint: &&usize| scene.joints()[**joint].to == 2;
        let all: Vec<usize> = (0..scene.joints().len()).collect();
        let beds: Vec<usize> = all.iter().filter(is_bed).copied().collect();
        let bounds = conditions.slip_bounds;
        let shares = |joint: usize| {
            let mut own = bounds.iter().filter(|bound| bound.joint == joint);
            let found = own.next().expect("there is another way");
            assert!(own.next().is_none());
            found.shares.clone()
        };
        let [one, other] = [shares(beds[0]), shares(beds[1])];
        // One of them slips farther by what the head joint opens.
        let [with, without] = if one.len() > other.len() {
            [one, other]
        } else {
            [other, one]
        };
        assert_eq!((with.len(), without.len()), (2, 1));
        let all = with.iter().chain(&without);
        assert!(all.clone().all(|(_, share)| (share - 1.0).abs() < 1e-12));
        assert_eq!(
            all.filter(|(rate, _)| beds.contains(&(rate / 4))).count(),
            2
        );
    }

    /// What bounds are made of is the slip, to rounding, on walls with openings too. With open head joints the two
    /// closed chains of this wall have four joints each, one of which is common to both.
    #[test]
    fn slips_are_made_of_the_rates_of_other_joints() {
        for (head_joints, short, long) in [(HeadJoints::Contact, 15, 0), (HeadJoints::Open, 0, 7)] {
            let wall = Wall::laid([4.0, 1.75], 0.65, &["h1h", "11", "hgh", "11"]);
            let scene = wall.scene(head_joints).unwrap();
            let count = |longest: LongestWay| {
                let conditions = Conditions::of(&scene).with_slip_bounds(&scene, longest);
                for bound in &conditions.slip_bounds {
                    let rounding = bound.rounding.iter().map(|entry| entry.1);
                    assert!(rounding.fold(0.0, f64::max) < 1e-13, "{bound:?}");
                    assert!(bound.shares.iter().all(|entry| entry.1 > 0.0));
                }
                let bounds = conditions.slip_bounds.iter();
                let is_long: Vec<bool> = bounds.map(|bound| bound.is_long).collect();
                assert!(is_long.is_sorted(), "short ones stand first");
                is_long.iter().fold([0, 0], |[short, long], &is_long| {
                    if is_long {
                        [short, long + 1]
                    } else {
                        [short + 1, long]
                    }
                })
            };
            assert_eq!(count(LongestWay::TwoJoints), [short, 0]);
            assert_eq!(count(LongestWay::ThreeJoints), [short, long]);
        }
    }
}
