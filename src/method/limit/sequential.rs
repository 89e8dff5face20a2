//! Sequential linear programming for non-associative friction, the paper's micro-block method
//! (Gilbert, Casapulla & Ahmed, Computers & Structures 84 (2006) 873-887).

use super::ending::{Ending, Solution};
use super::own_weight::{own_weight, without_optimum};
use super::program::{FrictionLaw, Program};
use crate::answer::{
    Bracket, Outcome, SequentialEnding, SequentialFacts, Status, VELOCITY_THRESHOLDS, Work,
    crack_slope,
};
use crate::method::{Method, Settings};
use crate::scene::Scene;

/// `lower` and `upper` are both the last λ. It depends on the start and carries the bias of c0, so
/// it is an estimate unless the judge proves the state; `reason` names the ending.
pub struct Sequential;

/// Every number of the procedure. Users of the published one differ in them, so they stand here.
#[derive(Clone, Copy, Debug, PartialEq)]
struct SequentialSettings {
    /// α of the first step: how contractant the substitute friction law is.
    first_alpha: f64,
    /// α is halved every step down to this.
    last_alpha: f64,
    /// β: share of the new normal force in the next n̄.
    renewal: f64,
    /// c0 over the largest normal force: shear that every joint carries uncompressed.
    cohesion: f64,
    /// Largest |Δλ|/λ of a step that counts as settled.
    settled: f64,
    /// Settled steps in a row, α at its floor, that count as converged.
    steps_settled: usize,
    /// Steps after which the procedure is given up.
    steps: usize,
}

impl Default for SequentialSettings {
    fn default() -> Self {
        Self {
            first_alpha: 0.3,
            last_alpha: 0.001,
            renewal: 0.6,
            // 1e-5, as published, lifts λ on a wall of 48 courses 0.04 % above λ_A; the bias is in
            // proportion, and down to 1e-7 no more sub-programs become infeasible (measured).
            cohesion: 1e-6,
            settled: 1e-4,
            steps_settled: 3,
            steps: 60,
        }
    }
}

impl SequentialSettings {
    /// The defaults with what a user asks for.
    fn of_user(user: &Settings) -> Self {
        Self {
            first_alpha: user.alpha,
            renewal: user.beta,
            cohesion: user.c0,
            ..Self::default()
        }
    }
}

impl Method for Sequential {
    fn name(&self) -> &str {
        "sequential"
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        sequential(scene, &SequentialSettings::of_user(settings), settings)
    }
}

/// Runs the procedure with settings of one's own; of `user`, only those of the program count.
fn sequential(scene: &Scene, settings: &SequentialSettings, user: &Settings) -> Outcome {
    let mut work = Work::default();
    let at_rest = match own_weight(scene, &mut work) {
        Ok(forces) => forces,
        Err(outcome) => return *outcome,
    };
    let mut program = Program::to_tolerance(scene, user.lp_tolerance, user.scaling);
    let start = match program.solve_counted(&mut work) {
        Ending::Solved(solution) => solution,
        ending => return without_optimum(scene, &ending, at_rest, &mut work),
    };
    let mut frozen = normal_forces(&start);
    let mut lambdas = vec![start.lambda];
    let mut last = start;
    let mut alpha = settings.first_alpha;
    let ending = loop {
        if lambdas.len() > settings.steps {
            break SequentialEnding::StepLimit;
        }
        program.set_friction(&substitute_law(scene, &frozen, alpha, settings.cohesion));
        last = match program.solve_counted(&mut work) {
            Ending::Solved(solution) => solution,
            Ending::Infeasible(_) => break SequentialEnding::SubProgramInfeasible,
            Ending::Unbounded => break SequentialEnding::SubProgramUnbounded,
            Ending::GaveUp(_) => break SequentialEnding::SubProgramUnsolved,
        };
        lambdas.push(last.lambda);
        let at_floor = alpha <= settings.last_alpha;
        if at_floor && has_settled(&lambdas, settings) {
            break SequentialEnding::Converged;
        }
        if at_floor && let Some(period) = cycle(&lambdas, settings.settled) {
            break SequentialEnding::Cycling { period };
        }
        for (old, new) in frozen.iter_mut().zip(normal_forces(&last)) {
            *old = settings.renewal * new + (1.0 - settings.renewal) * *old;
        }
        alpha = (alpha / 2.0).max(settings.last_alpha);
    };
    let facts = SequentialFacts {
        ending,
        steps: lambdas.len() - 1,
    };
    let outcome = if ending == SequentialEnding::Converged {
        converged(scene, &program, &last, facts)
    } else {
        Outcome::without_number(Status::Undecided, facts)
    };
    Outcome { work, ..outcome }
}

