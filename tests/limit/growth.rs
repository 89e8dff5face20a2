//! How time and memory grow with the wall: a table, with the few limits that are promised.

use crate::scenes::{laid, running_bond};
use trilith::answer::Status;
use trilith::judge::judge;
use trilith::method::limit::{Associative, Interval};
use trilith::method::{Method, Settings};
use trilith::scene::{HeadJoints, Scene};

/// What one method costs on one scene.
struct Cost {
    /// CPU seconds: printed, and held to nothing, as a machine may be slow.
    seconds: f64,
    /// Peak resident megabytes.
    megabytes: f64,
    /// Iterations of all its programs.
    iterations: usize,
}

fn measure(method: &dyn Method, scene: &Scene) -> Cost {
    let mut settings = Settings::default();
    settings.interval.starts = 1;
    reset_peak();
    let clock = cpu_time::ThreadTime::now();
    let mut outcome = method.solve(scene, &settings);
    let seconds = clock.elapsed().as_secs_f64();
    let peak = peak();
    judge(scene, &mut outcome);
    assert_eq!(outcome.status, Status::Verified, "{}", outcome.reason());
    let bracket = outcome.bracket().expect("verified with a bracket");
    println!(
        "  {:12} {:.6} {:5} of {:5} blocks {:4} programs {:5} iterations {seconds:8.3} s {peak:6.0} MB",
        method.name(),
        bracket.lower,
        outcome.work.modelled,
        scene.blocks().len(),
        outcome.work.programs,
        outcome.work.iterations,
    );
    Cost {
        seconds,
        megabytes: peak,
        iterations: outcome.work.iterations,
    }
}

/// Linux keeps the peak for a process; NaN elsewhere.
fn peak() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let kilobytes = line.and_then(|line| line.split_whitespace().next()?.parse::<f64>().ok());
    kilobytes.unwrap_or(f64::NAN) / 1024.0
}

fn reset_peak() {
    // Where this fails the peak is that of all runs so far: too large, never too small.
    let _ = std::fs::write("/proc/self/clear_refs", "5");
}

/// Slope of log(seconds) over log(blocks), least squares.
fn exponent(points: &[(f64, f64)]) -> f64 {
    let logs: Vec<(f64, f64)> = points.iter().map(|(x, y)| (x.ln(), y.ln())).collect();
    let count = logs.len() as f64;
    let mean = |part: fn(&(f64, f64)) -> f64| logs.iter().map(part).sum::<f64>() / count;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let covariance: f64 = logs.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let variance: f64 = logs.iter().map(|p| (p.0 - x).powi(2)).sum();
    covariance / variance
}

/// Most iterations of a program of λ_A: an interior point needs few more on a wall of 96 courses than
/// on one of 12.
const MOST_ITERATIONS: usize = 100;

/// Up to 96 courses: λ_A in few iterations, under 1.5 GB.
#[test]
#[ignore = "a measurement, in release only"]
fn time_and_memory_grow_as_promised() {
    let names = [
        "contact, whole",
        "open, whole",
        "open, reduced",
        "open interval",
    ];
    let mut points = vec![Vec::new(); names.len()];
    for courses in [12, 24, 48, 96] {
        println!("{courses} courses");
        let wall = running_bond(courses, courses / 2, 0.75);
        let open = laid(&wall, HeadJoints::Open);
        // Without the coursing there is no stagger line to cut along.
        let whole = open.clone().without_wall();
        let runs: [(&dyn Method, &Scene); 4] = [
            (&Associative, &laid(&wall, HeadJoints::Contact)),
            (&Associative, &whole),
            (&Associative, &open),
            (&Interval, &open),
        ];
        // On 96 courses the gap stays open (at 1.4e-6 and above) for all steps of a start.
        let count = if courses < 96 { 4 } else { 3 };
        for (k, (method, scene)) in runs.into_iter().enumerate().take(count) {
            let Cost {
                seconds,
                megabytes,
                iterations,
            } = measure(method, scene);
            points[k].push((scene.blocks().len() as f64, seconds));
            let limit = [
                MOST_ITERATIONS,
                MOST_ITERATIONS,
                MOST_ITERATIONS,
                usize::MAX,
            ][k];
            assert!(iterations <= limit, "{}: {iterations} iterations", names[k]);
            assert!(megabytes.is_nan() || megabytes < 1536.0, "{megabytes} MB");
        }
    }
    for (name, points) in names.iter().zip(&points) {
        println!("{name}: seconds grow as blocks^{:.2}", exponent(points));
    }
}
