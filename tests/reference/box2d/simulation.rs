//! The scene in Box2D: bodies, contacts where the scene has joints, loads, and time.

use std::cell::RefCell;
use std::collections::BTreeMap;

use box2d_rust::body::{
    body_apply_force_to_center, body_apply_mass_from_shapes, body_apply_torque, body_get_position,
    body_get_rotation, body_set_angular_velocity, body_set_linear_velocity, create_body,
};
use box2d_rust::geometry::make_polygon;
use box2d_rust::hull::compute_hull;
use box2d_rust::math_functions::to_pos;
use box2d_rust::recording::{world_restore, world_snapshot};
use box2d_rust::shape::create_polygon_shape;
use box2d_rust::types::{BodyType, default_body_def, default_shape_def, default_world_def};
use box2d_rust::world::{World, world_set_custom_filter_callback, world_step};
use box2d_rust::{BodyId, ShapeId, Vec2};

use super::pieces;
use super::scene::{Pair, Scene, median_size, sizes};

/// Gravity of the simulation in m/s².
pub const GRAVITY: f64 = 10.0;

/// How Box2D is run.
#[derive(Clone, Copy)]
pub struct Setting {
    /// Steps a second.
    pub rate: f64,
    /// Substeps a step.
    pub substeps: i32,
    /// Stiffness of contacts in Hz; Box2D takes no more than an eighth of the substeps a second.
    pub hertz: f64,
    /// Size of the median block in the simulation, in metres.
    pub size: f64,
}

thread_local! {
    /// Friction of the pairs of pieces that share a joint. Box2D asks plain functions.
    static FRICTION: RefCell<BTreeMap<(u64, u64), f32>> = const { RefCell::new(BTreeMap::new()) };
}

fn friction(a: u64, b: u64) -> Option<f32> {
    FRICTION.with_borrow(|table| table.get(&(a.min(b), a.max(b))).copied())
}

fn mixed(_: f32, a: u64, _: f32, b: u64) -> f32 {
    friction(a, b).unwrap_or(0.0)
}

/// Pieces are made in order, and a shape's index begins at 1.
fn touches(a: ShapeId, b: ShapeId, _context: u64) -> bool {
    friction(a.index1 as u64 - 1, b.index1 as u64 - 1).is_some()
}

/// A force at a point of a body, that keeps its direction.
struct Force {
    body: usize,
    arm: Pair,
    dead: Pair,
    live: Pair,
}

pub struct Simulation {
    world: World,
    bodies: Vec<BodyId>,
    /// Distance of the farthest corner of each body from its centroid.
    reach: Vec<f64>,
    forces: Vec<Force>,
    setting: Setting,
}

/// Positions and rotations of the bodies.
pub type Places = Vec<[f64; 3]>;

impl Simulation {
    /// # Errors
    /// What of the scene Box2D cannot take, in words.
    pub fn new(scene: &Scene, setting: Setting) -> Result<Self, String> {
        if scene.joints.iter().any(|joint| joint.class == "guide") {
            return Err("supports that move are not simulated".to_owned());
        }
        let scale = setting.size / median_size(scene);
        let mut definition = default_world_def();
        definition.gravity = Vec2 { x: 0.0, y: 0.0 };
        definition.enable_sleep = false;
        definition.enable_continuous = false;
        definition.contact_hertz = setting.hertz as f32;
        definition.friction_callback = Some(mixed);
        let mut world = World::new(&definition);
        world_set_custom_filter_callback(&mut world, Some(touches), 0);
        let (weight, _) = sizes(scene);
        let mean = weight / scene.blocks.len() as f64;
        let mut laid = Laid::default();
        for support in &scene.supports {
            laid.body(&mut world, &support.corners, [0.0, 0.0], scale, None)?;
        }
        let mut bodies = Vec::new();
        let mut forces = Vec::new();
        for (body, block) in scene.blocks.iter().enumerate() {
            let carried: f64 = block.loads.iter().map(|l| l.dead[0].hypot(l.dead[1])).sum();
            // Mass decides nothing at rest; a stone without weight needs some to be simulated.
            let mass = (carried / mean).max(0.01);
            bodies.push(laid.body(
                &mut world,
                &block.corners,
                block.centroid,
                scale,
                Some(mass),
            )?);
            forces.extend(block.loads.iter().map(|load| Force {
                body,
                arm: [0, 1].map(|k| (load.point[k] - block.centroid[k]) * scale),
                dead: load.dead.map(|part| part / mean * GRAVITY),
                live: load.live.map(|part| part / mean * GRAVITY),
            }));
        }
        laid.contacts(scene, 1e-6 * median_size(scene))?;
        let reach = (scene.blocks.iter())
            .map(|block| {
                let [x, y] = block.centroid;
                let corners = block.corners.iter();
                scale
                    * corners
                        .map(|c| (c[0] - x).hypot(c[1] - y))
                        .fold(0.0, f64::max)
            })
            .collect();
        Ok(Self {
            world,
            bodies,
            reach,
            forces,
            setting,
        })
    }

