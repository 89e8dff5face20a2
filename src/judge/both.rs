//! The conclusion about a wall that is pushed both ways, from those about its sides; and which of several
//! governs.

use super::conclusion::{Basis, Conclusion, Floor};
use crate::answer::is_same_multiplier;

/// The conclusion about a wall: that of the side that governs, with the other's beside it. A side
/// without an answer governs only where the other stands.
///
/// # Panics
/// Where there is no side.
pub(crate) fn of_wall(mut sides: Vec<Conclusion>) -> Conclusion {
    let first = governing(&sides).expect("there is a side");
    let mut conclusion = sides.swap_remove(first);
    if let Some(other) = sides.pop() {
        conclusion.floor = floor(&conclusion, &other);
        conclusion.other = Some(Box::new(other));
    }
    conclusion
}

/// The place of the conclusion that governs: the first of those that no other governs over. `None` where
/// there are none.
pub(crate) fn governing(conclusions: &[Conclusion]) -> Option<usize> {
    let over = |first: usize, next: usize| match governs(&conclusions[next], &conclusions[first]) {
        true => next,
        false => first,
    };
    (0..conclusions.len()).reduce(over)
}

/// Whether a conclusion governs over another: of those with the same multiplier but for rounding neither does.
fn governs(a: &Conclusion, b: &Conclusion) -> bool {
    match (a.collapse_known(), b.collapse_known()) {
        (Some(x), Some(y)) => x < y && !is_same_multiplier(x, y, b.multiplier_unit),
        _ => rank(a.basis) < rank(b.basis),
    }
}

fn rank(basis: Basis) -> u8 {
    match basis {
        Basis::Falls => 0,
        Basis::LowestState | Basis::UpperBound | Basis::Observed | Basis::Estimate => 1,
        Basis::Nothing => 2,
        Basis::NoneFound => 3,
        Basis::Stands => 4,
    }
}

/// What is proved of both sides: the lower of their bounds, for the motions that both speak of. Where
/// one has none, the other's holds for its own push alone.
fn floor(governing: &Conclusion, other: &Conclusion) -> Option<Floor> {
    let own = governing.floor.clone();
    if other.basis == Basis::Stands {
        return own;
    }
    let (Some(own), Some(others)) = (&own, &other.floor) else {
        let push = Some(governing.push);
        return own.map(|own| Floor { push, ..own });
    };
    let mut by = own.by.clone();
    if others.by != own.by {
        by = format!("{by} and {}", others.by);
    }
    Some(Floor {
        by,
        lower: own.lower.min(others.lower),
        // A state that moves farther than the smaller cap is excluded for one side only.
        cap: own.cap.into_iter().chain(others.cap).reduce(f64::min),
        push: None,
    })
}
