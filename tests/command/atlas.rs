//! The small atlas: no method is wrong anywhere on it, and it notices methods that are.

use trilith::answer::{Bracket, Observed, Outcome, Status};
use trilith::inside::without_lower_bounds;
use trilith::inside::{Ending, Program};
use trilith::inside::{Parameters, solve_with};
use trilith::inside::{
    atlas, atlas::Atlas, atlas::Cell, atlas::CellVerdict, atlas::grids, run_rows,
};
use trilith::method::limit::{Associative, Interval};
use trilith::method::{Method, Settings};
use trilith::scene::{Block, Scene, SceneParts};

fn of(cells: &[Cell], verdict: CellVerdict) -> Vec<&Cell> {
    cells
        .iter()
        .filter(|cell| cell.verdict == verdict)
        .collect()
}

/// The cells of these methods on these grids.
fn cells(grids: &[atlas::Grid], methods: &[&dyn Method]) -> Vec<Cell> {
    let atlas = Atlas::new(grids, methods);
    let rows = run_rows(atlas.tasks(), None, &|_| {}).unwrap();
    atlas.cells(&rows)
}

#[test]
fn no_cell_of_the_small_atlas_is_wrong() {
    let grids = grids(false);
    let cells = cells(&grids, &without_lower_bounds());
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
        let picture = atlas::picture(grid, &cells, None);
        assert!(
            picture.contains(grid.x) && !picture.contains("NaN"),
            "{}",
            grid.name
        );
        assert_eq!(picture, atlas::picture(grid, &cells, None));
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
                facts: vec!["the solver says solved".into()],
                ..observed(Some(Bracket::point(solution.lambda)))
            },
            ending => Outcome::without_number(Status::Undecided, ending.kind().to_string()),
        }
    }
}

/// What a method observes that sees no block lighter than a thousandth of the heaviest.
struct SeesTheHeavy;

impl Method for SeesTheHeavy {
    fn name(&self) -> &str {
        "associative"
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        let weight = |block: &Block| -block.dead()[1];
        let heaviest = scene.blocks().iter().map(weight).fold(0.0, f64::max);
        let heavy = scene.blocks().iter();
        let heavy = heavy.filter(|block| weight(block) > 1e-3 * heaviest);
        let friction = scene.joints()[0].friction;
        let supports = scene.supports().to_vec();
        let parts = SceneParts::new(heavy.cloned().collect(), supports, friction);
        let seen = Scene::new(parts).expect("the numbers stay proper");
        observed(Associative.solve(&seen, settings).bracket())
    }
}

/// The associative multiplier from a grid of pushes that ends at 100 and has steps of 1e-4.
struct AbsoluteGrid;

impl Method for AbsoluteGrid {
    fn name(&self) -> &str {
        "associative"
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        let bracket = Associative.solve(scene, settings).bracket();
        observed(bracket.map(|exact| Bracket {
            lower: ((exact.lower / 1e-4).floor() * 1e-4).min(100.0 - 1e-4),
            upper: ((exact.upper / 1e-4).ceil() * 1e-4).min(100.0),
        }))
    }
}

/// The associative multiplier put forward as the lowest collapse state.
struct TakesTheBoundForTheState;

impl Method for TakesTheBoundForTheState {
    fn name(&self) -> &str {
        "interval"
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        observed(Associative.solve(scene, settings).bracket())
    }
}

/// A bracket that claims to be right to 1e-4 and gives no proof that the judge could refute.
fn observed(bracket: Option<Bracket>) -> Outcome {
    let stated_error = Some(1e-4);
    let observed = Observed {
        bracket,
        stated_error,
        ..Observed::default()
    };
    Outcome::with(Status::Bracketed, observed)
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
        solve_with(scene, &settings.pushover, |own| Parameters {
            substep: second / 240.0,
            substeps: 4,
            contact_frequency: 30.0 / second,
            damping_ratio: 5.0,
            settlement: f64::INFINITY,
            drift: f64::INFINITY,
            self_checks: false,
            ..own
        })
    }
}

fn cells_of(names: &[&str], method: &dyn Method) -> Vec<Cell> {
    let grids = grids(false).into_iter();
    let wanted: Vec<_> = grids.filter(|grid| names.contains(&grid.name)).collect();
    assert_eq!(wanted.len(), names.len());
    cells(&wanted, &[method])
}

#[test]
fn planted_faults_are_wrong_cells() {
    let walls: &[&str] = &["courses-friction", "unit-distance"];
    let faults: [(&dyn Method, &[&str], usize); 4] = [
        (&StopsEarly, walls, 3),
        (&Uncalibrated, walls, 3),
        (&SeesTheHeavy, &["weights", "light-beside-heavy"], 3),
        (&AbsoluteGrid, &["live-load"], 2),
    ];
    for (method, grids, at_least) in faults {
        let cells = cells_of(grids, method);
        let wrong = of(&cells, CellVerdict::Wrong);
        assert!(wrong.len() >= at_least, "{grids:?}: {cells:#?}");
    }
}

/// Where states lie below λ_A, a search that stays above them is not right.
#[test]
fn a_missed_state_is_not_right() {
    let cells = cells_of(&["openings-contact"], &TakesTheBoundForTheState);
    let missed = of(&cells, CellVerdict::Inaccurate);
    assert_eq!(missed.len(), cells.len());
    let found = cells_of(&["openings-contact"], &Interval);
    assert_eq!(of(&found, CellVerdict::Right).len(), found.len());
}
