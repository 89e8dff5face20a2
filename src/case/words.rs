//! What a case is, in a line each: for `show`, and beside its answer.

use super::geometry::Geometry;
use super::model::Case;
use crate::scene::{Forces, Friction, Push};
use crate::text::counted;

/// What the case is made of, in one paragraph.
pub(crate) fn geometry_words(case: &Case) -> String {
    match &case.geometry {
        Geometry::Wall(wall) => format!(
            "{} courses of units {} x {} x {}, weight {} each{}; friction {}, overburden ratio {}; \
             {}",
            wall.courses.len(),
            wall.unit_length,
            wall.unit_height,
            wall.thickness,
            wall.unit_weight,
            match case.is_weight_unsaid {
                true => " as none is written: forces are in weights of a unit",
                false => "",
            },
            friction(wall.friction),
            wall.overburden,
            forces(&wall.own.forces)
        ),
        Geometry::Blocks(assembly) => {
            let supports = assembly.supports.iter().map(|s| s.name.as_str());
            format!(
                "{} blocks on {}; friction {}; {}; edges \
                 touch within {:e} of the smaller block's extent",
                assembly.blocks.len(),
                supports.collect::<Vec<_>>().join(", "),
                friction(assembly.friction),
                forces(&assembly.forces),
                assembly.tolerance
            )
        }
        Geometry::Arch(arch) => format!(
            "an arch of mean radius {}, thickness {}, embrace {} degrees, {} voussoirs; \
             friction {}; {}",
            arch.mean_radius,
            arch.thickness,
            arch.embrace,
            arch.voussoirs,
            friction(arch.friction),
            forces(&arch.forces)
        ),
    }
}

fn forces(forces: &Forces) -> String {
    let weight = live(forces);
    match forces.extra.len() {
        0 => weight,
        count => format!("{weight}, and {}", counted(count, "load")),
    }
}

/// What pushes without the loads.
fn live(forces: &Forces) -> String {
    let [along, upwards] = forces.of_weight.into();
    match [along, upwards] {
        [1.0, 0.0] => "the live load is every weight sideways".to_owned(),
        [0.0, 0.0] => "the live load is the loads alone".to_owned(),
        [1.0, _] => format!("the live load is every weight sideways and {upwards} of it upwards"),
        _ => {
            format!("the live load is {along} of every weight sideways and {upwards} of it upwards")
        }
    }
}

pub(crate) fn push_words(pushes: &[Push]) -> &'static str {
    match pushes {
        [Push::Right] => "to the right",
        [Push::Left] => "to the left",
        _ => "to the right and to the left, and the weaker side counts",
    }
}

/// One number where all joints are alike.
fn friction(friction: Friction) -> String {
    let Friction { bed, head, base } = friction;
    if bed == head && bed == base {
        bed.to_string()
    } else {
        format!("{bed} bed, {head} head, {base} base")
    }
}
