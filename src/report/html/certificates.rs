//! What the judge computed: every residual by its name.

use maud::{Markup, html};

use super::sortable::{TableCell, plain, sortable};
use crate::answer::{Claim, Outcome};
use crate::mechanics::{
    CollapseResidual, JointForce, Mechanism, StaticResidual, VERIFIED_RESIDUAL,
    associative_violation, kinematic_multiplier,
};
use crate::number::number;
use crate::run::{CaseResult, Row};
use crate::scene::Scene;

/// Residuals of one thing that was put forward: name and value, scaled to total weight, height and
/// live power 1.
type NamedResiduals = Vec<(&'static str, f64)>;

fn of_forces(scene: &Scene, forces: &[JointForce], lambda: f64) -> NamedResiduals {
    let StaticResidual {
        equilibrium,
        tension,
        friction,
    } = StaticResidual::of(scene, forces, lambda);
    vec![
        ("equilibrium", equilibrium),
        ("tension", tension),
        ("friction beyond μN", friction),
    ]
}

fn of_state(scene: &Scene, forces: &[JointForce], mechanism: &Mechanism) -> NamedResiduals {
    let CollapseResidual {
        penetration,
        open_contact,
        idle_friction,
        gap,
    } = CollapseResidual::of(scene, forces, mechanism);
    vec![
        ("penetration", penetration),
        ("force at an opening", open_contact),
        ("idle friction", idle_friction),
        ("gap", gap),
    ]
}

/// Everything that an answer puts forward, as (what, λ, residuals).
fn put_forward(scene: &Scene, outcome: &Outcome) -> Vec<(String, f64, NamedResiduals)> {
    let mut found = Vec::new();
    if !outcome.states.is_empty() {
        for (index, state) in outcome.states.iter().enumerate() {
            let mut residuals = of_forces(scene, &state.forces, state.lambda);
            residuals.extend(of_state(scene, &state.forces, &state.mechanism));
            found.push((
                format!("collapse state {}", index + 1),
                state.lambda,
                residuals,
            ));
        }
        return found;
    }
    let Some(bracket) = outcome.bracket else {
        return found;
    };
    if let Some(forces) = &outcome.forces {
        found.push((
            "forces".to_owned(),
            bracket.lower,
            of_forces(scene, forces, bracket.lower),
        ));
    }
    let admissible = match outcome.claim {
        Claim::Associative => outcome.mechanism.as_ref(),
        Claim::Enclosed => outcome.ceiling.as_ref(),
        Claim::CollapseState | Claim::Bounded | Claim::Observed => None,
    };
    if let Some(mechanism) = admissible {
        let slack = associative_violation(scene, mechanism);
        let upper = kinematic_multiplier(scene, mechanism);
        found.push((
            "mechanism, from above".to_owned(),
            upper,
            vec![("flow rule", slack)],
        ));
    }
    if let (Claim::CollapseState | Claim::Enclosed, Some(forces), Some(mechanism)) =
        (outcome.claim, &outcome.forces, &outcome.mechanism)
    {
        let residuals = of_state(scene, forces, mechanism);
        found.push(("forces with mechanism".to_owned(), bracket.lower, residuals));
    }
    found
}

/// One line for everything that an answer puts forward: its residuals by name. Nothing without any.
pub fn in_short(result: &CaseResult) -> Markup {
    let mut lines = Vec::new();
    for row in &result.rows {
        let all = put_forward(result.scene(row), &row.outcome);
        // Of many collapse states the lowest and the highest.
        let count = all.len();
        let ends = all.into_iter().enumerate();
        let ends = ends.filter(|(index, _)| *index == 0 || index + 1 == count);
        for (_, (what, lambda, residuals)) in ends {
            let largest = residuals
                .iter()
                .map(|(_, value)| *value)
                .fold(0.0, f64::max);
            let named = residuals
                .iter()
                .map(|(name, value)| format!("{name} {value:.0e}"));
            lines.push(vec![
                TableCell::text(&row.method),
                TableCell::text(row.head_joints.name()),
                TableCell::text(what),
                TableCell::number(number(lambda, 6)),
                TableCell::word(if largest <= VERIFIED_RESIDUAL {
                    "holds"
                } else {
                    "above 1e-8"
                }),
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
pub fn certificates(result: &CaseResult) -> Option<Markup> {
    let mut lines = Vec::new();
    for row in &result.rows {
        for (what, lambda, residuals) in put_forward(result.scene(row), &row.outcome) {
            for (name, value) in residuals {
                let holds = value <= VERIFIED_RESIDUAL;
                lines.push(vec![
                    TableCell::text(&row.method),
                    TableCell::text(row.head_joints.name()),
                    TableCell::text(&what),
                    TableCell::number(number(lambda, 6)),
                    TableCell::text(name),
                    TableCell::number(format!("{value:.1e}")),
                    TableCell::word(if holds { "holds" } else { "above 1e-8" }),
                ]);
            }
        }
    }
    let checked: Vec<&Row> = result
        .rows
        .iter()
        .filter(|row| !row.outcome.checks.is_empty())
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
                ul.checks { @for check in &row.outcome.checks { li { (check.to_string()) } } }
            }
        }
    })
}
