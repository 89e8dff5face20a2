//! Entities of a drawing, its blocks and what its header says.

use std::collections::HashMap;
use std::ops::Range;

use super::groups::{Group, groups};
use crate::case::complaint::{Complaint, Document};

/// Something drawn.
#[derive(Clone, Debug)]
pub(super) struct Entity {
    /// `LINE`, `LWPOLYLINE`, …
    pub kind: String,
    /// Where it begins.
    pub place: Range<usize>,
    groups: Vec<Group>,
    /// The vertices of a POLYLINE.
    pub vertices: Vec<Entity>,
}

/// What an INSERT puts into the drawing.
#[derive(Clone, Debug, Default)]
pub(super) struct BlockOfEntities {
    /// The point that comes to lie where the INSERT is.
    pub base: [f64; 2],
    pub entities: Vec<Entity>,
}

/// A drawing as it is written.
pub(super) struct File {
    /// Length of a drawing unit in metres; `None` where the header does not say.
    pub metres: Option<f64>,
    pub blocks: HashMap<String, BlockOfEntities>,
    pub entities: Vec<Entity>,
    /// Whether this program wrote it, which puts what is no wall on layers of their own.
    pub is_ours: bool,
}

/// Lengths in metres of the units that `$INSUNITS` counts.
const UNITS: [(i64, f64); 8] = [
    (1, 0.0254),
    (2, 0.3048),
    (4, 1e-3),
    (5, 1e-2),
    (6, 1.0),
    (10, 0.9144),
    (14, 0.1),
    (7, 1e3),
];

impl Entity {
    /// The text of a group; empty where there is none.
    pub fn text<'a>(&self, document: &'a Document, code: i32) -> &'a str {
        let group = self.groups.iter().find(|group| group.code == code);
        group.map_or("", |group| document.at(group.place.clone()))
    }

    /// The number of a group, or what stands for one that is not written.
    ///
    /// # Errors
    /// A value that is no finite number.
    pub fn number(&self, document: &Document, code: i32, unsaid: f64) -> Result<f64, Complaint> {
        let group = self.groups.iter().find(|group| group.code == code);
        group.map_or(Ok(unsaid), |group| number(document, group))
    }

    /// The whole number of a group, 0 where there is none or no such number.
    pub fn flags(&self, document: &Document, code: i32) -> i64 {
        self.text(document, code).parse().unwrap_or(0)
    }

    /// All groups in order, for entities whose groups repeat.
    pub fn groups(&self) -> &[Group] {
        &self.groups
    }

    /// The layer; `0` where none is said.
    pub fn layer<'a>(&self, document: &'a Document) -> &'a str {
        match self.text(document, 8) {
            "" => "0",
            layer => layer,
        }
    }
}

/// The number in a group.
pub(super) fn number(document: &Document, group: &Group) -> Result<f64, Complaint> {
    let text = document.at(group.place.clone());
    match text.parse::<f64>() {
        Ok(number) if number.abs() <= 1e12 => Ok(number + 0.0),
        _ => Err(document
            .complain(
                group.place.clone(),
                format!("`{text}` is no number for group {}", group.code),
                "here",
            )
            .help("save the drawing again; coordinates reach from -1e12 to 1e12")),
    }
}

/// Reads the sections that count: header, blocks, entities.
///
/// # Errors
/// What is no DXF.
pub(super) fn file(document: &Document) -> Result<File, Complaint> {
    let groups = groups(document)?;
    let at = |group: &Group| document.at(group.place.clone());
    let mut file = File {
        metres: None,
        blocks: HashMap::new(),
        entities: Vec::new(),
        is_ours: groups
            .first()
            .is_some_and(|group| group.code == 999 && at(group) == "trilith"),
    };
    let mut seen = false;
    let mut i = 0;
    while i < groups.len() {
        if groups[i].code == 0 && at(&groups[i]) == "SECTION" {
            let end =
                (i + 1..groups.len()).find(|&k| groups[k].code == 0 && at(&groups[k]) == "ENDSEC");
            let end = end.unwrap_or(groups.len());
            let inside = &groups[(i + 2).min(end)..end];
            match groups.get(i + 1).map(at) {
                Some("HEADER") => file.metres = metres(document, inside),
                Some("BLOCKS") => file.blocks = blocks(document, inside)?,
                Some("ENTITIES") => {
                    seen = true;
                    file.entities = entities(document, inside);
                }
                _ => {}
            }
            i = end;
        }
        i += 1;
    }
    if seen {
        return Ok(file);
    }
    let end = document.text.len();
    Err(document
        .complain(end..end, "a DXF without entities", "no such section")
        .help("save the drawing again, with the blocks as closed polylines in model space"))
}

/// What the header says of the unit of length.
fn metres(document: &Document, groups: &[Group]) -> Option<f64> {
    let at = |group: &Group| document.at(group.place.clone()).to_owned();
    let place = groups
        .iter()
        .position(|group| group.code == 9 && at(group) == "$INSUNITS")?;
    let unit: i64 = at(groups.get(place + 1)?).parse().ok()?;
    let known = UNITS.iter().find(|(code, _)| *code == unit)?;
    Some(known.1)
}

fn blocks(
    document: &Document,
    groups: &[Group],
) -> Result<HashMap<String, BlockOfEntities>, Complaint> {
    let mut blocks = HashMap::new();
    let mut open: Option<(String, BlockOfEntities)> = None;
    for entity in entities(document, groups) {
        match entity.kind.as_str() {
            "BLOCK" => {
                let base = [
                    entity.number(document, 10, 0.0)?,
                    entity.number(document, 20, 0.0)?,
                ];
                let name = entity.text(document, 2).to_lowercase();
                open = Some((
                    name,
                    BlockOfEntities {
                        base,
                        entities: Vec::new(),
                    },
                ));
            }
            "ENDBLK" => blocks.extend(open.take()),
            _ => {
                if let Some((_, block)) = &mut open {
                    block.entities.push(entity);
                }
            }
        }
    }
    Ok(blocks)
}

/// The entities of a section; vertices and attributes go to what they belong to.
fn entities(document: &Document, groups: &[Group]) -> Vec<Entity> {
    let mut found: Vec<Entity> = Vec::new();
    // Vertices and attributes belong to the entity before them, up to SEQEND.
    let mut inside = false;
    for group in groups {
        if group.code == 0 {
            let kind = document.at(group.place.clone()).to_owned();
            let entity = Entity {
                kind,
                place: group.place.clone(),
                groups: Vec::new(),
                vertices: Vec::new(),
            };
            let of_last = matches!(entity.kind.as_str(), "VERTEX" | "ATTRIB" | "SEQEND");
            inside = of_last && !found.is_empty();
            if inside {
                let last = found.last_mut().expect("there is one");
                last.vertices.push(entity);
            } else {
                found.push(entity);
            }
            continue;
        }
        let last = found.last_mut();
        let last = last.and_then(|last| match inside {
            true => last.vertices.last_mut(),
            false => Some(last),
        });
        if let Some(entity) = last {
            entity.groups.push(group.clone());
        }
    }
    found
}
