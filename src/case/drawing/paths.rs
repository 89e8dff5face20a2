//! From entities to paths in the plane: INSERTs resolved, arcs as chords.

use std::f64::consts::TAU;
use std::ops::Range;

use super::curves::Chords;
use super::entities::{Entity, File, number};
use super::placing::Placing;
use crate::case::complaint::{Complaint, Document};
use crate::scene::{Point, Vector};

/// A path of straight edges.
#[derive(Clone, Debug)]
pub(super) struct Path {
    /// The handle of its entity, behind those of the INSERTs that it came through; empty where the
    /// drawing has none.
    pub handle: String,
    pub kind: String,
    pub layer: String,
    pub place: Range<usize>,
    /// Ends and corners; the first one once, where it is closed.
    pub points: Vec<Point>,
    pub closed: bool,
}

/// What is drawn beside outlines and says nothing about them.
const LEFT_ASIDE: [&str; 16] = [
    "TEXT",
    "MTEXT",
    "DIMENSION",
    "ARC_DIMENSION",
    "ATTDEF",
    "ATTRIB",
    "LEADER",
    "MULTILEADER",
    "MLEADER",
    "POINT",
    "VIEWPORT",
    "TABLE",
    "ACAD_TABLE",
    "TOLERANCE",
    "IMAGE",
    "WIPEOUT",
];

/// Layers of an exported drawing that are no walls.
const OWN_LAYERS: [&str; 4] = ["names", "mechanism", "thrust", "resultants"];

/// Deepest INSERT in INSERT.
const DEEPEST: usize = 16;

/// Most paths of a drawing.
const MOST_PATHS: usize = 500_000;

/// Most copies of one INSERT.
const MOST_COPIES: i64 = 100_000;

/// All paths of a drawing, and the kinds of entities that were left aside.
pub(super) struct Paths<'a> {
    pub document: &'a Document,
    pub file: &'a File,
    pub chords: Chords,
    /// Layers that are not read.
    pub without: &'a [String],
    pub found: Vec<Path>,
    /// Kinds that were left aside, each once.
    pub left_aside: Vec<String>,
}

/// Where an INSERT stands.
struct Inside<'a> {
    placing: Placing,
    handle: &'a str,
    layer: Option<&'a str>,
    depth: usize,
}

