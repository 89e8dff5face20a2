//! Sequential linear programming for non-associative friction, the paper's micro-block method
//! (Gilbert, Casapulla & Ahmed, Computers & Structures 84 (2006) 873-887).

use super::ending::{Ending, totals};
use super::own_weight::{own_weight, stands_without_dilatancy, without_optimum};
use super::program::{FrictionLaw, Program};
use crate::answer::{Evidence, Outcome, SequentialEnding, SequentialFacts, Status, Work};
use crate::mechanics::{CollapseState, Mechanism, friction_excess, live_unit};
use crate::method::{Method, SequentialSettings, Settings};
use crate::scene::Scene;

/// `lower` and `upper` are both the last λ. It depends on the start and carries the bias of c0, so
/// it is an estimate unless the judge proves the state; `reason` names the ending.
pub struct Sequential;

/// α is halved every step down to this.
const LAST_ALPHA: f64 = 0.001;

/// Largest |Δλ|/λ of a step that counts as settled.
const SETTLED: f64 = 1e-4;

/// Settled steps in a row, α at its floor, that count as converged.
const STEPS_SETTLED: usize = 3;

/// Steps after which the procedure is given up.
const STEPS: usize = 60;

impl Method for Sequential {
    fn name(&self) -> &str {
        "sequential"
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        let mut work = Work::default();
        sequential(scene, settings, &mut work).after(work)
    }
}

fn sequential(scene: &Scene, settings: &Settings, work: &mut Work) -> Outcome {
    let SequentialSettings {
        mut alpha,
        beta,
        c0,
    } = settings.sequential;
    let at_rest = match own_weight(scene, work) {
        Ok(forces) => forces,
        Err(outcome) => return *outcome,
    };
    let program = Program::to_tolerance(scene, settings.programs.lp_tolerance);
    let mut program = program.by(settings.programs.engine);
    let mut ceiling = None;
    let (mut frozen, mut lambdas) = match program.solve_counted(work) {
        Ending::Solved(solution) => {
            ceiling = Some(program.scale().mechanism(&solution.velocity));
            (totals(&solution.forces), vec![solution.lambda])
        }
        // Nothing collapses by associative friction. The forces under the own weight are a start.
        Ending::Unbounded => {
            if let Some(outcome) = stands_without_dilatancy(scene, &at_rest, work) {
                return outcome;
            }
            let unit = scene.total_weight();
            let normal = totals(&at_rest);
            (normal.iter().map(|n| n / unit).collect(), Vec::new())
        }
        ending => return without_optimum(scene, &ending, at_rest, work),
    };
    let mut steps = 0;
    let mut last = None;
    let ending = loop {
        if steps == STEPS {
            break SequentialEnding::StepLimit;
        }
        program.set_friction(&substitute_law(scene, &frozen, alpha, c0));
        let solution = match program.solve_counted(work) {
            Ending::Solved(solution) => solution,
            Ending::Infeasible(_) => break SequentialEnding::SubProgramInfeasible,
            Ending::Unbounded => break SequentialEnding::SubProgramUnbounded,
            Ending::GaveUp(_) => break SequentialEnding::SubProgramUnsolved,
        };
        steps += 1;
        lambdas.push(solution.lambda);
        let normal = totals(&solution.forces);
        last = Some(solution);
        if let Some(ending) = ended(&lambdas).filter(|_| alpha <= LAST_ALPHA) {
            break ending;
        }
        for (old, new) in frozen.iter_mut().zip(normal) {
            *old = beta * new + (1.0 - beta) * *old;
        }
        alpha = (alpha / 2.0).max(LAST_ALPHA);
    };
    let facts = SequentialFacts { ending, steps };
    let Some(last) = last.filter(|_| ending == SequentialEnding::Converged) else {
        return Outcome::without_number(Status::Undecided, facts);
    };
    let state = (program.scale()).state(last.lambda, &last.forces, &last.velocity);
    let evidence = Evidence::State {
        stated_error: ceiling.and_then(|ceiling| stated_error(scene, &state, &ceiling)),
        state,
    };
    Outcome::with(Status::Estimate, evidence).because(facts)
}

/// What λ may be off by, relative to it: as much as it moves in the steps that settle it, and what
/// c0 and capacities that lag behind their normal forces let joints carry beyond Coulomb's law,
/// measured by how far that can raise λ above λ_A, whose mechanism is `ceiling`.
fn stated_error(scene: &Scene, state: &CollapseState, ceiling: &Mechanism) -> Option<f64> {
    let lambda = state.lambda;
    let excess = friction_excess(scene, &state.forces, ceiling);
    let least = 1e-3 * scene.total_weight() / live_unit(scene);
    let error = STEPS_SETTLED as f64 * SETTLED + excess / lambda.abs().max(least);
    error.is_finite().then_some(error)
}

/// |t| ≤ c0 + (1+α) μ n̄ − α μ n, a slightly contractant law through (n̄, μ n̄).
fn substitute_law(scene: &Scene, frozen: &[f64], alpha: f64, cohesion: f64) -> Vec<FrictionLaw> {
    // What guides a support is no joint between stones: its forces may be any, and it carries no shear.
    let contacts = scene.contacts().len();
    let c0 = cohesion * frozen[..contacts].iter().copied().fold(0.0, f64::max);
    let joints = scene.joints().iter().zip(frozen).enumerate();
    let laws = joints.map(|(index, (joint, n))| FrictionLaw {
        slope: -alpha * joint.friction,
        intercept: match index < contacts {
            true => c0 + (1.0 + alpha) * joint.friction * n,
            false => 0.0,
        },
    });
    laws.collect()
}

/// How the iteration ends with these λ, α being at its floor.
fn ended(lambdas: &[f64]) -> Option<SequentialEnding> {
    if has_settled(lambdas) {
        let is_push = lambdas.last().is_some_and(|lambda| *lambda >= 0.0);
        return Some(match is_push {
            true => SequentialEnding::Converged,
            false => SequentialEnding::BelowZero,
        });
    }
    let period = cycle(lambdas, SETTLED)?;
    Some(SequentialEnding::Cycling { period })
}

fn has_settled(lambdas: &[f64]) -> bool {
    let steps: Vec<f64> = lambdas
        .windows(2)
        .map(|w| (w[1] - w[0]).abs() / w[1].abs().max(1e-3))
        .collect();
    let recent = steps.iter().rev().take(STEPS_SETTLED);
    steps.len() >= STEPS_SETTLED && recent.copied().all(|step| step < SETTLED)
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
    fn a_repeating_tail_is_a_cycle_and_a_settled_one_is_not() {
        let repeating = [0.7, 0.5, 0.6, 0.5, 0.6, 0.5, 0.6];
        assert_eq!(cycle(&repeating, 1e-4), Some(2));
        assert_eq!(cycle(&[0.7, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5], 1e-4), None);
        assert!(has_settled(&[0.7, 0.5, 0.5, 0.5, 0.5]));
    }
}
