//! What must hold between the methods of one scene.

use super::check::{Check, Verdict};
use crate::answer::{Bracket, Outcome};
use crate::scene::HeadJoints;

/// Convergence tolerance of the sequential method: what it may exceed λ_A by through c0.
const COHESION_BIAS: f64 = 1e-4;

/// Outcomes of one scene by method name.
pub type Answers<'a> = [(&'a str, &'a Outcome)];

fn bracket_of(answers: &Answers, method: &str) -> Option<Bracket> {
    let found = answers.iter().find(|(name, _)| *name == method)?;
    found.1.bracket
}

/// Relations between the methods of one scene.
pub fn cross_check(head_joints: HeadJoints, answers: &Answers) -> Vec<Check> {
    let associative = bracket_of(answers, "associative");
    let sequential = bracket_of(answers, "sequential");
    let interval = bracket_of(answers, "interval");
    let check = |method: &str, text: String, verdict| Check {
        head_joints,
        method: method.to_owned(),
        text,
        verdict,
    };
    let mut checks = Vec::new();
    if let (Some(a), Some(s)) = (associative, sequential) {
        let (text, verdict) = sequential_below_associative(a, s);
        checks.push(check("sequential", text, verdict));
    }
    if let (Some(a), Some(i)) = (associative, interval) {
        let holds = i.upper <= a.upper + 1e-6 * a.upper.max(1e-3);
        let text = "interval is not above associative".to_owned();
        checks.push(check("interval", text, Verdict::of(holds)));
    }
    if let (Some(s), Some(i)) = (sequential, interval) {
        let slack = COHESION_BIAS * i.upper.max(1e-3);
        let inside = s.lower >= i.lower - slack && s.upper <= i.upper + slack;
        // Outside lies no contradiction: the interval is what was found.
        let (word, verdict) = match inside {
            true => ("lies in", Verdict::Holds),
            false => ("lies outside", Verdict::Marked),
        };
        let text = format!("sequential {word} the verified interval found");
        checks.push(check("sequential", text, verdict));
    }
    if let Some(range) = bracket_of(answers, "macro-block") {
        let width = 100.0 * (range.upper - range.lower) / range.upper;
        let micro = answers.iter().filter(|(name, _)| *name != "macro-block");
        for (name, outcome) in micro {
            let Some(value) = outcome.bracket else {
                continue;
            };
            let inside = value.lower >= range.lower && value.upper <= range.upper;
            // The range is a claim of the paper, not a law.
            let (word, verdict) = match inside {
                true => ("contains", Verdict::Holds),
                false => ("does not contain", Verdict::Marked),
            };
            let text = format!("macro-block range ({width:.0} % wide) {word} {name}");
            checks.push(check("macro-block", text, verdict));
        }
    }
    checks.extend(pushover_check(answers).map(|(text, verdict)| check("pushover", text, verdict)));
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
    let (_, outcome) = answers.iter().find(|(name, _)| *name == "pushover")?;
    let (pushover, error) = (outcome.bracket?, outcome.stated_error?);
    let known = ["associative", "sequential", "interval"];
    let lowest = known
        .iter()
        .filter_map(|method| bracket_of(answers, method))
        .map(|bracket| bracket.lower)
        .fold(f64::INFINITY, f64::min);
    let highest = bracket_of(answers, "associative")?.upper;
    let (low, high) = (lowest * (1.0 - error), highest * (1.0 + error));
    let meets = pushover.upper >= low && pushover.lower <= high;
    let text = format!(
        "pushover {} [{low:.4}, {high:.4}], lowest known to associative widened by {} %",
        if meets { "meets" } else { "misses" },
        crate::number::short(100.0 * error, 2)
    );
    Some((text, Verdict::of(meets)))
}

/// Open head joints never raise λ_A, as they only take forces away.
pub fn open_never_raises(contact: Option<Bracket>, open: Option<Bracket>) -> Option<Check> {
    let (contact, open) = (contact?, open?);
    let holds = open.lower <= contact.upper * (1.0 + 1e-6);
    Some(Check {
        head_joints: HeadJoints::Open,
        method: "associative".to_owned(),
        text: "open head joints do not raise the associative multiplier".to_owned(),
        verdict: Verdict::of(holds),
    })
}
