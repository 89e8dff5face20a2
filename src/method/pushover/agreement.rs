//! What levels agree on: the error of a pushover, measured by what shorter substeps change.

use super::model::GRID;
use super::tuned::Tuned;
use crate::answer::{Bracket, magnitude};

/// What one level saw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// Last load at rest, and first that collapsed.
    pub bracket: Bracket,
    /// Displacement up to the last load at rest, in course heights.
    pub drift: f64,
    /// Part of the work of the push that went into motion where the scene fell in a jump: not at a collapse state,
    /// so that levels do not tell how far off. 0 where it did not.
    pub jump: f64,
}

/// What differences between levels of one portion are measured by.
#[derive(Clone, Copy, Debug)]
pub struct Sizes {
    /// λ for a λ* of 1.
    pub unit: f64,
    /// The smaller of width and height, in course heights.
    pub extent: f64,
    /// Whether differences between levels may shrink so slowly that brackets overlap before they are gone.
    pub sways: bool,
}

/// Where levels say that the multiplier lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosure {
    /// The brackets of the last two levels, and what their trend leaves.
    pub bracket: Bracket,
    /// Error that is stated, relative to λ; infinite where none is.
    pub error: f64,
}

/// What the levels agree on. Two suffice where they differ by less than a part of the error that is
/// the `target`; of more the differences have to shrink. Where no further level may follow, an error
/// up to a few times the target is stated.
pub fn agreement(
    levels: &[Level],
    sizes: Sizes,
    target: f64,
    ends: bool,
    tuned: &Tuned,
) -> Option<Enclosure> {
    let [.., before, last] = *levels else {
        return None;
    };
    let size = magnitude(last.bracket.upper, sizes.unit);
    let step = apart(before, last);
    // Where none may follow, the difference itself has to be within the target, and is stated.
    let part = if ends { 1.0 } else { tuned.close };
    let close = step.abs() <= part * target * size;
    let grid = sizes.unit / GRID;
    let shows = !overlap(before.bracket, last.bracket, grid);
    let ratio = shrinkage(levels);
    // Small steps of a scene that sways add up, where they all lead the same way and do not shrink.
    let goes_on = sizes.sways && shows && ratio > tuned.shrinking;
    if goes_on || !(close || ratio.abs() <= tuned.shrinking) {
        return None;
    }
    let ratio = ratio.abs().min(tuned.shrinking);
    let left = match shows {
        true => step * ratio / (1.0 - ratio),
        false if sizes.sways => unresolved(levels, grid),
        false => 0.0,
    };
    // A further level may show what these two do not.
    let complete = ends || shows || left == 0.0;
    let missing = fell_short(levels, sizes, tuned).filter(|by| by.abs() > left.abs());
    let left = missing.unwrap_or(left);
    let bracket = covering(before.bracket, last.bracket, left, grid);
    // The scene collapses elsewhere than where it was laid, with other lever arms. A trend that shows makes up for
    // what contacts deflect.
    let moved = match shows {
        true => slid(before, last).clamp(0.0, last.drift),
        false => last.drift,
    };
    let width = bracket.relative_width(sizes.unit);
    let error = rounded_up(width.max(moved / sizes.extent));
    // No further level sees more than a step of the grid.
    let most = target * if ends { tuned.most_error } else { 1.0 };
    let most = most.max(rounded_up(grid / size));
    let least = least(before, last, sizes, target, tuned);
    // A further level may not jump, and state an error.
    let agrees = complete && error <= most && (ends || least.is_finite());
    let error = error.max(least);
    agrees.then_some(Enclosure { bracket, error })
}

/// The least error that is stated: of a scene that falls in a jump the one that is asked for. A wall that sways
/// states none where a large part of the work went into motion.
fn least(before: Level, last: Level, sizes: Sizes, target: f64, tuned: &Tuned) -> f64 {
    match before.jump.max(last.jump) {
        jump if sizes.sways && jump > tuned.jumping => f64::INFINITY,
        jump if jump > 0.0 => target,
        _ => 0.0,
    }
}

/// Whether the last two levels saw the same bracket and no jump, and differ in deflection alone, which falls by four
/// where one halves the substep of the other: little of how far the scene moved is left for a substep of 0.
pub fn differ_in_deflection(levels: &[Level], tuned: &Tuned) -> bool {
    let [.., before, last] = *levels else {
        return false;
    };
    let same = before.bracket == last.bracket && before.jump.max(last.jump) == 0.0;
    same && slid(before, last) < tuned.creeping * last.drift
}

