//! The collapse multiplier seen by Box2D: an outside program for trilith.
//!
//!     cargo build --release --example box2d_witness
//!     trilith run paper-1 --external box2d="target/release/examples/box2d_witness"
//!
//! Reads a scene on standard input, writes a bracket on standard output. The engine is the crate
//! `box2d-rust`, which nobody here wrote: rigid bodies of single precision in soft contact. The scene
//! is scaled so that its median block has `--size` metres, comes to rest, and is pushed in steps, each
//! held until it rests or runs away. An upper end counts only where a step of the tolerance collapsed
//! from rest.

#[path = "box2d/pieces.rs"]
mod pieces;
#[path = "box2d/scene.rs"]
mod scene;
#[path = "box2d/search.rs"]
mod search;
#[path = "box2d/simulation.rs"]
mod simulation;

use clap::Parser;
use serde_json::{Value, json};

use search::Ending;
use simulation::{Setting, Simulation};

/// The collapse multiplier of a scene on standard input, seen by Box2D.
#[derive(Parser)]
struct Arguments {
    /// Steps a second
    #[arg(long, default_value_t = 240.0)]
    rate: f64,
    /// Substeps a step
    #[arg(long, default_value_t = 8)]
    substeps: i32,
    /// Stiffness of contacts in Hz [default: an eighth of the substeps a second, the most that Box2D
    /// takes]
    #[arg(long)]
    hertz: Option<f64>,
    /// Size of the median block in metres
    #[arg(long, default_value_t = 1.0)]
    size: f64,
    /// Width of the bracket, relative to λ
    #[arg(long, default_value_t = 0.002)]
    tolerance: f64,
    /// Do not repeat it with half the time step, and state no error
    #[arg(long)]
    once: bool,
    /// Say every step on standard error
    #[arg(long)]
    verbose: bool,
}

/// The push, as a part of the dead load, that the answer may always be off: three times the most by
/// which it was, on stacks that a push of 3e-4 of their weight topples (8e-6).
const SMALLEST: f64 = 2.5e-5;

fn main() {
    let arguments = Arguments::parse();
    let given = &arguments;
    let hertz = given.hertz.unwrap_or(1.0);
    let substeps = f64::from(given.substeps);
    let positive = |value: f64| value.is_finite() && value > 0.0;
    let numbers = [given.rate, given.size, given.tolerance, hertz, substeps];
    if !numbers.into_iter().all(positive) {
        eprintln!("every setting is a number above 0");
        std::process::exit(2);
    }
    let scene: scene::Scene = match serde_json::from_reader(std::io::stdin().lock()) {
        Ok(scene) => scene,
        Err(error) => {
            eprintln!("no scene on standard input: {error}");
            std::process::exit(2);
        }
    };
    println!("{}", answer(&scene, &arguments));
}

/// The bracket, or why there is none. The error that it states is what half the time step changes.
fn answer(scene: &scene::Scene, arguments: &Arguments) -> Value {
    let coarse = match bracket(scene, arguments, arguments.rate) {
        Ok(found) => found,
        Err(answer) => return answer,
    };
    if arguments.once {
        return json!({"kind": "estimate", "lambda": coarse[0], "upper": coarse[1]});
    }
    let [lower, upper] = match bracket(scene, arguments, 2.0 * arguments.rate) {
        Ok(found) => found,
        Err(answer) => return answer,
    };
    // Single precision tells no smaller pushes apart, whatever the step.
    let (dead, live) = scene::sizes(scene);
    let least = (SMALLEST * dead / live / lower).max(arguments.tolerance);
    let error = (lower - coarse[0]).abs().max((upper - coarse[1]).abs()) / lower;
    json!({
        "kind": "estimate", "lambda": lower, "upper": upper,
        "stated_error": error.max(least).min(1.0),
    })
}

fn bracket(scene: &scene::Scene, arguments: &Arguments, rate: f64) -> Result<[f64; 2], Value> {
    let undecided = |reason: String| json!({"kind": "undecided", "reason": reason});
    let setting = Setting {
        rate,
        substeps: arguments.substeps,
        hertz: (arguments.hertz).unwrap_or(rate * f64::from(arguments.substeps) / 8.0),
        size: arguments.size,
    };
    let (dead, live) = scene::sizes(scene);
    if dead <= 0.0 || live <= 0.0 {
        return Err(undecided("no dead load, or nothing that pushes".to_owned()));
    }
    let mut simulation = Simulation::new(scene, setting).map_err(
        |reason| json!({"kind": "not-applicable", "reason": format!("Box2D: {reason}")}),
    )?;
    // λ in units in which the live load is as large as the dead one.
    match search::search(&mut simulation, dead / live, arguments) {
        Ending::Bracket { lower, upper } => Ok([lower, upper]),
        Ending::Undecided(reason) => Err(undecided(reason)),
    }
}
