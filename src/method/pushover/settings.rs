//! Every setting in one place, without dimensions: lengths in course heights, g = 1, so times are
//! in √(H_c/g) and speeds in √(g·H_c).

use super::model::Model;
use crate::method::{self, Accuracy, Collapse};

/// λ is a whole number of these; brackets then print exactly with five decimals.
pub const GRID: f64 = 1e5;

/// Courses from which on a wall is tall: it sways further before it falls, and is costlier.
pub const TALL: f64 = 20.0;

/// Settings of one pushover.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Substep τ. The error of λ falls with τ and grows with the number of courses.
    pub substep: f64,
    /// Substeps in a time step; collision detection runs and forces turn once a time step.
    pub substeps: usize,
    /// Natural frequency of the contacts; times τ at most 0.25, beyond which walls jitter.
    pub contact_frequency: f64,
    /// Damping ratio of the contacts.
    pub damping_ratio: f64,
    /// Relaxation sweeps a substep; friction is solved in these only.
    pub stabilization: usize,
    /// Distance at which contacts are foreseen; not below `recycle_distance`, or a corner that is
    /// open when a pair's contact points are renewed would be missing when it closes.
    pub prediction: f64,
    /// Relative drift up to which a pair keeps its contact points. That keeps the geometry of the
    /// scene as laid; renewed at every step, points follow the small movements before collapse,
    /// which costs λ 0.1 to 0.4 % in small walls and 4 % in a slender arch.
    pub recycle_distance: f64,
    /// Time over which a step of λ is applied; at once, it would overshoot.
    pub ramp: f64,
    /// Time over which rest or collapse must show.
    pub window: f64,
    /// Time after which a state that neither rests nor collapses is unclear.
    pub patience: f64,
    /// Kinetic damping: blocks are stopped when their kinetic energy has fallen to this part of
    /// its last peak.
    pub damp_below: f64,
    /// Inertia taken from slow motions: what speeds gain or lose over a window, they gain or lose
    /// this many times more.
    pub hurry: f64,
    /// Acceleration, in g, below which a motion is slow.
    pub slow_motion: f64,
    /// Speed below which the settled scene is at rest under its own weight.
    pub settled_speed: f64,
    /// Displacement beyond which a large step is given up.
    pub runaway: f64,
    /// Displacement beyond which the last, small step has collapsed.
    pub collapse: f64,
    /// Slip of a joint since the scene settled beyond which it counts as collapse.
    pub slip: f64,
    /// Time steps of a collapse that are kept.
    pub frames: usize,
    /// Displacement under the own weight alone beyond which the contacts are too soft for the scene.
    pub settlement: f64,
    /// Displacement under the own weight alone beyond which the scene falls.
    pub fall: f64,
    /// Displacement up to the last load at rest beyond which that is no longer the scene as laid.
    pub drift: f64,
    /// First increment of λ, in `GRID` units.
    pub first_increment: u64,
    /// Largest λ that is tried, in `GRID` units.
    pub largest: u64,
    /// Width of the bracket relative to λ.
    pub tolerance: f64,
    /// Error that is stated for the bracket, relative to λ.
    pub stated_error: f64,
    /// Time steps after which the search gives up.
    pub budget: usize,
    /// Whether a self-check that fails takes the number away. Off only to show what they are worth.
    pub self_checks: bool,
}

