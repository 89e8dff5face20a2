//! Every tuned number of one pushover in one table, without dimensions: lengths in course heights H_c,
//! g = 1, so times are in √(H_c/g) and speeds in √(g·H_c). Those of models, levels and ranges, which no
//! scene changes, stand in `tuned`. The tests in `doubled` halve and double each, and answers must stay
//! within their stated error.
//!
//! What stands elsewhere is no tuned number: the grid of λ (`model`), the size of faces (`faces`),
//! how long a recorded fall is (`fall`).

use super::model::Model;
use super::tuned::Tuned;
use crate::method::{Accuracy, Collapse, PushoverSettings};

/// Courses above which a wall is tall: a bracket states a larger error.
const TALL: f64 = 30.0;

/// Displacement beyond which a scene at rest has left the place where it was laid, in course heights:
/// as far as contacts keep their points.
pub const SLIDE: f64 = 0.02;

/// Slip of a joint that counts as the first, where a user asks for that, in course heights.
pub const FIRST_SLIP: f64 = 1e-3;

const LENGTH: &str = "H_c";
const TIME: &str = "√(H_c/g)";
const SPEED: &str = "√(g·H_c)";
const FREQUENCY: &str = "1/√(H_c/g)";
const LAMBDA: &str = "of λ";

/// What the parameters of one pushover follow from.
struct Basis {
    accuracy: Accuracy,
    courses: f64,
    /// How small the smallest block is.
    smallness: f64,
    sways: bool,
    /// Whether head joints are in contact, so that units wedge each other in their course.
    wedges: bool,
    /// How many times finer than at normal accuracy.
    finer: f64,
    /// Substep times courses.
    product: f64,
    /// Factor on the displacements that count as running away.
    sway: f64,
    stated_error: f64,
}

impl Basis {
    fn new(model: &Model, accuracy: Accuracy, tuned: &Tuned) -> Self {
        let finer = match accuracy {
            Accuracy::Coarse => 0.5,
            Accuracy::Normal => 1.0,
            Accuracy::Fine => 2.0,
        };
        let sways = model.courses >= tuned.swaying;
        // Elastic deflections, and with them all drift up to the limit, fall with the square of the
        // substep. The first level of a wall that sways only finds the limit: half of this costs twice as much.
        let product = if sways { 0.03 } else { 0.025 } / finer;
        Self {
            accuracy,
            courses: model.courses,
            smallness: model.smallness,
            sways,
            wedges: model.portion.has_range(model.scene),
            finer,
            product,
            sway: if sways { (product / 0.05).powi(2) } else { 1.0 },
            stated_error: stated_error(accuracy, model.courses),
        }
    }

    fn substep(&self) -> f64 {
        // Fewer courses than 8 still need the substep of 8: it also resolves a block's rocking.
        self.product / self.courses.max(8.0)
    }

    fn window(&self) -> f64 {
        if self.sways { 0.2 } else { 0.5 }
    }
}

/// The error that a bracket states, relative to λ: of either end against the limit.
fn stated_error(accuracy: Accuracy, courses: f64) -> f64 {
    let [usual, tall] = match accuracy {
        Accuracy::Coarse => [1e-2, 1.5e-2],
        Accuracy::Normal => [2e-3, 3e-3],
        Accuracy::Fine => [5e-4, 1.5e-3],
    };
    if courses > TALL { tall } else { usual }
}

/// Makes [`Parameters`] from entries `field: type = value, printed name, unit;`. An entry without a
/// name is not printed.
macro_rules! parameters {
    ($of:ident: $(
        $(#[doc = $meaning:literal])+
        $field:ident: $Type:ty = $value:expr $(, $name:literal, $unit:expr)?;
    )+) => {
        /// Parameters of one pushover, which follow from accuracy and scene.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Parameters {$(
            $(#[doc = $meaning])+
            pub $field: $Type,
        )+}

        impl Parameters {
            fn of($of: &Basis) -> Self {
                Self { $($field: $value),+ }
            }

            /// Name, value and unit of each that is printed.
            pub fn listed(&self) -> Vec<(&'static str, f64, &'static str)> {
                vec![
                    ("time step", self.time_step(), TIME),
                    $($(($name, self.$field as f64, $unit),)?)+
                ]
            }
        }
    };
}

