//! Checks that cost further runs: half the substep, and the mirrored scene.

use super::checks::{Check, agree};
use super::settings::Settings;
use super::solve_with;
use crate::method::{self, Outcome};
use crate::scene::{Point, Polygon, PolygonError, Push, Scene, Vector};

/// Repeats a bracketed pushover with half the substep and on the mirrored scene. Empty where
/// `outcome` has no bracket.
pub fn verify(scene: &Scene, user: &method::Settings, outcome: &Outcome) -> Vec<Check> {
    let (Some(bracket), Some(error)) = (outcome.bracket, outcome.stated_error) else {
        return Vec::new();
    };
    let compare = |other: Option<Outcome>, what: &str| match other.map(|o| (o.bracket, o.reason)) {
        Some((Some(other), _)) => agree(bracket, other, error, what),
        Some((None, reason)) => failed(what, &reason),
        None => failed(what, "the scene cannot be mirrored"),
    };
    vec![
        compare(
            Some(solve_with(scene, user, Settings::halved)),
            "half the substep",
        ),
        compare(
            mirrored(scene).ok().map(|m| solve_with(&m, user, |s| s)),
            "mirrored",
        ),
    ]
}

fn failed(what: &str, reason: &str) -> Check {
    Check {
        passed: false,
        text: format!("{what}: {reason}"),
    }
}

/// The scene seen from behind: everything mirrored about the middle of the blocks, the push too.
///
/// # Errors
/// Never on a valid scene; a mirrored outline is as good as the outline.
pub fn mirrored(scene: &Scene) -> Result<Scene, PolygonError> {
    let (low, high) = scene.bounds();
    let about = low.x + high.x;
    let point = |p: Point| Point::new(about - p.x, p.y);
    let vector = |v: Vector| Vector::new(-v.x, v.y);
    let shape = |s: &Polygon| Polygon::new(s.corners().iter().map(|&p| point(p)).collect());
    let mut scene = scene.clone();
    for block in &mut scene.blocks {
        block.shape = shape(&block.shape)?;
        for load in &mut block.loads {
            load.point = point(load.point);
            load.dead = vector(load.dead);
            load.live = vector(load.live);
        }
    }
    for support in &mut scene.supports {
        *support = shape(support)?;
    }
    for joint in &mut scene.joints {
        joint.ends = joint.ends.map(point);
        joint.normal = vector(joint.normal);
    }
    scene.push = match scene.push {
        Push::Right => Push::Left,
        Push::Left => Push::Right,
    };
    Ok(scene)
}
