//! The blocks of a model's JSON.

use std::collections::BTreeMap;
use std::ops::Range;

use serde_json::Value;

use super::matrix::Places;
use super::solid::{Point3, Solid};
use crate::case::complaint::{Complaint, Document};
use crate::case::drawing::drawn::named_apart;
use crate::case::printable::printable;

const MOST_BLOCKS: usize = 100_000;

/// Most vertices of a block's mesh.
const MOST_VERTICES: usize = 5_000;

/// Largest coordinate.
const FARTHEST: f64 = 1e12;

const HELP: &str =
    "write a `BlockModel` of compas_dem or an `Assembly` of compas_assembly with `to_json`";

/// The blocks of a model, in the order of its graph.
///
/// # Errors
/// What is no JSON, or no model that is known, or a block without a mesh.
pub(super) fn solids(document: &Document) -> Result<Vec<Solid>, Complaint> {
    let root: Value = serde_json::from_str(&document.text).map_err(|error| {
        let at = offset(&document.text, error.line(), error.column());
        Complaint::at(at..at + 1, format!("not JSON: {error}"), "here").help(HELP)
    })?;
    let kind = root["dtype"].as_str().unwrap_or_default();
    let data = &root["data"];
    let mut solids = match kind.rsplit('/').next().unwrap_or_default() {
        "BlockModel" => of_model(document, data)?,
        "Assembly" => of_assembly(document, data)?,
        _ => {
            let title = match kind {
                "" => "no model of COMPAS: it has no `dtype`".to_owned(),
                kind => format!("no model of blocks: its `dtype` is `{}`", printable(kind)),
            };
            return Err(Complaint::at(0..1, title, "this object").help(HELP));
        }
    };
    named_apart(solids.iter_mut().map(|solid| &mut solid.name));
    Ok(solids)
}

/// The elements of a BlockModel.
fn of_model(document: &Document, data: &Value) -> Result<Vec<Solid>, Complaint> {
    let places =
        Places::of(data).map_err(|title| Complaint::at(0..1, title, "in it").help(HELP))?;
    let nodes = numbered(&data["graph"]["node"]);
    let elements = data["elements"].as_object();
    let mut elements: Vec<(&String, &Value)> = elements.into_iter().flatten().collect();
    if elements.len() > MOST_BLOCKS {
        return Err(too_many());
    }
    let ranks = ranked(&nodes);
    elements.sort_by_key(|(guid, _)| {
        ranks
            .get(guid.as_str())
            .map_or(usize::MAX, |(rank, _)| *rank)
    });
    let solid = |(place, (guid, element)): (usize, (&String, &Value))| {
        let own = &element["data"];
        let known = ranks.get(guid.as_str());
        let number = known.map_or(place.to_string(), |(_, key)| (*key).to_owned());
        let material = own["material"].as_str().unwrap_or_default();
        let solid = Solid {
            name: name_of(&own["name"], &element["name"], &number),
            guid: printable(guid),
            place: found(document, guid),
            is_support: own["is_support"].as_bool().unwrap_or(false),
            density: data["materials"][material]["data"]["density"].as_f64(),
            ..Solid::default()
        };
        let mut solid = with_mesh(solid, &own["geometry"]["data"])?;
        for vertex in &mut solid.vertices {
            *vertex = places.placed(guid, *vertex);
        }
        Ok(solid)
    };
    elements.into_iter().enumerate().map(solid).collect()
}

fn of_assembly(document: &Document, data: &Value) -> Result<Vec<Solid>, Complaint> {
    let graph = match &data["graph"]["data"] {
        Value::Null => &data["graph"],
        inside => inside,
    };
    let nodes = numbered(&graph["node"]);
    if nodes.len() > MOST_BLOCKS {
        return Err(too_many());
    }
    let unsaid = graph["default_node_attributes"]["is_support"].as_bool();
    let solid = |(key, node): &(&str, &Value)| {
        let block = &node["block"];
        let guid = block["guid"].as_str().unwrap_or_default();
        let own = &block["data"];
        let is_support = node["is_support"].as_bool().or(unsaid);
        let solid = Solid {
            name: name_of(&own["attributes"]["name"], &Value::Null, key),
            guid: printable(guid),
            place: found(document, guid),
            is_support: is_support.unwrap_or(false),
            ..Solid::default()
        };
        with_mesh(solid, own)
    };
    nodes.iter().map(solid).collect()
}

