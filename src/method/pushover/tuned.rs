//! The tuned numbers that no scene changes: of models, levels and ranges. Those of one pushover follow from
//! its scene and stand in `parameters`.

tuned! {
    /// The tuned numbers of models, levels and ranges, the same on every scene.
    Tuned:
    /// Range of a block's mass, in mean masses.
    masses: [f64; 2] = [0.05, 20.0];
    /// Power of the depth below the top with which masses grow in a scene that sways.
    depth_power: f64 = 2.0;
    /// Weight over mass by area below which a block is light, in the unit of g.
    light: f64 = 0.2;
    /// Diameter below which a block is small, in course heights.
    small: f64 = 0.3;
    /// Largest ratio of two blocks' weights that is answered.
    most_unequal: f64 = 1e4;
    /// Courses from which on a wall sways: it leans further before it falls, settles more slowly and is
    /// costlier, so that other tolerances hold for it, and a part of it is held fixed.
    swaying: f64 = 20.0;
    /// Overlaps between the stagger line and the part of a tall wall that is held fixed: the strip that
    /// must stay still.
    margin: f64 = 3.0;
    /// Levels that a pushover may have; each halves the substep.
    levels: usize = 4;
    /// Times that the substep may be halved.
    halvings: u32 = 6;
    /// Relaxation sweeps that a scene which neither rests nor falls is given one by one beside its own.
    more_sweeps: usize = 2;
    /// Levels that may end with a load that neither rests nor collapses in time.
    doubts: usize = 3;
    /// Levels that must agree where a scene sways, unless two differ in deflection alone: three show a trend.
    levels_of_swaying: usize = 3;
    /// Part of how far such a scene moves before it collapses that may be left for a substep of 0 where two do.
    creeping: f64 = 0.1;
    /// Part of the work of the push that may go into motion in a jump where a scene that sways states an error. Two
    /// walls lay 2.1 and 2.5 % below their lowest collapse states with 1.9 and 3.4 %; with 0.8 %, 0.1 %.
    jumping: f64 = 0.01;
    /// Blocks times substeps after which no further level is begun; 1800 blocks need 80 to 310 million each.
    budget: usize = 1_000_000_000;
    /// Part of the error asked for within which two levels agree at once.
    close: f64 = 0.25;
    /// Part of a difference between levels that the next one may be, where they shrink.
    shrinking: f64 = 0.5;
    /// Times the error asked for up to which an error that was measured is stated and not refused.
    most_error: f64 = 5.0;
    /// Blocks times substeps beyond which a range is not begun, or not ended, but on request.
    range_budget: usize = 500_000_000;
    /// Substeps of one pushover for every course: what a range is expected to cost. Measured on walls of
    /// 6 to 48 courses, which need 800 to 3400.
    substeps_of_course: f64 = 2000.0;
}
