//! Scenes of the library's cases, with what their references say.

use super::grid::Known;
use crate::answer::Bracket;
use crate::case::{Case, Quantity, Reference, SourceKind, library};
use crate::method::{Kind, kind};
use crate::scene::HeadJoints;

/// The library's case of this name with what is known of it; `None` where there is no such case, or
/// its references leave λ_A or the lowest state open.
pub fn of_library(name: &str, head_joints: HeadJoints) -> Option<(Case, Known)> {
    let case = library().into_iter().find(|case| case.name == name)?;
    let about = |r: &&Reference| {
        r.head_joints.is_none_or(|only| only == head_joints)
            && r.kind != SourceKind::Published
            && r.deviation.is_none()
    };
    let value = |of: Kind, quantities: [Quantity; 2]| {
        let mut about = case.references.iter().filter(about);
        about.find(|r| kind(&r.method) == of && quantities.contains(&r.quantity))
    };
    use Quantity::{Lambda, Lower, Upper};
    let bound = value(Kind::AssociativeBounds, [Lambda; 2])?;
    let lowest = value(Kind::CollapseStates, [Lower, Lambda])?;
    let highest = value(Kind::CollapseStates, [Upper, Lambda]).unwrap_or(lowest);
    let accuracy = [bound, lowest, highest].map(|r| r.tolerance / r.value);
    let known = Known {
        states: Bracket {
            lower: lowest.value,
            upper: highest.value,
        },
        associative: bound.value,
        accuracy: accuracy.into_iter().fold(0.0, f64::max),
    };
    Some((case, known))
}
