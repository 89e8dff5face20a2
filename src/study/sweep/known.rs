//! Values from elsewhere on the walls of a sweep: those of built-in cases.

use crate::case::{Geometry, Quantity, Reference, find, library};
use crate::method::{Kind, kind};
use crate::scene::{HeadJoints, Wall};

/// A multiplier that somebody else gives for a point of a sweep over the overburden.
#[derive(Clone, Debug, PartialEq)]
pub struct KnownPoint {
    /// Overburden ratio.
    pub overburden: f64,
    pub lambda: f64,
    /// The method that it is about.
    pub method: String,
    /// What it stands on.
    pub source: String,
}

/// Values of all built-in cases that are this case under any overburden, for a setting of head joints.
/// What is known of the closed form holds for both settings.
pub fn of_overburden(case: &str, head_joints: HeadJoints) -> Vec<KnownPoint> {
    let Some(base) = find(case)
        .ok()
        .and_then(|cases| bare(&cases.first()?.geometry))
    else {
        return Vec::new();
    };
    let mut points = Vec::new();
    for case in library() {
        let Geometry::Wall(wall) = &case.geometry else {
            continue;
        };
        if bare(&case.geometry).as_ref() != Some(&base) {
            continue;
        }
        let own = case
            .references
            .iter()
            .filter(|r| is_multiplier(r, head_joints));
        points.extend(own.map(|r| KnownPoint {
            overburden: wall.overburden,
            lambda: r.value,
            method: r.method.clone(),
            source: format!("{}: {}, {}", case.name, r.kind.name(), r.source),
        }));
    }
    points
}

/// A wall without what differs between the cases.
fn bare(geometry: &Geometry) -> Option<Wall> {
    match geometry {
        Geometry::Wall(wall) => Some(Wall {
            overburden: 0.0,
            ..wall.clone()
        }),
        Geometry::Blocks(_) | Geometry::Arch(_) => None,
    }
}

fn is_multiplier(reference: &Reference, head_joints: HeadJoints) -> bool {
    let holds = reference.head_joints.is_none_or(|only| only == head_joints);
    let of_lambda = matches!(
        reference.quantity,
        Quantity::Lambda | Quantity::Lower | Quantity::Upper
    );
    holds && of_lambda && kind(&reference.method) != Kind::Outside
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_overburdens_of_the_library_are_points_of_paper_1() {
        let points = of_overburden("paper-1", HeadJoints::Open);
        let overburdens: Vec<f64> = points.iter().map(|point| point.overburden).collect();
        for expected in [0.0, 0.25, 1.0, 10.0] {
            assert!(overburdens.contains(&expected), "{overburdens:?}");
        }
        let associative =
            |point: &&KnownPoint| point.method == "associative" && point.overburden == 1.0;
        let found = points.iter().find(associative).unwrap();
        assert_eq!(found.lambda, 0.558296);
        assert!(
            of_overburden("stack", HeadJoints::Open)
                .iter()
                .all(|p| p.overburden == 0.0)
        );
        assert!(of_overburden("no-such", HeadJoints::Open).is_empty());
    }
}
