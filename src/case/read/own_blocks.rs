//! What single blocks and joints of a coursed wall have of their own, and the forces on it.

use std::collections::{BTreeMap, HashMap, HashSet};

use toml::Spanned;

use super::bodies::{one_weight, short_name};
use super::checks::{Written, not_negative, positive, whole};
use super::file::{BodyTable, CaseFile, Place};
use super::forces::{Loadable, forces};
use super::missing::missing_key;
use super::own_joints::own_joints;
use super::values::WholeNumber;
use crate::case::complaint::Complaint;
use crate::scene::Wall;

/// Gives a wall's blocks what the file says of single ones; `weights` are those of its legend.
pub(super) fn own_blocks(
    file: &CaseFile,
    wall: &mut Wall,
    weights: BTreeMap<usize, f64>,
) -> Result<(), Complaint> {
    wall.own.weights = weights;
    if !file.block.is_empty() {
        named_blocks(file, wall)?;
    }
    if file.load.is_empty() && file.live.is_none() && file.joint.is_empty() {
        return Ok(());
    }
    let assembly = wall.assembly().expect("the wall was laid before");
    let joints = own_joints(file, &assembly, Some(wall.courses.len()))?;
    (wall.own.joints, wall.own.beds) = (joints.named, joints.beds);
    wall.own.forces = forces(file, &Loadable::of(&assembly))?;
    Ok(())
}

/// The `[[block]]` tables: each names a block by course and piece.
fn named_blocks(file: &CaseFile, wall: &mut Wall) -> Result<(), Complaint> {
    let blocks = wall.block_places().enumerate();
    let places: HashMap<(usize, usize), usize> = blocks.map(|(i, place)| (place, i)).collect();
    let names = wall.block_names().into_iter().enumerate();
    let mut taken: HashMap<String, Option<usize>> =
        names.map(|(block, name)| (name, Some(block))).collect();
    taken.insert("ground".to_owned(), None);
    let mut described = HashSet::new();
    for table in &file.block {
        let block = block(table, wall, &places)?;
        if !described.insert(block) {
            return Err(table
                .wrong("a second table of one block", "the same course and piece")
                .help("write its name and its weight into one `[[block]]`"));
        }
        let table = table.get_ref();
        if let Some(name) = &table.name {
            let short = short_name(name)?.to_owned();
            match taken.insert(short.clone(), Some(block)) {
                Some(known) if known != Some(block) => {
                    let title = format!("`{short}` is the name of another block");
                    return Err(name
                        .wrong(title, "here again")
                        .help("choose a name that no other block has"));
                }
                _ => wall.own.names.insert(block, short),
            };
        }
        if let Some(weight) = &table.weight {
            let weight = positive("weight", weight)?;
            wall.own.weights.insert(block, weight);
        }
        one_weight(table)?;
        if let Some(specific) = &table.specific_weight {
            let specific = positive("specific_weight", specific)?;
            let assembly = wall.assembly().expect("the wall was laid before");
            let area = assembly.blocks[block].shape.area();
            let weight = specific * wall.thickness * area;
            wall.own.weights.insert(block, weight);
        }
        if let Some(friction) = &table.friction {
            let friction = not_negative("friction", friction)?;
            wall.own.frictions.insert(block, friction);
        }
    }
    Ok(())
}

fn block(
    spanned: &Spanned<BodyTable>,
    wall: &Wall,
    places: &HashMap<(usize, usize), usize>,
) -> Result<usize, Complaint> {
    let table = spanned.get_ref();
    let foreign = [
        ("corners", table.corners.place()),
        ("centre", table.centre.place()),
    ];
    for (key, span) in foreign {
        if let Some(span) = span {
            let title = format!("`{key}` of a block in a course");
            let complaint = Complaint::at(span, title, "the course says where it lies");
            return Err(complaint.help(format!(
                "remove `{key}`; a block of another shape needs the form of explicit blocks, \
                 which `trilith convert` writes"
            )));
        }
    }
    let of = |key, value: &Option<Spanned<WholeNumber>>, most| match value {
        Some(value) => whole(key, value, most),
        None => Err(missing_key(spanned.span(), key)),
    };
    let course = of("course", &table.course, wall.courses.len())?;
    let piece = of("piece", &table.piece, wall.courses[course - 1].len())?;
    places.get(&(course, piece)).copied().ok_or_else(|| {
        let span = table.piece.place().unwrap_or(spanned.span());
        let title = format!("piece {piece} of course {course} is a gap");
        let complaint = Complaint::at(span, title, "no block");
        complaint.help("pieces are counted from the left, gaps as well")
    })
}
