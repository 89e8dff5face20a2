//! The physics: rapier behind one folder. Nothing else in the crate names it.
//!
//! Lengths here are in course heights, g = 1, forces in mean block weights.

mod closed;

use rapier2d::math::{Pose, Rotation, Vector as Vec2};
use rapier2d::parry::mass_properties::MassProperties;
use rapier2d::parry::shape::SharedShape;
use rapier2d::prelude::{
    BroadPhaseBvh, CCDSolver, CoefficientCombineRule, ColliderBuilder, ColliderHandle, ColliderSet,
    ContactPair, Group, ImpulseJointSet, IntegrationParameters, InteractionGroups,
    InteractionTestMode, IslandManager, LockedAxes, MultibodyJointSet, NarrowPhase,
    PhysicsPipeline, RigidBodyBuilder, RigidBodyHandle, RigidBodySet, SoftBodiesSettings,
    SoftBodySet, SpringCoefficients,
};

use super::faces::{DEPTH, Face};
use super::model::{Model, MovingBody};
use super::parameters::Parameters;

/// Where a block is and how fast it moves, in course heights and g = 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyState {
    /// Centroid.
    pub position: [f64; 2],
    /// Rotation since the start, counter-clockwise.
    pub rotation: f64,
    /// Velocity of the centroid.
    pub velocity: [f64; 2],
    /// Rotation rate.
    pub spin: f64,
}

/// The contact at a joint of the scene during the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The joint's place in the scene.
    pub joint: usize,
    /// Unit normal into the block that the joint's normal points into.
    pub normal: [f64; 2],
    /// Force on that block.
    pub force: [f64; 2],
}

/// The part of the physics that a checkpoint has to keep.
#[derive(Clone, Default)]
struct World {
    islands: IslandManager,
    broad_phase: BroadPhaseBvh,
    narrow_phase: NarrowPhase,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    joints: ImpulseJointSet,
    multibodies: MultibodyJointSet,
    soft_bodies: SoftBodySet,
    ccd: CCDSolver,
}

/// A state to come back to.
pub struct Checkpoint(World);

/// Blocks on supports under `dead + λ · live`.
pub struct Physics<'a> {
    model: &'a Model<'a>,
    parameters: IntegrationParameters,
    pipeline: PhysicsPipeline,
    world: World,
    blocks: Vec<RigidBodyHandle>,
    /// The multiplier λ*.
    pub multiplier: f64,
    /// Time steps made so far, abandoned ones included.
    pub steps: usize,
    /// Whether rapier had to take a body with a position that is no number out of the scene.
    pub broken: bool,
}

impl<'a> Physics<'a> {
    /// Puts the model's bodies where they belong, at rest.
    pub fn new(model: &'a Model<'a>, parameters: &Parameters) -> Self {
        let mut world = World::default();
        for face in &model.fixed {
            world.colliders.insert(collider(face));
        }
        let mut blocks = Vec::with_capacity(model.blocks.len());
        for block in &model.blocks {
            let handle = world.bodies.insert(body(block));
            for face in &block.faces {
                let bodies = &mut world.bodies;
                let collider = collider(face);
                world.colliders.insert_with_parent(collider, handle, bodies);
            }
            blocks.push(handle);
        }
        Self {
            model,
            parameters: integration(parameters),
            pipeline: PhysicsPipeline::new(),
            world,
            blocks,
            multiplier: 0.0,
            steps: 0,
            broken: false,
        }
    }

    /// Length of one time step.
    pub fn dt(&self) -> f64 {
        self.parameters.dt
    }

    /// Advances by one time step.
    pub fn step(&mut self) {
        self.apply_loads();
        let world = &mut self.world;
        self.pipeline.step(
            Vec2::ZERO,
            &self.parameters,
            &mut world.islands,
            &mut world.broad_phase,
            &mut world.narrow_phase,
            &mut world.bodies,
            &mut world.colliders,
            &mut world.joints,
            &mut world.multibodies,
            &mut world.soft_bodies,
            &mut world.ccd,
            &(),
            &(),
        );
        let quarantine = self.pipeline.quarantine();
        self.broken |= !(quarantine.bodies().is_empty() && quarantine.colliders().is_empty());
        self.steps += 1;
    }

    /// Every force at its own point, which turns with its block; directions stay.
    fn apply_loads(&mut self) {
        for (block, &handle) in self.model.blocks.iter().zip(&self.blocks) {
            let Some(body) = self.world.bodies.get_mut(handle) else {
                continue;
            };
            body.reset_forces(false);
            body.reset_torques(false);
            let turn = *body.rotation();
            for load in &block.loads {
                let force = vec2(load.dead) + vec2(load.live) * self.multiplier;
                let arm = turn * vec2(load.arm);
                body.add_force(force, false);
                body.add_torque(arm.perp_dot(force), false);
            }
        }
    }

    /// All blocks, in the model's order.
    pub fn states(&self) -> Vec<BodyState> {
        let bodies = self.blocks.iter().map(|&handle| {
            let Some(body) = self.world.bodies.get(handle) else {
                return BodyState::default();
            };
            BodyState {
                position: body.translation().into(),
                rotation: body.rotation().angle(),
                velocity: body.linvel().into(),
                spin: body.angvel(),
            }
        });
        bodies.collect()
    }

