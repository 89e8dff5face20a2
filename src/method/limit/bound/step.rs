//! One step of the interior point: predicted, corrected, and where that leads nowhere, towards the centre.

use nalgebra::DMatrix;

use super::lifted::{Lifted, Residual};
use super::newton::Newton;
use super::point::{Lengths, Point};

/// A program's conditions about a point, linear in the step.
pub(super) struct Linearised<'a> {
    program: &'a Lifted<'a>,
    at: &'a Point,
    residual: &'a Residual,
    weights: Weights,
    /// Products times multipliers.
    product: DMatrix<f64>,
    /// Whether the weights cannot be softened any more.
    is_softest: bool,
}

/// How multipliers follow products.
struct Weights {
    /// Change of a product for a change of its multiplier.
    softness: f64,
    /// What holds the unknowns.
    held: f64,
    /// 1 / (product + softness · multiplier), and that times the multiplier.
    softened: DMatrix<f64>,
    values: DMatrix<f64>,
}

/// What a step is to do.
struct Aim {
    /// Changes of product times multiplier, and of the scale condition's.
    wanted: DMatrix<f64>,
    of_scale: f64,
    /// Share that it takes back of what the conditions and the identity leave.
    taken: f64,
}

impl<'a> Linearised<'a> {
    /// With softness and hold that many times larger than they are at first.
    pub(super) fn new(
        program: &'a Lifted<'a>,
        at: &'a Point,
        residual: &'a Residual,
        softer: f64,
    ) -> Self {
        let own = program.products.parameters();
        let of_mean =
            |[share, least, most]: [f64; 3]| softer * (share * residual.mean).clamp(least, most);
        let softness = of_mean(own.softness);
        let soften = |product, multiplier| 1.0 / (product + softness * multiplier);
        let softened = at.products.zip_map(&at.multipliers, soften);
        let mut values = at.multipliers.component_mul(&softened);
        for (value, is_zero) in values.iter_mut().zip(&program.is_zero) {
            if *is_zero {
                *value = 1.0 / softness;
            }
        }
        let weights = Weights {
            softness,
            held: of_mean(own.hold),
            softened,
            values,
        };
        Self {
            program,
            at,
            residual,
            weights,
            product: at.products.component_mul(&at.multipliers),
            is_softest: softer >= own.softest,
        }
    }

    /// Mehrotra's step, drawn to the centre, and how far it goes. None where rounding spoils its linear system,
    /// so that a softer one is to be tried.
    pub(super) fn corrected(&self) -> Option<(Point, Lengths)> {
        let (program, at, mean) = (self.program, self.at, self.residual.mean);
        let own = program.products.parameters();
        let scale = at.scale[1] / at.scale[0];
        let weights = &self.weights;
        let newton = Newton::new(&program.products, &weights.values, scale, weights.held);
        let scaled = at.scale[0] * at.scale[1];
        let straight = Aim {
            wanted: -&self.product,
            of_scale: -scaled,
            taken: 1.0,
        };
        let (predicted, _) = self.step(&newton, &straight, own.predicted_to);
        let lengths = program.lengths(at, &predicted);
        let after = at.sum_behind(&predicted, lengths, &program.is_zero);
        // Mehrotra cubes this; what that is worth stands with `left_behind`.
        let share = (after / program.count / mean).powi(2);
        let bent = predicted.products.component_mul(&predicted.multipliers);
        let of_scale = -scaled - predicted.scale[0] * predicted.scale[1];
        let aim = self.towards(-&self.product - bent, of_scale, share);
        let (step, left) = self.step(&newton, &aim, own.solved_to);
        if left > own.unsolved && !self.is_softest {
            return None;
        }
        let corrected = self.drawn_to_centre(&newton, step, aim, share * mean);
        let reach = program.lengths(at, &corrected);
        if reach[0].min(reach[1]) >= own.short_step {
            return Some((corrected, reach));
        }
        // A correction that leads nowhere: back towards the centre.
        let aim = self.towards(-&self.product, -scaled, own.centre);
        let (step, _) = self.step(&newton, &aim, own.solved_to);
        let centred = self.drawn_to_centre(&newton, step, aim, own.centre * mean);
        let other = program.lengths(at, &centred);
        if other[0].min(other[1]) > reach[0].min(reach[1]) {
            Some((centred, other))
        } else {
            Some((corrected, reach))
        }
    }

