//! Where to look next: steps that double, then an extrapolation of how fast too large loads ran
//! away. Nothing here decides anything; it only spares holds.

use super::model::GRID;
use super::parameters::Parameters;

/// What is known about where the limit may be, in grid units of λ*.
#[derive(Clone, Debug)]
pub struct Hint {
    increment: u64,
    /// Loads that ran away, lowest last, and the acceleration with which they did.
    runaways: Vec<(u64, f64)>,
    /// The last step ran away below the estimate: it was too long.
    overshot: bool,
    /// Where another pushover saw the collapse, while nothing here contradicts it.
    expected: Option<[u64; 2]>,
    /// A load that was reached in too long a step to come to rest in time.
    slow: Option<u64>,
    doubt: f64,
    near: f64,
}

impl Hint {
    /// Nothing is known yet but where the limit may be `expected`.
    pub fn new(parameters: &Parameters, expected: Option<[u64; 2]>) -> Self {
        Self {
            increment: (parameters.first_increment * GRID).round() as u64,
            doubt: parameters.doubt,
            near: parameters.near,
            runaways: Vec::new(),
            overshot: false,
            expected,
            slow: None,
        }
    }

    /// The limit that two runaways extrapolate: the acceleration grows with the excess.
    pub fn estimate(&self) -> Option<f64> {
        let [.., (far, fast), (near, slow)] = self.runaways[..] else {
            return None;
        };
        let (far, near) = (far as f64, near as f64);
        let at = near - slow * (far - near) / (fast - slow);
        (slow > 0.0 && fast > slow && at < near).then_some(at)
    }

    /// The lowest load that ran away.
    fn high(&self) -> Option<u64> {
        self.runaways.last().map(|&(load, _)| load)
    }

    /// A load near the limit, as far as known: what the finest step is measured with.
    pub fn near(&self, lower: u64) -> u64 {
        if let Some([from, to]) = self.expected {
            return from.midpoint(to);
        }
        self.high()
            .map_or(lower + self.increment, |high| lower.midpoint(high))
    }

    /// The load to try after a rest at `lower`: no more than `finest` above it where the limit
    /// seems to lie in between, and then so that it lies in the middle.
    pub fn next(&self, lower: u64, finest: u64) -> u64 {
        if let Some(slow) = self.slow {
            let half = (finest / 2).max(1);
            return (lower.midpoint(slow) / half * half).max(lower + half);
        }
        let Some(high) = self.high() else {
            let stop = self.approach(finest).into_iter().flatten();
            let next = stop.into_iter().find(|&stop| stop > lower);
            return next.unwrap_or(lower + self.increment);
        };
        if high - lower <= finest {
            return lower + finest;
        }
        let half = (finest / 2).max(1);
        let middle = (lower.midpoint(high) / half * half).max(lower + half);
        let (low, width) = (lower as f64, finest as f64);
        let estimate = self.estimate().filter(|&at| at > low && !self.overshot);
        let Some(at) = estimate else {
            return middle;
        };
        if at - low <= self.near * width {
            return lower + finest;
        }
        let doubt = (self.doubt * (high as f64 - at)).max(0.5 * width);
        let below = ((at - doubt) / half as f64).round() as u64 * half;
        if below > lower {
            return below;
        }
        let above = ((at + doubt) / half as f64).round() as u64 * half;
        above.clamp(lower + finest, high)
    }

    /// Loads at which to rest on the way to where the limit is expected: not in one step, which
    /// would shake the blocks, and first a little below it.
    fn approach(&self, finest: u64) -> Option<[u64; 6]> {
        let [from, to] = self.expected?;
        let below = from.saturating_sub(2 * finest);
        let part = |of: u64| below / 32 * of / finest * finest;
        let beyond = to.max(from + finest);
        Some([part(16), part(28), part(31), below, from, beyond])
    }

    /// A step to `load` neither rested nor ran away in time: a shorter one sways less.
    pub fn was_slow(&mut self, load: u64) {
        self.slow = Some(load);
    }

    /// The scene rests at `lower`.
    pub fn rested(&mut self, lower: u64, finest: u64) {
        self.overshot = false;
        self.slow = None;
        if let Some([from, to]) = self.expected {
            if lower >= to.max(from + finest) {
                self.expected = None;
                self.increment = 2 * finest;
            }
            return;
        }
        match self.high() {
            None => self.increment = larger(self.increment),
            Some(high) if high <= lower => {
                // It had overshot.
                self.runaways.clear();
                self.increment = finest;
            }
            Some(_) => {}
        }
    }

    /// A step to `load` ran away with this acceleration.
    pub fn ran_away(&mut self, load: u64, acceleration: f64) {
        self.expected = None;
        self.slow = None;
        self.overshot = self.estimate().is_some_and(|at| load as f64 <= at);
        self.runaways.retain(|&(known, _)| known > load);
        self.runaways.push((load, acceleration));
    }
}

/// Largest increment of the series 1, 2, 5, 10, … that is no more than `tolerance` of λ.
pub fn finest_increment(lambda: u64, tolerance: f64) -> u64 {
    let limit = lambda as f64 * tolerance;
    let mut increment = 1;
    while larger(increment) as f64 <= limit {
        increment = larger(increment);
    }
    increment
}

/// The next increment of the series 1, 2, 5, 10, …
fn larger(increment: u64) -> u64 {
    let leading_digit = increment / 10u64.pow(increment.max(1).ilog10());
    match leading_digit {
        2 => increment / 2 * 5,
        _ => increment * 2,
    }
}