impl Settings {
    /// Settings for a model.
    pub fn new(model: &Model, accuracy: Accuracy) -> Self {
        let stated_error = accuracy.stated_error(model.courses);
        let finer = match accuracy {
            Accuracy::Coarse => 0.5,
            Accuracy::Normal => 1.0,
            Accuracy::Fine => 2.0,
        };
        // Fewer courses than 8 still need the substep of 8: it also resolves a block's rocking.
        let tall = model.courses >= TALL;
        // Elastic deflections, and with them all drift up to the limit, fall with the square of the
        // substep at the same number of substeps: a tall wall has to be kept from leaning.
        let product = if tall { 0.015 } else { 0.025 } / finer;
        let substep = product / model.courses.max(8.0);
        let sway = if tall { (product / 0.025).powi(2) } else { 1.0 };
        let window = if tall { 0.2 } else { 0.5 };
        Self {
            substep,
            substeps: (32.0 * finer) as usize,
            contact_frequency: 0.25 / substep,
            damping_ratio: 10.0,
            stabilization: 1,
            prediction: 0.02,
            recycle_distance: 0.02,
            ramp: window,
            window,
            patience: 200.0,
            // Stopping at every dip of the energy follows a step most gently, but keeps the slow
            // modes of a tall wall from ever settling.
            damp_below: if tall { 0.5 } else { 1.0 },
            hurry: 16.0,
            slow_motion: if tall { 0.02 } else { 0.01 },
            settled_speed: 1e-7,
            runaway: sway * if tall { 6e-3 } else { 2e-3 } * model.courses.max(10.0),
            collapse: sway * if tall { 7.5e-3 } else { 6e-3 } * model.courses.max(6.0),
            slip: f64::INFINITY,
            frames: 0,
            // paper-1 settles by 1.4e-4 and loses nothing up to 6e-4, but 2.7 % of λ at 2.2e-3.
            settlement: if accuracy == Accuracy::Coarse {
                6e-3
            } else {
                1.5e-3
            },
            fall: 1.0,
            drift: 0.02 * model.courses.max(5.0),
            first_increment: if tall { 20_000 } else { 5_000 },
            largest: 10_000_000,
            tolerance: if model.courses > 30.0 { 0.5 } else { 0.4 } * stated_error,
            stated_error,
            budget: 200_000,
            self_checks: true,
        }
    }

    /// The same with the definition of collapse, the recording, the substep and the stiffness that
    /// a user asks for. Contacts soften with a longer substep; stiffness goes with the square of
    /// their frequency.
    pub fn asked(self, user: &method::Settings) -> Self {
        Self {
            substep: self.substep * user.substep,
            substeps: ((self.substeps as f64 / user.substep).round() as usize).max(1),
            contact_frequency: self.contact_frequency / user.substep * user.stiffness.sqrt(),
            slip: match user.collapse {
                Collapse::Runaway => f64::INFINITY,
                Collapse::FirstSlip => 1e-3,
            },
            frames: if user.recording { 100 } else { 0 },
            ..self
        }
    }

    /// Name, value and unit of each, and of what the engine gets besides.
    pub fn listed(&self) -> Vec<(&'static str, f64, &'static str)> {
        let (time, speed, grid) = ("√(H_c/g)", "√(g·H_c)", "of λ");
        vec![
            ("time step", self.substep * self.substeps as f64, time),
            ("substep", self.substep, time),
            ("substeps", self.substeps as f64, "a time step"),
            ("contact frequency", self.contact_frequency, "1/√(H_c/g)"),
            ("contact damping ratio", self.damping_ratio, ""),
            ("relaxation sweeps", self.stabilization as f64, "a substep"),
            ("solver sweeps", 1.0, "a substep"),
            ("warm start", 1.0, ""),
            ("prediction distance", self.prediction, "H_c"),
            ("contact recycle distance", self.recycle_distance, "H_c"),
            ("ramp", self.ramp, time),
            ("window", self.window, time),
            ("patience", self.patience, time),
            ("kinetic damping below", self.damp_below, "of its peak"),
            ("hurry", self.hurry, ""),
            ("slow motion", self.slow_motion, "g"),
            ("settled speed", self.settled_speed, speed),
            ("runaway", self.runaway, "H_c"),
            ("collapse", self.collapse, "H_c"),
            ("first slip", self.slip, "H_c"),
            ("frames", self.frames as f64, "at least"),
            ("settlement limit", self.settlement, "H_c"),
            ("fall", self.fall, "H_c"),
            ("drift limit", self.drift, "H_c"),
            ("first increment", self.first_increment as f64 / GRID, grid),
            ("largest", self.largest as f64 / GRID, grid),
            ("tolerance", self.tolerance, grid),
            ("stated error", self.stated_error, grid),
            ("budget", self.budget as f64, "time steps"),
        ]
    }

    /// The same with half the substep.
    pub fn halved(self) -> Self {
        Self {
            substep: self.substep / 2.0,
            contact_frequency: 2.0 * self.contact_frequency,
            substeps: 2 * self.substeps,
            ..self
        }
    }
}
