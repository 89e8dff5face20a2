//! Every tuned number of the search for collapse states. None of them can make an answer wrong, as
//! every state is verified; they decide which states are found, and how soon.
//!
//! Where nothing is said of a measurement there was none: the number was chosen, and what is known is
//! what the test below shows, which halves and doubles each.

use crate::method::limit::noise::Noise;

/// A number between two others, at random.
#[derive(Clone, Copy, Debug)]
pub struct Range(pub f64, pub f64);

impl Range {
    pub(super) fn pick(self, noise: &mut Noise) -> f64 {
        noise.between(self.0, self.1)
    }
}

/// A number whose decimal logarithm lies between two others, at random.
#[derive(Clone, Copy, Debug)]
pub struct Decades(pub f64, pub f64);

impl Decades {
    pub(super) fn pick(self, noise: &mut Noise) -> f64 {
        10f64.powf(noise.between(self.0, self.1))
    }
}

tuned! {
    /// The tuned numbers of one search.
    Tuned:
    /// Factor on normal forces, joint by joint. Of 48 starts from the associative state's, on six walls
    /// that a search without such starts gets wrong, 12 reached the lowest known state, and 1 of 48
    /// without factors; no other range was measured.
    scaled: Range = Range(0.1, 1.8);
    /// Share of the joints whose normal force under the own weight is thinned.
    thinned: f64 = 0.5;
    /// What is left of it there.
    thinned_to: f64 = 0.05;
    /// Normal force that all joints have but for this factor, in units of the joint.
    even: Decades = Decades(-2.0, 1.0);
    /// λ of random statics, as a part of λ_A. On those six walls 12 of 48 starts between 0.2 and 0.6
    /// reached the lowest known state, 3 of 48 above.
    statics: Range = Range(0.05, 1.0);
    /// The same where the normal forces are scaled too.
    statics_scaled: Range = Range(0.1, 1.0);
    /// λ of random statics, as a part of the lowest state's.
    statics_below: Range = Range(0.2, 1.0);
    /// Size of random prices of normal forces.
    priced: Decades = Decades(-2.0, 0.5);
    /// Rise of the lowest state's normal forces, in units of the joint. Rises of 0.01 to 0.1 found
    /// 0.53785 on paper-3 in contact, those of head joints alone 0.53943.
    raised: Decades = Decades(-3.0, 0.0);
    /// Share of these starts that raise head joints alone.
    heads_alone: f64 = 0.3;
    /// Largest factor on the lowest state's prices.
    repriced: f64 = 2.0;
    /// Largest part of λ's cost that is taken away meanwhile.
    repriced_weight: f64 = 0.9;
    /// Frozen programs that make a start. Without such starts an irregular bond ended at 0.38095, with
    /// them below 0.368.
    frozen: usize = 4;
    /// Frozen programs of one start until it is given up.
    steps: usize = 40;
    /// The same of a start that goes on quickly: on a wall of 24 courses whose crack is as flat as its stagger
    /// the gap was still open (at 1.6e-7) after 40, and closed within 150.
    quick_steps: usize = 150;
    /// Infeasible ones of them until it goes back to a Coulomb state's own forces.
    infeasible: usize = 4;
    /// Largest change of a joint's frozen normal force, in units of the joint, at random or in head
    /// joints. Without it the solver lands in the middle of all mechanisms that are equally good, where
    /// most joints move and the fewest states remain; with it, on one mechanism: 8 of 14 hard scenes
    /// reached the lowest known state, none without.
    change: f64 = 1e-3;
    /// Part of the last gap up to which the quick way goes on from the Coulomb state. On 34 courses of 18 units, with
    /// friction changed by up to 1e-8, one start closes its gap in 12 of 12 runs with 0.8, in 11 with 0.9 and in none
    /// with 0.5: half the way to other forces spoils a gap that falls slowly.
    gap_left: f64 = 0.8;
    /// Part of the way to other normal forces that a step without chance goes.
    part_way: f64 = 0.5;
    /// Largest gap of a collapse state. The judge allows 1e-8; a state must keep away from that.
    closed: f64 = 2e-9;
    /// Shares by which the cost of λ in program (b) is changed to look for the lowest and highest λ
    /// among the states of one mechanism, from large to small. Up to a size that depends on the scene
    /// this leaves the gap closed (an exact penalty), which the gap itself shows.
    cost_changes: [f64; 4] = [1e-2, 1e-3, 1e-4, 1e-5];
    /// How many of these may be passed over, after they were too large on a scene: by the last one alone λ
    /// would be known to 2e-4. On paper-3 in contact a blending start takes 50 programs so, and 70 without.
    too_large: usize = 2;
    /// Starts on a part of a wall that lead to states of the part alone, and to none of the whole wall from
    /// there, until a larger part is searched.
    of_part: usize = 3;
    /// Largest difference of the prices of one mechanism.
    same_prices: f64 = 1e-6;
    /// How far above λ_A a state may lie, relative to that: what the program for λ_A leaves.
    above_bound: f64 = 1e-8;
    /// First states kept: on a part of a wall the highest ones need not be states of the whole wall.
    firsts: usize = 4;
    /// Programs of a search times blocks^`growth`: about 0.8 s for 24 to 40 blocks. Of 122 walls of that size in
    /// contact, 2 end more than 0.1 % above the lowest state that 1,500 starts meet, up to 6 %; 5 did with 16,000 and
    /// a growth of 0.6, some 0.55 as many programs (measured).
    programs: f64 = 58_000.0;
    /// A program's time grows with the blocks by a power of about 1.5 (measured), so that a search's does by 0.7.
    growth: f64 = 0.8;
    /// Programs of a search for each joint at most: a scene of few joints has few states.
    of_joint: usize = 60;
    /// What a program costs with Clarabel, in programs of the structured engine: 3 to 7 times as much
    /// in searches on walls of 28 to 650 blocks (measured).
    clarabel: usize = 4;
    /// Starts are dear where the first one takes more programs than this over blocks^`growth`, whatever
    /// the budget: on walls of 150 blocks and more small steps from the lowest state found more than
    /// further starts did (measured).
    dear: f64 = 5_100.0;
    /// Part of the budget after which dear starts end where two of them ended alike.
    dear_part: f64 = 0.5;
    /// Times the budget that a search gets whose lowest state was met once: others may be missed. With 1.0 and
    /// with 1.5 the same λ come out on 90 walls in contact of 12 to 480 blocks.
    met_once: f64 = 1.2;
}

