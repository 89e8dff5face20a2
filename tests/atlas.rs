//! The small atlas: no method is wrong anywhere on it, and it notices methods that are.

use trilith::answer::{Bracket, Claim, Outcome, Status};
use trilith::method::limit::{Ending, Program};
use trilith::method::pushover::{Parameters, solve_with};
use trilith::method::{Method, Settings, methods};
use trilith::scene::Scene;
use trilith::study::atlas::{self, Cell, CellVerdict, grids};

fn of(cells: &[Cell], verdict: CellVerdict) -> Vec<&Cell> {
    cells
        .iter()
        .filter(|cell| cell.verdict == verdict)
        .collect()
}

#[test]
fn no_cell_of_the_small_atlas_is_wrong() {
    let grids = grids(false);
    let cells = atlas::run(&grids, &methods(), &());
    assert!(
        grids.len() >= 4 && cells.len() >= 60,
        "{} cells",
        cells.len()
    );
    let wrong = of(&cells, CellVerdict::Wrong);
    assert!(wrong.is_empty(), "{wrong:#?}");
    // Refusing everything would be no wrong cell either.
    for method in ["associative", "interval", "pushover", "auto"] {
        let own: Vec<Cell> = cells
            .iter()
            .filter(|c| c.row.method == method)
            .cloned()
            .collect();
        let right = of(&own, CellVerdict::Right).len();
        assert!(
            2 * right > own.len(),
            "{method}: {right} of {} are right",
            own.len()
        );
    }
    let loose = |c: &&Cell| c.grid == "tolerance" && c.row.method == "associative";
    let statuses: Vec<Status> = cells.iter().filter(loose).map(|c| c.row.status()).collect();
    assert!(statuses.contains(&Status::Estimate) && statuses.contains(&Status::Verified));
    for grid in &grids {
        let picture = atlas::picture(grid, &cells);
        assert!(
            picture.contains(grid.x) && !picture.contains("NaN"),
            "{}",
            grid.name
        );
        assert_eq!(picture, atlas::picture(grid, &cells));
    }
}

/// A solver that stops early and claims success: its own word that the error is below 1e-4.
struct StopsEarly;

impl Method for StopsEarly {
    fn name(&self) -> &str {
        "associative"
    }

    fn solve(&self, scene: &Scene, _settings: &Settings) -> Outcome {
        match Program::to_tolerance(scene, 1e-2).solve() {
            Ending::Solved(solution) => Outcome {
                claim: Claim::Observed,
                bracket: Some(Bracket::point(solution.lambda)),
                stated_error: Some(1e-4),
                ..Outcome::without_number(Status::Bracketed, "the solver says solved")
            },
            ending => Outcome::without_number(Status::Undecided, ending.kind().to_string()),
        }
    }
}

/// The pushover as rapier comes: four substeps of 1/240 s, contacts of 30 Hz, points renewed; no
/// self-check may take its number away.
struct Uncalibrated;

impl Method for Uncalibrated {
    fn name(&self) -> &str {
        "pushover"
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        // Units of √(H_c/g) for courses of 1.75 m.
        let second = (9.81_f64 / 1.75).sqrt();
        let outcome = solve_with(scene, &settings.pushover, |own| Parameters {
            substep: second / 240.0,
            substeps: 4,
            contact_frequency: 30.0 / second,
            damping_ratio: 5.0,
            settlement: f64::INFINITY,
            drift: f64::INFINITY,
            self_checks: false,
            ..own
        });
        Outcome {
            claim: Claim::Observed,
            ..outcome
        }
    }
}

#[test]
fn planted_faults_are_wrong_cells() {
    let grids = grids(false);
    let walls: Vec<_> = (grids.into_iter())
        .filter(|grid| ["courses-friction", "unit-distance"].contains(&grid.name))
        .collect();
    for (method, at_least) in [(&StopsEarly as &dyn Method, 3), (&Uncalibrated, 3)] {
        let cells = atlas::run(&walls, &[method], &());
        let wrong = of(&cells, CellVerdict::Wrong);
        assert!(wrong.len() >= at_least, "{}: {cells:#?}", method.name());
    }
}