/// The last levels that fell in one way. Contacts deflect less with a shorter substep: where a scene that sways moved
/// farther before its fall than at the level before, that one had fallen too early, and levels up to it do not count.
pub fn of_one_fall(levels: &[Level], sizes: Sizes, tiny: f64) -> &[Level] {
    let farther = |pair: &[Level]| sizes.sways && pair[1].drift > pair[0].drift + tiny;
    let before = levels.windows(2).rposition(farther);
    &levels[before.map_or(0, |at| at + 1)..]
}

/// How much higher one level lies than another.
fn apart(one: Level, other: Level) -> f64 {
    let middle = |of: Level| of.bracket.lower.midpoint(of.bracket.upper);
    middle(other) - middle(one)
}

/// The last difference as a part of the one before; below 0 where it turns back, infinite without one before.
fn shrinkage(levels: &[Level]) -> f64 {
    match *levels {
        [.., first, before, last] => apart(before, last) / apart(first, before),
        _ => f64::INFINITY,
    }
}

/// What the last two of levels that do not agree saw: states that lie close together. The error is how far the
/// last one moved the ends; where differences grow beyond what may be stated, they have no end in sight.
pub fn wandering(levels: &[Level], sizes: Sizes, target: f64, tuned: &Tuned) -> Option<Enclosure> {
    let [.., first, before, last] = *levels else {
        return None;
    };
    let earlier = first.bracket.hull(before.bracket);
    let bracket = before.bracket.hull(last.bracket);
    let size = magnitude(bracket.upper, sizes.unit);
    let ends = (earlier.lower - bracket.lower).max(bracket.upper - earlier.upper);
    let width = before.bracket.width().max(last.bracket.width());
    let error = rounded_up((ends.max(width) / size).max(last.drift / sizes.extent));
    let grows = shrinkage(levels).abs() > 1.0;
    let covers = error <= tuned.most_error * target || !grows;
    let error = error.max(least(before, last, sizes, target, tuned));
    covers.then_some(Enclosure { bracket, error })
}

/// What may be left of a trend that earlier levels show and the last two, whose brackets overlap or meet, do not.
/// Their middles differ by no more than the wider one's width; as differences halve, what follows is no more either.
fn unresolved(levels: &[Level], grid: f64) -> f64 {
    let differ = |pair: &&[Level]| !overlap(pair[0].bracket, pair[1].bracket, grid);
    let [before, last] = [2, 1].map(|back| levels[levels.len() - back].bracket);
    let width = before.width().max(last.width());
    let trend = |pair: &[Level]| pair[1].bracket.lower - pair[0].bracket.lower;
    let shown = levels.windows(2).rfind(differ);
    shown.map_or(0.0, |pair| width.copysign(trend(pair)))
}

/// What is left to where the levels before the last one led, where the last one of a scene that sways turns back, or
/// falls short of it: it fell early, or at another state, and does not tell that their trend has ended.
fn fell_short(levels: &[Level], sizes: Sizes, tuned: &Tuned) -> Option<f64> {
    let [.., first, before, last] = *levels else {
        return None;
    };
    let (step, back) = (apart(first, before), apart(before, last));
    // Of three levels nothing tells by how much differences shrink.
    let ratio = match levels.len() {
        3 => tuned.shrinking,
        all => shrinkage(&levels[..all - 1]).abs(),
    };
    // Where differences did not shrink, only a level that turns back falls short.
    if ratio > tuned.shrinking && step * back >= 0.0 {
        return None;
    }
    let ratio = ratio.min(tuned.shrinking);
    let left = step * ratio / (1.0 - ratio) - back;
    let shows = left.abs() > before.bracket.width().max(last.bracket.width());
    (sizes.sways && shows && step * left > 0.0).then_some(left)
}

/// How far the scene slides before it collapses, in course heights: what is left of how far it moved without
/// deflections, which fall by four from one level to the other.
fn slid(before: Level, last: Level) -> f64 {
    (4.0 * last.drift - before.drift) / 3.0
}

/// Whether brackets overlap or meet: they show no trend.
fn overlap(before: Bracket, last: Bracket, grid: f64) -> bool {
    let tiny = grid / 2.0;
    before.lower < last.upper + tiny && last.lower < before.upper + tiny
}

/// Both brackets, and the last one moved on by what the trend leaves; the ends on the grid.
fn covering(before: Bracket, last: Bracket, left: f64, grid: f64) -> Bracket {
    let lower = before.lower.min(last.lower + left.min(0.0));
    let upper = before.upper.max(last.upper + left.max(0.0));
    let on_grid = |steps: f64| steps / GRID * (grid * GRID);
    // Ends that are on the grid stay where they are in spite of rounding.
    let rounding = |at: f64| 1e-6 * (at / grid).max(1.0);
    Bracket {
        lower: on_grid((lower / grid + rounding(lower)).floor()).max(0.0),
        upper: on_grid((upper / grid - rounding(upper)).ceil()),
    }
}

