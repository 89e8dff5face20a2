//! What the judge computed: every residual by its name.

use maud::{Markup, html};

use super::sortable::{TableCell, plain, sortable};
use crate::answer::Evidence;
use crate::judge::{Recomputed, Verdict};
use crate::mechanics::{CollapseResidual, StaticResidual, VERIFIED_RESIDUAL};
use crate::number::number;
use crate::run::{CaseResult, Row};

/// One thing that an answer puts forward: what it is, its multiplier, and its residuals by name.
struct PutForward {
    what: String,
    lambda: Option<f64>,
    residuals: Vec<(&'static str, f64)>,
}

/// Everything that an answer puts forward, in the order of the evidence.
fn put_forward(row: &Row) -> Vec<PutForward> {
    let residuals = row.residuals.iter().enumerate();
    let described = residuals.map(|(index, of)| {
        let (lambda, residuals) = by_name(of);
        PutForward {
            what: what(&row.outcome.evidence, of, index),
            lambda,
            residuals,
        }
    });
    described.collect()
}

/// What residuals are of, in words.
fn what(evidence: &Evidence, of: &Recomputed, index: usize) -> String {
    match (evidence, of) {
        (_, Recomputed::Ceiling { .. }) => "mechanism, from above".to_owned(),
        (_, Recomputed::Ray { .. }) => "forces that carry any push".to_owned(),
        (Evidence::States { .. }, _) => format!("collapse state {}", index + 1),
        (Evidence::Enclosed { .. } | Evidence::Bounded { .. }, _) => "collapse state".to_owned(),
        (Evidence::State { .. } | Evidence::Number { .. }, _) => "forces with mechanism".to_owned(),
        (Evidence::Bounds { .. }, _) => "forces".to_owned(),
        (Evidence::Falls { .. }, _) => "mechanism under the dead load".to_owned(),
        (Evidence::Stands { .. }, _) => "forces at rest".to_owned(),
        // Refuted, or without residuals.
        (Evidence::Nothing | Evidence::ClosedForm { .. } | Evidence::Observed(_), _) => {
            "refuted".to_owned()
        }
    }
}

fn by_name(of: &Recomputed) -> (Option<f64>, Vec<(&'static str, f64)>) {
    match of {
        Recomputed::Forces { lambda, statics } => (Some(*lambda), of_forces(statics)),
        Recomputed::State {
            lambda,
            statics,
            collapse,
        } => (
            Some(*lambda),
            [of_forces(statics), of_state(collapse)].concat(),
        ),
        Recomputed::Ceiling {
            lambda, flow_rule, ..
        } => (Some(*lambda), vec![("flow rule", *flow_rule)]),
        Recomputed::Falling { flow_rule } => (None, vec![("flow rule", *flow_rule)]),
        Recomputed::Ray { statics } => (None, of_forces(statics)),
    }
}

fn of_forces(statics: &StaticResidual) -> Vec<(&'static str, f64)> {
    let StaticResidual {
        equilibrium,
        tension,
        friction,
    } = *statics;
    vec![
        ("equilibrium", equilibrium),
        ("tension", tension),
        ("friction beyond μN", friction),
    ]
}

fn of_state(collapse: &CollapseResidual) -> Vec<(&'static str, f64)> {
    let CollapseResidual {
        penetration,
        open_contact,
        idle_friction,
        gap,
    } = *collapse;
    vec![
        ("penetration", penetration),
        ("force at an opening", open_contact),
        ("idle friction", idle_friction),
        ("gap", gap),
    ]
}

fn shown(lambda: Option<f64>) -> TableCell {
    lambda.map_or_else(
        || TableCell::text("-"),
        |lambda| TableCell::number(number(lambda, 6)),
    )
}

/// Whether a residual is small enough for `verified`.
fn within(residual: f64) -> TableCell {
    match residual <= VERIFIED_RESIDUAL {
        true => TableCell::verdict(Verdict::Holds),
        false => TableCell::word("above 1e-8"),
    }
}

/// One line for everything that an answer puts forward: its residuals by name. Nothing without any.
pub fn in_short(result: &CaseResult) -> Markup {
    let mut lines = Vec::new();
    for row in &result.rows {
        let all = put_forward(row);
        // Of many collapse states the lowest and the highest.
        let count = all.len();
        let ends = all.into_iter().enumerate();
        let ends = ends.filter(|(index, _)| *index == 0 || index + 1 == count);
        for (_, of) in ends {
            let largest = of.residuals.iter().map(|(_, value)| *value);
            let largest = largest.fold(0.0, f64::max);
            let named = of
                .residuals
                .iter()
                .map(|(name, value)| format!("{name} {value:.0e}"));
            lines.push(vec![
                TableCell::text(&row.method),
                TableCell::text(row.head_joints.name()),
                TableCell::text(&of.what),
                shown(of.lambda),
                within(largest),
                TableCell::text(named.collect::<Vec<_>>().join(", ")),
            ]);
        }
    }
    let columns = [
        "Method",
        "Joints",
        "What",
        "λ",
        "Verdict",
        "Residuals, scaled",
    ];
    html! {
        @if !lines.is_empty() { (plain("Certificates", &columns, &lines)) }
    }
}

/// One line a residual, and the self-checks of the pushover in words. `None` without either.
pub fn in_full(result: &CaseResult) -> Option<Markup> {
    let mut lines = Vec::new();
    for row in &result.rows {
        for of in put_forward(row) {
            for (name, value) in of.residuals {
                lines.push(vec![
                    TableCell::text(&row.method),
                    TableCell::text(row.head_joints.name()),
                    TableCell::text(&of.what),
                    shown(of.lambda),
                    TableCell::text(name),
                    TableCell::number(format!("{value:.1e}")),
                    within(value),
                ]);
            }
        }
    }
    let checked: Vec<&Row> = result
        .rows
        .iter()
        .filter(|row| !row.outcome.evidence.checks().is_empty())
        .collect();
    let columns = [
        "Method",
        "Head joints",
        "What",
        "λ",
        "Residual",
        "Value",
        "Verdict",
    ];
    (!(lines.is_empty() && checked.is_empty())).then(|| {
        html! {
            @if !lines.is_empty() {
                (sortable("Residuals that the judge recomputed", &columns, &lines))
            }
            @for row in checked {
                h4 { "Self-checks of " (row.method) ", " (row.head_joints.name()) " head joints" }
                ul.checks { @for check in row.outcome.evidence.checks() { li { (check.to_string()) } } }
            }
        }
    })
}
