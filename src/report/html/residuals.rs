//! What the judge computed: every residual by its name.

use maud::{Markup, html};

use super::sortable::{TableCell, plain, sortable};
use crate::answer::Evidence;
use crate::judge::{Recomputed, Verdict};
use crate::mechanics::{CollapseResidual, StaticResidual, VERIFIED_RESIDUAL};
use crate::number::number;
use crate::run::{CaseResult, Row};

/// One thing that an answer puts forward: the cells that say what it is, and its residuals by name.
type PutForward = ([TableCell; 4], Vec<(&'static str, f64)>);

/// Everything that an answer puts forward, in the order of the evidence.
fn put_forward(row: &Row) -> Vec<PutForward> {
    let residuals = row.residuals.iter().enumerate();
    let described = residuals.map(|(index, of)| {
        let (lambda, residuals) = by_name(of);
        // Where a support moves, its reaction.
        let lambda = lambda.map(|lambda| row.reads(lambda));
        let cells = [
            TableCell::text(&row.method),
            TableCell::text(row.head_joints.name()),
            TableCell::text(what(&row.outcome.evidence, of, index)),
            match lambda {
                Some(lambda) => TableCell::number(number(lambda, 6)),
                None => TableCell::text("-"),
            },
        ];
        (cells, residuals)
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

/// Whether a residual is small enough for `verified`.
fn within(residual: f64) -> TableCell {
    match residual <= VERIFIED_RESIDUAL {
        true => TableCell::verdict(Verdict::Holds),
        false => TableCell::word("above 1e-8"),
    }
}

/// One line for everything that an answer puts forward, of `all` answers or of the lowest states that count:
/// its residuals by name. Nothing without any.
pub fn in_short(result: &CaseResult, all_answers: bool) -> Markup {
    let counts = |row: &&Row| {
        let mut conclusions = result.conclusions.iter();
        let of_row = conclusions.find(|of| of.head_joints == row.head_joints);
        all_answers || of_row.is_some_and(|of| of.methods.first() == Some(&row.method))
    };
    let mut lines = Vec::new();
    for row in result.rows.iter().filter(counts) {
        let mut all = put_forward(row);
        // Of many collapse states the lowest and the highest.
        let last = (all.len() > 1).then(|| all.pop()).flatten();
        let last = last.filter(|_| all_answers);
        all.truncate(1);
        for (cells, residuals) in all.into_iter().chain(last) {
            let largest = residuals.iter().map(|(_, value)| *value);
            let largest = largest.fold(0.0, f64::max);
            let named = residuals.iter();
            let named = named.map(|(name, value)| format!("{name} {value:.0e}"));
            let named = TableCell::text(named.collect::<Vec<_>>().join(", "));
            lines.push(cells.into_iter().chain([within(largest), named]).collect());
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
        for (cells, residuals) in put_forward(row) {
            for (name, value) in residuals {
                let (name, shown) = (TableCell::text(name), format!("{value:.1e}"));
                let own = [name, TableCell::number(shown), within(value)];
                lines.push(cells.iter().cloned().chain(own).collect());
            }
        }
    }
    let checked = result.rows.iter();
    let checked = checked.filter(|row| !row.outcome.evidence.checks().is_empty());
    let checked: Vec<&Row> = checked.collect();
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