/// The smallest number of the series 1, 2, 3, 5, 10, … times 1e-4 that is no less.
pub fn rounded_up(error: f64) -> f64 {
    // 1e-9 is rounding.
    let units = (error * 1e4 * (1.0 - 1e-9)).ceil().clamp(1.0, 1e4) as u64;
    let digit = 10u64.pow(units.ilog10());
    let series = [1, 2, 3, 5, 10].map(|first| first * digit);
    let rounded = series.into_iter().find(|&number| number >= units);
    rounded.unwrap_or(units) as f64 / 1e4
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZES: Sizes = Sizes {
        unit: 1.0,
        extent: 9.0,
        sways: false,
    };

    fn at(lower: f64, upper: f64, drift: f64) -> Level {
        let bracket = Bracket { lower, upper };
        Level {
            bracket,
            drift,
            jump: 0.0,
        }
    }

    /// Figures that were seen on paper-1 and on a wall with a load on top.
    #[test]
    fn levels_agree_where_their_differences_shrink() {
        let agree = |levels: &[Level]| agreement(levels, SIZES, 2e-3, false, &Tuned::TUNED);
        assert_eq!(agree(&[at(0.5, 0.5002, 1e-3)]), None);
        let paper_1 = [at(0.63975, 0.64025, 3.8e-3), at(0.63975, 0.64, 1e-3)];
        let found = agree(&paper_1).unwrap();
        assert_eq!(found.bracket, paper_1[0].bracket);
        assert_eq!(found.error, 1e-3);
        let top_heavy = [(0.5043, 7.7e-3), (0.513, 2.7e-3), (0.5131, 7e-4)];
        let top_heavy = top_heavy.map(|(lower, drift)| at(lower, lower + 2e-4, drift));
        assert_eq!(agree(&top_heavy[..2]), None);
        let (lower, upper) = (0.513, 0.5133);
        assert_eq!(agree(&top_heavy).unwrap().bracket, Bracket { lower, upper });
    }

    /// Two levels agree at once within a quarter of the error asked for: 0.2 % of 0.5 is 1e-3.
    #[test]
    fn two_levels_agree_within_a_quarter_of_the_target() {
        let second = |apart: f64| [at(0.5, 0.5001, 1e-3), at(0.5 + apart, 0.5001 + apart, 1e-3)];
        let agree = |apart| agreement(&second(apart), SIZES, 2e-3, false, &Tuned::TUNED).is_some();
        assert!(agree(2.0e-4));
        assert!(!agree(3.0e-4));
        // A bracket as wide as the grid, 1 % of 1e-3: no level sees more.
        let of_grid = [at(5.3e-4, 5.4e-4, 1e-4); 2];
        let found = agreement(&of_grid, SIZES, 2e-3, false, &Tuned::TUNED);
        assert_eq!(found.unwrap().error, 1e-2);
        assert_eq!([0.0, 3e-4, 2.3e-3].map(rounded_up), [1e-4, 3e-4, 3e-3]);
    }

    /// Brackets that agree, of a scene that slides along before it collapses.
    #[test]
    fn a_drift_that_stays_is_no_agreement() {
        let levels = [at(0.2414, 0.2415, 0.079), at(0.2414, 0.2415, 0.111)];
        assert_eq!(agreement(&levels, SIZES, 2e-3, true, &Tuned::TUNED), None);
    }

    /// 60 courses of 4 x 1.75, whose limit is 0.43500: the last two brackets are the same, and 0.2 % too low.
    #[test]
    fn a_trend_that_brackets_no_longer_show_is_stated() {
        let sways = Sizes {
            sways: true,
            extent: 60.0,
            ..SIZES
        };
        let (two, one) = (at(0.4335, 0.434, 0.1), at(0.4335, 0.434, 0.03));
        let levels = [at(0.431, 0.4315, 0.4), at(0.433, 0.4335, 0.3), two, one];
        let found = agreement(&levels, sways, 3e-3, true, &Tuned::TUNED).unwrap();
        let (lower, upper) = (0.4335, 0.4345);
        assert_eq!(found.bracket, Bracket { lower, upper });
        assert_eq!(found.error, 3e-3);
        assert_eq!(agreement(&levels, sways, 3e-3, false, &Tuned::TUNED), None);
        let without = agreement(&levels[2..], sways, 3e-3, true, &Tuned::TUNED).unwrap();
        assert_eq!(without.bracket, two.bracket);
    }

    /// A wall of 30 courses whose lowest collapse state is 0.3650, with a friction of 0.6581 and of 0.6580.
    #[test]
    fn a_level_that_turns_back_or_falls_short_does_not_end_a_trend() {
        for last in [0.3632, 0.3637] {
            let lower = [0.3500, 0.3606, 0.3635, last];
            let levels = lower.map(|lower| at(lower, lower + 2e-4, 0.01));
            let covers = |sways| {
                let sizes = Sizes { sways, ..SIZES };
                let found = agreement(&levels, sizes, 2e-3, true, &Tuned::TUNED).unwrap();
                found.bracket.upper * (1.0 + found.error) > 0.3650
            };
            assert!(covers(true) && !covers(false), "{last}");
        }
    }

    /// Drifts of paper-3, and of a wall of 20 × 48 units whose third level lies 0.1 % higher.
    #[test]
    fn deflection_falls_with_the_square_of_the_substep() {
        let two = |lower, jump, drifts: [f64; 2]| {
            let before = at(0.5405, 0.5415, drifts[0]);
            let last = at(lower, 0.5415, drifts[1]);
            differ_in_deflection(&[Level { jump, ..before }, last], &Tuned::TUNED)
        };
        assert!(two(0.5405, 0.0, [0.231, 0.0586]));
        assert!(!two(0.5405, 0.0, [0.345, 0.1121]));
        assert!(!two(0.5405, 9e-3, [0.231, 0.0586]));
        assert!(!two(0.5410, 0.0, [0.231, 0.0586]));
    }

    /// A wall of 34 courses, levels 0.3495, 0.3515, 0.3615, 0.3625 and 0.3635, whose lowest collapse state is 0.3726.
    #[test]
    fn levels_of_another_fall_and_small_steps_that_go_on_do_not_agree() {
        let levels = [0.007, 0.081, 0.203, 0.115].map(|drift| at(0.36, 0.3605, drift));
        let going_on = [0.3615, 0.3625, 0.3635].map(|lower| at(lower, lower + 5e-4, 0.01));
        for sways in [false, true] {
            let sizes = Sizes { sways, ..SIZES };
            let alike = [2, 3, 4].map(|seen| of_one_fall(&levels[..seen], sizes, 0.01).len());
            assert_eq!(alike, if sways { [1, 1, 2] } else { [2, 3, 4] });
            let agreed = agreement(&going_on, sizes, 3e-3, true, &Tuned::TUNED);
            assert_eq!(agreed.is_none(), sways);
        }
    }

    /// Rubble that falls 0.13 % below its lowest state at every substep, and a wall of 34 courses, 2.8 %.
    #[test]
    fn levels_of_a_scene_that_falls_in_a_jump_state_what_was_asked_or_nothing() {
        let level = at(0.4026, 0.4028, 2.3e-3);
        let stated = |sways, jump| {
            let levels = [level, level, Level { jump, ..level }];
            let sizes = Sizes { sways, ..SIZES };
            let agreed = agreement(&levels, sizes, 2e-3, true, &Tuned::TUNED).unwrap();
            let covered = wandering(&levels, sizes, 2e-3, &Tuned::TUNED).unwrap();
            assert_eq!(agreed.error, covered.error);
            agreed.error
        };
        assert_eq!([0.0, 0.02].map(|jump| stated(false, jump)), [5e-4, 2e-3]);
        let swaying = [0.0, 0.009, 0.02].map(|jump| stated(true, jump));
        assert_eq!(swaying, [5e-4, 2e-3, f64::INFINITY]);
    }

    #[test]
    fn a_trend_is_followed_to_its_end() {
        let levels = [(0.49, 4e-3), (0.496, 1e-3), (0.499, 2e-4)];
        let levels = levels.map(|(lower, drift)| at(lower, lower + 2e-4, drift));
        assert_eq!(agreement(&levels, SIZES, 2e-3, false, &Tuned::TUNED), None);
        let found = agreement(&levels, SIZES, 4e-3, true, &Tuned::TUNED).unwrap();
        let (lower, upper) = (0.496, 0.5022);
        assert_eq!(found.bracket, Bracket { lower, upper });
        assert_eq!(found.error, 2e-2);
    }

    /// Rubble in contact whose collapse states lie close together, and one whose levels have no end in sight.
    #[test]
    fn levels_that_wander_state_how_far() {
        let levels = |brackets: [f64; 4]| brackets.map(|lower| at(lower, lower + 2e-4, 1e-3));
        let seen = levels([0.3516, 0.3516, 0.4050, 0.3517]);
        let covered = |levels: &[Level]| wandering(levels, SIZES, 2e-3, &Tuned::TUNED);
        let found = covered(&seen).unwrap();
        assert_eq!((found.bracket.lower, found.error), (0.3517, 5e-4));
        let seen = levels([0.3437, 0.3437, 0.3765, 0.4455]);
        assert_eq!(covered(&seen), None);
        assert_eq!(covered(&seen[..2]), None);
    }
}
