//! Entities of a drawing, its blocks and what its header says.

use std::collections::HashMap;
use std::ops::Range;

use super::groups::{AT_THE_END, Group};
use super::placing::Spatial;
use crate::case::complaint::Complaint;
use crate::scene::Vector;

/// Something drawn.
#[derive(Debug)]
pub(super) struct Entity<'a> {
    /// `LINE`, `LWPOLYLINE`, …
    pub kind: &'a str,
    /// Where it begins.
    pub place: Range<usize>,
    /// All groups in order, for entities whose groups repeat.
    pub groups: &'a [Group<'a>],
    pub vertices: Vec<Entity<'a>>,
}

/// What an INSERT puts into the drawing.
pub(super) struct BlockOfEntities<'a> {
    /// The point that comes to lie where the INSERT is.
    pub base: Spatial,
    pub entities: Vec<Entity<'a>>,
}

/// A drawing as it is written.
pub(super) struct File<'a> {
    /// Length of a drawing unit in metres; `None` where the header does not say.
    pub metres: Option<f64>,
    pub blocks: HashMap<String, BlockOfEntities<'a>>,
    pub entities: Vec<Entity<'a>>,
    /// Why a layer, in lower case, is not seen: `frozen` or `switched-off`.
    pub unseen_layers: HashMap<String, &'static str>,
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

impl<'a> Entity<'a> {
    fn group(&self, code: i32) -> Option<&'a Group<'a>> {
        self.groups.iter().find(|group| group.code == code)
    }

    /// The text of a group; empty where there is none.
    pub fn text(&self, code: i32) -> &'a str {
        self.group(code).map_or("", |group| group.text)
    }

    /// The number of a group, or what stands for one that is not written.
    ///
    /// # Errors
    /// A value that is no finite number.
    pub fn number(&self, code: i32, unsaid: f64) -> Result<f64, Complaint> {
        self.group(code).map_or(Ok(unsaid), number)
    }

    /// A point or a direction: the numbers of a group and of the one for y, 0 where they are not
    /// written.
    ///
    /// # Errors
    /// A value that is no finite number.
    pub fn pair(&self, code: i32) -> Result<Vector, Complaint> {
        let (x, y) = (self.number(code, 0.0)?, self.number(code + 10, 0.0)?);
        Ok(Vector::new(x, y))
    }

    /// As [`pair`](Self::pair), with the number for z.
    ///
    /// # Errors
    /// A value that is no finite number.
    pub fn triple(&self, code: i32) -> Result<Spatial, Complaint> {
        let flat = self.pair(code)?;
        Ok(Spatial::new(flat.x, flat.y, self.number(code + 20, 0.0)?))
    }

    /// The whole number of a group, 0 where there is none or no such number.
    pub fn flags(&self, code: i32) -> i64 {
        self.text(code).parse().unwrap_or(0)
    }

    /// The layer; `0` where none is said.
    pub fn layer(&self) -> &'a str {
        match self.text(8) {
            "" => "0",
            layer => layer,
        }
    }

    /// What is wrong with it, where it is on this layer.
    pub fn complain(&self, layer: &str, what: &str) -> Complaint {
        let label = handle_and_layer(self.text(5), layer);
        Complaint::at(self.place.clone(), what, label)
    }
}

pub(super) fn number(group: &Group) -> Result<f64, Complaint> {
    match group.text.parse::<f64>() {
        Ok(number) if number.abs() <= 1e12 => Ok(number + 0.0),
        _ => {
            let title = format!("`{}` is no number for group {}", group.text, group.code);
            Err(Complaint::at(group.place.clone(), title, "here")
                .help("save the drawing again; coordinates reach from -1e12 to 1e12"))
        }
    }
}

