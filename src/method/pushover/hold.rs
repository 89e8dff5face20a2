//! Holding a load until the blocks rest or run away.

use super::measure::{displacement, kinetic_energy, speed, twice_kinetic_energy};
use super::model::{GRID, Model};
use super::parameters::Parameters;
use super::physics::{BodyState, Physics};

/// How a hold at constant λ ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Held {
    /// Speeds fell below the limit and stayed there without help.
    Rest,
    /// Displaced beyond the limit and not slowing down.
    Collapse {
        /// What takes a point from rest to its speed over its displacement, in g.
        acceleration: f64,
    },
    /// Neither within the time allowed.
    Unclear,
}

/// When a collapse has begun.
pub struct Onset {
    /// Blocks.
    pub states: Vec<BodyState>,
    /// Kinetic energy that they gained by themselves: without what extrapolated drift gave them.
    pub energy: f64,
}

/// Holds loads on one model.
pub struct Hold<'a> {
    model: &'a Model<'a>,
    parameters: &'a Parameters,
    /// Time that the last hold took.
    pub elapsed: f64,
    /// When its collapse had begun.
    pub onset: Option<Onset>,
    /// Time that the first push took to come to rest; 0 until then.
    first: f64,
    /// The longest time that a push took to come to rest.
    longest: f64,
}

impl<'a> Hold<'a> {
    /// For a model and its parameters.
    pub fn new(model: &'a Model<'a>, parameters: &'a Parameters) -> Self {
        Self {
            model,
            parameters,
            elapsed: 0.0,
            onset: None,
            first: 0.0,
            longest: 0.0,
        }
    }

    /// The scene under its weight and a push against its live loads: none, or a small one.
    pub fn settle(&mut self, physics: &mut Physics, push: f64) -> Held {
        let own = self.parameters;
        let (speed, limit) = (own.settled_speed, own.fall);
        self.hold(physics, [-push; 2], speed, limit, own.patience)
    }

    /// From rest at one λ* to another, in grid units. `last`: a collapse counts, and there is all the
    /// time that is allowed. A longer step has a few times what rests have taken: what sways longer
    /// is reached sooner by two shorter steps.
    pub fn step(
        &mut self,
        physics: &mut Physics,
        loads: [u64; 2],
        finest: u64,
        last: bool,
    ) -> Held {
        let parameters = self.parameters;
        let (limit, patience) = if last {
            (parameters.collapse, parameters.patience)
        } else {
            // What runs away by a quarter of the step takes so long.
            let step = (loads[1] - loads[0]) as f64 / GRID;
            let runs_away = (8.0 * parameters.runaway / step).sqrt();
            let rests = parameters.rests_allowed * self.longest;
            let patience = rests.max(parameters.least_patience);
            let patience = patience.max(runs_away).min(parameters.patience);
            (parameters.runaway, patience)
        };
        // An unbalanced tenth of the smallest increment would reach this speed in a window.
        let resting_speed = parameters.resting * finest as f64 / GRID * parameters.window;
        let loads = loads.map(|load| load as f64 / GRID);
        let held = self.hold(physics, loads, resting_speed, limit, patience);
        if held == Held::Rest {
            self.longest = self.longest.max(self.elapsed);
            if self.first == 0.0 {
                self.first = self.elapsed;
            }
        }
        held
    }

