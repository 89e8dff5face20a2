//! A scene as a BlockModel of COMPAS (compas_dem): blocks as meshes, the mechanism and contact forces.

use serde_json::{Map, Value, json};

use crate::mechanics::{JointForce, Mechanism};
use crate::scene::{Assembly, Joint, Point, Polygon, Scene, Side};

/// The JSON of a model, which `BlockModel.from_json` reads. The plane is x–z, y its depth: of a block
/// its weight over its area, of a support that of the deepest block, each centred on y = 0.
pub(crate) fn compas(
    scene: &Scene,
    assembly: &Assembly,
    mechanism: Option<&Mechanism>,
    forces: Option<&[JointForce]>,
) -> String {
    let depths: Vec<f64> = assembly
        .blocks
        .iter()
        .map(|block| block.weight / block.shape.area())
        .collect();
    let deepest = depths.iter().copied().fold(0.0, f64::max);
    let still = scene.still_supports();
    let blocks = assembly.blocks.iter().zip(&depths);
    let blocks = blocks.map(|(block, depth)| (block.name.clone(), &block.shape, *depth, false));
    // Supports that move are the scene's last blocks.
    let moving = scene.blocks().iter().enumerate().skip(depths.len());
    let moving = moving.map(|(index, block)| (scene.block_name(index), &block.shape));
    let supports = still.iter();
    let supports = supports.map(|(index, shape)| (assembly.supports[*index].name.clone(), shape));
    let supports = moving.chain(supports);
    let supports = supports.map(|(name, shape)| (name, shape, deepest, true));
    let (mut elements, mut children) = (Map::new(), Vec::new());
    let mut nodes = Map::new();
    for (node, (name, shape, depth, is_support)) in blocks.chain(supports).enumerate() {
        let id = guid(ELEMENT, node);
        children.push(json!({"name": "ElementNode", "element": id}));
        let mut attributes = json!({"element": id});
        if let Some(motion) = mechanism.and_then(|of| of.motions.get(node)) {
            attributes["displacement"] = json!([motion.velocity.x, 0.0, motion.velocity.y]);
            attributes["rotation"] = json!(motion.rotation);
        }
        nodes.insert(node.to_string(), attributes);
        let mesh = object(
            "compas.datastructures/Mesh",
            mesh(shape, depth),
            guid(MESH, node),
        );
        let data = json!({
            "transformation": null, "features": [], "name": name, "material": null,
            "geometry": mesh, "is_support": is_support,
        });
        elements.insert(id.clone(), object("compas_dem.elements/Block", data, id));
    }
    let most = nodes.len().saturating_sub(1);
    let data = json!({
        "transformation": null,
        "elements": elements,
        "materials": {},
        "tree": {"attributes": {}, "root": {"name": "root", "children": children}},
        "graph": {
            "attributes": {},
            "default_node_attributes": {"x": 0.0, "y": 0.0, "z": 0.0, "element": null},
            "default_edge_attributes": {"modifiers": null, "contacts": null},
            "node": nodes,
            "edge": edges(scene, &still, (&depths, deepest), forces),
            "max_node": most,
        },
    });
    object("compas_dem.models/BlockModel", data, guid(MODEL, 0)).to_string()
}

const MODEL: u32 = 0;
const ELEMENT: u32 = 1;
const MESH: u32 = 2;
const CONTACT: u32 = 3;

/// A GUID that no other object of the model has; the same model is the same bytes.
fn guid(kind: u32, number: usize) -> String {
    format!("{kind:08x}-0000-4000-8000-{number:012x}")
}

fn object(dtype: &str, data: Value, guid: String) -> Value {
    json!({"dtype": dtype, "data": data, "guid": guid})
}

