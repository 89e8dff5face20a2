//! The table: one line a method and head-joint setting, computed beside published.

use crate::answer::{Bracket, Outcome, Status, VERIFIED_RESIDUAL};
use crate::case::{Case, Kind, Quantity, Reference};
use crate::judge::{Check, computed};
use crate::number::{number, short};
use crate::run::{CaseResult, Row};

/// Column names, above the lines of [`lines`].
pub const HEADING: &str = "method       joints   status          lambda             reference          \
                           error %  tan beta  reference  c      e      verdict      note";

/// What the letters behind references mean.
pub const LEGEND: &str = "references: p published, a analytic, i independent code; error: the farther \
                          end of the bracket; c, e: widths of the crack's triangle along the top";

/// One fixed-width line a row.
pub fn lines(result: &CaseResult) -> Vec<String> {
    result.rows.iter().map(|row| line(result, row)).collect()
}

fn line(result: &CaseResult, row: &Row) -> String {
    let widths = [12, 8, 15, 18, 18, 8, 9, 10, 6, 6, 12, 0];
    let cells = cells(result, row).into_iter().zip(widths);
    let padded: Vec<String> = cells
        .map(|(cell, width)| format!("{cell:<width$}"))
        .collect();
    padded.join(" ").trim_end().to_owned()
}

/// What a row says, column by column as in [`HEADING`].
pub fn cells(result: &CaseResult, row: &Row) -> [String; 12] {
    let outcome = &row.outcome;
    let known = References::of(&result.case, row);
    let crack = outcome.crack.as_ref();
    let width = |value: Option<f64>| value.map_or("-".to_owned(), |v| short(v, 3));
    let mut tan_beta = crack.map_or("-".to_owned(), |c| number(c.tan_beta, 4));
    if crack.is_some_and(|c| !c.sharp) {
        tan_beta.push('~');
    }
    let error = known.error(outcome);
    [
        row.method.clone(),
        row.head_joints.name().to_owned(),
        outcome.status.name().to_owned(),
        multiplier(row),
        known.multiplier(),
        error.map_or("-".to_owned(), |e| number(100.0 * e, 2)),
        tan_beta,
        known.slope(),
        width(crack.and_then(|c| c.c)),
        width(crack.and_then(|c| c.e)),
        verdict(result, row).to_owned(),
        note(row),
    ]
}

/// λ with the digits that its status vouches for.
pub fn multiplier(row: &Row) -> String {
    let Some(Bracket { lower, upper }) = row.outcome.bracket else {
        return "-".to_owned();
    };
    // The closed form and the pushover's grid are exact in 5 decimals, and so is a proof to 1e-6.
    let exact = row.outcome.status != Status::Estimate || row.method == "macro-block";
    let decimals = if exact { 5 } else { 4 };
    let ends = [lower, upper].map(|end| number(end, decimals));
    let one = upper - lower <= 2e-6 * upper.abs().max(1e-3);
    if one {
        ends[0].clone()
    } else {
        ends.join(" - ")
    }
}

/// The worst verdict about this row, or "-" where nothing is known to compare with.
fn verdict(result: &CaseResult, row: &Row) -> &'static str {
    let about = |check: &&Check| check.head_joints == row.head_joints && check.method == row.method;
    let worst = result.checks.iter().filter(about).map(|c| c.verdict).max();
    worst.map_or("-", |verdict| verdict.name())
}

/// The reason, and the residual where it fails what `verified` asks for.
fn note(row: &Row) -> String {
    let mut note = row.outcome.reason().clone();
    if row.residual.is_some_and(|r| r > VERIFIED_RESIDUAL) && row.outcome.status != Status::Failed {
        note.push_str(", residual above 1e-8");
    }
    if row.outcome.crack.is_some_and(|c| !c.sharp) {
        let space = if note.is_empty() { "" } else { "; " };
        note.push_str(space);
        note.push_str("~ crack not sharp");
    }
    note
}

/// The references about one row, published ones first.
struct References<'a> {
    of_row: Vec<&'a Reference>,
}

impl<'a> References<'a> {
    fn of(case: &'a Case, row: &Row) -> Self {
        let mut of_row: Vec<&Reference> = case
            .references
            .iter()
            .filter(|r| r.method == row.method)
            .filter(|r| r.head_joints.is_none_or(|only| only == row.head_joints))
            .collect();
        of_row.sort_by_key(|r| (r.deviation.is_some(), r.kind as u8));
        Self { of_row }
    }

    fn first(&self, quantity: Quantity) -> Option<&'a Reference> {
        self.of_row.iter().copied().find(|r| r.quantity == quantity)
    }

    fn text(reference: &Reference) -> String {
        let letter = match reference.kind {
            Kind::Published => 'p',
            Kind::Analytic => 'a',
            Kind::Independent => 'i',
        };
        format!("{} {letter}", short(reference.value, 6))
    }

    fn multiplier(&self) -> String {
        if let Some(lambda) = self.first(Quantity::Lambda) {
            return Self::text(lambda);
        }
        match (self.first(Quantity::Lower), self.first(Quantity::Upper)) {
            (Some(low), Some(high)) => format!("{} - {}", short(low.value, 6), Self::text(high)),
            (one, other) => one.or(other).map_or("-".to_owned(), Self::text),
        }
    }

    fn slope(&self) -> String {
        self.first(Quantity::TanBeta)
            .map_or("-".to_owned(), Self::text)
    }

    /// Largest relative error over the references shown.
    fn error(&self, outcome: &Outcome) -> Option<f64> {
        let quantities = match self.first(Quantity::Lambda) {
            Some(_) => vec![Quantity::Lambda],
            None => vec![Quantity::Lower, Quantity::Upper],
        };
        let errors = quantities.into_iter().filter_map(|quantity| {
            let reference = self.first(quantity)?;
            Some(computed(outcome, quantity)?.error(reference.value))
        });
        errors.reduce(f64::max)
    }
}