impl Paths<'_> {
    /// Reads the drawing's entities.
    ///
    /// # Errors
    /// An entity that is no outline of a block, with its name, handle and layer.
    pub fn read(&mut self) -> Result<(), Complaint> {
        let file = self.file;
        self.entities(
            &file.entities,
            &Inside {
                placing: Placing::AS_DRAWN,
                handle: "",
                layer: None,
                depth: 0,
            },
        )
    }

    fn entities(&mut self, entities: &[Entity], inside: &Inside) -> Result<(), Complaint> {
        for entity in entities {
            // Entities of paper space are about sheets.
            if entity.flags(self.document, 67) == 1 {
                continue;
            }
            let layer = match (entity.layer(self.document), inside.layer) {
                ("0", Some(layer)) => layer,
                (layer, _) => layer,
            };
            let is_ours = self.file.is_ours && OWN_LAYERS.contains(&layer);
            if is_ours || self.without.iter().any(|other| same(other, layer)) {
                continue;
            }
            self.entity(entity, layer, inside)?;
            if self.found.len() > MOST_PATHS {
                return Err(self
                    .complain(
                        entity,
                        layer,
                        &format!("more than {MOST_PATHS} outlines and lines"),
                    )
                    .help("leave out layers (`without`)"));
            }
        }
        Ok(())
    }

    fn entity(&mut self, entity: &Entity, layer: &str, inside: &Inside) -> Result<(), Complaint> {
        let (points, closed) = match entity.kind.as_str() {
            "LINE" => (self.line(entity)?, false),
            "ARC" => (self.arc(entity)?, false),
            "CIRCLE" => (self.circle(entity)?, true),
            "LWPOLYLINE" => self.light_polyline(entity)?,
            "POLYLINE" => self.polyline(entity, layer)?,
            "INSERT" => return self.insert(entity, layer, inside),
            kind if LEFT_ASIDE.contains(&kind) => {
                if !self.left_aside.iter().any(|known| known == kind) {
                    self.left_aside.push(kind.to_owned());
                }
                return Ok(());
            }
            kind => {
                let help = match kind {
                    "SPLINE" | "ELLIPSE" => "draw the curve as a polyline with arcs, or flatten it",
                    "HATCH" => "put hatches on a layer of their own and leave it out (`without`)",
                    _ => "draw blocks as closed polylines, or leave its layer out (`without`)",
                };
                let what = format!("{kind} is no outline of a block");
                return Err(self.complain(entity, layer, &what).help(help));
            }
        };
        let mirrored = self.mirrored(entity, layer)?;
        let to = |p: Vector| {
            let p = if mirrored { Vector::new(-p.x, p.y) } else { p };
            Point::from(inside.placing.point(p))
        };
        self.found.push(Path {
            handle: chained(inside.handle, entity.text(self.document, 5)),
            kind: entity.kind.clone(),
            layer: layer.to_owned(),
            place: entity.place.clone(),
            points: points.into_iter().map(to).collect(),
            closed,
        });
        Ok(())
    }

    /// Whether an entity is drawn from behind: its direction of extrusion points away. Lines are not:
    /// their ends are given in the plane itself.
    fn mirrored(&self, entity: &Entity, layer: &str) -> Result<bool, Complaint> {
        let along = [210, 220].map(|code| entity.number(self.document, code, 0.0));
        let [x, y] = along;
        let z = entity.number(self.document, 230, 1.0)?;
        if x?.abs().max(y?.abs()) > 1e-6 {
            return Err(self
                .complain(
                    entity,
                    layer,
                    "an outline that does not lie in the plane of x and y",
                )
                .help("draw the elevation in the plane of x and y"));
        }
        Ok(z < 0.0 && entity.kind != "LINE")
    }

    fn pair(&self, entity: &Entity, code: i32) -> Result<Vector, Complaint> {
        Ok(Vector::new(
            entity.number(self.document, code, 0.0)?,
            entity.number(self.document, code + 10, 0.0)?,
        ))
    }

    fn line(&self, entity: &Entity) -> Result<Vec<Vector>, Complaint> {
        Ok(vec![self.pair(entity, 10)?, self.pair(entity, 11)?])
    }

    fn arc(&self, entity: &Entity) -> Result<Vec<Vector>, Complaint> {
        let from = entity.number(self.document, 50, 0.0)?.to_radians();
        let to = entity.number(self.document, 51, 360.0)?.to_radians();
        // Counter-clockwise, at most once round.
        let angle = (to - from).rem_euclid(TAU);
        self.round(entity, from, if angle == 0.0 { TAU } else { angle })
    }

    fn circle(&self, entity: &Entity) -> Result<Vec<Vector>, Complaint> {
        let mut points = self.round(entity, 0.0, TAU)?;
        points.pop();
        Ok(points)
    }

    /// Points about the centre of an entity, from an angle on.
    fn round(&self, entity: &Entity, from: f64, angle: f64) -> Result<Vec<Vector>, Complaint> {
        let centre = self.pair(entity, 10)?;
        let radius = entity.number(self.document, 40, 0.0)?;
        Ok(self.chords.arc(centre, radius, from, angle))
    }

    fn light_polyline(&self, entity: &Entity) -> Result<(Vec<Vector>, bool), Complaint> {
        let mut corners: Vec<(Vector, f64)> = Vec::new();
        for group in entity.groups() {
            match group.code {
                10 => corners.push((Vector::new(number(self.document, group)?, 0.0), 0.0)),
                20 => {
                    if let Some((corner, _)) = corners.last_mut() {
                        corner.y = number(self.document, group)?;
                    }
                }
                42 => {
                    if let Some((_, bulge)) = corners.last_mut() {
                        *bulge = number(self.document, group)?;
                    }
                }
                _ => {}
            }
        }
        let closed = entity.flags(self.document, 70) & 1 == 1;
        Ok((self.chords.polyline(&corners, closed), closed))
    }

    fn polyline(&self, entity: &Entity, layer: &str) -> Result<(Vec<Vector>, bool), Complaint> {
        let flags = entity.flags(self.document, 70);
        if flags & (2 | 4 | 16 | 64) != 0 {
            return Err(self
                .complain(entity, layer, "a POLYLINE that is a fitted curve or a mesh")
                .help("draw the outline as a polyline with arcs"));
        }
        let mut corners = Vec::new();
        for vertex in entity.vertices.iter().filter(|v| v.kind == "VERTEX") {
            let bulge = vertex.number(self.document, 42, 0.0)?;
            corners.push((self.pair(vertex, 10)?, bulge));
        }
        let closed = flags & 1 == 1;
        Ok((self.chords.polyline(&corners, closed), closed))
    }

    fn insert(&mut self, entity: &Entity, layer: &str, inside: &Inside) -> Result<(), Complaint> {
        let name = entity.text(self.document, 2);
        let file = self.file;
        let Some(block) = file.blocks.get(&name.to_lowercase()) else {
            let what = format!("an INSERT of `{name}`, which is not in the drawing");
            let complaint = self.complain(entity, layer, &what);
            return Err(complaint.help("bind references to other drawings before saving"));
        };
        if inside.depth >= DEEPEST {
            let what = format!("INSERTs in one another, more than {DEEPEST} deep");
            return Err(self.complain(entity, layer, &what).help("explode them"));
        }
        let mirrored = if self.mirrored(entity, layer)? {
            -1.0
        } else {
            1.0
        };
        let scale = |code| entity.number(self.document, code, 1.0);
        let (x, y) = (scale(41)?, scale(42)?);
        let (sin, cos) = entity
            .number(self.document, 50, 0.0)?
            .to_radians()
            .sin_cos();
        let (columns, rows) = (
            entity.flags(self.document, 70),
            entity.flags(self.document, 71),
        );
        let (columns, rows) = (columns.max(1), rows.max(1));
        if columns.saturating_mul(rows) > MOST_COPIES {
            let what = format!("an INSERT of {columns} by {rows} copies");
            return Err(self
                .complain(entity, layer, &what)
                .help("insert fewer copies"));
        }
        let [wide, high] = [44, 45].map(|code| entity.number(self.document, code, 0.0));
        let (wide, high) = (wide?, high?);
        let turned =
            |v: Vector| Vector::new(mirrored * (cos * v.x - sin * v.y), sin * v.x + cos * v.y);
        let mut at = self.pair(entity, 10)?;
        at.x *= mirrored;
        let own = chained(inside.handle, entity.text(self.document, 5));
        for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)))
        {
            let linear = [turned(Vector::new(x, 0.0)), turned(Vector::new(0.0, y))];
            let step = turned(Vector::new(wide * column as f64, high * row as f64));
            let base = linear[0] * block.base[0] + linear[1] * block.base[1];
            let placing = Placing {
                columns: linear,
                shift: at + step - base,
            };
            let copy = match (columns, rows) {
                (1, 1) => own.clone(),
                _ => format!("{own}.{}", row * columns + column + 1),
            };
            self.entities(
                &block.entities,
                &Inside {
                    placing: inside.placing.after(&placing),
                    handle: &copy,
                    layer: Some(layer),
                    depth: inside.depth + 1,
                },
            )?;
        }
        Ok(())
    }

    fn complain(&self, entity: &Entity, layer: &str, what: &str) -> Complaint {
        let handle = entity.text(self.document, 5);
        let handle = match handle {
            "" => String::new(),
            handle => format!("handle {handle}, "),
        };
        let label = format!("{handle}layer `{layer}`");
        self.document.complain(entity.place.clone(), what, label)
    }
}

/// Whether two layers are one: their names do not tell capitals.
pub(super) fn same(one: &str, other: &str) -> bool {
    one.to_lowercase() == other.to_lowercase()
}

fn chained(before: &str, handle: &str) -> String {
    match (before, handle) {
        ("", handle) => handle.to_owned(),
        (before, "") => before.to_owned(),
        (before, handle) => format!("{before}.{handle}"),
    }
}