    /// A step whose products with multipliers are drawn towards the centre where a longer one would leave
    /// them far off, as long as that makes it longer (Gondzio, Comput. Optim. Appl. 6 (1996) 137-156). The
    /// factor is there already, so that each correction is one more solution.
    fn drawn_to_centre(
        &self,
        newton: &Newton,
        mut step: Point,
        mut aim: Aim,
        centre: f64,
    ) -> Point {
        let (program, at) = (self.program, self.at);
        let own = program.products.parameters();
        let range = [own.near_centre * centre, centre / own.near_centre];
        let mut reach = program.lengths(at, &step);
        for _ in 0..own.corrections {
            let [primal, dual] = reach.map(|length| (length + own.longer).min(1.0));
            let missing = |[product, by]: [f64; 2], [multiplier, dual_by]: [f64; 2]| {
                let reached = (product + primal * by) * (multiplier + dual * dual_by);
                (reached.clamp(range[0], range[1]) - reached).max(-range[1])
            };
            let mut wanted = aim.wanted.clone();
            for (k, wanted) in wanted.iter_mut().enumerate() {
                if !program.is_zero[k] {
                    let product = [at.products[k], step.products[k]];
                    *wanted += missing(product, [at.multipliers[k], step.multipliers[k]]);
                }
            }
            let [first, second] = [0, 1].map(|k| [at.scale[k], step.scale[k]]);
            let other = Aim {
                wanted,
                of_scale: aim.of_scale + missing(first, second),
                ..aim
            };
            let (drawn, _) = self.step(newton, &other, own.solved_to);
            let longer = program.lengths(at, &drawn);
            let sum = |lengths: Lengths| lengths[0].min(1.0) + lengths[1].min(1.0);
            if sum(longer) < sum(reach) + own.worth * own.longer {
                break;
            }
            (step, aim, reach) = (drawn, other, longer);
        }
        step
    }

    /// What changes product times multiplier like this and draws it towards this share of the mean. A step that is
    /// drawn to the centre takes less of what the conditions leave, so that products do not vanish before that.
    fn towards(&self, mut wanted: DMatrix<f64>, of_scale: f64, share: f64) -> Aim {
        let centre = share * self.residual.mean;
        for (wanted, is_zero) in wanted.iter_mut().zip(&self.program.is_zero) {
            *wanted = if *is_zero { 0.0 } else { *wanted + centre };
        }
        let left = self.program.products.parameters().left_behind;
        Aim {
            wanted,
            of_scale: of_scale + centre,
            taken: 1.0 - left * share.min(1.0),
        }
    }

    /// The step of this aim, whose linear system is to leave this share of its right side, or what does not count
    /// beside what multipliers leave of the identity now; also the share that it leaves.
    fn step(&self, newton: &Newton, aim: &Aim, left: f64) -> (Point, f64) {
        let (program, at, residual) = (self.program, self.at, self.residual);
        let Weights {
            softness,
            softened,
            values,
            ..
        } = &self.weights;
        // What multipliers become where products do not move.
        let violated = &residual.products * aim.taken;
        let mut target = aim.wanted.component_mul(softened);
        target -= values.component_mul(&violated);
        let missing = program.is_zero.iter().zip(&violated);
        for (target, (is_zero, missing)) in target.iter_mut().zip(missing) {
            if *is_zero {
                *target = -missing / softness;
            }
        }
        let scale = residual.scale * aim.taken;
        let of_scale = aim.of_scale / at.scale[0] - at.scale[1] / at.scale[0] * scale;
        let mut right = program.products.transposed(&target);
        right -= &residual.identity * aim.taken;
        right -= &program.scale_row * of_scale;
        let own = program.products.parameters();
        // What counts as unsolved is not borne.
        let bearable = (own.solved_of_left * residual.left).min(own.unsolved * right.amax());
        let (unknowns, left) = newton.solve(&right, [bearable, left]);
        let moved = program.products.of(&unknowns);
        let multipliers = target - values.component_mul(&moved);
        let mut products = moved + violated + &multipliers * *softness;
        for (product, is_zero) in products.iter_mut().zip(&program.is_zero) {
            if *is_zero {
                *product = 0.0;
            }
        }
        let work = program.products.work(&unknowns);
        let first = scale - work;
        let second = of_scale + at.scale[1] / at.scale[0] * work;
        let step = Point {
            unknowns,
            products,
            multipliers,
            scale: [first, second],
        };
        (step, left)
    }
}
