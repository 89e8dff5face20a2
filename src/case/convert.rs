//! A case of any form as explicit blocks: a case file, and the corners in a CSV beside it.

use std::fmt::Write;

use super::geometry::Geometry;
use super::model::Case;
use super::moved::{tables, with_parts};
use super::reference::{Quantity, Reference};
use super::written::{pair, quoted};
use crate::method::{Kind, kind};
use crate::scene::{
    Assembly, Force, Friction, NamedBlock, NamedJoint, Point, Polygon, Side, TOUCHING,
};

/// The two files of a case of explicit blocks.
#[derive(Clone, Debug, PartialEq)]
pub struct BlocksFiles {
    /// The case, which names the CSV.
    pub toml: String,
    /// A row a corner: block, x, y, and the block's weight.
    pub csv: String,
}

impl Case {
    /// The case as explicit blocks, whose corners stand in a file `csv` beside it. Numbers are written
    /// so that they are read as the same ones, and blocks keep their order: all methods but the closed
    /// form answer the same. References of the closed form and of cracks, which need courses, are left
    /// out.
    ///
    /// # Panics
    /// As [`Geometry::scene`].
    pub fn as_blocks(&self, csv: &str) -> BlocksFiles {
        let mut assembly = self.geometry.assembly();
        if let Some(motion) = &self.motion {
            with_parts(&mut assembly, motion);
        }
        BlocksFiles {
            toml: self.blocks_toml(&assembly, csv),
            csv: corners(&assembly),
        }
    }

    fn blocks_toml(&self, assembly: &Assembly, csv: &str) -> String {
        let mut text = format!(
            "title = {}\nsource = {}\n{}",
            quoted(&self.title),
            quoted(&self.source),
            friction(assembly.friction)
        );
        if !matches!(self.geometry, Geometry::Arch(_)) {
            let word = match self.head_joints.as_slice() {
                [one] => one.name(),
                _ => "both",
            };
            let _ = writeln!(text, "head_joints = \"{word}\"");
        }
        let push = match self.pushes.as_slice() {
            [one] => one.name(),
            _ => "both",
        };
        let [along, upwards] = assembly.forces.of_weight.into();
        let live = match [along, upwards] {
            [1.0, 0.0] => quoted("weight"),
            [0.0, 0.0] => quoted("loads"),
            _ => format!("{{ weight = [{along:?}, {upwards:?}] }}"),
        };
        let _ = writeln!(text, "push = \"{push}\"\nlive = {live}");
        if assembly.overburden != 0.0 {
            let _ = writeln!(text, "overburden = {:?}", assembly.overburden);
        }
        text.push('\n');
        let supports = assembly
            .supports
            .iter()
            .map(|support| quoted(&support.name));
        let supports: Vec<String> = supports.collect();
        let _ = writeln!(
            text,
            "[blocks]\ncsv = {}\nsupports = [{}]",
            quoted(csv),
            supports.join(", ")
        );
        if assembly.tolerance != TOUCHING {
            let _ = writeln!(text, "tolerance = {:?}", assembly.tolerance);
        }
        if assembly.radial {
            text.push_str("radial = true\n");
        }
        text.extend(assembly.blocks.iter().map(own_keys));
        let joints = assembly.named_joints.iter();
        text.extend(joints.map(|named| joint(assembly, named)));
        for force in &assembly.forces.extra {
            text.push_str(&load(force, &assembly.blocks[force.block].name));
        }
        text.extend(self.motion.as_ref().map(tables));
        for reference in self.references.iter().filter(|r| holds_for_blocks(r)) {
            text.push_str(&written(reference));
        }
        text
    }
}

/// A row a corner, blocks first.
fn corners(assembly: &Assembly) -> String {
    let has_layers = !assembly.layers.is_empty();
    let mut text = String::from(match has_layers {
        true => "block,x,y,weight,layer\n",
        false => "block,x,y,weight\n",
    });
    let mut body = |name: &str, shape: &Polygon, weight: &str| {
        let layer = assembly.layers.get(name).map_or("", String::as_str);
        let layer = match has_layers {
            true => format!(",{}", cell(layer)),
            false => String::new(),
        };
        for Point { coords } in shape.corners() {
            let _ = writeln!(
                text,
                "{},{:?},{:?},{weight}{layer}",
                cell(name),
                coords.x,
                coords.y
            );
        }
    };
    for block in &assembly.blocks {
        body(&block.name, &block.shape, &format!("{:?}", block.weight));
    }
    for support in &assembly.supports {
        body(&support.name, &support.shape, "");
    }
    text
}

/// What a block has that its rows of the CSV do not say.
fn own_keys(block: &NamedBlock) -> String {
    let mut keys = String::new();
    if block.centre != block.shape.centroid() {
        let _ = writeln!(keys, "centre = {}", pair(block.centre.coords));
    }
    if let Some(friction) = block.friction {
        let _ = writeln!(keys, "friction = {friction:?}");
    }
    match keys.is_empty() {
        true => keys,
        false => format!("\n[[block]]\nname = {}\n{keys}", quoted(&block.name)),
    }
}

