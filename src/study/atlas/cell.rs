//! What a method's answer at one place is worth.

use std::borrow::Cow;
use std::collections::BTreeMap;

use super::grid::{Grid, GridPoint};
use crate::answer::{Bracket, Status};
use crate::method::{Method, kind};
use crate::run::{Row, Subject, Task};
use crate::scene::HeadJoints;
use crate::text::worded;

worded! {
    /// What an answer turned out to be.
    #[derive(PartialOrd, Ord)]
    CellVerdict {
        /// Within 1 % of what is known.
        Right = "right",
        /// Farther off, and it claims no more: an estimate, a range that is wider than what is known, a
        /// search that has missed the lowest state.
        Inaccurate = "inaccurate",
        /// No answer: `undecided`, `not-applicable`, `failed`.
        Refused = "refused",
        /// What is known refutes what a `verified` or `bracketed` answer states, or an answer without a
        /// multiplier where there is one.
        Wrong = "WRONG",
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
    /// What the answer is compared with, from elsewhere.
    pub reference: Bracket,
    /// Distance of the answer's farther end from that, relative, where there is an answer.
    pub error: Option<f64>,
    /// The answer.
    pub row: Row,
    /// What it turned out to be.
    pub verdict: CellVerdict,
}

impl Cell {
    fn new(grid: &Grid, place: &GridPoint, row: Row) -> Self {
        let known = &place.known;
        let kind = kind(&row.method);
        let unit = row.multiplier_unit;
        let stated = row.stated_error().unwrap_or(0.0);
        let answer = row.bracket();
        let error = answer.map(|answer| known.error(kind, answer, unit));
        let holds = answer.is_none_or(|answer| known.allows(kind, answer, stated, unit));
        let verdict = verdict(row.status(), error, holds);
        Self {
            grid: grid.name,
            x: place.x.clone(),
            y: place.y.clone(),
            reference: known.expected(kind),
            error: error.filter(|_| verdict != CellVerdict::Refused),
            verdict,
            row,
        }
    }
}

/// What an answer is worth that is off by `error`, if it has a number, and `holds` in what it
/// states. A claim is held to what it states, also where that is less than 1 %.
fn verdict(status: Status, error: Option<f64>, holds: bool) -> CellVerdict {
    let claims = match status {
        Status::Undecided | Status::NotApplicable | Status::Failed => return CellVerdict::Refused,
        Status::Stands | Status::Falls => return CellVerdict::Wrong,
        Status::Verified | Status::Bracketed => true,
        Status::Estimate => false,
    };
    let Some(error) = error else {
        return CellVerdict::Refused;
    };
    match (claims && !holds, error <= RIGHT) {
        (true, _) => CellVerdict::Wrong,
        (false, true) => CellVerdict::Right,
        (false, false) => CellVerdict::Inaccurate,
    }
}

/// Methods on every place of the grids that speak of them, before and while they run.
pub struct Atlas<'a> {
    places: Vec<(&'a Grid, &'a GridPoint)>,
    tasks: Vec<Task<'a>>,
}

impl<'a> Atlas<'a> {
    /// These methods on these grids.
    pub fn new(grids: &'a [Grid], methods: &[&'a dyn Method]) -> Self {
        let (mut places, mut tasks) = (Vec::new(), Vec::new());
        for grid in grids {
            let speaks = |name: &str| grid.kinds.is_empty() || grid.kinds.contains(&kind(name));
            for &method in methods.iter().filter(|method| speaks(method.name())) {
                for place in &grid.cells {
                    places.push((grid, place));
                    tasks.push(task(grid, place, method));
                }
            }
        }
        Self { places, tasks }
    }

    /// The tasks, one a cell.
    pub fn tasks(&self) -> &[Task<'a>] {
        &self.tasks
    }

    /// The cells whose rows are there, in the order of the tasks.
    pub fn cells(&self, rows: &[Row]) -> Vec<Cell> {
        let known: BTreeMap<&str, &Row> = rows.iter().map(|row| (row.id.as_str(), row)).collect();
        let places = self.places.iter().zip(&self.tasks);
        let cells = places.filter_map(|((grid, place), task)| {
            let row = known.get(task.id())?;
            Some(Cell::new(grid, place, (*row).clone()))
        });
        cells.collect()
    }
}

