//! What must hold between the methods of a sweep: the rows about one wall, compared like those of a
//! case.

use indexmap::IndexMap;

use crate::answer::Outcome;
use crate::judge::{Check, cross_check};
use crate::run::{Row, Task, named};

/// A check, and the wall that it is about.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepCheck {
    /// Case and parameters, in words.
    pub wall: String,
    /// What was compared.
    pub check: Check,
}

/// Compares the rows of all methods about each wall, in the order of the tasks, and gives every row
/// the worst verdict about it. Rows that were read back from a file are compared like fresh ones.
pub fn compare(tasks: &[Task], rows: &mut [Row]) -> Vec<SweepCheck> {
    let mut walls: IndexMap<(String, String), Vec<usize>> = IndexMap::new();
    for (index, row) in rows.iter().enumerate() {
        let parameters = row.parameters.iter();
        let parameters: Vec<String> = parameters
            .map(|(name, value)| format!("{name}={value}"))
            .collect();
        let wall = (row.scene_name(), parameters.join(" "));
        walls.entry(wall).or_default().push(index);
    }
    let mut checks = Vec::new();
    for ((scene_name, parameters), indices) in walls {
        let wall = format!("{scene_name} {parameters}").trim_end().to_owned();
        let sides = (tasks[indices[0]].subject().sides)();
        for scene in sides.iter() {
            let rows = indices.iter().map(|&index| &rows[index]);
            let answers: Vec<(&str, &Outcome)> = rows
                .filter_map(|row| Some((row.method.as_str(), row.side(scene.push())?)))
                .collect();
            checks.extend(cross_check(scene, &answers).into_iter().map(|check| {
                let (wall, check) = (wall.clone(), named(check, scene, &sides));
                (indices.clone(), SweepCheck { wall, check })
            }));
        }
    }
    for (indices, SweepCheck { check, .. }) in &checks {
        for &index in indices {
            let row = &mut rows[index];
            if row.method == check.method {
                row.verdict = row.verdict.max(Some(check.verdict));
            }
        }
    }
    checks.into_iter().map(|(_, check)| check).collect()
}
