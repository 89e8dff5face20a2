//! What must hold between the methods of one scene, and against the references of its case.

use crate::case::{Case, Quantity, Reference};
use crate::method::{Bracket, Outcome, Status};
use crate::scene::HeadJoints;

/// Result of one check, from good to bad.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// It holds.
    Holds,
    /// It holds within a stated allowance that has a known cause.
    Marked,
    /// A method that the check needs gave no number.
    NotDecided,
    /// It does not hold, and the case says why.
    Deviates,
    /// It does not hold.
    Violated,
}

impl Verdict {
    /// A check without shades.
    fn of(holds: bool) -> Self {
        if holds {
            Verdict::Holds
        } else {
            Verdict::Violated
        }
    }

    /// The word in records.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Holds => "holds",
            Verdict::Marked => "marked",
            Verdict::Deviates => "deviates",
            Verdict::Violated => "VIOLATED",
            Verdict::NotDecided => "not decided",
        }
    }
}

/// One line of the cross-check.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// Head joints of the scene it is about.
    pub head_joints: HeadJoints,
    /// What is compared, with its figures.
    pub text: String,
    /// The result.
    pub verdict: Verdict,
}

/// Convergence tolerance of the sequential method: what it may exceed λ_A by through c0.
const COHESION_BIAS: f64 = 1e-4;

/// Stated relative error of the pushover.
const PUSHOVER_ERROR: f64 = 2e-3;

/// Outcomes of one scene by method name.
pub type Answers<'a> = [(&'static str, &'a Outcome)];

fn bracket_of(answers: &Answers, method: &str) -> Option<Bracket> {
    let found = answers.iter().find(|(name, _)| *name == method)?;
    found.1.bracket
}

/// Relations between the methods of one scene.
pub fn cross_check(head_joints: HeadJoints, answers: &Answers) -> Vec<Check> {
    let associative = bracket_of(answers, "associative");
    let sequential = bracket_of(answers, "sequential");
    let interval = bracket_of(answers, "interval");
    let check = |text: String, verdict| Check {
        head_joints,
        text,
        verdict,
    };
    let mut checks = Vec::new();
    if let (Some(a), Some(s)) = (associative, sequential) {
        let (text, verdict) = sequential_below_associative(a, s);
        checks.push(check(text, verdict));
    }
    if let (Some(a), Some(i)) = (associative, interval) {
        let holds = i.upper <= a.upper + 1e-6 * a.upper.max(1e-3);
        let text = "interval is not above associative".to_owned();
        checks.push(check(text, Verdict::of(holds)));
    }
    if let (Some(s), Some(i)) = (sequential, interval) {
        let slack = COHESION_BIAS * i.upper.max(1e-3);
        let inside = s.lower >= i.lower - slack && s.upper <= i.upper + slack;
        // Outside lies no contradiction: the interval is what was found.
        let (word, verdict) = match inside {
            true => ("lies in", Verdict::Holds),
            false => ("lies outside", Verdict::Marked),
        };
        checks.push(check(
            format!("sequential {word} the verified interval found"),
            verdict,
        ));
    }
    if let Some(range) = bracket_of(answers, "macro-block") {
        let width = 100.0 * (range.upper - range.lower) / range.upper;
        let micro = answers.iter().filter(|(name, _)| *name != "macro-block");
        for (name, outcome) in micro {
            let Some(value) = outcome.bracket else {
                continue;
            };
            let inside = value.lower >= range.lower && value.upper <= range.upper;
            let word = if inside {
                "contains"
            } else {
                "does not contain"
            };
            let text = format!("macro-block range ({width:.0} % wide) {word} {name}");
            // The range is a claim of the paper, not a law.
            let verdict = if inside {
                Verdict::Holds
            } else {
                Verdict::Marked
            };
            checks.push(check(text, verdict));
        }
    }
    checks.extend(pushover_check(answers).map(|(text, verdict)| check(text, verdict)));
    checks
}

/// λ_sequential ≤ λ_A (1 + 1e-4), what is above λ_A marked as the bias of c0.
fn sequential_below_associative(associative: Bracket, sequential: Bracket) -> (String, Verdict) {
    let excess = (sequential.upper - associative.upper) / associative.upper.max(1e-3);
    if excess <= 1e-6 {
        (
            "sequential is not above associative".to_owned(),
            Verdict::Holds,
        )
    } else if excess <= COHESION_BIAS {
        let text = "sequential is above associative by no more than 0.01 %: bias of c0";
        (text.to_owned(), Verdict::Marked)
    } else {
        let text = format!("sequential is {:.3} % above associative", 100.0 * excess);
        (text, Verdict::Violated)
    }
}

