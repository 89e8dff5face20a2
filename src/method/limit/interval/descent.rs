//! From normal forces to a collapse state, and down from there.

use super::parameters::Tuned;
use super::search::{Prices, Search, State};
use crate::answer::{SearchFailure, is_same_multiplier};
use crate::method::limit::ending::{Solution, totals};
use crate::method::limit::noise::Noise;
use crate::scene::JointClass;

/// How a search goes on from capacities that leave a gap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Approach {
    /// To the Coulomb state's normal forces where that halves the gap: few programs, and it ends on
    /// higher states.
    Quick,
    /// A random part of the way to the forces of the frozen program, always: more programs, and
    /// lower states.
    Blending,
    /// Nowhere: it ends at a mechanism without states. For normal forces of a state, raised a little.
    Nearby,
}

impl Approach {
    /// Frozen programs until a start is given up.
    fn steps(self, tuned: &Tuned) -> usize {
        match self {
            Approach::Quick => tuned.quick_steps,
            Approach::Blending | Approach::Nearby => tuned.steps,
        }
    }
}

/// The states that one start leads to, of the scene that is searched.
pub(super) struct Branch {
    pub(super) first: State,
    pub(super) lowest: State,
}

/// Whether two states count as one by their λ*.
pub(super) fn is_same(lambda: f64, other: f64) -> bool {
    is_same_multiplier(lambda, other, 1.0)
}

/// Whether a state lies below another one, whose λ is infinite where there is none.
pub(super) fn is_below(lambda: f64, other: f64) -> bool {
    lambda < other && !(other.is_finite() && is_same(lambda, other))
}

/// One start on its way.
pub(super) struct Descent<'a, 'b> {
    pub(super) search: &'a mut Search<'b>,
    pub(super) approach: Approach,
    pub(super) noise: Noise,
    /// λ of states found before; where the start meets one of them it is followed no further.
    pub(super) known: &'a [f64],
}

impl Descent<'_, '_> {
    /// From normal forces to a state, then on from the lowest state of its mechanism until λ stops
    /// falling: (a) gives a mechanism, (b) tells whether it has states. Where it has none the normal
    /// forces are blended, or replaced, by those of (a) or (b).
    pub(super) fn follow(&mut self, mut normal: Vec<f64>) -> Result<Branch, SearchFailure> {
        let tuned = self.search.tuned;
        let mut branch: Option<Branch> = None;
        let mut refused: Option<Refused> = None;
        let mut last_gap = f64::INFINITY;
        let mut infeasible = 0;
        let mut failure = SearchFailure::GapOpen;
        for _ in 0..self.approach.steps(&tuned) {
            let above = match self.frozen(&normal, branch.is_some()) {
                // Inclined joints may need more shear than these capacities give.
                Err(SearchFailure::Infeasible) if infeasible < tuned.infeasible => {
                    infeasible += 1;
                    normal = self.nearer_to_coulomb(&normal, infeasible)?;
                    continue;
                }
                Err(why) => {
                    failure = why;
                    break;
                }
                Ok(above) => above,
            };
            let prices = self.search.prices(&above.velocity);
            let (gap, coulomb) = match refused
                .take_if(|known| known.prices.are_those_of(&prices, tuned.same_prices))
            {
                Some(known) => (known.gap, known.normal),
                None => match self.states_of(&above, &prices) {
                    Ok(Tested::Lowest(state)) => {
                        let Some(state) = self.search.lowest_pushed(state) else {
                            failure = SearchFailure::BelowZero;
                            break;
                        };
                        let lower = branch
                            .as_ref()
                            .is_none_or(|branch| is_below(state.lambda, branch.lowest.lambda));
                        if !lower {
                            break;
                        }
                        normal = totals(&state.forces);
                        let is_known = self.is_known(state.lambda);
                        let first = branch.map_or_else(|| state.clone(), |branch| branch.first);
                        branch = Some(Branch {
                            first,
                            lowest: state,
                        });
                        if is_known {
                            break;
                        }
                        last_gap = f64::INFINITY;
                        continue;
                    }
                    Ok(Tested::None { gap, normal }) => (gap, normal),
                    Err(why) => {
                        failure = why;
                        break;
                    }
                },
            };
            if self.approach == Approach::Nearby {
                break;
            }
            self.search.coulomb_normal = Some(coulomb.clone());
            normal = match self.approach {
                Approach::Quick if gap < tuned.gap_left * last_gap => coulomb.clone(),
                Approach::Quick | Approach::Nearby => {
                    blend(&normal, &totals(&above.forces), tuned.part_way)
                }
                Approach::Blending => blend(&normal, &totals(&above.forces), self.noise.uniform()),
            };
            last_gap = gap;
            refused = Some(Refused {
                prices,
                gap,
                normal: coulomb,
            });
        }
        branch.ok_or(failure)
    }