fn task<'a>(grid: &Grid, place: &'a GridPoint, method: &'a dyn Method) -> Task<'a> {
    let subject = Subject {
        case: grid.name.to_owned(),
        head_joints: HeadJoints::Contact,
        parameters: vec![
            (grid.x.to_owned(), place.x.clone()),
            (grid.y.to_owned(), place.y.clone()),
        ],
        blocks: place.scene.blocks().len(),
        sides: Box::new(|| Cow::Borrowed(std::slice::from_ref(&place.scene))),
        determined_by: Vec::new(),
    };
    Task::new(subject, method, place.settings)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::Kind;
    use crate::study::atlas::grid::Known;

    /// The verdict on an answer of a method of this kind where this is known.
    fn of(kind: Kind, known: Known, status: Status, ends: [f64; 2], stated: f64) -> CellVerdict {
        let [lower, upper] = ends;
        let answer = Bracket { lower, upper };
        let error = known.error(kind, answer, 1.0);
        verdict(status, Some(error), known.allows(kind, answer, stated, 1.0))
    }

    #[test]
    fn claims_are_held_to_what_they_state_and_estimates_to_one_percent() {
        use CellVerdict::*;
        let of = |status, ends, stated| of(Kind::Observed, Known::exact(0.5), status, ends, stated);
        assert_eq!(of(Status::Verified, [0.5, 0.5], 0.0), Right);
        assert_eq!(of(Status::Verified, [0.501, 0.501], 0.0), Wrong);
        assert_eq!(of(Status::Bracketed, [0.4985, 0.499], 2e-3), Right);
        assert_eq!(of(Status::Bracketed, [0.497, 0.498], 2e-3), Wrong);
        assert_eq!(of(Status::Bracketed, [0.4, 0.6], 0.0), Inaccurate);
        assert_eq!(of(Status::Estimate, [0.3, 0.3], 0.0), Inaccurate);
        assert_eq!(of(Status::Estimate, [0.503, 0.503], 0.0), Right);
        assert_eq!(of(Status::Undecided, [0.3, 0.3], 0.0), Refused);
        assert_eq!(of(Status::Verified, [f64::NAN, f64::NAN], 0.0), Wrong);
        assert_eq!(verdict(Status::Stands, None, true), Wrong);
        assert_eq!(verdict(Status::Undecided, None, true), Refused);
        // A state below the only one.
        let (kind, known) = (Kind::CollapseStates, Known::exact(0.5));
        assert_eq!(
            super::tests::of(kind, known, Status::Verified, [0.4, 0.5], 0.0),
            Wrong
        );
    }

    #[test]
    fn where_there_are_several_states_each_kind_is_held_to_what_it_is_about() {
        use CellVerdict::*;
        let known = Known {
            states: Bracket {
                lower: 0.4,
                upper: 0.5,
            },
            associative: 0.6,
            accuracy: 1e-6,
        };
        let (bounds, states) = (Kind::AssociativeBounds, Kind::CollapseStates);
        let (enclosure, seen) = (Kind::Enclosure, Kind::Observed);
        for (kind, ends, expected) in [
            (bounds, [0.6, 0.6], Right),
            (bounds, [0.4, 0.5], Wrong),
            (states, [0.4, 0.55], Right),
            (states, [0.39, 0.39], Right),
            (states, [0.45, 0.5], Inaccurate),
            (states, [0.4, 0.61], Wrong),
            (enclosure, [0.4, 0.6], Right),
            (enclosure, [0.4, 0.59], Wrong),
            (enclosure, [0.61, 0.61], Wrong),
            (seen, [0.4, 0.5], Right),
            (seen, [0.55, 0.55], Inaccurate),
            (seen, [0.61, 0.62], Wrong),
            (seen, [0.38, 0.39], Wrong),
        ] {
            let status = match kind {
                Kind::Enclosure | Kind::Observed => Status::Bracketed,
                _ => Status::Verified,
            };
            let found = of(kind, known, status, ends, 0.0);
            assert_eq!(found, expected, "{kind:?} {ends:?}");
        }
    }
}
