//! From entities to paths in the plane: INSERTs resolved, arcs as chords.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::ops::Range;

use indexmap::IndexMap;

use super::curves::Chords;
use super::entities::{Entity, File, number};
use super::placing::Placing;
use crate::case::complaint::Complaint;
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
    pub file: &'a File<'a>,
    pub chords: Chords,
    /// Layers that are not read.
    pub without: &'a [String],
    pub found: Vec<Path>,
    /// Kinds that were left aside, each once.
    pub left_aside: Vec<&'a str>,
    /// What nobody who looks at the drawing sees, with how many entities of it there are.
    pub unseen: BTreeMap<String, usize>,
    /// Kinds that are no outlines, by their layer: how many there are, and what is said of the first.
    pub unread: IndexMap<(&'a str, String), (usize, Complaint)>,
}

/// Where an INSERT stands.
struct Inside<'a> {
    placing: Placing,
    handle: &'a str,
    layer: Option<&'a str>,
    depth: usize,
}

impl<'a> Paths<'a> {
    /// Reads the drawing's entities.
    ///
    /// # Errors
    /// An entity that is no outline of a block, with its name, handle and layer.
    pub fn read(&mut self) -> Result<(), Complaint> {
        self.entities(
            &self.file.entities,
            &Inside {
                placing: Placing::AS_DRAWN,
                handle: "",
                layer: None,
                depth: 0,
            },
        )?;
        self.all_read()
    }

    /// Complains of the first entity that is no outline, and names all kinds that are none with their
    /// layers, so that one look at the drawing mends them all.
    fn all_read(&mut self) -> Result<(), Complaint> {
        let unread = std::mem::take(&mut self.unread);
        let kinds = unread
            .iter()
            .map(|((kind, layer), (count, _))| format!("{count} {kind} on layer `{layer}`"));
        let all = kinds.collect::<Vec<_>>().join(", ");
        let count = unread.len();
        match unread.into_values().next() {
            None => Ok(()),
            Some((1, complaint)) if count == 1 => Err(complaint),
            Some((_, complaint)) => {
                let help = format!("{}; in all, no outlines are {all}", complaint.advice());
                Err(complaint.help(help))
            }
        }
    }

    fn entities(&mut self, entities: &'a [Entity<'a>], inside: &Inside) -> Result<(), Complaint> {
        for entity in entities {
            // Entities of paper space are about sheets.
            if entity.flags(67) == 1 {
                continue;
            }
            let layer = match (entity.layer(), inside.layer) {
                ("0", Some(layer)) => layer,
                (layer, _) => layer,
            };
            let is_ours = self.file.is_ours && OWN_LAYERS.contains(&layer);
            if is_ours || self.without.iter().any(|other| same(other, layer)) {
                continue;
            }
            if let Some(unseen) = self.unseen(entity, layer) {
                *self.unseen.entry(unseen).or_default() += 1;
                continue;
            }
            self.entity(entity, layer, inside)?;
            if self.found.len() > MOST_PATHS {
                let what = format!("more than {MOST_PATHS} outlines and lines");
                let complaint = entity.complain(layer, &what);
                return Err(complaint.help("leave out layers: `without` names them"));
            }
        }
        Ok(())
    }

    /// Why an entity on this layer is not seen, where it is not. What an INSERT on a layer that is
    /// switched off puts on other layers is seen all the same.
    fn unseen(&self, entity: &Entity, layer: &str) -> Option<String> {
        if entity.flags(60) == 1 {
            return Some("marked invisible".to_owned());
        }
        let why = self.file.unseen_layers.get(&layer.to_lowercase())?;
        let is_seen = entity.kind == "INSERT" && *why != "frozen";
        (!is_seen).then(|| format!("on the {why} layer `{layer}`"))
    }

    fn entity(
        &mut self,
        entity: &'a Entity<'a>,
        layer: &str,
        inside: &Inside,
    ) -> Result<(), Complaint> {
        let chords = self.chords;
        let (points, closed) = match entity.kind {
            "LINE" => (vec![entity.pair(10)?, entity.pair(11)?], false),
            "ARC" => (arc(entity, chords)?, false),
            "CIRCLE" => {
                let mut points = round(entity, chords, 0.0, TAU)?;
                points.pop();
                (points, true)
            }
            "LWPOLYLINE" => light_polyline(entity, chords)?,
            "POLYLINE" => polyline(entity, layer, chords)?,
            "INSERT" => return self.insert(entity, layer, inside),
            kind if LEFT_ASIDE.contains(&kind) => {
                if !self.left_aside.contains(&kind) {
                    self.left_aside.push(kind);
                }
                return Ok(());
            }
            kind => {
                let help = match kind {
                    "SPLINE" | "ELLIPSE" => "draw the curve as a polyline with arcs, or flatten it",
                    "HATCH" => {
                        "put hatches on a layer of their own and leave it out: `without` names it"
                    }
                    _ => {
                        "draw blocks as closed polylines, or leave its layer out: `without` names it"
                    }
                };
                let of = (kind, layer.to_owned());
                let what = format!("{kind} is no outline of a block");
                let complain = || (0, entity.complain(layer, &what).help(help));
                self.unread.entry(of).or_insert_with(complain).0 += 1;
                return Ok(());
            }
        };
        let mirrored = mirrored(entity, layer)?;
        let to = |p: Vector| {
            let p = if mirrored { Vector::new(-p.x, p.y) } else { p };
            Point::from(inside.placing.point(p))
        };
        self.found.push(Path {
            handle: chained(inside.handle, entity.text(5)),
            kind: entity.kind.to_owned(),
            layer: layer.to_owned(),
            place: entity.place.clone(),
            points: points.into_iter().map(to).collect(),
            closed,
        });
        Ok(())
    }

    fn insert(
        &mut self,
        entity: &'a Entity<'a>,
        layer: &str,
        inside: &Inside,
    ) -> Result<(), Complaint> {
        let name = entity.text(2);
        let Some(block) = self.file.blocks.get(&name.to_lowercase()) else {
            let what = format!("an INSERT of `{name}`, which is not in the drawing");
            let complaint = entity.complain(layer, &what);
            return Err(complaint.help("bind references to other drawings before saving"));
        };
        if inside.depth >= DEEPEST {
            let what = format!("INSERTs in one another, more than {DEEPEST} deep");
            return Err(entity.complain(layer, &what).help("explode them"));
        }
        let mirrored = if mirrored(entity, layer)? { -1.0 } else { 1.0 };
        let (x, y) = (entity.number(41, 1.0)?, entity.number(42, 1.0)?);
        let (sin, cos) = entity.number(50, 0.0)?.to_radians().sin_cos();
        let [columns, rows] = [70, 71].map(|code| entity.flags(code).max(1));
        if columns.saturating_mul(rows) > MOST_COPIES {
            let what = format!("an INSERT of {columns} by {rows} copies");
            return Err(entity.complain(layer, &what).help("insert fewer copies"));
        }
        let (wide, high) = (entity.number(44, 0.0)?, entity.number(45, 0.0)?);
        let turned =
            |v: Vector| Vector::new(mirrored * (cos * v.x - sin * v.y), sin * v.x + cos * v.y);
        let mut at = entity.pair(10)?;
        at.x *= mirrored;
        let own = chained(inside.handle, entity.text(5));
        for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)))
        {
            let linear = [turned(Vector::new(x, 0.0)), turned(Vector::new(0.0, y))];
            let step = turned(Vector::new(wide * column as f64, high * row as f64));
            let base = linear[0] * block.base.x + linear[1] * block.base.y;
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
}

