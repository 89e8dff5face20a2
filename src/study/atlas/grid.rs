//! A grid: what is varied, on which scenes, against which values.

use crate::answer::{Bracket, magnitude};
use crate::method::{Kind, Settings};
use crate::scene::Scene;

/// A grid over two properties that make methods fail.
pub struct Grid {
    /// A word for file names.
    pub name: &'static str,
    /// What is varied from left to right, with its unit.
    pub x: &'static str,
    /// What is varied from bottom to top, with its unit.
    pub y: &'static str,
    /// The kinds of methods that it says something about; empty: all.
    pub kinds: &'static [Kind],
    /// What it shows, where methods fail in it, and why.
    pub causes: &'static str,
    /// Its cells, row by row.
    pub cells: Vec<GridPoint>,
}

/// A place on a grid: one scene and setting, and what the answer must be.
pub struct GridPoint {
    pub x: String,
    pub y: String,
    pub scene: Scene,
    pub settings: Settings,
    pub known: Known,
}

impl GridPoint {
    pub fn of_scene([x, y]: [String; 2], known: Known, scene: Scene) -> Self {
        Self {
            x,
            y,
            scene,
            settings: Settings::default(),
            known,
        }
    }
}

/// All values, or those of the small atlas.
pub fn chosen<'a, T>(large: bool, all: &'a [T], small: &'a [T]) -> &'a [T] {
    if large { all } else { small }
}

/// A cell for each pair of values, row by row.
pub fn crossed<X: Copy, Y: Copy>(
    xs: &[X],
    ys: &[Y],
    cell: impl Fn(X, Y) -> GridPoint,
) -> Vec<GridPoint> {
    let row = |&y: &Y| xs.iter().map(|&x| cell(x, y)).collect::<Vec<_>>();
    ys.iter().flat_map(row).collect()
}

const EXACT: f64 = 1e-6;

/// Multipliers of a scene from elsewhere than the methods.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Known {
    /// Lowest and highest collapse state known without dilatancy. Others may exist below and
    /// between, unless both are [`Known::associative`].
    pub states: Bracket,
    /// λ_A, which no collapse state exceeds.
    pub associative: f64,
    /// How far these may be off, relative.
    pub accuracy: f64,
}

impl Known {
    /// A multiplier that equilibrium determines, whatever friction does: from a formula.
    pub fn exact(lambda: f64) -> Self {
        Self::within(lambda, EXACT)
    }

    /// One multiplier for friction with and without dilatancy, so accurate.
    pub const fn within(lambda: f64, accuracy: f64) -> Self {
        Self {
            states: Bracket::point(lambda),
            associative: lambda,
            accuracy,
        }
    }

    /// What the same scene has under live loads that are `factor` times as large.
    pub fn under_live(self, factor: f64) -> Self {
        Self {
            states: Bracket {
                lower: self.states.lower / factor,
                upper: self.states.upper / factor,
            },
            associative: self.associative / factor,
            ..self
        }
    }

    /// Whether there are several collapse multipliers.
    fn are_several(&self) -> bool {
        self.states.lower < self.associative
    }

    /// What the answer of such a method is compared with.
    pub fn expected(&self, kind: Kind) -> Bracket {
        match kind {
            Kind::AssociativeBounds => Bracket::point(self.associative),
            Kind::Enclosure => Bracket {
                upper: self.associative,
                ..self.states
            },
            _ => self.states,
        }
    }

    /// Distance of the answer's farther end from what is expected, relative to that. Of several
    /// states, how far the lowest is missed: which is the highest nobody knows.
    pub fn error(&self, kind: Kind, answer: Bracket, unit: f64) -> f64 {
        let expected = self.expected(kind);
        let distance = if kind == Kind::CollapseStates && self.are_several() {
            (answer.lower - expected.lower).max(0.0)
        } else {
            let [low, high] = [answer.lower - expected.lower, answer.upper - expected.upper];
            low.abs().max(high.abs())
        };
        distance / magnitude(expected.lower, unit)
    }

    /// Whether what such a method proves, or saw to within `stated`, can be true.
    pub fn allows(&self, kind: Kind, answer: Bracket, stated: f64, unit: f64) -> bool {
        let slack = (stated + self.accuracy) * magnitude(self.associative, unit);
        let at_most = |end: f64, value: f64| end - slack <= value;
        let at_least = |end: f64, value: f64| end + slack >= value;
        // A state below those known refutes nothing where there are several.
        let is_state = |end: f64| {
            let known = self.are_several() || at_least(end, self.states.lower);
            known && at_most(end, self.associative)
        };
        let Bracket { lower, upper } = answer;
        let bounds = at_least(upper, self.associative);
        match kind {
            Kind::AssociativeBounds => at_most(lower, self.associative) && bounds,
            Kind::Enclosure => is_state(lower) && bounds,
            // A bound below a state: above all known ones it would refute them.
            Kind::LowerBound => at_most(lower, self.states.lower) && is_state(upper),
            Kind::CollapseState | Kind::CollapseStates => is_state(lower) && is_state(upper),
            Kind::ClosedForm | Kind::Observed | Kind::Outside => {
                at_most(lower, self.associative) && at_least(upper, self.states.lower)
            }
        }
    }
}
