//! Names, weights and loads of single blocks of a coursed wall.

use std::collections::{BTreeMap, HashMap, HashSet};

use toml::Spanned;

use super::bodies::short_name;
use super::checks::{positive, whole};
use super::explain::missing_key;
use super::file::{BodyTable, CaseFile};
use super::forces::{Loadable, forces};
use super::values::WholeNumber;
use crate::case::complaint::{Complaint, Document};
use crate::scene::{HeadJoints, Polygon, Wall};

/// Gives a wall's blocks what the file says of single ones; `weights` are those of its legend.
pub(super) fn own_blocks(
    document: &Document,
    file: &CaseFile,
    wall: &mut Wall,
    weights: BTreeMap<usize, f64>,
) -> Result<(), Complaint> {
    wall.of_blocks.weights = weights;
    if !file.block.is_empty() {
        named_blocks(document, file, wall)?;
    }
    if file.load.is_empty() && file.live.is_none() {
        return Ok(());
    }
    let scene = wall.scene(HeadJoints::Contact);
    let scene = scene.expect("the wall was laid before");
    let names = wall.block_names();
    let shapes = scene.blocks().iter().map(|block| &block.shape);
    let blocks: Vec<(&str, &Polygon)> = names.iter().map(String::as_str).zip(shapes).collect();
    let loadable = Loadable::new(blocks, vec!["ground"]);
    wall.of_blocks.forces = forces(document, file, &loadable)?;
    Ok(())
}

/// The `[[block]]` tables: each names a block by course and piece.
fn named_blocks(document: &Document, file: &CaseFile, wall: &mut Wall) -> Result<(), Complaint> {
    let places: HashMap<(usize, usize), usize> = wall
        .block_places()
        .enumerate()
        .map(|(block, place)| (place, block))
        .collect();
    let mut taken: HashMap<String, Option<usize>> = wall
        .block_names()
        .into_iter()
        .enumerate()
        .map(|(block, name)| (name, Some(block)))
        .collect();
    taken.insert("ground".to_owned(), None);
    let mut described = HashSet::new();
    for table in &file.block {
        let block = block(document, table, wall, &places)?;
        if !described.insert(block) {
            let title = "a second table of one block";
            return Err(document
                .complain(table.span(), title, "the same course and piece")
                .help("write its name and its weight into one `[[block]]`"));
        }
        let table = table.get_ref();
        if let Some(name) = &table.name {
            let short = short_name(document, name)?.to_owned();
            match taken.insert(short.clone(), Some(block)) {
                Some(known) if known != Some(block) => {
                    let title = format!("`{short}` is the name of another block");
                    return Err(document
                        .complain(name.span(), title, "here again")
                        .help("choose a name that no other block has"));
                }
                _ => wall.of_blocks.names.insert(block, short),
            };
        }
        if let Some(weight) = &table.weight {
            let weight = positive(document, "weight", weight)?;
            wall.of_blocks.weights.insert(block, weight);
        }
    }
    Ok(())
}

/// The block that a table is about.
fn block(
    document: &Document,
    spanned: &Spanned<BodyTable>,
    wall: &Wall,
    places: &HashMap<(usize, usize), usize>,
) -> Result<usize, Complaint> {
    let table = spanned.get_ref();
    let foreign = [
        ("corners", table.corners.as_ref().map(Spanned::span)),
        ("centre", table.centre.as_ref().map(Spanned::span)),
    ];
    for (key, span) in foreign {
        if let Some(span) = span {
            let title = format!("`{key}` of a block in a course");
            return Err(document
                .complain(span, title, "the course says where it lies")
                .help(format!(
                    "remove `{key}`; a block of another shape needs the form of explicit blocks, \
                     which `trilith convert` writes"
                )));
        }
    }
    let of = |key: &'static str, value: &Option<Spanned<WholeNumber>>, most: usize| match value {
        Some(value) => whole(document, key, value, most),
        None => Err(missing_key(document, spanned.span(), key)),
    };
    let course = of("course", &table.course, wall.courses.len())?;
    let pieces = &wall.courses[course - 1];
    let piece = of("piece", &table.piece, pieces.len())?;
    places.get(&(course, piece)).copied().ok_or_else(|| {
        let value = table.piece.as_ref().map_or(spanned.span(), Spanned::span);
        document
            .complain(
                value,
                format!("piece {piece} of course {course} is a gap"),
                "no block",
            )
            .help("pieces are counted from the left, gaps as well")
    })
}
