//! What a method's answer at one place is worth.

use std::borrow::Cow;

use super::grid::{Grid, GridPoint};
use super::grids::grids;
use crate::answer::{Bracket, Status, magnitude};
use crate::method::{Method, kind};
use crate::run::{Progress, Row, Subject, Task};
use crate::scene::HeadJoints;
use crate::study::sweep;

/// What an answer turned out to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum CellVerdict {
    /// Within 1 % of the reference.
    Right,
    /// Outside, and it claims no more: an estimate, or a range that holds the reference.
    Inaccurate,
    /// No answer: `undecided`, `not-applicable`, `failed`.
    Refused,
    /// The reference lies outside what a `verified` or `bracketed` answer states, or an answer
    /// without a multiplier where there is one.
    Wrong,
}

impl CellVerdict {
    /// Every verdict, from good to bad.
    pub const ALL: [CellVerdict; 4] = [
        CellVerdict::Right,
        CellVerdict::Inaccurate,
        CellVerdict::Refused,
        CellVerdict::Wrong,
    ];

    /// The word in tables and legends.
    pub fn name(self) -> &'static str {
        match self {
            CellVerdict::Right => "right",
            CellVerdict::Inaccurate => "inaccurate",
            CellVerdict::Refused => "refused",
            CellVerdict::Wrong => "WRONG",
        }
    }
}

/// Relative error of a right answer.
pub const RIGHT: f64 = 0.01;

/// One method at one place of a grid.
#[derive(Clone, Debug)]
pub struct Cell {
    /// Name of the grid.
    pub grid: &'static str,
    /// Values of the place.
    pub x: String,
    /// Values of the place.
    pub y: String,
    /// The multiplier, from elsewhere.
    pub reference: f64,
    /// The answer.
    pub row: Row,
    /// What it turned out to be.
    pub verdict: CellVerdict,
}

impl Cell {
    fn new(grid: &Grid, place: &GridPoint, row: Row) -> Self {
        let stated = row.outcome.stated_error.unwrap_or(0.0);
        let (status, bracket) = (row.status(), row.bracket());
        let known = [place.reference, place.accuracy];
        Self {
            grid: grid.name,
            x: place.x.clone(),
            y: place.y.clone(),
            reference: place.reference,
            verdict: verdict(status, bracket, stated, known, row.multiplier_unit),
            row,
        }
    }

    /// Error of the farther end, where there is an answer.
    pub fn error(&self) -> Option<f64> {
        let answered = self.verdict != CellVerdict::Refused;
        Some(
            self.row
                .bracket()
                .filter(|_| answered)?
                .error(self.reference, self.row.multiplier_unit),
        )
    }
}

/// What an answer is worth against a reference that is itself known to `accuracy`, in a scene with
/// this `unit` of λ. A claim is held
/// to what it states, also where that is less than 1 %.
fn verdict(
    status: Status,
    bracket: Option<Bracket>,
    stated: f64,
    [reference, accuracy]: [f64; 2],
    unit: f64,
) -> CellVerdict {
    let claims = match status {
        Status::Undecided | Status::NotApplicable | Status::Failed => return CellVerdict::Refused,
        Status::Stands | Status::Falls => return CellVerdict::Wrong,
        Status::Verified | Status::Bracketed => true,
        Status::Estimate => false,
    };
    let Some(bracket) = bracket else {
        return CellVerdict::Refused;
    };
    let slack = (stated + accuracy) * magnitude(reference, unit);
    let holds = bracket.lower - slack <= reference && reference <= bracket.upper + slack;
    match (claims && !holds, bracket.error(reference, unit) <= RIGHT) {
        (true, _) => CellVerdict::Wrong,
        (false, true) => CellVerdict::Right,
        (false, false) => CellVerdict::Inaccurate,
    }
}

/// Runs methods on every place of the grids that speak of them, through the sweep's runner.
pub fn run(grids: &[Grid], methods: &[&dyn Method], progress: &dyn Progress) -> Vec<Cell> {
    let (mut of_task, mut tasks) = (Vec::new(), Vec::new());
    for grid in grids {
        let speaks = |name: &str| grid.kinds.is_empty() || grid.kinds.contains(&kind(name));
        for &method in methods.iter().filter(|method| speaks(method.name())) {
            for place in &grid.cells {
                of_task.push((grid, place));
                tasks.push(task(grid, place, method));
            }
        }
    }
    let rows = sweep::run(&tasks, None, progress);
    // Only a journal can fail.
    let rows = rows.unwrap_or_default();
    let cells = of_task.into_iter().zip(rows);
    cells
        .map(|((grid, place), row)| Cell::new(grid, place, row))
        .collect()
}

fn task<'a>(grid: &Grid, place: &'a GridPoint, method: &'a dyn Method) -> Task<'a> {
    let subject = Subject {
        case: grid.name.to_owned(),
        head_joints: HeadJoints::Contact,
        parameters: vec![
            (grid.x.to_owned(), place.x.clone()),
            (grid.y.to_owned(), place.y.clone()),
        ],
        blocks: place.blocks,
        sides: Box::new(|| Cow::Owned(vec![(place.scene)()])),
        determined_by: Vec::new(),
    };
    Task::new(subject, method, place.settings)
}

/// Number of places of all grids, for a method that all of them speak of.
pub fn size(large: bool) -> usize {
    grids(large).iter().map(|grid| grid.cells.len()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn claims_are_held_to_what_they_state_and_estimates_to_one_percent() {
        let at = |lower, upper| Some(Bracket { lower, upper });
        let of = |status, bracket, stated| verdict(status, bracket, stated, [0.5, 1e-6], 1.0);
        use CellVerdict::*;
        assert_eq!(of(Status::Verified, at(0.5, 0.5), 0.0), Right);
        assert_eq!(of(Status::Verified, at(0.501, 0.501), 0.0), Wrong);
        assert_eq!(of(Status::Bracketed, at(0.4985, 0.499), 2e-3), Right);
        assert_eq!(of(Status::Bracketed, at(0.497, 0.498), 2e-3), Wrong);
        assert_eq!(of(Status::Bracketed, at(0.4, 0.6), 0.0), Inaccurate);
        assert_eq!(of(Status::Estimate, at(0.3, 0.3), 0.0), Inaccurate);
        assert_eq!(of(Status::Estimate, at(0.503, 0.503), 0.0), Right);
        assert_eq!(of(Status::Undecided, at(0.3, 0.3), 0.0), Refused);
        assert_eq!(of(Status::Stands, None, 0.0), Wrong);
        assert_eq!(of(Status::Verified, at(f64::NAN, f64::NAN), 0.0), Wrong);
    }
}
