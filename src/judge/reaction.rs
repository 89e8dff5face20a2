//! The conclusion about a scene with a support that moves, in terms of its reaction.

use std::fmt;

use super::conclusion::{ALIKE, Basis, Conclusion, Difference, Doubt};
use super::heard::LowerState;
use crate::answer::{Status, write_motion_cap};
use crate::number::{above, below, number, short};
use crate::scene::{Reaction, Sense};

/// Writes the conclusion, whose multipliers are changes of this reaction.
pub(super) fn write(
    f: &mut fmt::Formatter<'_>,
    of: &Conclusion,
    reaction: &Reaction,
) -> fmt::Result {
    let decimals = if of.status == Status::Estimate { 4 } else { 5 };
    let reads = |lambda: f64| number(reaction.at(lambda), decimals);
    write_best(f, of, reaction, &reads)?;
    if let Some(floor) = &of.floor {
        write!(f, "; it is proved that ")?;
        write_motion_cap(f, reaction, floor.lower, floor.cap)?;
        write!(f, " ({})", floor.by)?;
    }
    if let Some(difference) = &of.difference {
        let Difference {
            method,
            explanation,
            relative,
            associative,
            ..
        } = difference;
        match (associative, relative) {
            (None, _) => write!(f, "; {method} stands, which is {explanation}")?,
            (_, Some(relative)) if relative.abs() <= ALIKE => {
                write!(f, "; {method} gives the same")?;
            }
            (&Some(lambda), _) => {
                let bound = bound(reaction, lambda);
                write!(f, "; {method} proves {bound}, which is {explanation}")?;
            }
        }
    }
    if of.bracket.is_some() {
        let share = short(100.0 * reaction.start / reaction.weight, 2);
        let start = number(reaction.start, 5);
        let start = format!("{start} ({share} % of the weight)");
        match (reaction.sense, reaction.limited) {
            (Sense::Away, true) => {
                write!(f, "; a linear program finds at most {start} at rest")?;
            }
            (Sense::Against, true) => {
                write!(f, "; a linear program finds at least {start} at rest")?;
            }
            (sense, false) => {
                let end = match sense {
                    Sense::Away => "largest",
                    Sense::Against => "least",
                };
                write!(
                    f,
                    "; no {end} reaction at rest is known, and it begins at {start} here"
                )?;
            }
        }
    }
    let mut lead = "; NOT EXPLAINED: ";
    for doubt in &of.doubts {
        write!(f, "{lead}")?;
        write_doubt(f, doubt, &reads)?;
        lead = ", ";
    }
    Ok(())
}

/// What the reaction never passes, rounded outwards.
fn bound(reaction: &Reaction, lambda: f64) -> String {
    let bound = reaction.at(lambda);
    match reaction.sense {
        Sense::Away => format!("at least {}", below(bound, 5)),
        Sense::Against => format!("at most {}", above(bound, 5)),
    }
}

/// The best answer.
fn write_best(
    f: &mut fmt::Formatter<'_>,
    of: &Conclusion,
    reaction: &Reaction,
    reads: &dyn Fn(f64) -> String,
) -> fmt::Result {
    let (by, status, support) = (of.methods.join(", "), of.status.name(), &reaction.support);
    let (first, way) = match reaction.sense {
        Sense::Away => ("largest", "falls"),
        Sense::Against => ("smallest", "rises"),
    };
    let found = of.bracket.map(|bracket| {
        let share = short(100.0 * reaction.at(bracket.lower) / reaction.weight, 2);
        let (one, other) = (reads(bracket.lower), reads(bracket.upper));
        match (one == other, reaction.sense) {
            (true, _) => format!("{one} ({share} % of the weight)"),
            (false, Sense::Away) => format!("{other} - {one}"),
            (false, Sense::Against) => format!("{one} - {other}"),
        }
    });
    let found = found.unwrap_or_default();
    let gives_way =
        format!("the reaction of {support} {way} to {found}, where it gives way; that is");
    match of.basis {
        Basis::Falls => write!(f, "no reaction of {support} holds it ({by})"),
        Basis::LowestState => {
            write!(
                f,
                "{gives_way} {status}, and the {first} reaction of any collapse state found ({by})"
            )?;
            if let Some(other) = of.highest_state {
                let way = match reaction.sense {
                    Sense::Away => "down",
                    Sense::Against => "up",
                };
                write!(f, "; others were found {way} to {}", reads(other))?;
            }
            of.seen.as_ref().map_or(Ok(()), |seen| seen.write(f, reads))
        }
        Basis::Stands => write!(
            f,
            "it stands: no change of the reaction of {support} is too large for it ({by})"
        ),
        Basis::UpperBound => {
            let bound = of.bracket.map(|bracket| bound(reaction, bracket.upper));
            let bound = bound.unwrap_or_default();
            write!(
                f,
                "the reaction of {support} is {bound}, which is {status} ({by}); no collapse state is \
                 verified"
            )
        }
        Basis::Observed => write!(
            f,
            "{gives_way} {status}, as the simulation shows ({by}); nothing is proved"
        ),
        Basis::Estimate => write!(f, "{gives_way} an {status} ({by}); nothing is proved"),
        Basis::NoneFound => write!(
            f,
            "no collapse state was found ({by}), which does not prove that none exists"
        ),
        Basis::Nothing if of.methods.is_empty() => write!(f, "there is no answer"),
        Basis::Nothing => write!(f, "there is no answer ({by})"),
    }
}

/// What is not explained, with the reaction for each multiplier.
fn write_doubt(
    f: &mut fmt::Formatter<'_>,
    doubt: &Doubt,
    reads: &dyn Fn(f64) -> String,
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
