//! The plane of a model: every block is a prism across it, and the middles of all lie in it.

use super::solid::{Point3, Solid};
use crate::case::complaint::Complaint;
use crate::number::ends_of;
use crate::scene::Point;

/// Levels and outlines agree within this part of a block's extent.
const SAME: f64 = 1e-6;

/// Middles of blocks agree within this part of the smaller depth.
const IN_PLANE: f64 = 1e-3;

/// Largest part of a normal that may point up, for a plane that stands.
const UPRIGHT: f64 = 1e-6;

/// A block as the plane cuts it.
pub(super) struct Prism {
    /// The outline, in order round it.
    pub points: Vec<Point>,
    /// Its length across the plane.
    pub depth: f64,
}

/// A plane that stands upright.
struct Plane {
    /// What it is called.
    name: &'static str,
    /// The unit vector across it.
    across: [f64; 2],
}

impl Plane {
    /// How far a point lies from the plane through the origin.
    fn level(&self, [x, y, _]: Point3) -> f64 {
        let [across_x, across_y] = self.across;
        across_x * x + across_y * y
    }

    /// A point as the plane shows it. Along an axis coordinates stay as they are, to the last bit.
    fn shown(&self, [x, y, z]: Point3) -> Point {
        match self.across {
            [0.0, _] => Point::new(x, z),
            [_, 0.0] => Point::new(y, z),
            [across_x, across_y] => Point::new(across_y * x - across_x * y, z),
        }
    }
}

/// Every block as a prism across one plane: x–z by custom, y–z, or the one that a face shows.
///
/// # Errors
/// The block that is no prism, or whose middle lies beside those of the others.
pub(super) fn prisms(solids: &[Solid], remarks: &mut Vec<String>) -> Result<Vec<Prism>, Complaint> {
    let mut planes = vec![
        Plane {
            name: "x–z",
            across: [0.0, 1.0],
        },
        Plane {
            name: "y–z",
            across: [-1.0, 0.0],
        },
    ];
    planes.extend(solids.first().into_iter().flat_map(faces_across));
    let mut refused = None;
    for plane in planes {
        match across(solids, &plane) {
            Err(complaint) => refused = refused.or(Some(complaint)),
            Ok(prisms) => {
                let [least, largest] = ends_of(prisms.iter().map(|prism| prism.depth));
                let depth = match largest - least <= SAME * largest {
                    true => format!("{largest}"),
                    false => format!("{least} to {largest}"),
                };
                let name = plane.name;
                remarks.push(format!(
                    "plane of the model: {name}; depth of the blocks: {depth}"
                ));
                return Ok(prisms);
            }
        }
    }
    Err(refused.expect("a plane was tried"))
}

/// Planes along the upright faces of a block.
fn faces_across(solid: &Solid) -> Vec<Plane> {
    let normal = |face: &Vec<usize>| {
        // The area vector of the face.
        let mut sum = [0.0; 3];
        for (k, &corner) in face.iter().enumerate() {
            let (a, b) = (
                solid.vertices[corner],
                solid.vertices[face[(k + 1) % face.len()]],
            );
            sum[0] += a[1] * b[2] - a[2] * b[1];
            sum[1] += a[2] * b[0] - a[0] * b[2];
            sum[2] += a[0] * b[1] - a[1] * b[0];
        }
        let level = sum[0].hypot(sum[1]);
        (sum[2].abs() <= UPRIGHT * level && level > 0.0).then(|| {
            // To the right is where x grows, or y.
            let sign = if sum[1] < 0.0 || (sum[1] == 0.0 && sum[0] > 0.0) {
                -1.0
            } else {
                1.0
            };
            Plane {
                name: "along an upright face of the first block",
                across: [sign * sum[0] / level, sign * sum[1] / level],
            }
        })
    };
    solid.faces.iter().filter_map(normal).collect()
}