/// The mesh of a prism: the corners of its front, y < 0, and those of its back.
fn mesh(shape: &Polygon, depth: f64) -> Value {
    let corners = shape.corners();
    let count = corners.len();
    let (mut vertices, mut faces) = (Map::new(), Map::new());
    for (side, y) in [-depth / 2.0, depth / 2.0].into_iter().enumerate() {
        for (k, corner) in corners.iter().enumerate() {
            let vertex = json!({"x": corner.x, "y": y, "z": corner.y});
            vertices.insert((side * count + k).to_string(), vertex);
        }
    }
    // Seen from y < 0 with x to the right and z up, the outline runs counter-clockwise.
    faces.insert("0".to_owned(), (0..count).collect());
    faces.insert("1".to_owned(), (count..2 * count).rev().collect());
    for k in 0..count {
        let next = (k + 1) % count;
        faces.insert(
            (k + 2).to_string(),
            json!([next, k, count + k, count + next]),
        );
    }
    json!({
        "attributes": {},
        "default_vertex_attributes": {"x": 0.0, "y": 0.0, "z": 0.0},
        "default_edge_attributes": {},
        "default_face_attributes": {},
        "vertex": vertices,
        "face": faces,
        "facedata": {},
        "edgedata": {},
        "max_vertex": 2 * count - 1,
        "max_face": count + 1,
    })
}

/// The contacts of all joints, from the body that the normal points away from to the one that it
/// points into.
fn edges(
    scene: &Scene,
    still: &[(usize, Polygon)],
    (depths, deepest): (&[f64], f64),
    forces: Option<&[JointForce]>,
) -> Value {
    let mut edges: Map<String, Value> = Map::new();
    let depth = |block: usize| depths.get(block).copied().unwrap_or(deepest);
    for (place, joint) in scene.contacts().iter().enumerate() {
        let (from, depth) = match joint.from {
            Side::Block(block) => (block, depth(block).min(depth(joint.to))),
            Side::Support(support) => {
                // Of the parts that it may be in, the one below the joint's middle.
                let middle = nalgebra::center(&joint.ends[0], &joint.ends[1]).x;
                let off = |part: &Polygon| {
                    let (low, high) = part.bounds();
                    (low.x - middle).max(middle - high.x)
                };
                let parts = still
                    .iter()
                    .enumerate()
                    .filter(|(_, part)| part.0 == support);
                let nearest = parts.min_by(|a, b| off(&a.1.1).total_cmp(&off(&b.1.1)));
                let part = nearest.map_or(0, |(part, _)| part);
                (scene.blocks().len() + part, depth(joint.to))
            }
        };
        let force = forces.and_then(|forces| forces.get(place));
        let made = contact(place, joint, depth, force);
        let of = edges.entry(from.to_string()).or_insert_with(|| json!({}));
        match &mut of[joint.to.to_string()]["contacts"] {
            Value::Array(contacts) => contacts.push(made),
            none => *none = json!([made]),
        }
    }
    edges.into()
}

/// A contact over a joint: half of the normal force of an end at each of its two corners, and a quarter
/// of the shear at all four.
fn contact(place: usize, joint: &Joint, depth: f64, force: Option<&JointForce>) -> Value {
    let [one, other] = joint.ends;
    let half = depth / 2.0;
    let at = |p: Point, y: f64| json!([p.x, y, p.y]);
    let points = [
        at(one, -half),
        at(other, -half),
        at(other, half),
        at(one, half),
    ];
    let forces = force.into_iter().flat_map(|force| {
        let [first, second] = force.normal;
        [first, second, second, first].map(|normal| {
            json!({"c_np": normal / 2.0, "c_nn": 0.0, "c_u": force.shear / 4.0, "c_v": 0.0})
        })
    });
    let (middle, tangent, normal) = (
        nalgebra::center(&one, &other),
        joint.tangent(),
        joint.normal,
    );
    // x along the tangent, z along the normal, and so y across the plane.
    let across = normal.y * tangent.x - normal.x * tangent.y;
    let frame = json!({
        "point": at(middle, 0.0),
        "xaxis": [tangent.x, 0.0, tangent.y],
        "yaxis": [0.0, across, 0.0],
    });
    let data = json!({
        "name": "FrictionContact",
        "points": points,
        "frame": {"dtype": "compas.geometry/Frame", "data": frame},
        "size": (other - one).norm() * depth,
        "mesh": null,
        "holes": null,
        "forces": forces.collect::<Vec<_>>(),
    });
    object(
        "compas_dem.interactions/FrictionContact",
        data,
        guid(CONTACT, place),
    )
}
