//! What a conclusion says of a scene with a support that moves, in terms of its reaction.

use super::conclusion::{ALIKE, Basis, Conclusion, Difference, Doubt};
use crate::number::{above, below, number, short};
use crate::scene::{Reaction, Sense};

/// The best answer.
pub(super) fn best(of: &Conclusion, reaction: &Reaction) -> String {
    let reads = |lambda: f64| number(reaction.at(lambda), of.decimals());
    let (by, status, support) = (of.methods.join(", "), of.status.name(), &reaction.support);
    let (first, way, onward) = match reaction.sense {
        Sense::Away => ("largest", "falls", "down"),
        Sense::Against => ("smallest", "rises", "up"),
    };
    let found = of.bracket.map_or_else(String::new, |bracket| {
        let share = short(100.0 * reaction.at(bracket.lower) / reaction.weight, 2);
        let (one, other) = (reads(bracket.lower), reads(bracket.upper));
        // Friction can hold back a support that slides along its joint.
        let pull = if one.starts_with('-') { "a pull, " } else { "" };
        match (one == other, reaction.sense) {
            (true, _) => format!("{one} ({pull}{share} % of the weight)"),
            (false, Sense::Away) => format!("{other} - {one}"),
            (false, Sense::Against) => format!("{one} - {other}"),
        }
    });
    let gives_way =
        format!("the reaction of {support} {way} to {found}, where it gives way; that is");
    match of.basis {
        Basis::Falls => format!("no reaction of {support} holds it ({by})"),
        Basis::LowestState => {
            let others = of.highest_state.map_or_else(String::new, |other| {
                format!("; others were found {onward} to {}", reads(other))
            });
            let seen = of.seen(&reads);
            format!(
                "{gives_way} {status}, and the {first} reaction of any collapse state found \
                 ({by}){others}{seen}"
            )
        }
        Basis::Stands => {
            format!("it stands: no change of the reaction of {support} is too large for it ({by})")
        }
        Basis::UpperBound => {
            let bound = of.bracket.map(|bracket| bound(reaction, bracket.upper));
            let bound = bound.unwrap_or_default();
            format!(
                "the reaction of {support} is {bound}, which is {status} ({by}); no collapse state is \
                 verified"
            )
        }
        Basis::Observed => {
            format!("{gives_way} {status}, as the simulation shows ({by}); nothing is proved")
        }
        Basis::Estimate | Basis::NoneFound | Basis::Nothing => {
            format!("{gives_way} an {status} ({by}); nothing is proved")
        }
    }
}

/// What the reaction never passes, rounded outwards.
fn bound(reaction: &Reaction, lambda: f64) -> String {
    let bound = reaction.at(lambda);
    match reaction.sense {
        Sense::Away => format!("at least {}", below(bound, 5)),
        Sense::Against => format!("at most {}", above(bound, 5)),
    }
}

/// What other proofs say that is not the same.
pub(super) fn difference(difference: &Difference, reaction: &Reaction) -> String {
    let Difference {
        method,
        explanation,
        relative,
        associative,
    } = difference;
    match (associative, relative) {
        (None, _) => format!("{method} stands: {explanation}"),
        (_, Some(relative)) if relative.abs() <= ALIKE => format!("{method} gives the same"),
        (Some(lambda), _) => {
            let bound = bound(reaction, *lambda);
            format!("{method} proves {bound}: {explanation}")
        }
    }
}

/// The reaction that it begins with.
pub(super) fn start(reaction: &Reaction) -> String {
    let share = short(100.0 * reaction.start / reaction.weight, 2);
    let start = number(reaction.start, 5);
    let start = format!("{start} ({share} % of the weight)");
    let (most, end) = match reaction.sense {
        Sense::Away => ("at most", "largest"),
        Sense::Against => ("at least", "least"),
    };
    match reaction.limited {
        true => format!("a linear program finds {most} {start} at rest"),
        false => format!("no {end} reaction at rest is known, and it begins at {start} here"),
    }
}

/// What is not explained, with the reaction for each multiplier.
pub(super) fn doubt(of: &Conclusion, doubt: &Doubt, reaction: &Reaction) -> String {
    let reads = |lambda: &f64| number(reaction.at(*lambda), of.decimals());
    match doubt {
        Doubt::Lower(lower) => {
            let (by, at) = (&lower.by, reads(&lower.lambda));
            format!("{by} gives {at}, so that it may give way sooner")
        }
        Doubt::Bound { by, lambda } => {
            format!("{by} proves that none is beyond {}", reads(lambda))
        }
        Doubt::Above { by, lambda, .. } => {
            let at = reads(lambda);
            format!("{by} gives {at}, which is beyond what bounds every collapse")
        }
        Doubt::Excluded {
            by,
            lambda,
            floor,
            least,
        } => {
            let (at, least) = (reads(lambda), reads(least));
            format!("{by} gives {at}, and {floor} proves that it does not give way before {least}")
        }
        Doubt::Impossible { by, lambda } => {
            let at = reads(lambda);
            format!("{by} gives {at}, before which it cannot give way")
        }
        Doubt::Stands { .. } | Doubt::Falls { .. } => doubt.to_string(),
    }
}