fn joint(assembly: &Assembly, named: &NamedJoint) -> String {
    let [one, other] = named.between.map(|body| match body {
        Side::Block(block) => quoted(&assembly.blocks[block].name),
        Side::Support(support) => quoted(&assembly.supports[support].name),
    });
    let mut text = format!("\n[[joint]]\nbetween = [{one}, {other}]\n");
    if let Some(class) = named.class {
        let _ = writeln!(text, "class = \"{}\"", class.name());
    }
    if let Some(friction) = named.friction {
        let _ = writeln!(text, "friction = {friction:?}");
    }
    if named.open {
        text.push_str("open = true\n");
    }
    text
}

/// A name as a cell: in quotes where it would be read as something else.
fn cell(name: &str) -> String {
    if name.contains([',', ';', '\t', '"']) || name.starts_with('#') {
        format!("\"{}\"", name.replace('"', "\"\""))
    } else {
        name.to_owned()
    }
}

fn friction(friction: Friction) -> String {
    let Friction { bed, head, base } = friction;
    if bed == head && bed == base {
        format!("friction = {bed:?}\n")
    } else {
        format!("friction = {{ bed = {bed:?}, head = {head:?}, base = {base:?} }}\n")
    }
}

fn load(force: &Force, block: &str) -> String {
    format!(
        "\n[[load]]\nblock = {}\nat = {}\ndead = {}\nlive = {}\n",
        quoted(block),
        pair(force.point.coords),
        pair(force.dead),
        pair(force.live)
    )
}

/// Whether a value is expected of the same blocks without their courses.
fn holds_for_blocks(reference: &Reference) -> bool {
    let of_courses = [Quantity::TanBeta, Quantity::C, Quantity::E];
    kind(&reference.method) != Kind::ClosedForm && !of_courses.contains(&reference.quantity)
}

fn written(reference: &Reference) -> String {
    let mut text = format!("\n[[references]]\nmethod = {}\n", quoted(&reference.method));
    if let Some(head_joints) = reference.head_joints {
        let _ = writeln!(text, "head_joints = \"{}\"", head_joints.name());
    }
    let _ = writeln!(
        text,
        "quantity = \"{}\"\nvalue = {:?}\ntolerance = {:?}\nsource = {}\nkind = \"{}\"",
        reference.quantity.name(),
        reference.value,
        reference.tolerance,
        quoted(&reference.source),
        reference.kind.name()
    );
    if !reference.note.is_empty() {
        let _ = writeln!(text, "note = {}", quoted(&reference.note));
    }
    if let Some(deviation) = &reference.deviation {
        let _ = writeln!(text, "deviation = {}", quoted(deviation));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::find::library;
    use crate::scene::HeadJoints;

    /// A support that moves is the same one, and the ground under some units a support of its own.
    #[test]
    fn a_support_that_moves_comes_back() {
        let wall = "unit = { length = 1, height = 1, weight = 1 }\ncourses = [\"1111\"]\nfriction = 0.5\n\
                    [[move]]\nunits = \"2-3\"\ndirection = [0, -2]\nmoves = \"away\"\npushed = 0.1\n";
        let case = Case::read("a.toml", wall.as_bytes()).unwrap();
        let files = case.as_blocks("blocks.csv");
        let beside = |_: &str| Ok(files.csv.clone().into_bytes());
        let blocks = Case::read_with("a.toml", files.toml.as_bytes(), &beside).unwrap();
        let [expected, found] = [case, blocks].map(|case| case.scene(HeadJoints::Contact));
        assert_eq!(found.blocks(), expected.blocks());
        assert_eq!(found.reaction(), expected.reaction());
        assert_eq!(found.joints().len(), expected.joints().len());
    }

    /// Every built-in case comes back with the same blocks, joints and forces, to the last bit.
    #[test]
    fn every_case_comes_back_as_the_same_scene() {
        // The ground under units that move is a support of its own.
        for case in library().into_iter().filter(|case| case.motion.is_none()) {
            let files = case.as_blocks("blocks.csv");
            let beside = |_: &str| Ok(files.csv.clone().into_bytes());
            let read = Case::read_with("a.toml", files.toml.as_bytes(), &beside);
            let blocks = read.unwrap_or_else(|complaint| panic!("{}: {complaint}", case.name));
            assert_eq!(blocks.warnings, []);
            assert_eq!(blocks.head_joints, case.head_joints);
            assert_eq!(blocks.pushes, case.pushes);
            for head_joints in [HeadJoints::Contact, HeadJoints::Open] {
                for &push in &case.pushes {
                    let scene = case.geometry.scene(head_joints, push);
                    let expected = scene.without_wall();
                    let found = blocks.geometry.scene(head_joints, push);
                    assert_eq!(found, expected, "{}", case.name);
                }
            }
        }
    }
}