    /// Multiplies all velocities; by zero, for kinetic damping.
    pub fn scale_velocities(&mut self, factor: f64) {
        for &handle in &self.blocks {
            if let Some(body) = self.world.bodies.get_mut(handle) {
                let (velocity, spin) = (body.linvel() * factor, body.angvel() * factor);
                body.set_linvel(velocity, false);
                body.set_angvel(spin, false);
            }
        }
    }

    /// Every contact that was solved in the last step, pressed or not.
    pub fn contacts(&self) -> Vec<Contact> {
        let pairs = self.world.narrow_phase.contact_pairs();
        pairs.flat_map(|pair| self.pair_contacts(pair)).collect()
    }

    fn pair_contacts(&self, pair: &ContactPair) -> Vec<Contact> {
        let of = |collider: ColliderHandle| self.world.colliders.get(collider);
        let (Some(one), Some(other)) = (of(pair.collider1), of(pair.collider2)) else {
            return Vec::new();
        };
        // From the joint's first body to its second.
        let sign = match one.user_data < other.user_data {
            true => 1.0,
            false => -1.0,
        };
        let solved = pair.manifolds().iter();
        let solved = solved.filter(|manifold| !manifold.data.solver_contacts.is_empty());
        let contact = solved.map(|manifold| {
            let normal = manifold.data.normal;
            // The solver's tangent for the first body, on which its impulses act.
            let tangent = Vec2::new(normal.y, -normal.x);
            let (mut pressed, mut sheared) = (0.0, 0.0);
            for active in &manifold.data.solver_contacts {
                for id in active.contact_indices() {
                    if let Some(point) = manifold.points.get(id as usize) {
                        pressed += point.data.impulse;
                        sheared += point.data.tangent_impulse.x;
                    }
                }
            }
            // Impulses are sums over the whole time step.
            let impulse = normal * pressed - tangent * sheared;
            Contact {
                joint: (one.user_data / 2) as usize,
                normal: (normal * sign).into(),
                force: (impulse * (sign / self.dt())).into(),
            }
        });
        contact.collect()
    }

    /// Keeps the present state.
    pub fn checkpoint(&self) -> Checkpoint {
        Checkpoint(self.world.clone())
    }

    /// Goes back to a kept state.
    pub fn restore(&mut self, checkpoint: &Checkpoint) {
        self.world = checkpoint.0.clone();
        // Only workspace, but none of it may reach over from the abandoned state.
        self.pipeline = PhysicsPipeline::new();
        self.broken = false;
    }
}

/// Every parameter by name: none is left to a default that a later version might change.
fn integration(parameters: &Parameters) -> IntegrationParameters {
    let softness = SpringCoefficients {
        natural_frequency: parameters.contact_frequency,
        damping_ratio: parameters.damping_ratio,
    };
    let dt = parameters.time_step();
    IntegrationParameters {
        dt,
        min_ccd_dt: dt,
        contact_softness: softness,
        static_contact_softness: softness,
        warmstart_coefficient: parameters.warm_start,
        length_unit: 1.0,
        // Never read: nothing here is soft.
        soft_bodies: SoftBodiesSettings::default(),
        // Only read by continuous collision detection, which is off.
        normalized_allowed_linear_error: parameters.prediction,
        normalized_max_corrective_velocity: 1.0,
        normalized_prediction_distance: parameters.prediction,
        normalized_max_linear_velocity: 1e3,
        num_solver_iterations: parameters.substeps,
        num_internal_pgs_iterations: parameters.solver_sweeps,
        num_internal_stabilization_iterations: parameters.stabilization,
        max_ccd_substeps: 0,
        contact_clustering: false,
        contact_recycling: parameters.recycle_distance > 0.0,
        normalized_contact_recycle_distance: parameters.recycle_distance,
        friction_in_bias_pass: false,
        warmstart_joints: false,
    }
}

/// A block's body. Gravity is off: weights are forces like all others.
fn body(block: &MovingBody) -> RigidBodyBuilder {
    let properties = MassProperties::new(Vec2::ZERO, block.mass, block.inertia);
    let locked = match block.is_pinned {
        true => LockedAxes::TRANSLATION_LOCKED,
        false => LockedAxes::empty(),
    };
    RigidBodyBuilder::dynamic()
        .locked_axes(locked)
        .translation(vec2(block.centre))
        .gravity_scale(0.0)
        .linear_damping(0.0)
        .angular_damping(0.0)
        .can_sleep(false)
        .ccd_enabled(false)
        .additional_mass_properties(properties)
}

/// A face as a cuboid, whose contacts rapier finds exactly. It knows its joint and which of the two
/// bodies it is on.
fn collider(face: &Face) -> ColliderBuilder {
    let rotation = Rotation::from_cos_sin_unchecked(face.along[0], face.along[1]);
    let groups = InteractionGroups::new(
        Group::from_bits_retain(face.groups.member),
        Group::from_bits_retain(face.groups.meets),
        InteractionTestMode::And,
    );
    ColliderBuilder::new(SharedShape::cuboid(face.half, DEPTH / 2.0))
        .density(0.0)
        .restitution(0.0)
        .contact_skin(0.0)
        .collision_groups(groups)
        // Both faces of a joint have its coefficient, and this rule does not square it.
        .friction(face.friction)
        .friction_combine_rule(CoefficientCombineRule::Min)
        .position(Pose::from_parts(vec2(face.centre), rotation))
        .user_data(2 * face.joint as u128 + u128::from(face.is_second))
}

fn vec2([x, y]: [f64; 2]) -> Vec2 {
    Vec2::new(x, y)
}
