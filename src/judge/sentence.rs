//! The conclusion as a sentence.

use std::fmt;

use super::conclusion::{Basis, Conclusion};
use super::reaction;
use crate::answer::{AT_REST, Status, is_same_multiplier, magnitude};
use crate::number::{above, number, percent};
use crate::scene::Push;

impl Conclusion {
    /// λ with the digits that the status vouches for.
    fn lambda(&self) -> String {
        self.bracket.map_or_else(String::new, |bracket| {
            let proved = self.status != Status::Estimate;
            let decimals = if proved { 5 } else { 4 };
            let [low, high] = [bracket.lower, bracket.upper].map(|end| number(end, decimals));
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
}

impl fmt::Display for Conclusion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(reaction) = &self.reaction {
            return reaction::write(f, self, reaction);
        }
        let by = self.methods.join(", ");
        let status = self.status.name();
        let lambda = self.lambda();
        match self.basis {
            Basis::Falls => write!(f, "it falls under its own weight ({by})"),
            Basis::LowestState => {
                write!(
                    f,
                    "λ = {lambda} is {status}: it is the lowest collapse state found ({by})"
                )?;
                if let Some(highest) = self.highest_state {
                    let highest = number(highest, 5);
                    write!(f, ", and others were found up to {highest}")?;
                }
                if let Some(seen) = &self.seen {
                    seen.write(f, &|lambda| number(lambda, 5))?;
                }
                match self.bracket {
                    Some(bracket) if bracket.lower == 0.0 => write!(f, "; {AT_REST}"),
                    _ => Ok(()),
                }
            }
            Basis::Stands => write!(f, "it stands: no push is too large for it ({by})"),
            Basis::UpperBound => {
                let upper = self.bracket.map_or(f64::NAN, |bracket| bracket.upper);
                let upper = above(upper, 5);
                write!(
                    f,
                    "λ is at most {upper}, which is {status} ({by}); no collapse state is verified"
                )
            }
            Basis::Observed => write!(
                f,
                "λ = {lambda} is {status}, as the simulation shows ({by}); nothing is proved"
            ),
            Basis::Estimate => write!(f, "λ = {lambda} is an {status} ({by}); nothing is proved"),
            Basis::NoneFound => write!(
                f,
                "no collapse state was found ({by}), which does not prove that none exists"
            ),
            Basis::Nothing if self.methods.is_empty() => write!(f, "there is no answer"),
            Basis::Nothing => write!(f, "there is no answer ({by})"),
        }?;
        if let Some(floor) = &self.floor {
            write!(f, "; it is proved that {floor} ({})", floor.by)?;
        }
        if let Some(difference) = &self.difference {
            write!(f, "; {difference}")?;
        }
        let other = self.other.as_deref().filter(|_| self.basis != Basis::Falls);
        if let Some(other) = other {
            self.write_other(f, other)?;
        }
        let mut lead = "; NOT EXPLAINED: ";
        for doubt in &self.doubts {
            write!(f, "{lead}{doubt}")?;
            lead = ", ";
        }
        // Sides alike have the same doubts.
        let others = other.iter().flat_map(|other| &other.doubts);
        for doubt in others.filter(|doubt| !self.doubts.contains(doubt)) {
            let push = other.map_or(self.push, |other| other.push).name();
            write!(f, "{lead}pushed to the {push}, {doubt}")?;
            lead = ", ";
        }
        Ok(())
    }
}
