//! The conclusion as a sentence.

use std::fmt;

use super::conclusion::{Basis, Conclusion};
use super::reaction;
use crate::answer::{LimitFact, Status, is_same_multiplier, magnitude, reaction_floor};
use crate::number::{above, number, percent};
use crate::scene::Push;

impl Conclusion {
    /// λ with the digits that the status vouches for.
    fn lambda(&self) -> String {
        self.bracket.map_or_else(String::new, |bracket| {
            let ends = [bracket.lower, bracket.upper];
            let [low, high] = ends.map(|end| number(end, self.decimals()));
            if low == high {
                low
            } else {
                format!("{low} - {high}")
            }
        })
    }

    /// What the side that does not govern comes to, and by how much this one governs.
    fn write_other(&self, f: &mut fmt::Formatter<'_>, other: &Conclusion) -> fmt::Result {
        let [push, to] = [self.push, other.push].map(Push::name);
        let (by, status) = (other.methods.join(", "), other.status.name());
        if let Some((least, next)) = self.collapse_known().zip(other.collapse_known()) {
            if is_same_multiplier(least, next, self.multiplier_unit) {
                return write!(f, "; pushed to the {to}, λ is the same ({status}, {by})");
            }
            let share = percent((next - least) / magnitude(next, self.multiplier_unit));
            let at = match other.basis {
                Basis::UpperBound => format!("λ is at most {}", above(next, 5)),
                _ => format!("λ = {}", other.lambda()),
            };
            return write!(
                f,
                "; that is the push to the {push}, which governs by {share}: to the {to} {at} ({status}, {by})"
            );
        }
        write!(f, "; that is the push to the {push}, and to the {to} ")?;
        match other.basis {
            Basis::Stands => write!(f, "it stands ({by})"),
            Basis::Falls => write!(f, "it falls under its own weight ({by})"),
            Basis::NoneFound => write!(f, "no collapse state was found ({by})"),
            _ => write!(f, "there is no answer, so that the wall may be weaker"),
        }
    }

    /// The best answer, and whose it is.
    fn best(&self) -> String {
        let (by, status, lambda) = (self.methods.join(", "), self.status.name(), self.lambda());
        match (self.basis, &self.reaction) {
            (Basis::NoneFound, _) => {
                format!("no collapse state was found ({by}), which does not prove that none exists")
            }
            (Basis::Nothing, _) if by.is_empty() => "there is no answer".to_owned(),
            (Basis::Nothing, _) => format!("there is no answer ({by})"),
            (_, Some(reaction)) => reaction::best(self, reaction),
            (Basis::Falls, _) => format!("it falls under its own weight ({by})"),
            (Basis::LowestState, _) => {
                let others = self.highest_state.map_or_else(String::new, |highest| {
                    format!(", and others were found up to {}", number(highest, 5))
                });
                let seen = self.seen(&|lambda| number(lambda, 5));
                let at_rest = match self.bracket {
                    Some(bracket) if bracket.lower == 0.0 => format!("; {}", LimitFact::AtRest),
                    _ => String::new(),
                };
                let rest = match self.is_rest_undecided {
                    true => ", which is undecided about how far other states reach",
                    false => "",
                };
                format!(
                    "λ = {lambda} is {status}: it is the lowest collapse state found \
                     ({by}{rest}){others}{seen}{at_rest}"
                )
            }
            (Basis::Stands, _) => format!("it stands: no push is too large for it ({by})"),
            (Basis::UpperBound, _) => {
                let upper = self.bracket.map_or(f64::NAN, |bracket| bracket.upper);
                let upper = above(upper, 5);
                format!(
                    "λ is at most {upper}, which is {status} ({by}); no collapse state is verified"
                )
            }
            (Basis::Observed, _) => format!(
                "λ = {lambda} is {status}, as the simulation shows ({by}); nothing is proved"
            ),
            (Basis::Estimate, _) => {
                format!("λ = {lambda} is an {status} ({by}); nothing is proved")
            }
        }
    }

    /// What a simulation saw, where people read this number for each λ.
    pub(super) fn seen(&self, reads: &dyn Fn(f64) -> String) -> String {
        self.seen.as_ref().map_or_else(String::new, |seen| {
            let [one, other] = [seen.bracket.lower, seen.bracket.upper].map(reads);
            let by = &seen.by;
            format!("; {by} saw {one} to {other}, which is not their range")
        })
    }

    /// Decimals that the status vouches for.
    pub(super) fn decimals(&self) -> usize {
        if self.status == Status::Estimate {
            4
        } else {
            5
        }
    }
}

impl fmt::Display for Conclusion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.best())?;
        if let Some(floor) = &self.floor {
            let words = match &self.reaction {
                Some(reaction) => reaction_floor(reaction, floor.lower, floor.cap),
                None => floor.to_string(),
            };
            write!(f, "; it is proved that {words} ({})", floor.by)?;
        }
        if let Some(difference) = &self.difference {
            let words = match &self.reaction {
                Some(reaction) => reaction::difference(difference, reaction),
                None => difference.to_string(),
            };
            write!(f, "; {words}")?;
        }
        if let Some(reaction) = self.reaction.as_ref().filter(|_| self.bracket.is_some()) {
            write!(f, "; {}", reaction::start(reaction))?;
        }
        let other = self.other.as_deref().filter(|_| self.basis != Basis::Falls);
        if let Some(other) = other {
            self.write_other(f, other)?;
        }
        let doubts = self.doubts.iter().map(|doubt| match &self.reaction {
            Some(reaction) => reaction::doubt(self, doubt, reaction),
            None => doubt.to_string(),
        });
        // Sides alike have the same doubts.
        let others = other.iter().flat_map(|other| {
            let push = other.push.name();
            let doubts = other.doubts.iter();
            let doubts = doubts.filter(|doubt| !self.doubts.contains(doubt));
            doubts.map(move |doubt| format!("pushed to the {push}, {doubt}"))
        });
        let doubts: Vec<String> = doubts.chain(others).collect();
        if !doubts.is_empty() {
            write!(f, "; NOT EXPLAINED: {}", doubts.join(", "))?;
        }
        Ok(())
    }
}
