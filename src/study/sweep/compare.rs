//! What must hold between the methods of a sweep: the rows about one wall, compared like those of a
//! case.

use indexmap::IndexMap;

use crate::answer::Outcome;
use crate::judge::{Check, cross_check};
use crate::run::{Row, Task, named};

/// Compares the rows of all methods about each wall, in the order of the tasks, and gives every row
/// the worst verdict about it. Each check stands behind case and parameters in words. Rows that were read
/// back from a file are compared like fresh ones.
pub fn compare(tasks: &[Task], rows: &mut [Row]) -> Vec<(String, Check)> {
    let mut walls: IndexMap<(String, String), Vec<usize>> = IndexMap::new();
    for (index, row) in rows.iter().enumerate() {
        let parameters = row.parameters.iter();
        let parameters: Vec<String> = parameters
            .map(|(name, value)| format!("{name}={value}"))
            .collect();
        let wall = (row.scene_name(), parameters.join(" "));
        walls.entry(wall).or_default().push(index);
    }
    let (mut checks, mut worst) = (Vec::new(), Vec::new());
    for ((scene_name, parameters), indices) in walls {
        let wall = format!("{scene_name} {parameters}").trim_end().to_owned();
        let sides = (tasks[indices[0]].subject().sides)();
        for scene in sides.iter() {
            let of_wall = indices.iter().map(|&index| &rows[index]);
            let answers: Vec<(&str, &Outcome)> = of_wall
                .filter_map(|row| Some((row.method.as_str(), row.side(scene.push())?)))
                .collect();
            for check in cross_check(scene, &answers) {
                let check = named(check, scene, &sides);
                for &index in &indices {
                    if rows[index].method == check.method {
                        worst.push((index, check.verdict));
                    }
                }
                checks.push((wall.clone(), check));
            }
        }
    }
    for (index, verdict) in worst {
        rows[index].verdict = rows[index].verdict.max(Some(verdict));
    }
    checks
}