parameters! { of:
    /// Substep τ. The error of λ falls with τ and grows with the number of courses.
    substep: f64 = of.substep(), "substep", TIME;
    /// Substeps in a time step; collision detection runs and forces turn once a time step.
    substeps: usize = (32.0 * of.finer) as usize, "substeps", "a time step";
    /// Natural frequency of the contacts; times τ at most 0.25, beyond which walls jitter.
    contact_frequency: f64 = 0.25 / of.substep(), "contact frequency", FREQUENCY;
    /// Damping ratio of the contacts.
    damping_ratio: f64 = 10.0, "contact damping ratio", "";
    /// Relaxation sweeps a substep; friction is solved in these only. Where a single one does not solve the
    /// friction of a tall wall to the end, its courses creep along every bed, and what creeps is taken for
    /// collapse; masses that grow with the depth below the top see to that. Stones whose head joints are in
    /// contact wedge each other, and with a single sweep creep past each other at any substep: rubble then
    /// falls up to 2.5 % below its lowest state. With four some stepped stones rattle.
    stabilization: usize = if of.wedges { 2 } else { 1 }, "relaxation sweeps", "a substep";
    /// Sweeps a substep that also push bodies apart.
    solver_sweeps: usize = 1, "solver sweeps", "a substep";
    /// Part of the last substep's impulses that a substep begins with.
    warm_start: f64 = 1.0, "warm start", "";
    /// Distance at which contacts are foreseen; not below `recycle_distance`, or a corner that is
    /// open when a pair's contact points are renewed would be missing when it closes.
    prediction: f64 = SLIDE / of.smallness, "prediction distance", LENGTH;
    /// Relative drift up to which a pair keeps its contact points. That keeps the geometry of the
    /// scene as laid; renewed at every step, points follow the small movements before collapse,
    /// which costs λ 0.1 to 0.4 % in small walls and 4 % in a slender arch.
    recycle_distance: f64 = SLIDE / of.smallness, "contact recycle distance", LENGTH;
    /// Time over which a step of λ is applied; at once, it would overshoot.
    ramp: f64 = of.window(), "ramp", TIME;
    /// Time over which rest or collapse must show.
    window: f64 = of.window(), "window", TIME;
    /// Time after which a state that neither rests nor collapses is unclear.
    patience: f64 = 200.0, "patience", TIME;
    /// The least part of the time that the first push took to come to rest, over which every further
    /// step of λ is applied: that time tells how slowly a scene sways, and one that sways slowly would
    /// be thrown over by a step that a stiff one does not feel.
    ramp_of_rest: f64 = 0.25, "ramp at least", "of the first rest";
    /// Times the longest rest so far that a load may take, where a shorter step can follow.
    rests_allowed: f64 = 8.0, "time of a step", "longest rests";
    /// The least time that every load has.
    least_patience: f64 = 20.0, "time of a step at least", TIME;
    /// Steps in a row, each half as long as the one before, that may neither rest nor run away in time,
    /// before any push has come to rest and later: contacts that let a scene sway so long are too soft.
    slow_steps: [usize; 2] = [1, 3];
    /// Kinetic damping: blocks are stopped when their kinetic energy has fallen to this part of
    /// its last peak. Stopping at every dip follows a step most gently, but keeps the slow modes of
    /// a wall that sways from settling (48×20 units: 144 million block steps, 67 with 0.9). Where two
    /// modes sway, their energy may never fall far, so that half the peak stops neither: slender walls of
    /// 56 courses then took 5 and more times as long.
    damp_below: f64 = if of.sways { 0.9 } else { 1.0 }, "kinetic damping below", "of its peak";
    /// Factor of the extrapolation of slow drift: what speeds gain or lose over a window, they gain
    /// or lose this many times more. None where it is 0. A wall that sways is thrown over by more.
    extrapolation: f64 = if of.sways { 4.0 } else { 16.0 }, "drift extrapolation", "";
    /// Acceleration below which a motion is slow, as a part of what the push would give all blocks.
    slow_motion: f64 = if of.sways { 0.04 } else { 0.02 }, "slow motion", "λ* g";
    /// Speed below which the settled scene is at rest under its own weight.
    settled_speed: f64 = 1e-7, "settled speed", SPEED;
    /// Displacement beyond which a large step is given up, which is only a hint of where the limit is. A wall
    /// that sways leans far on its way to a rest.
    runaway: f64 = of.sway * if of.sways { 9e-3 } else { 2e-3 } * of.courses.max(10.0),
        "runaway", LENGTH;
    /// Displacement beyond which the last, small step has collapsed.
    collapse: f64 = of.sway * if of.sways { 7.5e-3 } else { 6e-3 } * of.courses.max(6.0),
        "collapse", LENGTH;
    /// Part of that displacement at which the fall has begun: later, what falls has other lever arms.
    onset: f64 = 1.0 / 6.0, "onset of collapse", "of that displacement";
    /// Factor of time step and window where the substep is halved: a wall that sways does so twice as fast then.
    level_factor: f64 = if of.sways { 0.5 } else { 1.0 };
    /// Slip of a joint since the scene settled beyond which it counts as collapse.
    slip: f64 = f64::INFINITY, "first slip", LENGTH;
    /// Displacement since the scene settled beyond which a rest counts as collapse.
    slide: f64 = f64::INFINITY;
    /// States of the blocks that are kept of what follows the collapse.
    frames: usize = 0, "frames", "at least";
    /// Displacement under the own weight alone beyond which the contacts are too soft for the
    /// scene: paper-1 settles by 1.4e-4 and loses nothing up to 6e-4, but 2.7 % of λ at 2.2e-3.
    settlement: f64 = if of.accuracy == Accuracy::Coarse { 6e-3 } else { 1.5e-3 },
        "settlement limit", LENGTH;
    /// Displacement under the own weight alone beyond which the scene falls.
    fall: f64 = 1.0, "fall", LENGTH;
    /// Displacement up to the last load at rest beyond which that is no longer the scene as laid.
    drift: f64 = 0.02 * of.courses.max(5.0), "drift limit", LENGTH;
    /// First increment of λ*.
    first_increment: f64 = if of.sways { 0.2 } else { 0.05 }, "first increment", LAMBDA;
    /// Largest λ* that is tried.
    largest: f64 = 100.0, "largest", LAMBDA;
    /// Width of the bracket relative to λ.
    tolerance: f64 = if of.courses > TALL { 2.0 / 3.0 } else { 0.4 } * of.stated_error,
        "tolerance", LAMBDA;
    /// Error that is stated for the bracket, relative to λ.
    stated_error: f64 = of.stated_error, "stated error", LAMBDA;
    /// Time steps after which the search gives up.
    budget: usize = 200_000, "budget", "time steps";
    /// Part of the smallest increment of λ* whose push no scene at rest may gain speed by in a window.
    resting: f64 = 0.1;
    /// Mass below which a block's energy counts as if it had this mass.
    seen: f64 = 0.05;
    /// Part of the distance to the nearest runaway by which an extrapolation of runaways may be wrong.
    doubt: f64 = 0.05;
    /// Part of the smallest increment within which an extrapolated limit lets that increment follow.
    near: f64 = 0.75;
    /// Part of the largest displacement up to which a block beside those held fixed stands still.
    still: f64 = 1e-2;
    /// Largest speed of a settled scene.
    moving: f64 = 1e-6;
    /// Largest part of the weight that what is fixed may fail to carry.
    missing: f64 = 1e-4;
    /// Whether a self-check that fails takes the number away. Off only to show what they are worth.
    self_checks: bool = true;
}