fn across(solids: &[Solid], plane: &Plane) -> Result<Vec<Prism>, Complaint> {
    let mut prisms = Vec::new();
    let mut first: Option<(f64, f64)> = None;
    for solid in solids {
        let levels: Vec<f64> = solid
            .vertices
            .iter()
            .map(|&vertex| plane.level(vertex))
            .collect();
        let [low, high] = ends_of(levels.iter().copied());
        let (depth, middle) = (high - low, f64::midpoint(low, high));
        let (depth_of_first, middle_of_first) = *first.get_or_insert((depth, middle));
        let beside = (middle - middle_of_first).abs();
        if beside > IN_PLANE * depth.min(depth_of_first) {
            let (name, other) = (&solid.name, &solids[0].name);
            let title = format!(
                "not a plane model: the middle of the block `{name}` lies {beside:.4} beside that of \
                 `{other}`, across the plane {}",
                plane.name
            );
            return Err(solid.complain(&title).help(PLANE));
        }
        let points = outline(solid, plane, &levels, [low, high]).ok_or_else(|| {
            let title = format!(
                "not a plane model: the block `{}` is no prism across the plane {}",
                solid.name, plane.name
            );
            solid.complain(&title).help(PLANE)
        })?;
        prisms.push(Prism { points, depth });
    }
    Ok(prisms)
}

const PLANE: &str = "walls, piers and arches can be read whose blocks are prisms across one upright \
                     plane, with closed meshes, and centred on it; vaults and domes cannot";

/// The outline of a prism: the border of its faces on one side; `None` where it is no prism.
fn outline(
    solid: &Solid,
    plane: &Plane,
    levels: &[f64],
    [low, high]: [f64; 2],
) -> Option<Vec<Point>> {
    let near = SAME * solid.extent();
    let on = |level: f64| move |vertex: usize| (levels[vertex] - level).abs() <= near;
    let (front, back) = (on(low), on(high));
    let shown: Vec<Point> = solid
        .vertices
        .iter()
        .map(|&vertex| plane.shown(vertex))
        .collect();
    let used = || solid.faces.iter().flatten().copied();
    let mates = |vertex: usize, other: &dyn Fn(usize) -> bool| {
        used().any(|mate| other(mate) && (shown[mate] - shown[vertex]).norm() <= near)
    };
    let paired = |vertex: usize| match (front(vertex), back(vertex)) {
        (true, false) => mates(vertex, &back),
        (false, true) => mates(vertex, &front),
        _ => false,
    };
    if high - low <= near || !used().all(paired) {
        return None;
    }
    // Vertices at one place are one corner.
    let corner = |vertex: usize| {
        let same = |other: &usize| front(*other) && (shown[*other] - shown[vertex]).norm() <= near;
        used().find(same).unwrap_or(vertex)
    };
    let mut edges: Vec<[usize; 2]> = Vec::new();
    for face in solid
        .faces
        .iter()
        .filter(|face| face.iter().all(|&vertex| front(vertex)))
    {
        for (k, &from) in face.iter().enumerate() {
            let (from, to) = (corner(from), corner(face[(k + 1) % face.len()]));
            // An edge of two faces is inside.
            match edges
                .iter()
                .position(|edge| *edge == [from, to] || *edge == [to, from])
            {
                Some(known) => drop(edges.swap_remove(known)),
                None if from != to => edges.push([from, to]),
                None => {}
            }
        }
    }
    Some(
        ring(edges)?
            .into_iter()
            .map(|vertex| shown[vertex])
            .collect(),
    )
}

/// The one closed way through all edges, whichever way each is written; it begins with the first.
fn ring(mut edges: Vec<[usize; 2]>) -> Option<Vec<usize>> {
    let [start, mut at] = *edges.first()?;
    edges.swap_remove(0);
    let mut ring = vec![start];
    while at != start {
        ring.push(at);
        let next = edges.iter().position(|edge| edge.contains(&at))?;
        let [from, to] = edges.swap_remove(next);
        at = if from == at { to } else { from };
    }
    edges.is_empty().then_some(ring)
}
