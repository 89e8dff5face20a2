//! From entities to paths in the plane: INSERTs resolved, arcs as chords.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::ops::Range;

use indexmap::IndexMap;
use nalgebra::Matrix3;

use super::curves::Chords;
use super::entities::{Entity, File, handle_and_layer, number};
use super::placing::{Placing, Spatial};
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
    /// Ends and corners; the first one once, where it is closed. In space as they are read, then in the
    /// plane of the wall.
    pub in_space: Vec<Spatial>,
    pub points: Vec<Point>,
    pub closed: bool,
}

/// What is drawn beside outlines and says nothing about them.
const LEFT_ASIDE: [&str; 17] = [
    "HATCH",
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

/// Flags of a POLYLINE: one in space; a fitted curve or a mesh.
const IN_SPACE: i64 = 8;
const CURVED: i64 = 2 | 4 | 16 | 64;

/// Deepest INSERT in INSERT.
const DEEPEST: usize = 16;

const MOST_PATHS: usize = 500_000;

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
                placing: Placing::as_drawn(),
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
                if entity.kind != "VIEWPORT" {
                    *self.unseen.entry("in paper space".to_owned()).or_default() += 1;
                }
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
        let flat = |points: Vec<Vector>, height: f64| -> Result<Vec<Spatial>, Complaint> {
            let axes = axes(entity)?;
            let laid = points
                .into_iter()
                .map(|p| axes * Spatial::new(p.x, p.y, height));
            Ok(laid.collect())
        };
        let height = entity.number(30, 0.0)?;
        let (points, closed) = match entity.kind {
            // Releases before 11 call one in space a 3DLINE.
            "LINE" | "3DLINE" => (vec![entity.triple(10)?, entity.triple(11)?], false),
            "ARC" => (flat(arc(entity, chords)?, height)?, false),
            "CIRCLE" => {
                let mut points = round(entity, chords, 0.0, TAU)?;
                points.pop();
                (flat(points, height)?, true)
            }
            "LWPOLYLINE" => {
                let (points, closed) = light_polyline(entity, chords)?;
                (flat(points, entity.number(38, 0.0)?)?, closed)
            }
            "POLYLINE" if entity.flags(70) & (IN_SPACE | CURVED) == IN_SPACE => {
                let vertices = entity.vertices.iter().filter(|v| v.kind == "VERTEX");
                let points = vertices.map(|vertex| vertex.triple(10));
                (points.collect::<Result<_, _>>()?, entity.flags(70) & 1 == 1)
            }
            "POLYLINE" => {
                let (points, closed) = polyline(entity, layer, chords)?;
                (flat(points, height)?, closed)
            }
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
        self.found.push(Path {
            handle: chained(inside.handle, entity.text(5)),
            kind: entity.kind.to_owned(),
            layer: layer.to_owned(),
            place: entity.place.clone(),
            in_space: (points.into_iter())
                .map(|p| inside.placing.point(p))
                .collect(),
            points: Vec::new(),
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
        let [x, y, z] = [41, 42, 43].map(|code| entity.number(code, 1.0));
        let scale = Matrix3::from_diagonal(&Spatial::new(x?, y?, z?));
        let (sin, cos) = entity.number(50, 0.0)?.to_radians().sin_cos();
        let turned = axes(entity)? * Matrix3::new(cos, -sin, 0.0, sin, cos, 0.0, 0.0, 0.0, 1.0);
        let [columns, rows] = [70, 71].map(|code| entity.flags(code).max(1));
        if columns.saturating_mul(rows) > MOST_COPIES {
            let what = format!("an INSERT of {columns} by {rows} copies");
            return Err(entity.complain(layer, &what).help("insert fewer copies"));
        }
        let (wide, high) = (entity.number(44, 0.0)?, entity.number(45, 0.0)?);
        let at = axes(entity)? * entity.triple(10)?;
        let own = chained(inside.handle, entity.text(5));
        for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)))
        {
            let linear = turned * scale;
            let step = turned * Spatial::new(wide * column as f64, high * row as f64, 0.0);
            let placing = Placing {
                linear,
                shift: at + step - linear * block.base,
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

/// The axes that an entity's coordinates are along: what is drawn from behind, or in a plane of its own,
/// says so by its direction of extrusion.
fn axes(entity: &Entity) -> Result<Matrix3<f64>, Complaint> {
    let [x, y, z] =
        [(210, 0.0), (220, 0.0), (230, 1.0)].map(|(code, unsaid)| entity.number(code, unsaid));
    let normal = Spatial::new(x?, y?, z?);
    Ok(match normal.norm() > 0.0 {
        true => Placing::in_plane(normal),
        false => Matrix3::identity(),
    })
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
    if flags & CURVED != 0 {
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

/// What is wrong with an outline, at its place in the drawing.
pub(super) fn complain(path: &Path, title: &str) -> Complaint {
    let whose = handle_and_layer(&path.handle, &path.layer);
    Complaint::at(path.place.clone(), title, format!("{}: {whose}", path.kind))
}

/// A path of which nothing goes on from an end.
pub(super) fn leads_nowhere(path: &Path, end: Point) -> Complaint {
    let title = format!("a {} that closes no outline", path.kind);
    let whose = handle_and_layer(&path.handle, &path.layer);
    let label = format!("{whose}: nothing goes on from ({}, {})", end.x, end.y);
    Complaint::at(path.place.clone(), title, label).help(
        "draw each block as one closed polyline, or as lines and arcs that meet; leave the layers of other \
         lines out: `without` names them",
    )
}
