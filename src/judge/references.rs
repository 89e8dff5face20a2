//! What must hold against the references of a case.

use super::check::{Check, Verdict};
use crate::answer::{Bracket, Status};
use crate::case::{Case, Quantity, Reference, nearest};
use crate::mechanics::Crack;
use crate::method::{Kind, kind};
use crate::scene::HeadJoints;

/// What a method computed of a wall, as references speak of it.
#[derive(Clone, Copy, Debug)]
pub struct Computed<'a> {
    /// What it is worth.
    pub status: Status,
    /// Lower end of the range of λ.
    pub lower: Option<f64>,
    pub upper: Option<f64>,
    pub crack: Option<&'a Crack>,
}

/// The computed value that a reference is about, as a bracket.
pub fn computed(of: &Computed, quantity: Quantity) -> Option<Bracket> {
    let crack = |value: fn(&Crack) -> Option<f64>| of.crack.and_then(value).map(Bracket::point);
    let both = of.lower.zip(of.upper);
    match quantity {
        Quantity::Lambda | Quantity::Reaction => {
            both.map(|(lower, upper)| Bracket { lower, upper })
        }
        Quantity::Lower => of.lower.map(Bracket::point),
        Quantity::Upper => of.upper.map(Bracket::point),
        Quantity::TanBeta => crack(|c| Some(c.tan_beta)),
        Quantity::C => crack(|c| c.c),
        Quantity::E => crack(|c| c.e),
        Quantity::AtRest => match (of.status, both) {
            (Status::Falls, _) => Some(Bracket::point(0.0)),
            (Status::Stands, _) | (_, Some(_)) => Some(Bracket::point(1.0)),
            _ => None,
        },
    }
}

/// A reference beside what a method computed.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison<'a> {
    pub reference: &'a Reference,
    /// The computed value, as a bracket; `None` where the method gave none.
    pub computed: Option<Bracket>,
    /// The farther end's distance from the reference, relative to that, or to a thousandth of the
    /// scene's unit of λ where it is smaller.
    pub error: Option<f64>,
    pub verdict: Verdict,
}

/// Every reference of the case about one method's answer for one head-joint setting, in a scene with
/// this unit of λ.
pub fn comparisons<'a>(
    case: &'a Case,
    head_joints: HeadJoints,
    method: &str,
    of: &Computed,
    unit: f64,
) -> Vec<Comparison<'a>> {
    let about = |reference: &&Reference| {
        reference.method == method && reference.head_joints.is_none_or(|only| only == head_joints)
    };
    let references = case.references.iter().filter(about);
    references.map(|r| compare(r, of, unit)).collect()
}

/// One reference beside what was computed.
pub(crate) fn compare<'a>(reference: &'a Reference, of: &Computed, unit: f64) -> Comparison<'a> {
    let unit = match reference.quantity {
        Quantity::Lambda | Quantity::Lower | Quantity::Upper | Quantity::Reaction => unit,
        Quantity::TanBeta | Quantity::C | Quantity::E | Quantity::AtRest => 1.0,
    };
    let computed = computed(of, reference.quantity);
    Comparison {
        reference,
        computed,
        error: computed.map(|value| value.error(reference.value, unit)),
        verdict: match computed {
            Some(value) => verdict(reference, value),
            // A method that declines or cannot decide contradicts nothing; one that broke does.
            None => match of.status {
                Status::Failed | Status::Falls | Status::Stands => Verdict::Violated,
                _ => Verdict::NotDecided,
            },
        },
    }
}

fn verdict(reference: &Reference, value: Bracket) -> Verdict {
    // Rounding of the sum must not decide: half a printed digit is a common tolerance.
    let allowed = reference.tolerance * (1.0 + 1e-9) + 1e-12;
    let distance = |end: f64| (end - reference.value).abs();
    let distance = distance(value.lower).max(distance(value.upper));
    match (distance <= allowed, &reference.deviation) {
        (true, None) => Verdict::Holds,
        // It is met after all: the case's reason is out of date.
        (true, Some(_)) => Verdict::Marked,
        (false, Some(_)) => Verdict::Deviates,
        (false, None) => Verdict::Violated,
    }
}

/// Every reference of the case that speaks of this scene and of a method that ran.
pub fn reference_checks(
    case: &Case,
    head_joints: HeadJoints,
    answers: &[(&str, Computed)],
    unit: f64,
) -> Vec<Check> {
    let mut checks = Vec::new();
    for reference in &case.references {
        if reference
            .head_joints
            .is_some_and(|only| only != head_joints)
        {
            continue;
        }
        let Some((_, of)) = answers.iter().find(|(name, _)| *name == reference.method) else {
            if kind(&reference.method) == Kind::Outside {
                checks.push(Check {
                    head_joints,
                    method: reference.method.clone(),
                    text: not_compared(reference, answers),
                    verdict: Verdict::NotDecided,
                });
            }
            continue;
        };
        let comparison = compare(reference, of, unit);
        checks.push(Check {
            head_joints,
            method: reference.method.clone(),
            text: in_words(&comparison, of.status),
            verdict: comparison.verdict,
        });
    }
    checks
}

/// Why the reference of an outside program stands beside nothing, and what to do about it.
fn not_compared(reference: &Reference, answers: &[(&str, Computed)]) -> String {
    let name = &reference.method;
    let outside = answers.iter().map(|(name, _)| *name);
    let outside = outside.filter(|name| kind(name) == Kind::Outside);
    let help = match nearest(name, outside) {
        Some(near) => format!("did the case mean `{near}`?"),
        None => format!("add it to the external methods: `{name}=COMMAND`"),
    };
    format!(
        "{} is not compared with {}, because no program of this name ran; {help}",
        subject(reference),
        label(reference)
    )
}

/// What the reference is about.
fn subject(reference: &Reference) -> String {
    format!("{} of {}", reference.quantity.words(), reference.method)
}

/// What stands beside it.
fn label(reference: &Reference) -> String {
    format!(
        "the {} value {}",
        reference.kind.name(),
        crate::number::short(reference.value, 6)
    )
}

fn in_words(comparison: &Comparison, status: Status) -> String {
    let reference = comparison.reference;
    let (subject, label) = (subject(reference), label(reference));
    let Some(error) = comparison.error else {
        return format!(
            "{subject} is not there to compare with {label}, because the answer is {}",
            status.name()
        );
    };
    let text = format!(
        "{subject} is {} % off {label} ({})",
        crate::number::number(100.0 * error, 2),
        reference.source
    );
    match (&reference.deviation, comparison.verdict) {
        (Some(why), Verdict::Deviates) => format!("{text}: {why}"),
        (Some(_), Verdict::Marked) => {
            format!("{text}, so that it is met, although the case calls it a deviation")
        }
        _ => text,
    }
}