    /// Holds λ until the blocks rest at no more than `resting_speed`, or move further than `limit`
    /// without slowing down. Kinetic damping: whenever the kinetic energy falls, all blocks are
    /// stopped, so that a step is followed quasi-statically; the last window must stay at rest
    /// without it.
    fn hold(
        &mut self,
        physics: &mut Physics,
        loads: [f64; 2],
        resting_speed: f64,
        limit: f64,
        patience: f64,
    ) -> Held {
        let parameters = self.parameters;
        let from: Vec<BodyState> = physics.states();
        let steps = (parameters.window / physics.dt()).ceil() as usize;
        let windows = (patience / parameters.window).ceil() as usize;
        let ramp = parameters.ramp.max(parameters.ramp_of_rest * self.first);
        let ramp = (ramp / physics.dt()).ceil().max(1.0);
        // Largest speed of the window before.
        let mut peak_before = f64::INFINITY;
        // Twice the kinetic energy at its peak since the blocks were last stopped.
        let mut energy = 0.0;
        // Kinetic energy that extrapolated drift has given them since.
        let mut given = 0.0;
        let mut pace_before = None;
        self.onset = None;
        for window in 0..windows {
            let ramping = ((window * steps) as f64) < ramp - 1.0;
            let damped = ramping || peak_before > resting_speed;
            let (mut peak, mut stopped) = (0.0f64, false);
            for step in 0..steps {
                let part = ((window * steps + step + 1) as f64 / ramp).min(1.0);
                physics.multiplier = loads[0] + part * (loads[1] - loads[0]);
                physics.step();
                self.elapsed = (window * steps + step + 1) as f64 * physics.dt();
                if physics.broken {
                    return Held::Unclear;
                }
                let states = physics.states();
                let now = speed(self.model, &states);
                peak = peak.max(now);
                let moved = displacement(self.model, &from, &states);
                let present = twice_kinetic_energy(self.model, &states, parameters.seen);
                let runs_away = now >= peak_before;
                if self.onset.is_none() && runs_away && moved > parameters.onset * limit {
                    let energy = kinetic_energy(self.model, &states) - given;
                    self.onset = Some(Onset { states, energy });
                }
                if runs_away && moved > limit {
                    let acceleration = now * now / (2.0 * moved);
                    return Held::Collapse { acceleration };
                }
                let falling = present < parameters.damp_below * energy;
                if damped && falling {
                    physics.scale_velocities(0.0);
                    (stopped, given) = (true, 0.0);
                }
                energy = if falling { 0.0 } else { present.max(energy) };
            }
            if !damped && peak <= resting_speed {
                self.onset = None;
                return Held::Rest;
            }
            peak_before = peak;
            if damped && !ramping && !stopped {
                let before = kinetic_energy(self.model, &physics.states());
                let factor = self.extrapolate_drift(physics, &from, pace_before);
                energy = energy * factor * factor;
                given += before * (factor * factor - 1.0);
                peak_before *= factor.max(1.0);
                pace_before = Some(self.pace(&physics.states()));
            } else {
                pace_before = None;
            }
        }
        Held::Unclear
    }

    /// How fast all blocks are together: the root of twice their kinetic energy.
    fn pace(&self, states: &[BodyState]) -> f64 {
        twice_kinetic_energy(self.model, states, self.parameters.seen).sqrt()
    }

    /// Extrapolates slow drift: scales velocities by 1 + factor · (1 − before/now), `before` being
    /// the [pace](Self::pace) at the end of the window before. Near the limit the blocks drift by
    /// many elastic deflections before they rest or run away, and inertia alone sets how long that
    /// takes; it has no part in where they stop. Returns the scale of the velocities.
    fn extrapolate_drift(
        &self,
        physics: &mut Physics,
        from: &[BodyState],
        before: Option<f64>,
    ) -> f64 {
        let extrapolation = self.parameters.extrapolation;
        let states = physics.states();
        let fastest = speed(self.model, &states);
        let moved = displacement(self.model, from, &states);
        let now = self.pace(&states);
        // Of a push by λ*, no more than a small part is left to accelerate a slow motion. A slender
        // column stands by so little that a fixed limit would let it be thrown over.
        let slow_motion = self.parameters.slow_motion * physics.multiplier.abs().min(1.0);
        let slow = fastest * fastest < 2.0 * moved * slow_motion;
        let Some(before) = before.filter(|_| slow && now > 0.0 && extrapolation > 0.0) else {
            return 1.0;
        };
        let scale = 1.0 + extrapolation * (1.0 - before / now);
        let scale = scale.clamp(0.0, 1.0 + extrapolation / 2.0);
        physics.scale_velocities(scale);
        scale
    }
}
