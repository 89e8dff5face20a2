//! Supports that move: each becomes a block without weight between frictionless guides, so that it
//! has one degree of freedom, and its reaction against the motion is the live load. Whoever solves or
//! judges a scene needs no further rule for it.

use super::block::{Block, Load};
use super::joints::{Joint, JointClass, Side};
use super::model::Scene;
use super::polygon::{Point, Polygon, Vector};
use super::reaction::{Reaction, Sense};

/// A motion of one support or of several as one, to the first order.
#[derive(Clone, Debug, PartialEq)]
pub struct SupportMotion {
    /// The supports; the first one's reaction stands for that of all.
    pub supports: Vec<MovingSupport>,
    /// The point that all of them turn about; `None` where they do not turn.
    pub about: Option<Point>,
    /// Whether they move away from the wall, so that the reaction falls, or against it.
    pub sense: Sense,
    /// Multiplier of the live load that acts all the while.
    pub pushed: f64,
}

/// A support that moves.
#[derive(Clone, Debug, PartialEq)]
pub struct MovingSupport {
    /// Its name in the case.
    pub name: String,
    /// Its outline.
    pub shape: Polygon,
    /// The support of the scene that it is, or a part of.
    pub support: usize,
    /// The blocks on that part; `None` where all of it moves.
    pub blocks: Option<Vec<usize>>,
    /// Velocity of its centroid away from the wall; of length 1 for the first support.
    pub away: Vector,
}

impl Scene {
    /// The scene with these supports free to move. λ is the reaction where they move against the wall,
    /// and the reaction with its sign turned where they move away.
    pub(crate) fn with_motion(self, motion: &SupportMotion) -> Self {
        let reaction = Reaction {
            support: motion.supports[0].name.clone(),
            start: 0.0,
            limited: false,
            range: 0.0,
            sense: motion.sense,
            weight: self.total_weight(),
        };
        let mut scene = self.without_wall().with_loads(|load, _| {
            load.dead += load.live * motion.pushed;
            load.live = Vector::zeros();
        });
        let first = scene.blocks.len();
        for (place, support) in motion.supports.iter().enumerate() {
            let index = first + place;
            let ground = Side::Support(support.support);
            let blocks = support.blocks.as_ref();
            let is_on_it = |to: &usize| blocks.is_none_or(|blocks| blocks.contains(to));
            for joint in &mut scene.joints {
                if joint.from == ground && is_on_it(&joint.to) {
                    joint.from = Side::Block(index);
                }
            }
            let guides = motion.guides(support);
            let links = (place > 0).then(|| motion.link(support)).into_iter();
            let guides = guides.into_iter().map(|guide| (ground, guide));
            let links = links
                .flat_map(both_ways)
                .map(|link| (Side::Block(first), link));
            scene
                .joints
                .extend(guides.chain(links).map(|(from, (ends, normal))| Joint {
                    from,
                    to: index,
                    ends,
                    normal,
                    friction: 0.0,
                    class: JointClass::Guide,
                }));
            // Each has its share, so that none is without a load that its forces are measured by.
            let share = -reaction.sign() / motion.supports.len() as f64;
            let live = support.away * (share / support.away.norm_squared());
            scene.blocks.push(Block {
                shape: support.shape.clone(),
                loads: vec![Load {
                    point: support.shape.centroid(),
                    dead: Vector::zeros(),
                    live,
                }],
            });
            if !scene.labels.blocks.is_empty() {
                scene.labels.blocks.push(support.name.clone());
            }
        }
        scene.reaction = Some(reaction);
        scene
    }

    /// The same scene where λ = 0 stands for this reaction, and λ can be this large, roughly. `limited`
    /// says whether no state at rest has one further out.
    pub(crate) fn with_start(mut self, start: f64, range: f64, limited: bool) -> Self {
        let Some(reaction) = &mut self.reaction else {
            return self;
        };
        (reaction.start, reaction.range, reaction.limited) = (start, range, limited);
        let from_wall = reaction.sign() * start;
        self.with_loads(|load, _| {
            // Nothing else is live.
            if load.live != Vector::zeros() {
                load.dead = load.live * from_wall;
            }
        })
    }

    /// Whether a block is a support that moves.
    pub(crate) fn is_moving_support(&self, block: usize) -> bool {
        let mut joints = self.joints.iter();
        self.reaction.is_some()
            && joints.any(|joint| joint.class == JointClass::Guide && joint.to == block)
    }

    /// How fast each support moves, where the first one's middle has a speed of 1 away from the wall: x, y
    /// and rotation. They are the last blocks; empty where none moves.
    pub(crate) fn support_motion(&self) -> Vec<[f64; 3]> {
        let Some(reaction) = &self.reaction else {
            return Vec::new();
        };
        let moving = (0..self.blocks.len()).filter(|&block| self.is_moving_support(block));
        let moving: Vec<usize> = moving.collect();
        let share = -reaction.sign() / moving.len() as f64;
        let of = |block: usize| {
            let own = &self.blocks[block];
            let live = own.loads.iter().map(|load| load.live).sum::<Vector>();
            let away = live * (share / live.norm_squared());
            let turns = self.pin(block).map_or(0.0, |pin| {
                let arm = own.shape.centroid() - pin;
                arm.perp(&away) / arm.norm_squared()
            });
            [away.x, away.y, turns]
        };
        moving.into_iter().map(of).collect()
    }