fn converged(scene: &Scene, program: &Program, last: &Solution, facts: SequentialFacts) -> Outcome {
    let scale = program.scale();
    let mechanism = scale.mechanism(&last.velocity);
    Outcome {
        bracket: Some(Bracket::point(last.lambda)),
        crack: crack_slope(scene, &mechanism, VELOCITY_THRESHOLDS),
        mechanism: Some(mechanism),
        forces: Some(scale.forces(&last.forces)),
        ..Outcome::without_number(Status::Estimate, facts)
    }
}

fn normal_forces(solution: &Solution) -> Vec<f64> {
    let forces = solution.forces.iter();
    forces
        .map(|f| (f.normal[0] + f.normal[1]).max(0.0))
        .collect()
}

/// |t| ≤ c0 + (1+α) μ n̄ − α μ n, a slightly contractant law through (n̄, μ n̄).
fn substitute_law(scene: &Scene, frozen: &[f64], alpha: f64, cohesion: f64) -> Vec<FrictionLaw> {
    let c0 = cohesion * frozen.iter().copied().fold(0.0, f64::max);
    let laws = scene
        .joints()
        .iter()
        .zip(frozen)
        .map(|(joint, n)| FrictionLaw {
            slope: -alpha * joint.friction,
            intercept: c0 + (1.0 + alpha) * joint.friction * n,
        });
    laws.collect()
}

fn has_settled(lambdas: &[f64], settings: &SequentialSettings) -> bool {
    let steps: Vec<f64> = lambdas
        .windows(2)
        .map(|w| (w[1] - w[0]).abs() / w[1].abs().max(1e-3))
        .collect();
    let recent = steps.iter().rev().take(settings.steps_settled);
    steps.len() >= settings.steps_settled && recent.copied().all(|step| step < settings.settled)
}

/// Period p ≥ 2 with which the last 3p values repeat themselves far closer than they change.
fn cycle(lambdas: &[f64], settled: f64) -> Option<usize> {
    (2..=8).find(|&period| {
        let Some(start) = lambdas.len().checked_sub(3 * period) else {
            return false;
        };
        let recent = &lambdas[start..];
        let repeats = recent
            .iter()
            .zip(&recent[period..])
            .all(|(a, b)| (a - b).abs() < 0.01 * settled * a.abs());
        let changes = recent
            .windows(2)
            .any(|w| (w[1] - w[0]).abs() > settled * w[0].abs());
        repeats && changes
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_user_who_asks_for_nothing_gets_the_defaults() {
        let asked = SequentialSettings::of_user(&Settings::default());
        assert_eq!(asked, SequentialSettings::default());
    }

    #[test]
    fn a_repeating_tail_is_a_cycle_and_a_settled_one_is_not() {
        let repeating = [0.7, 0.5, 0.6, 0.5, 0.6, 0.5, 0.6];
        assert_eq!(cycle(&repeating, 1e-4), Some(2));
        assert_eq!(cycle(&[0.7, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5], 1e-4), None);
        assert!(has_settled(
            &[0.7, 0.5, 0.5, 0.5, 0.5],
            &SequentialSettings::default()
        ));
    }
}