    /// Program (a), with capacities changed by so little that the state hardly changes: at random, or
    /// raised in the head joints once the quick way has reached a state.
    fn frozen(&mut self, normal: &[f64], has_state: bool) -> Result<Solution, SearchFailure> {
        let mut changed = normal.to_vec();
        let joints = self.search.scene.joints().iter();
        for (j, (joint, n)) in joints.zip(&mut changed).enumerate() {
            let share = match self.approach {
                Approach::Blending => self.noise.between(-1.0, 1.0),
                Approach::Quick if has_state && joint.class == JointClass::Head => 1.0,
                Approach::Quick | Approach::Nearby => continue,
            };
            *n = (*n + self.search.tuned.change * share * self.search.unit(j)).max(0.0);
        }
        self.search.frozen(&changed)
    }

    /// The lowest state of a mechanism, or how far it is from having one.
    ///
    /// Mostly one program tells: with λ's cost lowered by c, gap + c λ is at most c λ_A where the
    /// mechanism has a state.
    fn states_of(&mut self, above: &Solution, prices: &Prices) -> Result<Tested, SearchFailure> {
        let state = |solution| State::new(solution, above.velocity.clone(), prices.clone());
        let Tuned {
            closed,
            cost_changes,
            ..
        } = self.search.tuned;
        let mut changes = &cost_changes[self.search.too_large..];
        // The quick way goes to N of the nearest Coulomb state itself.
        if self.approach != Approach::Quick {
            let change = changes[0];
            changes = &changes[1..];
            let highest = self.search.associative.unwrap_or(f64::INFINITY);
            let most = change * highest + closed;
            let tilted = (self.search).nearest_within(prices, 1.0 - change, most)?;
            let gap = prices.gap(&tilted);
            if gap.abs() <= closed {
                return Ok(Tested::Lowest(state(tilted)));
            }
            if gap + change * tilted.lambda > most {
                let normal = totals(&tilted.forces);
                return Ok(Tested::None { gap, normal });
            }
        }
        // The quick way needs the nearest one where none has no gap either.
        let most = match self.approach {
            Approach::Quick => f64::INFINITY,
            Approach::Blending | Approach::Nearby => closed,
        };
        let below = self.search.nearest_within(prices, 1.0, most)?;
        let gap = prices.gap(&below);
        if gap.abs() > closed {
            let normal = totals(&below.forces);
            return Ok(Tested::None { gap, normal });
        }
        let lowest = (self.search).lowest_of(&above.velocity, prices, changes);
        Ok(Tested::Lowest(lowest.unwrap_or_else(|| state(below))))
    }

    fn is_known(&self, lambda: f64) -> bool {
        self.known.iter().any(|&known| is_same(lambda, known))
    }

    /// Half the way to normal forces that carry a Coulomb state, the whole way at last.
    fn nearer_to_coulomb(
        &mut self,
        normal: &[f64],
        infeasible: usize,
    ) -> Result<Vec<f64>, SearchFailure> {
        let coulomb = match self.search.coulomb_normal.clone() {
            Some(coulomb) => coulomb,
            None => {
                let associative = self.search.associative();
                totals(&associative.map_err(|_| SearchFailure::Unsolved)?.forces)
            }
        };
        Ok(if infeasible == self.search.tuned.infeasible {
            coulomb
        } else {
            blend(normal, &coulomb, self.search.tuned.part_way)
        })
    }
}

/// A mechanism that has no state, the gap that it leaves and the nearest Coulomb state's N.
struct Refused {
    prices: Prices,
    gap: f64,
    normal: Vec<f64>,
}

/// What programs (b) say of a mechanism.
enum Tested {
    /// Its lowest state.
    Lowest(State),
    /// It has none; the gap that is left and N of the nearest Coulomb state.
    None { gap: f64, normal: Vec<f64> },
}

/// Normal forces that lie such a share of the way from some to others.
fn blend(from: &[f64], to: &[f64], share: f64) -> Vec<f64> {
    let both = from.iter().zip(to);
    both.map(|(from, to)| from + share * (to - from)).collect()
}
