//! Where the interior point of a slice begins: all products alike, or at a point of the last slice of its branch.
//!
//! Slices of one branch differ in their ends and in what is assumed. What multipliers leave of the identity hardly
//! changes with either: products that are zero by a further assumption have none, and
//!
//! ```text
//! m (λ − a) + n (b − λ) = (m − d)(λ − a') + (n − d)(b' − λ) + ((a' − a) m + (b − b') n + (b' − a') d) · 1
//! ```
//!
//! for any d. So the next slice begins at a point of the last one that is far from its optimum, where no product is
//! near zero yet (Gondzio, Math. Prog. 83 (1998) 125-143). Products that its ends make negative are moved away from
//! zero; what that violates is taken back step by step.

use nalgebra::DMatrix;

use super::lifted::Lifted;
use super::point::Point;

/// A point on the way to the optimum of a slice.
#[derive(Clone, Debug)]
pub(super) struct Halfway {
    /// All forces times all motions: the lifted unknowns whatever is assumed.
    lifted: DMatrix<f64>,
    products: DMatrix<f64>,
    multipliers: DMatrix<f64>,
    is_zero: Vec<bool>,
    ends: [f64; 2],
    /// The bound, and what is left of the scale condition.
    sigma: f64,
    slack: f64,
    /// Mean of product times multiplier.
    mean: f64,
}

