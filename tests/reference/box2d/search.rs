//! The search for the first push that topples: settle, raise, hold, go back.

use super::Arguments;
use super::simulation::Simulation;

/// Times in seconds, under a gravity of 10 m/s² and blocks of about 1 m.
const SETTLE: f64 = 1.0;
const RAMP: f64 = 0.5;
const WINDOW: f64 = 0.5;
/// Windows after which a hold that neither rests nor runs away is given up.
const WINDOWS: usize = 16;
/// Motion in one window, in sizes of the median block: at rest below the first; below the second
/// at the end of the hold where it grows no more.
const AT_REST: f64 = 2e-5;
const CREEPS: f64 = 1e-3;
/// Motion since the step began that counts as collapse where the last windows grew.
const COLLAPSE: f64 = 0.05;
/// The push that is large enough, as a multiple of the dead load.
const MOST: f64 = 50.0;

pub enum Ending {
    Bracket { lower: f64, upper: f64 },
    Undecided(String),
}

enum Held {
    Rests,
    Collapses,
    Neither(f64),
}

pub fn search(simulation: &mut Simulation, unit: f64, arguments: &Arguments) -> Ending {
    let verbose = arguments.verbose;
    simulation.run(SETTLE, 0.0, 0.0);
    simulation.halt();
    match hold(simulation, 0.0, 0.0, verbose) {
        Held::Rests => {}
        Held::Collapses => return Ending::Undecided("falls before it is pushed".to_owned()),
        Held::Neither(moved) => {
            return Ending::Undecided(format!(
                "creeps by {moved:.1e} a window before it is pushed"
            ));
        }
    }
    let mut kept = simulation.keep();
    let (mut lower, mut step) = (0.0, 0.1);
    while lower < MOST {
        let tried: f64 = lower + step;
        let width = arguments.tolerance * lower.max(1e-3);
        let held = hold(simulation, lower * unit, tried * unit, verbose);
        if let Held::Rests = held {
            kept = simulation.keep();
            lower = tried;
            step *= 1.5;
            continue;
        }
        if step <= width {
            return match held {
                Held::Neither(moved) => Ending::Undecided(format!(
                    "at λ = {} neither at rest nor collapsed: {moved:.1e} of a block a window",
                    tried * unit
                )),
                _ => Ending::Bracket {
                    lower: lower * unit,
                    upper: tried * unit,
                },
            };
        }
        simulation.restore(&kept);
        step = if step <= 4.0 * width {
            width
        } else {
            step / 4.0
        };
    }
    Ending::Undecided(format!("stands up to λ = {}", lower * unit))
}

/// Raises the push and holds it until the scene rests, collapses, or the time is over.
fn hold(simulation: &mut Simulation, from: f64, to: f64, verbose: bool) -> Held {
    let begin = simulation.places();
    simulation.run(RAMP, from, to);
    let mut last = simulation.places();
    let mut before = f64::INFINITY;
    let mut held = Held::Rests;
    for window in 0..4 * WINDOWS {
        simulation.run(WINDOW, to, to);
        let now = simulation.places();
        let moved = simulation.moved(&last, &now);
        let total = simulation.moved(&begin, &now);
        last = now;
        held = if moved < AT_REST {
            Held::Rests
        } else if total > COLLAPSE && moved >= before || total > 4.0 * COLLAPSE {
            Held::Collapses
        } else {
            let (rests, grows) = (moved < CREEPS && moved <= 1.2 * before, moved > before);
            before = moved;
            let most = if grows { 4 * WINDOWS } else { WINDOWS };
            if window + 1 < most {
                continue;
            }
            if rests {
                Held::Rests
            } else {
                Held::Neither(moved)
            }
        };
        if verbose {
            let word = match held {
                Held::Rests => "rests",
                Held::Collapses => "collapses",
                Held::Neither(_) => "neither",
            };
            eprintln!(
                "{to:.5} {word} after {window} windows, {moved:.1e} in the last, {total:.1e} in all"
            );
        }
        break;
    }
    held
}
