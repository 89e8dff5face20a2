//! `trilith show`: one case as it is read.

use std::fmt::Write;

use crate::case::{self, Case, Geometry, geometry_words, push_words};
use crate::method::{PushoverSettings, pushover};
use crate::number::short;
use crate::scene::{Assembly, HeadJoints, Joint, JointClass, Scene, Sense, Side, Wall};

use super::plan::warn;
use super::screen::print_lines;
use super::stop::Stop;

pub(super) fn show(argument: &str, pushover: bool) -> Result<u8, Stop> {
    let cases = case::find(argument)?;
    warn(&cases);
    for case in &cases {
        print_lines(&description(case))?;
        for &head_joints in case.head_joints.iter().filter(|_| pushover) {
            let scene = case.scene(head_joints);
            let lines = pushover::parameters(&scene, &PushoverSettings::default())
                .unwrap_or_else(|reason| format!("It is not run: {reason}.\n"));
            print_lines(&format!(
                "pushover, {} head joints\n{lines}",
                head_joints.name()
            ))?;
        }
    }
    Ok(0)
}

fn description(case: &Case) -> String {
    let mut text = format!("{}: {}\nsource: {}\n", case.name, case.title, case.source);
    let _ = writeln!(text, "{}", geometry_words(case));
    text.push_str(&own(&case.geometry));
    let _ = writeln!(text, "pushed {}", push_words(&case.pushes));
    if let Some(demand) = case.demand {
        let _ = writeln!(text, "λ is compared with the demand of {demand}");
    }
    for head_joints in &case.head_joints {
        let scene = case.scene(*head_joints);
        let _ = writeln!(text, "{}", crate::record::fingerprint(*head_joints, &scene));
    }
    if let Geometry::Blocks(_) = case.geometry {
        text.push_str(&steep_joints(&case.scene(HeadJoints::Contact)));
    }
    if let Some(motion) = &case.motion {
        for support in &motion.supports {
            let [x, y] = [support.away.x, support.away.y].map(|part| short(part, 4));
            let (way, along) = match motion.sense {
                Sense::Away => ("away from", "along"),
                Sense::Against => ("against", "against"),
            };
            let name = &support.name;
            let _ = writeln!(
                text,
                "{name} moves {way} the wall, which is {along} [{x}, {y}]"
            );
        }
    }
    for r in &case.references {
        let joints = r.head_joints.map_or("both", |h| h.name());
        let _ = writeln!(
            text,
            "{} {} {}: {} +- {} ({}, {})",
            r.method,
            joints,
            r.quantity.name(),
            r.value,
            r.tolerance,
            r.kind.name(),
            r.source
        );
    }
    text
}

/// Which joints between blocks are head joints, and which are bed joints although they are steep.
fn steep_joints(scene: &Scene) -> String {
    let named = |wanted: &dyn Fn(&Joint) -> bool| {
        let joints = scene.joints().iter().filter(|joint| wanted(joint));
        let names = joints.filter_map(|joint| match joint.from {
            Side::Block(from) => {
                let names = [from, joint.to].map(|block| scene.block_name(block));
                Some(names.join(" | "))
            }
            Side::Support(_) => None,
        });
        names.collect::<Vec<_>>()
    };
    let is_steep = |joint: &Joint| joint.normal.x.abs() > joint.normal.y.abs();
    let heads = named(&|joint| joint.class == JointClass::Head);
    let beds = named(&|joint| joint.class == JointClass::Bed && is_steep(joint));
    listed("head joints", heads) + &listed("steep bed joints", beds)
}

/// Joints and blocks that are named at most.
const MOST_NAMED: usize = 40;

/// What single courses, joints and blocks have of their own, a line each; no line where they have nothing.
fn own(geometry: &Geometry) -> String {
    let assembly = geometry.assembly();
    let mut text = match geometry {
        Geometry::Wall(wall) => own_courses(wall),
        Geometry::Blocks(_) | Geometry::Arch(_) => String::new(),
    };
    let name = |body: Side| match body {
        Side::Block(block) => assembly.blocks[block].name.as_str(),
        Side::Support(support) => assembly.supports[support].name.as_str(),
    };
    let joints = match geometry {
        // Those of whole courses are named by them.
        Geometry::Wall(wall) => &wall.own.joints,
        Geometry::Blocks(_) | Geometry::Arch(_) => &assembly.named_joints,
    };
    let words = joints.iter().map(|joint| {
        let [one, other] = joint.between.map(name);
        let class = joint.class.map(|class| format!("{} joint", class.name()));
        let friction = joint
            .friction
            .map(|friction| format!("friction {friction}"));
        let open = joint.open.then(|| "open".to_owned());
        let said: Vec<String> = class.into_iter().chain(friction).chain(open).collect();
        format!("{one} | {other} ({})", said.join(", "))
    });
    text.push_str(&listed("joints of their own kind", words.collect()));
    let blocks = assembly.blocks.iter();
    let rough = blocks.filter_map(|block| Some(format!("{} {}", block.name, block.friction?)));
    text.push_str(&listed("friction of blocks", rough.collect()));
    if assembly.overburden > 0.0 {
        let faces = assembly.top_faces().into_iter();
        let faces = faces.map(|(block, _, _)| assembly.blocks[block].name.clone());
        let (ratio, pressure) = (assembly.overburden, short(assembly.pressure(), 6));
        let what = format!("overburden ratio {ratio}, {pressure} a unit of length, on");
        text.push_str(&listed(&what, faces.collect()));
    }
    text + &weights(&assembly)
}

/// What courses of a wall have of their own.
fn own_courses(wall: &Wall) -> String {
    let mut text = String::new();
    let heights = wall.own.heights.iter().map(f64::to_string);
    text.push_str(&listed(
        "heights of the courses from the bottom",
        heights.collect(),
    ));
    for (course, friction) in &wall.own.beds {
        let _ = writeln!(
            text,
            "friction {friction} of the joint that course {course} lies on"
        );
    }
    let open = wall.own.open.iter().map(usize::to_string);
    text.push_str(&listed("open head joints in course", open.collect()));
    text
}

/// Weights over areas, where they differ.
fn weights(assembly: &Assembly) -> String {
    let blocks = assembly.blocks.iter();
    let specific = blocks.map(|block| (block.weight / block.shape.area(), &block.name));
    let [least, most] = [1.0, -1.0].map(|sign: f64| {
        specific
            .clone()
            .min_by(|a, b| (sign * a.0).total_cmp(&(sign * b.0)))
    });
    match (least, most) {
        (Some((low, light)), Some((high, heavy))) if high > low * (1.0 + 1e-6) => format!(
            "weight over area from {} ({light}) to {} ({heavy})\n",
            short(low, 6),
            short(high, 6)
        ),
        _ => String::new(),
    }
}

/// A line that names what there is, not too many of it; nothing where there is nothing.
fn listed(what: &str, names: Vec<String>) -> String {
    match names.split_at_checked(MOST_NAMED) {
        Some((first, more)) if !more.is_empty() => {
            format!("{what}: {} and {} more\n", first.join(", "), more.len())
        }
        _ if names.is_empty() => String::new(),
        _ => format!("{what}: {}\n", names.join(", ")),
    }
}