    /// Runs for a time under loads that go in a straight line from one multiplier to another.
    pub fn run(&mut self, seconds: f64, from: f64, to: f64) {
        let steps = (seconds * self.setting.rate).round().max(1.0) as usize;
        for step in 1..=steps {
            let lambda = from + (to - from) * step as f64 / steps as f64;
            for force in &self.forces {
                let id = self.bodies[force.body];
                let turned = body_get_rotation(&self.world, id);
                let (c, s) = (f64::from(turned.c), f64::from(turned.s));
                let arm = [
                    c * force.arm[0] - s * force.arm[1],
                    s * force.arm[0] + c * force.arm[1],
                ];
                let [x, y] = [0, 1].map(|k| force.dead[k] + lambda * force.live[k]);
                let torque = arm[0] * y - arm[1] * x;
                let total = Vec2 {
                    x: x as f32,
                    y: y as f32,
                };
                body_apply_force_to_center(&mut self.world, id, total, true);
                body_apply_torque(&mut self.world, id, torque as f32, true);
            }
            let step = (1.0 / self.setting.rate) as f32;
            world_step(&mut self.world, step, self.setting.substeps);
        }
    }

    /// Takes all velocities away.
    pub fn halt(&mut self) {
        for &id in &self.bodies {
            body_set_linear_velocity(&mut self.world, id, Vec2 { x: 0.0, y: 0.0 });
            body_set_angular_velocity(&mut self.world, id, 0.0);
        }
    }

    pub fn places(&self) -> Places {
        (self.bodies.iter())
            .map(|&id| {
                let (at, turned) = (
                    body_get_position(&self.world, id),
                    body_get_rotation(&self.world, id),
                );
                let angle = f64::from(turned.s).atan2(f64::from(turned.c));
                [f64::from(at.x), f64::from(at.y), angle]
            })
            .collect()
    }

    /// The farthest that a corner may have moved between two times, in sizes of the median block.
    pub fn moved(&self, from: &Places, to: &Places) -> f64 {
        let corner = |((a, b), reach): ((&[f64; 3], &[f64; 3]), &f64)| {
            (a[0] - b[0]).hypot(a[1] - b[1]) + (a[2] - b[2]).abs() * reach
        };
        (from.iter().zip(to).zip(&self.reach))
            .map(corner)
            .fold(0.0, f64::max)
            / self.setting.size
    }

    pub fn keep(&self) -> Vec<u8> {
        world_snapshot(&self.world)
    }

    pub fn restore(&mut self, kept: &[u8]) {
        assert!(
            world_restore(&mut self.world, kept),
            "a snapshot of this very world"
        );
    }
}

/// What was made so far: the bodies in order, supports first, and of each its pieces.
#[derive(Default)]
struct Laid {
    pieces: Vec<Vec<(u64, Vec<Pair>)>>,
    count: u64,
}

impl Laid {
    fn body(
        &mut self,
        world: &mut World,
        corners: &[Pair],
        centre: Pair,
        scale: f64,
        mass: Option<f64>,
    ) -> Result<BodyId, String> {
        let mut definition = default_body_def();
        definition.position = to_pos(point(centre.map(|part| part * scale)));
        definition.enable_sleep = false;
        if mass.is_some() {
            definition.type_ = BodyType::Dynamic;
        }
        let id = create_body(world, &definition);
        let convex = pieces::convex(corners);
        if convex.is_empty() {
            return Err("an outline that cannot be cut into triangles".to_owned());
        }
        let area: f64 = convex.iter().map(|piece| area(piece)).sum::<f64>() * scale * scale;
        let mut own = Vec::new();
        for piece in convex {
            let local: Vec<Vec2> = (piece.iter())
                .map(|c| point([0, 1].map(|k| (c[k] - centre[k]) * scale)))
                .collect();
            let hull = compute_hull(&local);
            if hull.count as usize != local.len() {
                return Err(
                    "a corner nearer to others, or flatter, than Box2D tells apart; a larger \
                            --size may do"
                        .to_owned(),
                );
            }
            let mut shape = default_shape_def();
            shape.enable_custom_filtering = true;
            shape.material.user_material_id = self.count;
            shape.density = (mass.unwrap_or(1.0) / area) as f32;
            create_polygon_shape(world, id, &shape, &make_polygon(&hull, 0.0));
            own.push((self.count, piece));
            self.count += 1;
        }
        if mass.is_some() {
            body_apply_mass_from_shapes(world, id);
        }
        self.pieces.push(own);
        Ok(id)
    }

    /// Lets the pieces that share a joint touch, with the joint's friction.
    fn contacts(&self, scene: &Scene, tolerance: f64) -> Result<(), String> {
        let supports = scene.supports.len();
        let mut table = BTreeMap::new();
        for joint in &scene.joints {
            let from = match (joint.from_block, joint.from_support) {
                (Some(block), _) => supports + block,
                (None, Some(support)) => support,
                (None, None) => return Err("a joint from nowhere".to_owned()),
            };
            let along = |body: usize| {
                (self.pieces[body].iter())
                    .filter(|(_, piece)| pieces::has_edge_along(piece, joint.ends, tolerance))
                    .map(|&(number, _)| number)
            };
            for a in along(from) {
                for b in along(supports + joint.to) {
                    let friction = joint.friction as f32;
                    if *table.entry((a.min(b), a.max(b))).or_insert(friction) != friction {
                        return Err(
                            "one pair of stones with two coefficients of friction".to_owned()
                        );
                    }
                }
            }
        }
        FRICTION.replace(table);
        Ok(())
    }
}

fn point([x, y]: Pair) -> Vec2 {
    Vec2 {
        x: x as f32,
        y: y as f32,
    }
}

fn area(corners: &[Pair]) -> f64 {
    let next = |at: usize| corners[(at + 1) % corners.len()];
    (0..corners.len())
        .map(|at| (corners[at][0] * next(at)[1] - corners[at][1] * next(at)[0]) / 2.0)
        .sum()
}