/// The open pushover's bracket meets [lowest known, λ_A], widened by its stated error.
fn pushover_check(answers: &Answers) -> Option<(String, Verdict)> {
    let pushover = bracket_of(answers, "pushover")?;
    let known = ["associative", "sequential", "interval"];
    let lowest = known
        .iter()
        .filter_map(|method| bracket_of(answers, method))
        .map(|bracket| bracket.lower)
        .fold(f64::INFINITY, f64::min);
    let highest = bracket_of(answers, "associative")?.upper;
    let (low, high) = (
        lowest * (1.0 - PUSHOVER_ERROR),
        highest * (1.0 + PUSHOVER_ERROR),
    );
    let meets = pushover.upper >= low && pushover.lower <= high;
    let text = format!(
        "pushover {} [{low:.4}, {high:.4}], lowest known to associative widened by 0.2 %",
        if meets { "meets" } else { "misses" }
    );
    let verdict = if meets {
        Verdict::Holds
    } else {
        Verdict::Violated
    };
    Some((text, verdict))
}

/// Open head joints never raise λ_A, as they only take forces away.
pub fn open_never_raises(contact: Option<Bracket>, open: Option<Bracket>) -> Option<Check> {
    let (contact, open) = (contact?, open?);
    let holds = open.lower <= contact.upper * (1.0 + 1e-6);
    Some(Check {
        head_joints: HeadJoints::Open,
        text: "open head joints do not raise the associative multiplier".to_owned(),
        verdict: if holds {
            Verdict::Holds
        } else {
            Verdict::Violated
        },
    })
}

/// The computed value that a reference is about, as a bracket.
pub fn computed(outcome: &Outcome, quantity: Quantity) -> Option<Bracket> {
    let crack = |value: fn(&crate::mechanism::Crack) -> Option<f64>| {
        outcome.crack.as_ref().and_then(value).map(Bracket::point)
    };
    match quantity {
        Quantity::Lambda => outcome.bracket,
        Quantity::Lower => outcome.bracket.map(|b| Bracket::point(b.lower)),
        Quantity::Upper => outcome.bracket.map(|b| Bracket::point(b.upper)),
        Quantity::TanBeta => crack(|c| Some(c.tan_beta)),
        Quantity::C => crack(|c| c.c),
        Quantity::E => crack(|c| c.e),
    }
}

/// Every reference of the case that speaks of this scene and of a method that ran.
pub fn reference_checks(case: &Case, head_joints: HeadJoints, answers: &Answers) -> Vec<Check> {
    let mut checks = Vec::new();
    for reference in &case.references {
        if reference
            .head_joints
            .is_some_and(|only| only != head_joints)
        {
            continue;
        }
        let Some((_, outcome)) = answers.iter().find(|(name, _)| *name == reference.method) else {
            continue;
        };
        checks.push(reference_check(reference, head_joints, outcome));
    }
    checks
}

fn reference_check(reference: &Reference, head_joints: HeadJoints, outcome: &Outcome) -> Check {
    let label = format!(
        "{} {} {} {}",
        reference.method,
        reference.quantity.name(),
        reference.kind.name(),
        crate::record::short(reference.value, 6)
    );
    let Some(value) = computed(outcome, reference.quantity) else {
        let text = format!("{label}: no value, {}", outcome.status.name());
        // A method that declines or cannot decide contradicts nothing; one that broke does.
        let verdict = match outcome.status {
            Status::Failed | Status::Falls | Status::Stands => Verdict::Violated,
            _ => Verdict::NotDecided,
        };
        return Check {
            head_joints,
            text,
            verdict,
        };
    };
    let error = value.error(reference.value);
    // Rounding of the sum must not decide: half a printed digit is a common tolerance.
    let allowed = reference.tolerance * (1.0 + 1e-9) + 1e-12;
    let distance = (value.lower - reference.value)
        .abs()
        .max((value.upper - reference.value).abs());
    let text = format!(
        "{label}: error {} % ({})",
        crate::record::number(100.0 * error, 2),
        reference.source
    );
    let verdict = match (distance <= allowed, &reference.deviation) {
        (true, None) => Verdict::Holds,
        // It is met after all: the case's reason is out of date.
        (true, Some(_)) => Verdict::Marked,
        (false, Some(_)) => Verdict::Deviates,
        (false, None) => Verdict::Violated,
    };
    let text = match (&reference.deviation, verdict) {
        (Some(why), Verdict::Deviates) => format!("{text}: {why}"),
        (Some(_), Verdict::Marked) => {
            format!("{text}: met, although the case calls it a deviation")
        }
        _ => text,
    };
    Check {
        head_joints,
        text,
        verdict,
    }
}
