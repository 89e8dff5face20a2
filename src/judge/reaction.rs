//! The conclusion about a scene with a support that moves, in terms of its reaction.

use std::fmt;

use super::conclusion::{Basis, Conclusion, Doubt};
use super::heard::LowerState;
use crate::answer::{Status, write_motion_cap};
use crate::number::{number, short};
use crate::scene::{Reaction, Sense};

/// Writes the conclusion, whose multipliers are changes of this reaction.
pub(super) fn write(
    f: &mut fmt::Formatter<'_>,
    of: &Conclusion,
    reaction: &Reaction,
) -> fmt::Result {
    let (by, status, support) = (of.methods.join(", "), of.status.name(), &reaction.support);
    let decimals = if of.status == Status::Estimate { 4 } else { 5 };
    let reads = |lambda: f64| number(reaction.at(lambda), decimals);
    let falls = reaction.sense == Sense::Away;
    let found = of.bracket.map(|bracket| {
        let ends = [bracket.lower, bracket.upper].map(reads);
        let share = short(100.0 * reaction.at(bracket.lower) / reaction.weight, 2);
        match ends[0] == ends[1] {
            true => format!("{} ({share} % of the weight)", ends[0]),
            false if falls => format!("{} - {}", ends[1], ends[0]),
            false => format!("{} - {}", ends[0], ends[1]),
        }
    });
    let found = found.unwrap_or_default();
    let (first, limit) = match falls {
        true => ("largest", "at least"),
        false => ("smallest", "at most"),
    };
    match of.basis {
        Basis::Falls => write!(f, "no reaction of {support} holds it: it falls ({by})"),
        Basis::LowestState => {
            write!(
                f,
                "{support} gives way at a reaction of {found}, which is {status}: it is the {first} of any \
                 collapse state found ({by})"
            )?;
            match of.highest_state {
                Some(other) => write!(f, ", and others were found up to {}", reads(other)),
                None => Ok(()),
            }
        }
        Basis::Stands => write!(
            f,
            "it stands: no change of the reaction of {support} is too large for it ({by})"
        ),
        Basis::UpperBound => write!(
            f,
            "the reaction of {support} is {limit} {}, which is {status} ({by}); no collapse state is \
             verified",
            of.bracket
                .map_or_else(String::new, |bracket| reads(bracket.upper))
        ),
        Basis::Observed => write!(
            f,
            "{support} gives way at a reaction of {found}, which is {status}, as the simulation shows \
             ({by}); nothing is proved"
        ),
        Basis::Estimate => write!(
            f,
            "{support} gives way at a reaction of {found}, an {status} ({by}); nothing is proved"
        ),
        Basis::NoneFound => write!(
            f,
            "no collapse state was found ({by}), which does not prove that none exists"
        ),
        Basis::Nothing if of.methods.is_empty() => write!(f, "there is no answer"),
        Basis::Nothing => write!(f, "there is no answer ({by})"),
    }?;
    if let Some(floor) = &of.floor {
        write!(f, "; it is proved that ")?;
        write_motion_cap(f, reaction, floor.lower, floor.cap)?;
        write!(f, " ({})", floor.by)?;
    }
    if let Some(difference) = &of.difference {
        let method = &difference.method;
        match (difference.associative, difference.explanation) {
            (None, explanation) => write!(f, "; {method} stands, which is {explanation}")?,
            (Some(lambda), _) if of.bracket.is_some_and(|b| reads(b.lower) == reads(lambda)) => {
                write!(f, "; {method} gives the same")?;
            }
            (Some(lambda), explanation) => {
                write!(f, "; {method} proves that it is {limit} {}", reads(lambda))?;
                write!(f, ", which is {explanation}")?;
            }
        }
    }
    if of.basis == Basis::LowestState && of.difference.is_none() && of.floor.is_none() {
        write!(f, "; nothing bounds it")?;
    }
    let mut lead = "; NOT EXPLAINED: ";
    for doubt in &of.doubts {
        write!(f, "{lead}")?;
        write_doubt(f, doubt, reads)?;
        lead = ", ";
    }
    Ok(())
}

/// What is not explained, with the reaction for each multiplier.
fn write_doubt(
    f: &mut fmt::Formatter<'_>,
    doubt: &Doubt,
    reads: impl Fn(f64) -> String,
) -> fmt::Result {
    match doubt {
        Doubt::Lower(LowerState { by, lambda, .. }) => {
            write!(
                f,
                "{by} gives {}, so that it may give way sooner",
                reads(*lambda)
            )
        }
        Doubt::Bound { by, lambda } => {
            write!(f, "{by} proves that none is beyond {}", reads(*lambda))
        }
        Doubt::Above { by, lambda, .. } => {
            write!(
                f,
                "{by} gives {}, which is beyond what bounds every collapse",
                reads(*lambda)
            )
        }
        Doubt::Excluded {
            by,
            lambda,
            floor,
            least,
        } => write!(
            f,
            "{by} gives {}, and {floor} proves that it does not give way before {}",
            reads(*lambda),
            reads(*least)
        ),
        Doubt::Impossible { by, lambda } => {
            write!(
                f,
                "{by} gives {}, before which it cannot give way",
                reads(*lambda)
            )
        }
        Doubt::Stands { .. } | Doubt::Falls { .. } => write!(f, "{doubt}"),
    }
}