/// Whether an entity is drawn from behind: its direction of extrusion points away. Lines are not:
/// their ends are given in the plane itself.
fn mirrored(entity: &Entity, layer: &str) -> Result<bool, Complaint> {
    let (x, y) = (entity.number(210, 0.0), entity.number(220, 0.0));
    let z = entity.number(230, 1.0)?;
    if x?.abs().max(y?.abs()) > 1e-6 {
        let what = "an outline that does not lie in the plane of x and y";
        let complaint = entity.complain(layer, what);
        return Err(complaint.help("draw the elevation in the plane of x and y"));
    }
    Ok(z < 0.0 && entity.kind != "LINE")
}

fn arc(entity: &Entity, chords: Chords) -> Result<Vec<Vector>, Complaint> {
    let from = entity.number(50, 0.0)?.to_radians();
    let to = entity.number(51, 360.0)?.to_radians();
    // Counter-clockwise, at most once round.
    let angle = (to - from).rem_euclid(TAU);
    round(entity, chords, from, if angle == 0.0 { TAU } else { angle })
}

/// Points about the centre of an entity, from an angle on.
fn round(entity: &Entity, chords: Chords, from: f64, angle: f64) -> Result<Vec<Vector>, Complaint> {
    let centre = entity.pair(10)?;
    let radius = entity.number(40, 0.0)?;
    Ok(chords.arc(centre, radius, from, angle))
}

fn light_polyline(entity: &Entity, chords: Chords) -> Result<(Vec<Vector>, bool), Complaint> {
    let mut corners: Vec<(Vector, f64)> = Vec::new();
    for group in entity.groups {
        match (group.code, corners.last_mut()) {
            (10, _) => corners.push((Vector::new(number(group)?, 0.0), 0.0)),
            (20, Some((corner, _))) => corner.y = number(group)?,
            (42, Some((_, bulge))) => *bulge = number(group)?,
            _ => {}
        }
    }
    let closed = entity.flags(70) & 1 == 1;
    Ok((chords.polyline(&corners, closed), closed))
}

fn polyline(
    entity: &Entity,
    layer: &str,
    chords: Chords,
) -> Result<(Vec<Vector>, bool), Complaint> {
    let flags = entity.flags(70);
    if flags & (2 | 4 | 16 | 64) != 0 {
        let what = "a POLYLINE that is a fitted curve or a mesh";
        let complaint = entity.complain(layer, what);
        return Err(complaint.help("draw the outline as a polyline with arcs"));
    }
    let vertices = entity.vertices.iter().filter(|v| v.kind == "VERTEX");
    let corner = |vertex: &Entity| {
        let bulge = vertex.number(42, 0.0)?;
        Ok((vertex.pair(10)?, bulge))
    };
    let corners: Vec<(Vector, f64)> = vertices.map(corner).collect::<Result<_, _>>()?;
    let closed = flags & 1 == 1;
    Ok((chords.polyline(&corners, closed), closed))
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
