//! The range that everything about a scene is measured against.

use crate::answer::{Bracket, magnitude};
use crate::case::{Case, Quantity, Reference, SourceKind};
use crate::method::{Kind, kind};
use crate::scene::HeadJoints;

/// The collapse multipliers of a scene that are known from elsewhere.
#[derive(Clone, Debug, PartialEq)]
pub struct ReferenceRange {
    /// The value of the case that gives the lower end.
    pub lowest: Reference,
    /// Lowest and highest collapse state; one number where the multiplier is unique or no highest state
    /// is known.
    pub range: Bracket,
}

impl ReferenceRange {
    /// Distances of an answer's ends [a, b] from those of the range [r, R], relative to the
    /// [`magnitude`] of r: |a − r| and |b − R|.
    pub fn distances(&self, answer: Bracket, unit: f64) -> [f64; 2] {
        let Bracket { lower, upper } = self.range;
        let relative = |distance: f64| distance.abs() / magnitude(lower, unit);
        [
            relative(answer.lower - lower),
            relative(answer.upper - upper),
        ]
    }

    /// Whether an answer's lower end is not above the lowest state, to the digits of that.
    pub fn is_safe(&self, answer: Bracket, unit: f64) -> bool {
        let lowest = self.range.lower;
        answer.lower <= lowest + DIGITS * magnitude(lowest, unit)
    }

    /// Whether the lower end is of λ_A alone, the multiplier with dilatancy: an upper bound of what is
    /// wanted.
    pub fn is_associative(&self) -> bool {
        kind(&self.lowest.method) == Kind::AssociativeBounds
            && self.lowest.kind != SourceKind::Analytic
    }
}

/// Relative size of what references have no digits for.
pub const DIGITS: f64 = 1e-6;

/// The case's range for the collapse multiplier of a scene.
pub fn reference(case: &Case, head_joints: HeadJoints) -> Option<ReferenceRange> {
    let lowest = lowest(case, head_joints)?.clone();
    let own = |r: &&Reference| {
        r.head_joints.is_none_or(|only| only == head_joints)
            && kind(&r.method) == Kind::CollapseStates
            && r.quantity == Quantity::Upper
            && r.deviation.is_none()
    };
    let cited = case.references.iter().find(own).map(|r| r.value);
    let upper = cited.or_else(|| highest(&case.name, head_joints));
    let lower = lowest.value;
    let upper = upper.filter(|upper| *upper > lower).unwrap_or(lower);
    Some(ReferenceRange {
        lowest,
        range: Bracket { lower, upper },
    })
}

/// The case's best reference for the collapse multiplier of a scene: an exact one, else what another
/// code computed, else what is published; and one of the collapse without dilatancy before one of
/// λ_A, which is only a bound of it. Where head joints are in contact that is the lowest verified
/// value known.
///
/// The closed form's own references say what it must compute, not when the wall collapses, and known
/// deviations are no measure.
fn lowest(case: &Case, head_joints: HeadJoints) -> Option<&Reference> {
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

/// Case, setting and λ of the highest collapse states without dilatancy that another code found, which no
/// case cites: `states` of `tests/reference/limit.py` (HiGHS, SciPy
/// 1.17.1, 40 starts in contact and 20 open, seed 14), whose lowest are those that the cases cite. Six
/// digits, as the cases have.
const HIGHEST: [(&str, HeadJoints, f64); 5] = [
    ("paper-1", HeadJoints::Contact, 0.642859),
    ("paper-2", HeadJoints::Contact, 0.579317),
    ("paper-2", HeadJoints::Open, 0.562907),
    ("openings-3", HeadJoints::Contact, 0.402648),
    ("openings-4", HeadJoints::Contact, 0.322823),
];

/// The highest state of a scene, where it is not the lowest.
fn highest(case: &str, head_joints: HeadJoints) -> Option<f64> {
    let known = HIGHEST
        .iter()
        .find(|(name, setting, _)| *name == case && *setting == head_joints);
    known.map(|(_, _, lambda)| *lambda)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::find;

    /// Design, "Error of an answer": max(|a − r|, |b − R|) / r.
    #[test]
    fn neither_a_wide_bracket_nor_one_number_for_a_range_looks_exact() {
        let case = &find("paper-1").unwrap()[0];
        let known = reference(case, HeadJoints::Contact).unwrap();
        let range = Bracket {
            lower: 0.638982,
            upper: 0.642859,
        };
        assert_eq!(known.range, range);
        let error = |answer| known.distances(answer, 1.0).into_iter().fold(0.0, f64::max);
        assert_eq!(error(range), 0.0);
        let lowest = error(Bracket::point(0.638982));
        assert!((lowest - 0.003877 / 0.638982).abs() < 1e-12, "{lowest}");
        let closed = Bracket {
            lower: 0.48712,
            upper: 0.94545,
        };
        let far = error(closed);
        assert!(
            (far - (0.94545 - 0.642859) / 0.638982).abs() < 1e-12,
            "{far}"
        );
        assert!(known.is_safe(closed, 1.0) && !known.is_safe(Bracket::point(0.6429), 1.0));
        let open = reference(case, HeadJoints::Open).unwrap();
        assert_eq!(open.range, Bracket::point(0.639969));
    }
}
