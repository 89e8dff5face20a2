//! Every tuned number of the lower bound in one table. They decide how long a bound takes and how far
//! it gets, never what is proved: the test `tuned` halves and doubles each, and every proof must hold.
//! On its two walls the bounds of all these stay within 1e-4 of the lowest state.
//!
//! They were chosen on walls of about ten blocks and on paper-1 with open head joints (33 blocks). What
//! else was measured stands with each; "not measured" says that no run tells one value from another.

tuned! {
    /// The tuned numbers of one bound.
    Parameters:
    // Slices.
    /// Searches with the states of lifts as starts, at most: such starts led to states that 150 random
    /// ones had missed.
    restarts: usize = 3;
    /// By how much of λ* a state of such a search is below the last one, to count. Not measured.
    lower_state: f64 = 1e-9;
    /// How far above its end the bound of a slice without states may grow, relative to that and at
    /// least: the farther, the earlier the proof is done. Not measured.
    beyond: [f64; 2] = [0.01, 0.01];
    /// Share of the least of these at which such a slice may stop. Not measured.
    beyond_enough: f64 = 0.25;
    /// How far a slice that reaches the state ends behind it, over its width: where the state lies at
    /// the end, the lift has hardly an interior, and its multipliers do not settle.
    behind: f64 = 0.1;
    /// The least that it ends behind the state, and how far below it the bound may stay, over the gap
    /// that is asked for. Not measured.
    near_state: [f64; 2] = [0.01, 0.005];
    /// Interior-point steps of one slice at most: with 80, paper-2 with open head joints was stopped on
    /// its way to a bound at the lowest state.
    steps: usize = 250;
    /// Steps that the allowed arithmetic never keeps a bound from, however large the lift: those of two
    /// slices of paper-1 in contact (75 and 36), which enclose it within 0.07 %.
    least_steps: usize = 120;
    /// Gain of a slice, over its width, below which the next one is half as wide. Not measured.
    half_gain: f64 = 0.5;
    /// Largest share of the distance to the lowest state that slices after the first one span. Those that end
    /// before it take 25 to 45 steps each; those that reach it creep. openings-3 with open head joints is
    /// enclosed within 0.1 % in 200 steps; slices that reach the state took 320 and got no nearer.
    next_share: f64 = 0.5;
    /// Least share of the distance to the lowest state that a slice spans, and least share of its width
    /// that it gains, before the leaf is divided. Not measured.
    least_share: f64 = 0.2;
    /// Least share of its width that a slice gains, where a shorter one is worth while. With 0.15, of 16 walls of
    /// 12 to 18 blocks in contact with friction of 1.2 to 1.5, two ended 1.3 and 5.2 % apart for 0.8 and 3.9; a wall
    /// of 20 blocks with open head joints took 595 steps for 637.
    least_gain: f64 = 0.3;
    /// Products by which the division of a leaf is tried, at most: on one of 39 random walls (of 17 blocks)
    /// the eighth took the gap from 9.7 to 0.01 %, so that fewer miss it. 16 changed nothing on three others.
    divisions: usize = 8;
    /// What the two parts of a division gain together, of their distances to the state, where no other
    /// is tried. Not measured.
    least_division: f64 = 0.1;
    /// Bound, of 1 at most, at which a slice without an upper end ends; one above 0 excludes all its states. Not
    /// measured.
    excludes: f64 = 0.5;
    /// Share of a slice's width that rounding may cost before the slice is solved to its optimum: on
    /// paper-1 with open head joints no slice that ended early could be proved.
    lost_to_rounding: f64 = 0.2;
    /// States of a lift that are given to the search for collapse states. Not measured.
    states: usize = 8;
    /// Weight in a lift, over the power's, below which a rate's state is rounding. Not measured.
    state_weight: f64 = 1e-6;

    // The interior point.
    /// Products and multipliers at the start, times the number of joints. With 1 for each product, 17 walls of 13 to
    /// 20 blocks (19 to 41 joints) took 1,601 steps, with 0.03 for each 1,337; with 0.003 five of them took 418 for
    /// 387.
    start: f64 = 1.0;
    /// Sum of products times multipliers down to which a point of a slice is kept, for the next one to begin at: so far
    /// apart are its bound and the λ* of its lifted state, or what they leave. Four slices each of three walls of 17 to
    /// 20 blocks took 267 steps, with 0.3 301, with 0.03 289, and 378 where each began from all products alike.
    halfway: f64 = 0.1;
    /// Share of the mean product that one has at least where a slice begins at a point of another one. With 1 and
    /// 0.1 the steps were within 4 %.
    least_at_start: f64 = 0.3;
    /// Share of the rates that may be zero by further assumptions where a slice begins at a point of another one. On
    /// openings-3 with open head joints 2 to 12 % are, from one slice to the next: slices that began there took 20 to
    /// 36 steps for 15 to 22. On the walls of `halfway` above at most 1 % are.
    other_rates: f64 = 0.012;
    /// By how much the mean product may be larger there than it was, or the slice does not begin at that point. Not
    /// measured.
    off_centre: f64 = 10.0;
    /// Change of a product for a change of its multiplier, as a share of the mean product, and its least
    /// and most (proximal terms: Friedlander and Orban, Math. Prog. Comp. 4 (2012) 71-107; tied to the
    /// mean product as by Pougkakiotis and Gondzio, Comput. Optim. Appl. 78 (2021) 307-351). Without it
    /// and `hold` the iteration breaks down on walls of more than about 20 blocks, where weights span 20
    /// decades. Chosen on paper-1.
    softness: [f64; 3] = [1e-4, 1e-9, 1e-5];
    /// What holds the unknowns, likewise.
    hold: [f64; 3] = [1e-2, 1e-9, 1e-4];
    /// Share that a step leaves of what the conditions leave, over how far it is drawn to the centre. With 0, 11 slices
    /// of six walls of 10 to 20 blocks took 293 steps (264 if drawn by Mehrotra's cube), so 246; with 0.7 307, with
    /// 0.9 320.
    left_behind: f64 = 0.5;
    /// Share of the step that makes a number zero which is not gone. Not measured.
    kept_back: f64 = 0.005;
    /// Corrections of a step towards the centre, at most.
    corrections: usize = 3;
    /// By how much longer each of them is to make the step. Not measured.
    longer: f64 = 0.3;
    /// Share of that by which it makes it longer at least, or it is not taken. Not measured.
    worth: f64 = 0.1;
    /// Share of the mean product, and its inverse, between which products with multipliers are not drawn
    /// to the centre. Not measured.
    near_centre: f64 = 0.1;
    /// Steps shorter than this are tried again towards the centre, with corrections as well: without these, seven
    /// slices of a wall of 14 blocks (contact, friction 1.44) took 204 steps for 184.
    short_step: f64 = 0.15;
    /// Share of the mean product that they aim at then. Not measured.
    centre: f64 = 0.4;
    /// Steps shorter than this lead nowhere. Not measured.
    stalled_step: f64 = 0.05;
    /// How many of these in a row do not end it. Not measured.
    stalled_steps: usize = 8;
    /// Steps after which it ends where its bound is still below the slice: on a wall of 14 blocks most
    /// such slices crept on for 250 steps and proved nothing. One proved a quarter of its width in 186 steps,
    /// and one that ended half-way to the state all of its width in 29. Others took 15 to 75.
    late: usize = 80;
    /// Mean product at which it ends. Not measured.
    least_mean: f64 = 1e-13;
    /// The gap at which the bound is as good as the optimum. Not measured.
    gap: f64 = 1e-8;
    /// Share of what a slice gains, and of what is left above it, that its bound may fall short of where
    /// it has a lifted state: before, on paper-2 with open head joints, a slice that could gain no more
    /// than 5e-4 went on for 40 steps of 10 s. With 0.02 the slices that creep take 60 steps and more, and a wall
    /// of 14 blocks (contact, friction 1.44) 364 steps in all for 315.
    rough: f64 = 0.2;
    /// What multipliers and products may leave there. Not measured.
    roughly_left: f64 = 3e-6;
    /// What multipliers may leave of the identity at the end of the iteration; a last step takes more.
    /// Not measured.
    left: f64 = 1e-8;
    /// Share of what multipliers have left that they may leave where their proof was lost to that, and the
    /// iteration goes on. Not measured.
    refined: f64 = 0.1;
    /// What a unit of what multipliers leave of the identity costs of their bound, to compare them. Not
    /// measured.
    of_left: f64 = 1e4;
    /// Share of the right side that a step's linear system leaves. Not measured.
    solved_to: f64 = 1e-11;
    /// What it leaves over what multipliers leave of the identity, which it may leave at any rate: without, twelve
    /// slices took 1,997 rounds of conjugate gradients, so 1,165.
    solved_of_left: f64 = 1e-3;
    /// Share that it leaves at most, or the step is taken again, softer: in the first slice of paper-2 with open
    /// head joints the 37th step left 8e-6, those before it less than 1e-10. All multipliers after it were spoilt,
    /// so that the slice proved 0.044 of 0.563.
    unsolved: f64 = 1e-7;
    /// By how much softness and hold grow then, for the rest of the slice.
    softer: f64 = 10.0;
    /// Up to how much they grow. Not measured.
    softest: f64 = 1e4;
    /// The same of the prediction, which only says how far the step is drawn to the centre. As exact as the
    /// step itself it takes 3,453 rounds of conjugate gradients on paper-1 in contact, so 2,549.
    predicted_to: f64 = 1e-6;

    // Linear systems.
    /// Share of each diagonal entry, and of the largest, that is added to it. Not measured.
    regular: [f64; 2] = [1e-14, 1e-17];
    /// Rounds of conjugate gradients at most. Not measured.
    gradients: usize = 20;
    /// Rounds after which the residual is to be half as large: on paper-2 with open head joints all 20
    /// changed nothing.
    to_halve: usize = 4;

    // The way from multipliers to a proof.
    /// Rounds of cleaning multipliers, and solutions with one factor in each. Not measured.
    cleanings: usize = 3;
    /// What is left after which another round is of no use. Not measured.
    clean: f64 = 1e-14;
    /// Share of what was left before that a round leaves, where another one follows. Not measured.
    cleaner: f64 = 0.1;
    /// Share of the right side that its linear systems leave. Not measured.
    cleaned_to: f64 = 1e-10;
    /// Multipliers smaller than this share of the largest do not move. Not measured.
    unmoved: f64 = 1e-13;
    /// How freely the bound itself moves: where the multipliers on their way to zero are gone, it has to
    /// become the optimum. Not measured.
    of_sigma: [f64; 2] = [1e-6, 1.0];
    /// Share of a slice's width that may be lost on the way to a proof, where no other way is tried. Not
    /// measured.
    lost: f64 = 1e-4;

    // Forces that cannot vanish.
    /// How far beyond the λ up to which forces can vanish that is used: nearer, the multipliers of its
    /// proof grow until rounding takes it. Not measured.
    clear: f64 = 1e-4;
    /// What is added to all rates' multipliers, so that they absorb what rounding leaves. Not measured.
    absorbed: f64 = 1e-6;
    /// How far above its end the bound of a slice without such forces lies, relative to that and at
    /// least. Not measured.
    above: [f64; 2] = [0.01, 0.01];
}

