//! A motion without the rates that are zero by assumption: for each of them one unknown gives way.
//!
//! Held at zero by their products alone, such rates leave the lift without an interior: on walls of 16 to
//! 18 blocks slices ended half a per cent below a state that they meet without them.

use nalgebra::DMatrix;

use super::factor::Pattern;
use super::motion::{Motion, combined};
use super::parameters::ROUNDING;
use crate::certificate::Entry;

/// What is left of a motion.
pub(super) struct Reduced {
    /// With the same rates, of which those that are zero have no entries.
    pub(super) motion: Motion,
    /// Which of its unknowns meet in the linear systems.
    pub(super) pattern: Pattern,
    /// Every unknown of the whole motion, in those that are left.
    whole: Vec<Vec<Entry>>,
}

impl Reduced {
    /// Without the rates that are zero. One that follows from others takes no further unknown, and the
    /// power keeps its own.
    pub(super) fn new(motion: &Motion, is_zero: impl Fn(usize) -> bool) -> Self {
        let rates = motion.rows.len();
        let own = (0..motion.unknowns).map(|k| vec![(k, 1.0)]);
        let mut rows: Vec<Vec<Entry>> = motion.rows.iter().cloned().chain(own).collect();
        let mut is_gone = vec![false; motion.unknowns];
        let size = |row: &[Entry]| row.iter().fold(0.0, |most: f64, own| most.max(own.1.abs()));
        for rate in (0..rates).filter(|&rate| is_zero(rate)) {
            let least = ROUNDING.sqrt() * size(&motion.rows[rate]);
            let power = motion.power();
            let may_go = |own: &&Entry| own.1.abs() > least && power.iter().all(|p| p.0 != own.0);
            let largest = rows[rate].iter().filter(may_go);
            let largest = largest.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
            let Some(&(gone, pivot)) = largest else {
                continue;
            };
            is_gone[gone] = true;
            let others = rows[rate].iter().filter(|own| own.0 != gone);
            let instead: Vec<Entry> = others.map(|&(k, value)| (k, -value / pivot)).collect();
            rows[rate].clear();
            let meets = |row: &&mut Vec<Entry>| row.iter().any(|own| own.0 == gone);
            for row in rows.iter_mut().filter(meets) {
                *row = combined(row.iter().copied(), |k| match k == gone {
                    true => instead.clone(),
                    false => vec![(k, 1.0)],
                });
            }
        }
        let mut place = vec![0; motion.unknowns];
        let left = (0..motion.unknowns).filter(|&k| !is_gone[k]);
        let unknowns = left.enumerate().map(|(at, k)| place[k] = at).count();
        for own in rows.iter_mut().flatten() {
            own.0 = place[own.0];
        }
        let whole = rows.split_off(rates);
        let motion = Motion {
            rows,
            power: motion.power,
            unknowns,
        };
        Self {
            pattern: Pattern::new(unknowns, motion.meetings()),
            motion,
            whole,
        }
    }

    /// Columns of the whole motion's unknowns, from those that are left.
    pub(super) fn whole(&self, left: &DMatrix<f64>) -> DMatrix<f64> {
        let mut whole = DMatrix::zeros(left.nrows(), self.whole.len());
        for (mut column, entries) in whole.column_iter_mut().zip(&self.whole) {
            for &(k, value) in entries {
                column.axpy(value, &left.column(k), 1.0);
            }
        }
        whole
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certificate::Conditions;
    use crate::method::limit::bound::orders;
    use crate::method::limit::walls::wall;
    use crate::scene::Push;

    /// Rates that are zero are zero in every motion that is left, and the others are those of the whole.
    #[test]
    fn what_is_left_has_the_rates_of_the_whole() {
        let scene = wall(3, Push::Right);
        let conditions = Conditions::of(&scene).with_slip_bounds(&scene);
        let motion = Motion::with_sums(&conditions, &orders(&scene)[0]);
        let is_zero = |rate: usize| rate % 5 == 1 && rate < conditions.power();
        let reduced = Reduced::new(&motion, is_zero);
        let zeros = (0..motion.rows.len()).filter(|&rate| is_zero(rate)).count();
        assert!(zeros > 5 && reduced.motion.unknowns < motion.unknowns);
        assert!(reduced.motion.unknowns + zeros >= motion.unknowns);
        let left = DMatrix::from_fn(2, reduced.motion.unknowns, |i, k| {
            ((i + 3 * k) as f64).sin()
        });
        let whole = reduced.whole(&left);
        let (own, of_whole) = (reduced.motion.rates(&left), motion.rates(&whole));
        assert!((&own - of_whole).amax() < 1e-10 * whole.amax());
        let zero = (0..motion.rows.len()).filter(|&rate| is_zero(rate));
        assert!(
            zero.map(|rate| own.column(rate).amax())
                .all(|most| most == 0.0)
        );
        let power = own.column(motion.power).amax();
        assert!(power > 0.0, "the push still does work");
    }
}
