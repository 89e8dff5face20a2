//! Where a block stands: transformations of its own, of the groups that it is in, and of the model.

use std::collections::BTreeMap;

use nalgebra::{Matrix4, Vector4};
use serde_json::Value;

use super::solid::Point3;

/// Deepest that groups stand in groups.
const DEEPEST: usize = 100;

/// Transformations by the GUID of their elements; an element that stays where it is has none.
pub(super) struct Places(BTreeMap<String, Matrix4<f64>>);

impl Places {
    /// Those of a model's data; the error says what is no transformation.
    pub fn of(data: &Value) -> Result<Self, String> {
        let mut places = Self(BTreeMap::new());
        let outer = matrix(&data["transformation"])?;
        places.walk(data, &data["tree"]["root"], outer, 0)?;
        Ok(places)
    }

    fn walk(
        &mut self,
        data: &Value,
        node: &Value,
        outer: Option<Matrix4<f64>>,
        depth: usize,
    ) -> Result<(), String> {
        if depth > DEEPEST {
            return Err(format!(
                "groups stand in each other more than {DEEPEST} deep"
            ));
        }
        for child in node["children"].as_array().into_iter().flatten() {
            let guid = child["element"].as_str().unwrap_or_default();
            let own = matrix(&data["elements"][guid]["data"]["transformation"])?;
            let all = match (outer, own) {
                (Some(outer), Some(own)) => Some(outer * own),
                (outer, own) => outer.or(own),
            };
            if let Some(all) = all {
                self.0.insert(guid.to_owned(), all);
            }
            self.walk(data, child, all, depth + 1)?;
        }
        Ok(())
    }

    /// A point of an element in the coordinates of the model.
    pub fn placed(&self, guid: &str, [x, y, z]: Point3) -> Point3 {
        match self.0.get(guid) {
            None => [x, y, z],
            Some(matrix) => {
                let point = matrix * Vector4::new(x, y, z, 1.0);
                [point.x, point.y, point.z]
            }
        }
    }
}

/// The matrix of a transformation, where there is one.
fn matrix(value: &Value) -> Result<Option<Matrix4<f64>>, String> {
    if value.is_null() {
        return Ok(None);
    }
    let rows = value["data"]["matrix"].as_array();
    let numbers = rows
        .into_iter()
        .flatten()
        .flat_map(|row| row.as_array().into_iter().flatten());
    let numbers: Option<Vec<f64>> = numbers.map(Value::as_f64).collect();
    match numbers {
        Some(numbers) if numbers.len() == 16 => {
            Ok(Some(Matrix4::from_row_slice(&numbers)).filter(|read| *read != Matrix4::identity()))
        }
        _ => Err("a transformation that is no matrix of 4 by 4 numbers".to_owned()),
    }
}