/// What is asked of every pushover of a scene.
#[derive(Clone, Copy)]
pub struct Asked<'a> {
    /// What a user may change.
    pub settings: &'a PushoverSettings,
    /// What nobody needs to.
    pub tuned: Tuned,
    /// Whether a block that has left the place where it was laid counts as collapse.
    pub in_place: bool,
}

impl<'a> Asked<'a> {
    /// With the numbers as they are tuned.
    pub fn new(settings: &'a PushoverSettings) -> Self {
        Self {
            settings,
            tuned: Tuned::TUNED,
            in_place: false,
        }
    }

    /// Whether substeps are longer or contacts softer than the stated error was measured with.
    pub fn is_coarser(&self) -> bool {
        self.settings.substep > 1.0 || self.settings.stiffness < 1.0
    }

    /// Whether one level is all that is asked for: what no shorter substep confirms.
    pub fn has_one_level(&self) -> bool {
        self.settings.collapse == Collapse::FirstSlip || self.is_coarser()
    }
}

impl Parameters {
    /// Parameters for a model, with the definition of collapse, the recording, the substep and the
    /// stiffness that the settings ask for. Contacts soften with a longer substep; stiffness goes
    /// with the square of their frequency.
    pub fn new(model: &Model, asked: &Asked) -> Self {
        let settings = asked.settings;
        let own = Self::of(&Basis::new(model, settings.accuracy, &asked.tuned));
        Self {
            substep: own.substep * settings.substep,
            substeps: ((own.substeps as f64 / settings.substep).round() as usize).max(1),
            contact_frequency: own.contact_frequency / settings.substep * settings.stiffness.sqrt(),
            slip: match settings.collapse {
                Collapse::Runaway => f64::INFINITY,
                Collapse::FirstSlip => FIRST_SLIP,
            },
            slide: if asked.in_place { SLIDE } else { f64::INFINITY },
            frames: if settings.recording { 100 } else { 0 },
            ..own
        }
    }

    /// Length of a time step.
    pub fn time_step(&self) -> f64 {
        self.substep * self.substeps as f64
    }

    /// The same with the substep halved so many times: contacts are four times as stiff each time. The ramp
    /// stays: if it shrank, steps would overshoot alike on all levels, and no difference would show it.
    pub fn halved(self, times: u32) -> Self {
        let part = 0.5f64.powi(times as i32);
        let factor = self.level_factor.powi(times as i32);
        Self {
            substep: part * self.substep,
            contact_frequency: self.contact_frequency / part,
            substeps: (factor / part) as usize * self.substeps,
            window: factor * self.window,
            ..self
        }
    }

    /// The same without kinetic damping and without extrapolation.
    pub fn undamped(self) -> Self {
        Self {
            damp_below: 0.0,
            extrapolation: 0.0,
            ..self
        }
    }
}