/// The entries of an object whose keys are numbers, in their order.
fn numbered(object: &Value) -> Vec<(&str, &Value)> {
    let mut entries: Vec<(&str, &Value)> = object
        .as_object()
        .into_iter()
        .flatten()
        .map(|(key, value)| (key.as_str(), value))
        .collect();
    entries.sort_by_key(|(key, _)| (key.parse::<u64>().unwrap_or(u64::MAX), *key));
    entries
}

/// The place of every element in the graph, and its number there.
fn ranked<'a>(nodes: &[(&'a str, &'a Value)]) -> BTreeMap<&'a str, (usize, &'a str)> {
    let nodes = nodes.iter().enumerate();
    let ranks =
        nodes.filter_map(|(rank, (key, node))| Some((node["element"].as_str()?, (rank, *key))));
    ranks.collect()
}

/// What a block is called: by its modeller, or else its number in the graph.
fn name_of(own: &Value, outer: &Value, number: &str) -> String {
    let names = [own, outer].into_iter().filter_map(Value::as_str);
    // What COMPAS calls everything that nobody named.
    let mut given =
        names.filter(|name| !name.is_empty() && !["Block", "BlockElement"].contains(name));
    printable(given.next().unwrap_or(number))
}

/// The block with the vertices and faces of a mesh, which has to be that of a solid.
fn with_mesh(mut solid: Solid, data: &Value) -> Result<Solid, Complaint> {
    let unsaid = &data["default_vertex_attributes"];
    let mut places = BTreeMap::new();
    for (place, (key, vertex)) in numbered(&data["vertex"]).into_iter().enumerate() {
        let number = |axis: &str| {
            let value = vertex.get(axis).or(unsaid.get(axis));
            let number = value
                .and_then(Value::as_f64)
                .filter(|number| number.abs() <= FARTHEST);
            number.ok_or_else(|| {
                let title = format!("the block `{}` has a vertex without `{axis}`", solid.name);
                solid
                    .complain(&title)
                    .help("coordinates are numbers from -1e12 to 1e12")
            })
        };
        let vertex: Point3 = [number("x")?, number("y")?, number("z")?];
        solid.vertices.push(vertex);
        places.insert(key, place);
    }
    for (_, face) in numbered(&data["face"]) {
        let keys = face.as_array().into_iter().flatten();
        let of = |key: &Value| match key {
            Value::String(key) => places.get(key.as_str()).copied(),
            key => places.get(key.to_string().as_str()).copied(),
        };
        let face: Option<Vec<usize>> = keys.map(of).collect();
        solid.faces.push(face.ok_or_else(|| {
            let title = format!(
                "the block `{}` has a face with a vertex that is not there",
                solid.name
            );
            solid.complain(&title).help(HELP)
        })?);
    }
    if solid.faces.is_empty() || solid.vertices.len() < 6 {
        let title = format!("the block `{}` has no mesh of a solid", solid.name);
        let help = "give it a closed mesh as its geometry; solids of other kinds are not read";
        return Err(solid.complain(&title).help(help));
    }
    if solid.vertices.len() > MOST_VERTICES {
        let title = format!(
            "the block `{}` has more than {MOST_VERTICES} vertices",
            solid.name
        );
        return Err(solid.complain(&title).help("give it a mesh of its corners"));
    }
    Ok(solid)
}

fn too_many() -> Complaint {
    let title = format!("a model of more than {MOST_BLOCKS} blocks");
    Complaint::at(0..1, title, "this model").help("divide it")
}

/// Where a GUID first stands in the file.
fn found(document: &Document, guid: &str) -> Range<usize> {
    let at = match guid {
        "" => None,
        guid => document.text.find(guid),
    };
    at.map_or(0..1, |at| at..at + guid.len())
}

/// The place of a line and a column, both from 1.
fn offset(text: &str, line: usize, column: usize) -> usize {
    let before = text.split_inclusive('\n').take(line.saturating_sub(1));
    before.map(str::len).sum::<usize>() + column.saturating_sub(1)
}