    /// The joints between bodies that touch: those that guide supports come behind them.
    pub(crate) fn contacts(&self) -> &[Joint] {
        let mut joints = self.joints.iter();
        let guides = joints.position(|joint| joint.class == JointClass::Guide);
        &self.joints[..guides.unwrap_or(self.joints.len())]
    }

    /// The point that a support turns about; `None` for other blocks and supports that do not turn.
    pub(crate) fn pin(&self, block: usize) -> Option<Point> {
        let is_pin = |joint: &&Joint| {
            joint.class == JointClass::Guide && joint.to == block && joint.length() == 0.0
        };
        self.joints.iter().find(is_pin).map(|joint| joint.ends[0])
    }

    /// What stands still of every support, and which one that is: all of it, or the ground beside the parts
    /// that move.
    pub(crate) fn still_supports(&self) -> Vec<(usize, Polygon)> {
        let still = |(index, support): (usize, &Polygon)| {
            let guides = self.joints.iter().filter(|joint| {
                joint.class == JointClass::Guide && joint.from == Side::Support(index)
            });
            let mut moving: Vec<usize> = guides.map(|joint| joint.to).collect();
            moving.dedup();
            let parts = match moving.is_empty() {
                true => vec![support.clone()],
                false => beside(support, moving.iter().map(|&to| &self.blocks[to].shape)),
            };
            parts.into_iter().map(move |part| (index, part))
        };
        self.supports.iter().enumerate().flat_map(still).collect()
    }

    /// What λ says of a support that moves; `None` where none does.
    pub(crate) fn reaction(&self) -> Option<&Reaction> {
        self.reaction.as_ref()
    }
}

/// What is left of the ground beside parts of it that move, from the left; nothing where all of it does.
pub(crate) fn beside<'a>(
    ground: &Polygon,
    parts: impl Iterator<Item = &'a Polygon>,
) -> Vec<Polygon> {
    let (low, high) = ground.bounds();
    let mut spans: Vec<[f64; 2]> = parts
        .map(|part| part.bounds())
        .map(|(left, right)| [left.x, right.x])
        .collect();
    spans.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let lefts = std::iter::once(low.x).chain(spans.iter().map(|span| span[1]));
    let rights = spans
        .iter()
        .map(|span| span[0])
        .chain(std::iter::once(high.x));
    lefts
        .zip(rights)
        .filter_map(|(left, right)| Polygon::rectangle(left, right, low.y, high.y).ok())
        .collect()
}

/// Ends and normal of a joint that guides a support.
type Guide = ([Point; 2], Vector);

fn both_ways((ends, normal): Guide) -> [Guide; 2] {
    [(ends, normal), ([ends[1], ends[0]], -normal)]
}

impl MovingSupport {
    /// Distance of its farthest corner from its centroid.
    fn reach(&self) -> f64 {
        let centre = self.shape.centroid();
        let corners = self.shape.corners().iter();
        corners.fold(0.0, |reach: f64, corner| {
            reach.max((corner - centre).norm())
        })
    }
}

impl SupportMotion {
    /// What leaves a support its motion alone: two rails along it, or a pin that it turns about.
    fn guides(&self, support: &MovingSupport) -> Vec<Guide> {
        if let Some(about) = self.about {
            let pin = |normal| both_ways(([about; 2], normal));
            return [Vector::x(), Vector::y()].map(pin).concat();
        }
        let along = support.away.normalize();
        let across = Vector::new(-along.y, along.x);
        let centre = support.shape.centroid();
        let reach = support.reach();
        let rail = |across: Vector| {
            // As in every joint, the normal is the direction of the ends turned clockwise.
            let along = Vector::new(-across.y, across.x) * reach;
            let middle = centre - across * reach;
            ([middle - along, middle + along], across)
        };
        vec![rail(across), rail(-across)]
    }

    /// What makes a further support move with the first: along this normal both have one velocity.
    fn link(&self, support: &MovingSupport) -> Guide {
        let at = support.shape.centroid();
        let difference = support.away - self.first_at(at);
        let normal = match difference.norm() > SAME * support.away.norm() {
            true => Vector::new(-difference.y, difference.x),
            false => support.away,
        };
        let normal = normal.normalize();
        let along = Vector::new(-normal.y, normal.x) * support.reach();
        ([at - along, at + along], normal)
    }

    /// Velocity of the first support's motion at a point.
    pub(crate) fn first_at(&self, at: Point) -> Vector {
        let first = &self.supports[0];
        let Some(about) = self.about else {
            return first.away;
        };
        let turned = |arm: Vector| Vector::new(-arm.y, arm.x);
        let own = turned(first.shape.centroid() - about);
        turned(at - about) * (first.away.dot(&own) / own.norm_squared())
    }

    /// Whether the further supports can be made to move with the first: those that move along the same
    /// line do so at one rate.
    pub fn is_one(&self) -> bool {
        self.supports.iter().skip(1).all(|support| {
            let (_, normal) = self.link(support);
            let speed = support.away.norm();
            normal.dot(&support.away).abs() > SAME * speed && speed > 0.0
        })
    }
}

/// Velocities that differ by less than this part are one.
const SAME: f64 = 1e-6;
