//! The one value that everything about a scene is measured against.

use crate::case::{Case, Quantity, Reference, SourceKind};
use crate::method::{Kind, kind};
use crate::scene::HeadJoints;

/// The case's best reference for the collapse multiplier of a scene: an exact one, else what another
/// code computed, else what is published; and one of the collapse without dilatancy before one of
/// λ_A, which is only a bound of it. Where head joints are in contact that is the lowest verified
/// value known.
///
/// The closed form's own references say what it must compute, not when the wall collapses, and known
/// deviations are no measure.
pub fn reference(case: &Case, head_joints: HeadJoints) -> Option<&Reference> {
    let mut candidates: Vec<&Reference> = (case.references.iter())
        .filter(|r| r.head_joints.is_none_or(|only| only == head_joints))
        .filter(|r| kind(&r.method) != Kind::ClosedForm && r.deviation.is_none() && r.value > 0.0)
        .filter(|r| matches!(r.quantity, Quantity::Lambda | Quantity::Lower))
        .collect();
    // A stable sort: of equal ones, the first in the case.
    candidates.sort_by_key(|r| {
        let source = match r.kind {
            SourceKind::Analytic => 0,
            SourceKind::Independent => 1,
            SourceKind::Published => 2,
        };
        let bound = kind(&r.method) == Kind::AssociativeBounds && r.kind != SourceKind::Analytic;
        (bound, source, kind(&r.method) != Kind::CollapseStates)
    });
    candidates.first().copied()
}