#[cfg(test)]
mod tests {
    use rayon::prelude::*;

    use super::super::{Request, solve};
    use super::*;
    use crate::answer::Status;
    use crate::method::limit::Associative;
    use crate::method::limit::walls::bonded;
    use crate::method::tuned::Scaled;
    use crate::method::{Method, Settings};
    use crate::scene::Scene;

    impl Scaled for Range {
        fn scaled(&self, by: f64) -> Vec<Self> {
            vec![Range(self.0 * by, self.1 * by)]
        }
    }

    impl Scaled for Decades {
        fn scaled(&self, by: f64) -> Vec<Self> {
            vec![Decades(self.0 + by.log10(), self.1 + by.log10())]
        }
    }

    /// Part of λ by which a lowest state may lie above the stored one: what programs leave, and 0.1 % where
    /// a search of half the programs ends before it meets that of the first wall.
    fn missed(name: &str) -> f64 {
        match name {
            "growth" | "of_joint" => 1.1e-3,
            _ => 1e-6,
        }
    }

    /// Walls with the lowest state that any search found; one start alone misses that of the first.
    fn walls() -> [(Scene, f64); 2] {
        [
            (bonded(&["h11h", "1g1", "h11h", "111"]), 0.604_982_655),
            (bonded(&["1hh", "hh1", "1hh", "hh1"]), 0.380_952_381),
        ]
    }

    /// What is wrong with the answers where one number is multiplied.
    fn faults(&(by, (name, tuned)): &(f64, (&str, Tuned))) -> Vec<String> {
        let settings = Settings::default();
        let request = Request {
            tuned,
            ..Request::of(&settings)
        };
        let faults = walls().into_iter().filter_map(|(scene, lowest)| {
            let outcome = solve(&scene, &request);
            let ceiling = Associative.solve(&scene, &settings).bracket()?.upper;
            let found = outcome.bracket().map_or(f64::INFINITY, |at| at.lower);
            let most = ceiling.min(lowest) * (1.0 + missed(name));
            let is_right = outcome.status == Status::Verified && found <= most;
            (!is_right).then(|| format!("{name} × {by}: {found}, not {lowest}"))
        });
        faults.collect()
    }

    #[test]
    fn lowest_states_do_not_hang_on_tuned_numbers() {
        let each = |by| {
            Tuned::TUNED
                .each_times(by)
                .into_iter()
                .map(move |one| (by, one))
        };
        let each: Vec<_> = [0.5, 2.0].into_iter().flat_map(each).collect();
        let faults: Vec<String> = each.par_iter().flat_map(faults).collect();
        assert!(faults.is_empty(), "{faults:#?}");
    }
}