// What follows is not tuned: it is what a number in double precision can hold.

/// Multipliers are whole multiples of this: what is finer is below what rounding leaves, and would only
/// fill files.
pub(super) const GRAIN: f64 = 1.0 / (1u64 << 48) as f64;

/// What rounding leaves of a sum that cancels, over its magnitudes.
pub(super) const ROUNDING: f64 = 1e-14;

/// Share of a pivot's first value below which it is rounding: its unknown stays as it is.
pub(super) const LOST_PIVOT: f64 = 1e-15;

/// Pivot of an unknown that stays as it is.
pub(super) const HELD_PIVOT: f64 = 1e80;

/// Least diagonal of the equilibrium conditions' factor where they are independent.
pub(super) const INDEPENDENT: f64 = 1e-12;

/// Share of a row below which an entry, or the whole row, is what rounding leaves of others.
pub(super) const DEPENDENT: f64 = 1e-10;

/// By how much of the push's power multipliers may miss 1 and be those of an optimum.
pub(super) const OPTIMAL: f64 = 1e-6;

/// What another machine may round a scene's geometry to otherwise, relative to λ.
pub(super) const OTHER_MACHINE: f64 = 1e-9;

/// Columns of a block of a dense factor (what fits the fastest memory of any processor of today).
pub(super) const BLOCK: usize = 48;

/// Columns of tiles that are worked on as one, at most; more leave less to be done at once. Not measured.
pub(super) const GROUPED: usize = 4;

/// Orderings of a sparse factor that are tried: on paper-1 in contact the cheapest of 8 takes 12 % fewer products
/// than plain local fill.
pub(super) const ORDERINGS: usize = 8;

/// The most that chance adds to what an unknown fills in, as a share of it, for another ordering. Not measured.
pub(super) const UNEVEN: f64 = 0.3;

/// Products of a matrix and a column that one thread does together: less is not worth another's attention.
pub(super) const PIECE: usize = 4;

#[cfg(test)]
mod tests {
    use super::Parameters;
    use crate::method::Setting;

    #[test]
    fn the_help_says_how_many_steps_are_always_allowed() {
        let mut settings = Setting::all().iter();
        let work = settings.find(|setting| setting.name == "lift-work");
        let steps = format!("that of {} steps", Parameters::TUNED.least_steps);
        assert!(work.is_some_and(|work| work.meaning.contains(&steps)));
    }
}
