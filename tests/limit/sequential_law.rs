//! The substitute law of the sequential method, |t| ≤ c0 + (1+α) μ n̄ − α μ n, is Coulomb's once the
//! normal forces have settled: what slides, slides at its friction.

use trilith::method::limit::Sequential;
use trilith::method::{Method, Settings};
use trilith::scene::{HeadJoints, Own, Piece, Push, Wall};

/// λ of flat courses, each a unit wide, on top of each other, and the error that is stated for it.
fn answer(courses: usize, friction: f64) -> [f64; 2] {
    let wall = Wall {
        unit_length: 8.0,
        unit_height: 1.0,
        thickness: 1.0,
        unit_weight: 1.0,
        courses: vec![vec![Piece::Unit]; courses],
        friction: friction.into(),
        overburden: 0.0,
        push: Push::Right,
        own: Own::default(),
    };
    let scene = wall.scene(HeadJoints::Open).expect("it can be laid");
    let outcome = Sequential.solve(&scene, &Settings::default());
    let error = outcome
        .evidence
        .stated_error()
        .expect("there is a λ_A to measure it by");
    [outcome.bracket().expect("it slides").upper, error]
}

/// λ = μ in closed form, to what c0 adds: 1e-6 of the largest normal force.
#[test]
fn what_slides_slides_at_its_friction() {
    for friction in [0.1, 0.3, 0.65] {
        for courses in [1, 3] {
            let [found, stated] = answer(courses, friction);
            let error = (found - friction).abs() / friction;
            let what = format!("{courses} courses, μ {friction}: {found} ± {stated}");
            assert!(error <= 5e-4, "{what}");
            // Three settled steps of 1e-4 each, and what c0 lifts.
            assert!(error <= stated && stated <= 5e-4, "{what}");
        }
    }
}