/// Reads the sections that count: header, blocks, entities.
///
/// # Errors
/// What is no DXF.
pub(super) fn file<'a>(groups: &'a [Group<'a>]) -> Result<File<'a>, Complaint> {
    let mut file = File {
        metres: None,
        blocks: HashMap::new(),
        entities: Vec::new(),
        unseen_layers: HashMap::new(),
        is_ours: matches!(groups, [first, ..] if first.code == 999 && first.text == "trilith"),
    };
    let mut seen = false;
    for section in groups.split(|group| group.begins("ENDSEC")) {
        let begin = section.iter().position(|group| group.begins("SECTION"));
        let Some([_, name, inside @ ..]) = begin.map(|begin| &section[begin..]) else {
            continue;
        };
        match name.text {
            "HEADER" => file.metres = metres(inside),
            "TABLES" => file.unseen_layers = unseen_layers(inside),
            "BLOCKS" => file.blocks = blocks(inside)?,
            "ENTITIES" => {
                seen = true;
                file.entities = entities(inside);
            }
            _ => {}
        }
    }
    if seen {
        return Ok(file);
    }
    let complaint = Complaint::at(AT_THE_END, "a DXF without entities", "no such section");
    Err(complaint
        .help("save the drawing again, with the blocks as closed polylines in model space"))
}

/// What the header says of the unit of length.
fn metres(groups: &[Group]) -> Option<f64> {
    let is_unit = |group: &Group| group.code == 9 && group.text == "$INSUNITS";
    let place = groups.iter().position(is_unit)?;
    let unit: i64 = groups.get(place + 1)?.text.parse().ok()?;
    let known = UNITS.iter().find(|(code, _)| *code == unit)?;
    Some(known.1)
}

/// The layers that are frozen (bit 1 of group 70), or switched off (a negative colour in group 62).
fn unseen_layers(groups: &[Group]) -> HashMap<String, &'static str> {
    let records = entities(groups).into_iter();
    let layers = records.filter(|record| record.kind == "LAYER");
    let unseen = layers.filter_map(|layer| {
        let why = match (layer.flags(70) & 1, layer.flags(62)) {
            (1, _) => "frozen",
            (_, colour) if colour < 0 => "switched-off",
            _ => return None,
        };
        Some((layer.text(2).to_lowercase(), why))
    });
    unseen.collect()
}

fn blocks<'a>(groups: &'a [Group<'a>]) -> Result<HashMap<String, BlockOfEntities<'a>>, Complaint> {
    let mut blocks = HashMap::new();
    let mut open: Option<(String, BlockOfEntities)> = None;
    for entity in entities(groups) {
        match (entity.kind, &mut open) {
            ("BLOCK", _) => {
                let block = BlockOfEntities {
                    base: entity.triple(10)?,
                    entities: Vec::new(),
                };
                open = Some((entity.text(2).to_lowercase(), block));
            }
            ("ENDBLK", _) => blocks.extend(open.take()),
            (_, Some((_, block))) => block.entities.push(entity),
            (_, None) => {}
        }
    }
    Ok(blocks)
}

/// The entities of a section; vertices and attributes go to what they belong to, the entity before
/// them.
fn entities<'a>(groups: &'a [Group<'a>]) -> Vec<Entity<'a>> {
    let mut found: Vec<Entity> = Vec::new();
    for entity in groups.chunk_by(|_, next| next.code != 0) {
        let [first @ Group { code: 0, .. }, groups @ ..] = entity else {
            continue;
        };
        let entity = Entity {
            kind: first.text,
            place: first.place.clone(),
            groups,
            vertices: Vec::new(),
        };
        match found.last_mut() {
            Some(last) if ["VERTEX", "ATTRIB", "SEQEND"].contains(&entity.kind) => {
                last.vertices.push(entity);
            }
            _ => found.push(entity),
        }
    }
    found
}

/// What finds something in a drawing: its handle, where it has one, and its layer; in a model, which has
/// none, its GUID.
pub(super) fn handle_and_layer(handle: &str, layer: &str) -> String {
    match handle {
        handle if layer.is_empty() => handle.to_owned(),
        "" => format!("layer `{layer}`"),
        handle => format!("handle {handle}, layer `{layer}`"),
    }
}