impl Lifted<'_> {
    /// A point, for other slices to begin at.
    pub(super) fn halfway(&self, at: &Point, mean: f64) -> Halfway {
        let face = self.products.face;
        let lifted = &face.basis * &at.unknowns;
        Halfway {
            lifted: face.motion.all(&lifted),
            products: at.products.clone(),
            multipliers: at.multipliers.clone(),
            is_zero: self.is_zero.clone(),
            ends: [self.request.from, self.request.to],
            sigma: self.request.most - at.scale[1],
            slack: at.scale[0],
            mean,
        }
    }

    /// Where it begins: at this point, unless that has too many other rates or is too far off the centre here.
    pub(super) fn start(&self, halfway: Option<&Halfway>) -> Point {
        let own = self.products.parameters();
        let alike = halfway.filter(|halfway| self.other_rates(halfway) <= own.other_rates);
        let point = alike.map(|halfway| (self.start_at(halfway), own.off_centre * halfway.mean));
        let near = point.filter(|(point, most)| self.residual(point).mean < *most);
        near.map_or_else(|| self.start_alike(), |(point, _)| point)
    }

    /// Share of the rates that are zero or left out here and were not there, or the other way round.
    fn other_rates(&self, halfway: &Halfway) -> f64 {
        let rows = halfway.products.nrows();
        // The condition 1 is never zero, so that its products tell of the rates.
        let is_other = |rate: &usize| {
            let k = rate * rows + rows - 3;
            self.is_zero[k] != halfway.is_zero[k]
        };
        let rates = 0..halfway.products.ncols();
        rates.clone().filter(is_other).count() as f64 / rates.len() as f64
    }

    /// All products and multipliers that need not be zero are the same: one over the number of joints. Forces are of
    /// that size, as parts of the total weight. Multipliers are too, as terms of many joints add up to the power.
    fn start_alike(&self) -> Point {
        let (rows, rates) = (
            self.products.conditions.nrows(),
            self.products.face.motion.rows.len(),
        );
        let lift = self.products.face.lift;
        let all = lift.parameters.start / lift.joints() as f64;
        let start = self.is_zero.iter();
        let start = start.map(|&is_zero| if is_zero { 0.0 } else { all });
        let start = DMatrix::from_iterator(rows, rates, start);
        Point {
            unknowns: self.products.face.zero(),
            products: start.clone(),
            multipliers: start,
            scale: [1.0, 1.0],
        }
    }

    /// At a point of another slice.
    fn start_at(&self, halfway: &Halfway) -> Point {
        let face = self.products.face;
        let unknowns = face.motion.left_of(&face.basis.tr_mul(&halfway.lifted));
        let mut products = self.products.of(&unknowns);
        let mut multipliers = halfway.multipliers.clone();
        self.move_ends(halfway, &products, &mut multipliers);
        let least = self.products.parameters().least_at_start * halfway.mean;
        for (k, (product, multiplier)) in products.iter_mut().zip(&mut multipliers).enumerate() {
            match (self.is_zero[k], halfway.is_zero[k]) {
                (true, was_zero) => {
                    *product = 0.0;
                    *multiplier *= f64::from(was_zero);
                }
                (false, true) => {
                    *product = product.max(halfway.mean.sqrt());
                    *multiplier = halfway.mean / *product;
                }
                (false, false) => *product = product.max(least / *multiplier),
            }
        }
        let of_scale = self.request.most - halfway.sigma;
        let scale = [halfway.slack, of_scale.max(halfway.mean / halfway.slack)];
        Point {
            unknowns,
            products,
            multipliers,
            scale,
        }
    }

    /// Moves what λ − a and b − λ are multiplied with to other ends, with the least d that leaves 1 a multiplier.
    fn move_ends(
        &self,
        halfway: &Halfway,
        products: &DMatrix<f64>,
        multipliers: &mut DMatrix<f64>,
    ) {
        let ([a, b], [from, to]) = (halfway.ends, [self.request.from, self.request.to]);
        let one = products.nrows() - 3;
        let least = self.products.parameters().least_at_start * halfway.mean;
        for rate in 0..products.ncols() {
            let is_zero = |row: usize| {
                let k = row + rate * products.nrows();
                self.is_zero[k] || halfway.is_zero[k]
            };
            if is_zero(one) {
                continue;
            }
            let own = |row: usize| multipliers[(row, rate)];
            let [of_one, above, below] = [own(one), own(one + 1), own(one + 2)];
            let least = least / products[(one, rate)].max(halfway.products[(one, rate)]);
            let least = least.min(of_one);
            let of_one = of_one + (from - a) * above + (b - to) * below;
            // Neither of the two others is used up.
            let d = ((least - of_one) / (to - from)).clamp(0.0, 0.9 * above.min(below));
            multipliers[(one, rate)] = (of_one + d * (to - from)).max(least);
            multipliers[(one + 1, rate)] = above - d;
            multipliers[(one + 2, rate)] = below - d;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::face::Face;
    use super::super::interior_point::solve;
    use super::super::lift::Lift;
    use super::super::lifted::Request;
    use super::super::parameters::Parameters;
    use super::*;
    use crate::certificate::{Assumption, Conditions, Factor, LongestWay};
    use crate::method::limit::walls::{LOWEST_OF_SMALL_WALL as LOWEST, small_wall};
    use crate::scene::HeadJoints;

    fn lift() -> Lift {
        let scene = small_wall(HeadJoints::Contact);
        let conditions = Conditions::of(&scene).with_slip_bounds(&scene, LongestWay::ThreeJoints);
        Lift::new(conditions, Parameters::TUNED).unwrap()
    }

    fn request(from: f64, to: f64) -> Request {
        let own = Parameters::TUNED;
        Request {
            from,
            to,
            enough: to,
            most: 1.1 * to,
            steps: 100,
            exact: false,
            left: own.left,
        }
    }

    /// At a point of another slice, multipliers leave of the identity what they left there, for narrower ends and
    /// with further assumptions; those of inequalities are positive, for wider ends too.
    #[test]
    fn multipliers_of_one_slice_fit_others() {
        let lift = lift();
        let face = Face::of(&lift, &[], false);
        let first = request(0.2 * LOWEST, 0.8 * LOWEST);
        let (_, halfway) = solve(&face, first, None, &mut |_, _| true);
        let halfway = halfway.expect("it passes the point");
        let program = Lifted::new(&face, first);
        let left = |program: &Lifted| program.residual(&program.start_at(&halfway)).left;
        let before = left(&program);
        let assume = |pair: usize, zero: Factor| Assumption { pair, zero };
        let assumed = [assume(2, Factor::Force), assume(8, Factor::Rate)];
        for assumed in [&[][..], &assumed] {
            let face = Face::of(&lift, assumed, false);
            for ends in [[0.2, 0.8], [0.7, 0.8], [0.2, 0.85]] {
                let [from, to] = ends.map(|end| end * LOWEST);
                let program = Lifted::new(&face, request(from, to));
                let point = program.start_at(&halfway);
                let own = program.residual(&point);
                let is_narrower = to <= first.to;
                let left = own.left;
                assert!(
                    !is_narrower || left < 2.0 * before,
                    "{ends:?}: {left} {before}"
                );
                let pairs = point.products.iter().zip(&point.multipliers);
                let mut pairs = pairs.zip(&program.is_zero);
                assert!(pairs.all(|((p, m), is_zero)| *is_zero || (*p > 0.0 && *m > 0.0)));
            }
        }
    }

    /// A slice that begins at a point of the one below it excludes as much in fewer steps.
    #[test]
    fn a_slice_that_begins_halfway_takes_fewer_steps() {
        let lift = lift();
        let face = Face::of(&lift, &[], false);
        let solved = |[from, to]: [f64; 2], start: Option<&Halfway>| {
            let mut sigma = f64::NAN;
            let request = request(from * LOWEST, to * LOWEST);
            let (steps, halfway) = solve(&face, request, start, &mut |multipliers, _| {
                sigma = multipliers.sigma;
                true
            });
            (steps, halfway.expect("it passes the point"), sigma)
        };
        let (_, halfway, _) = solved([0.0, 0.8], None);
        for ends in [[0.8, 0.9], [0.8, 0.95], [0.8, 0.99]] {
            let (cold, _, own) = solved(ends, None);
            let (steps, _, sigma) = solved(ends, Some(&halfway));
            println!("{ends:?}: {steps} steps to {sigma}, {cold} to {own}");
            assert!(steps + 2 < cold, "{ends:?}: {steps} {cold}");
            let end = ends[1] * LOWEST;
            assert!(sigma > end && own > end, "{ends:?}: {sigma} {own}");
        }
    }
}
