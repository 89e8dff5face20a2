//! The hot paths one by one, for `tests/guard/run`: does the work of the path that its argument
//! names and prints the work counters; without an argument, lists the paths.

use trilith::answer::{CollapseResidual, Outcome, StaticResidual, Work};
use trilith::inside::Program;
use trilith::inside::{atlas::Columns, atlas::running_bond};
use trilith::method::limit::{Associative, Bound, Interval, Sequential};
use trilith::method::pushover::Pushover;
use trilith::method::{Method, Settings};

/// A path's name and its work.
type Path = (&'static str, fn() -> Work);

const PATHS: [Path; 9] = [
    ("joints", joints),
    ("assembly", assembly),
    ("associative", || work(&Associative, 10)),
    ("sequential", || work(&Sequential, 6)),
    ("interval", || work(&Interval, 6)),
    ("bound", || work(&Bound, 3)),
    ("reduced", || work(&Associative, 60)),
    ("judge", judge),
    ("pushover", pushover),
];

fn main() {
    let Some(wanted) = std::env::args().nth(1) else {
        for (name, _) in PATHS {
            println!("{name}");
        }
        return;
    };
    let Some((name, path)) = PATHS.into_iter().find(|(name, _)| *name == wanted) else {
        eprintln!("there is no path named `{wanted}`");
        std::process::exit(2);
    };
    let work = path();
    println!(
        "{name} {} {} {} {}",
        work.modelled, work.programs, work.iterations, work.block_steps
    );
}

fn solved(method: &dyn Method, courses: usize) -> Outcome {
    method.solve(&running_bond(courses), &Settings::default())
}

fn work(method: &dyn Method, courses: usize) -> Work {
    solved(method, courses).work
}

/// Laying a wall and finding its joints; the counter is the joints.
fn joints() -> Work {
    Work {
        modelled: running_bond(200).joints().len(),
        ..Work::default()
    }
}

/// The matrix of the linear program; the counter is the scenes.
fn assembly() -> Work {
    let scene = running_bond(40);
    let programs: Vec<Program> = (0..20).map(|_| Program::new(&scene)).collect();
    Work {
        programs: programs.len(),
        ..Work::default()
    }
}

/// Residuals of one state, again and again; the counter is the rounds.
fn judge() -> Work {
    let scene = running_bond(10);
    let outcome = solved(&Associative, 10);
    let (Some((_, forces)), Some(mechanism)) =
        (outcome.evidence.forces(), outcome.evidence.mechanism())
    else {
        return Work::default();
    };
    let mut rounds = 0;
    for round in 0..1000 {
        let lambda = 1e-3 * f64::from(round);
        let statics = StaticResidual::of(&scene, forces, lambda).largest();
        let collapse = CollapseResidual::of(&scene, forces, mechanism).largest();
        rounds += usize::from(statics.is_finite() && collapse.is_finite());
    }
    Work {
        iterations: rounds,
        ..Work::default()
    }
}

fn pushover() -> Work {
    let columns = Columns::default();
    Pushover.solve(&columns.scene(), &Settings::default()).work
}
