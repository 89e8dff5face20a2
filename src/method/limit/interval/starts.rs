//! Where the search for collapse states begins: few starts, chosen on purpose, all deterministic.

use super::noise::Noise;
use super::search::{Approach, Search, totals};
use crate::answer::SearchStart;
use crate::method::limit::ending::Ending;
use crate::scene::{HeadJoints, JointClass, Scene};

/// Normal forces to begin with.
pub(super) struct Start {
    /// What they are.
    pub(super) kind: SearchStart,
    /// N of every joint, dimensionless.
    pub(super) normal: Vec<f64>,
    /// How it goes on.
    pub(super) approach: Approach,
}

/// The first `count` starts, at least one.
///
/// With head joints in contact, the first two are the lowest state of the same scene with open head
/// joints (nothing on head joints: the state before pushing) and the associative state, which lies
/// in the middle of the optimal face. Between them they reach the lowest state known on every wall
/// with a reference; an interior-point solver started at random does not. With open head joints
/// the associative state comes first and is followed by the forces of a few programs with frozen
/// capacities, which find lower branches on irregular bonds. Further ones scale each joint's
/// associative N by 0.2 to 1.6.
pub(super) fn starts(
    scene: &Scene,
    search: &mut Search,
    count: usize,
) -> Result<Vec<Start>, Ending> {
    let mut starts = Vec::new();
    if scene.head_joints() == HeadJoints::Contact
        && let Some(normal) = open_state(scene, search)
    {
        starts.push(Start {
            kind: SearchStart::OpenState,
            normal,
            approach: Approach::Quick,
        });
    }
    if starts.len() >= count {
        return Ok(starts);
    }
    let associative = search.associative()?;
    starts.push(Start {
        kind: SearchStart::Associative,
        normal: associative.clone(),
        approach: Approach::Quick,
    });
    if starts.len() < count
        && let Some(normal) = frozen_state(search, associative.clone())
    {
        starts.push(Start {
            kind: SearchStart::Frozen,
            normal,
            approach: Approach::Quick,
        });
    }
    while starts.len() < count {
        let mut noise = Noise::new(starts.len());
        let scaled = associative
            .iter()
            .map(|n| n * (0.2 + 1.4 * noise.uniform()));
        starts.push(Start {
            kind: SearchStart::Scaled,
            normal: scaled.collect(),
            approach: Approach::Quick,
        });
    }
    Ok(starts)
}

/// The first `count` starts of a scene without an associative state: the forces that hold it under
/// its own weight, as they are and each scaled by 0.1 to 1.8.
pub(super) fn starts_at_rest(search: &mut Search, at_rest: &[f64], count: usize) -> Vec<Start> {
    search.carry(at_rest.to_vec());
    let scaled = |index: usize| {
        let mut noise = Noise::new(index);
        let scaled = at_rest.iter().map(|n| n * (0.1 + 1.7 * noise.uniform()));
        Start {
            kind: SearchStart::Scaled,
            normal: scaled.collect(),
            approach: Approach::Blending,
        }
    };
    let first = Start {
        kind: SearchStart::OwnWeight,
        normal: at_rest.to_vec(),
        approach: Approach::Quick,
    };
    std::iter::once(first)
        .chain((1..count).map(scaled))
        .collect()
}

/// Normal forces after a few programs with frozen capacities, each from the last one's forces: the
/// way of the sequential method, which ends on other branches than the gap does.
fn frozen_state(search: &mut Search, mut normal: Vec<f64>) -> Option<Vec<f64>> {
    for _ in 0..4 {
        normal = totals(&search.frozen(&normal).ok()?.forces);
    }
    Some(normal)
}

/// Normal forces of the lowest state of the first start with open head joints, zero on those;
/// `None` where the scene has no head joints or no such state is found.
fn open_state(scene: &Scene, search: &mut Search) -> Option<Vec<f64>> {
    let is_head = |class| class == JointClass::Head;
    if !scene.joints().iter().any(|joint| is_head(joint.class)) {
        return None;
    }
    let open = scene.clone().with_head_joints(HeadJoints::Open);
    let mut inner = Search::new(&open);
    let state = inner.associative().ok().and_then(|normal| {
        let first = inner.close(normal, Approach::Quick).ok()?;
        Some(inner.extreme_of(&first, -1.0))
    });
    search.work.programs += inner.work.programs;
    search.work.iterations += inner.work.iterations;
    let mut beds = totals(&state?.forces).into_iter();
    let all = scene.joints().iter().map(|joint| match joint.class {
        JointClass::Head => Some(0.0),
        JointClass::Base | JointClass::Bed => beds.next(),
    });
    all.collect()
}
