//! Curves of λ over one variable of a sweep, with bands for ranges and values from elsewhere.

use super::points::{SweepTable, Variable, VariableKind};
use crate::case::{Geometry, Quantity, Reference, find, library};
use crate::method::{Kind, Look, Mark, kind, look, method_look};
use crate::number::{number, short};
use crate::picture::palette::INK;
use crate::picture::{Filling, Line, Plot, PlotAxis, PlotPoint, Ticks};
use crate::run::Value;
use crate::scene::{HeadJoints, Wall};

/// Relative width from which on a bracket is a band.
const WIDE: f64 = 2e-3;

pub const KNOWN: Look = look(INK, Mark::Circle);

/// The curves of all methods on one scene.
pub fn curves(
    table: &SweepTable,
    scene: &str,
    chosen: &[(&str, &str)],
    x: &Variable,
    rows: &[&Vec<Value>],
) -> Plot {
    let mut plot = Plot {
        title: heading(scene, chosen),
        x: PlotAxis {
            label: x.label(),
            ticks: ticks(x),
        },
        y: PlotAxis {
            label: "collapse multiplier λ".to_owned(),
            ticks: Ticks::Fitting,
        },
        ..Plot::default()
    };
    for method in table.distinct("method") {
        let colour = method_look(method, 0).colour;
        let is_of = |row: &&&Vec<Value>| table.words(row, "method") == method;
        let (pieces, missing) = pieces(table, x, rows.iter().filter(is_of).copied());
        plot.missing
            .extend(missing.into_iter().map(|x| (x, colour)));
        let last = pieces.len().saturating_sub(1);
        for (index, points) in pieces.into_iter().enumerate() {
            let is_wide = |[_, low, high]: &[f64; 3]| high - low > WIDE * high.abs().max(1e-3);
            let wide = points.iter().any(is_wide);
            let line = |end: usize, name: bool, dashed: bool| Line {
                points: points.iter().map(|point| [point[0], point[end]]).collect(),
                colour,
                name: (name && index == last).then(|| method.to_owned()),
                dashed,
            };
            plot.lines.push(line(2, true, false));
            if wide {
                plot.lines.push(line(1, false, true));
                plot.ranges.push((points, colour));
            }
        }
    }
    let known = known(table, scene, x, rows).unwrap_or_default();
    if !known.is_empty() {
        plot.marks.push((KNOWN, known));
    }
    plot
}

/// Points of a curve as abscissa and both ends, in pieces: a point without an answer ends one. The
/// points without an answer beside them.
fn pieces<'a>(
    table: &SweepTable,
    x: &Variable,
    rows: impl Iterator<Item = &'a Vec<Value>>,
) -> (Vec<Vec<[f64; 3]>>, Vec<f64>) {
    let numbers = x.numbers();
    let place = |row: &[Value]| {
        let value = table.words(row, &x.name);
        let index = x.values.iter().position(|known| known == value)?;
        let numbers = numbers.as_ref();
        Some(numbers.map_or(index as f64, |numbers| numbers[index]))
    };
    let point = |row: &'a Vec<Value>| {
        let ends = table.number(row, "lower").zip(table.number(row, "upper"));
        Some((place(row)?, ends))
    };
    let mut points: Vec<_> = rows.filter_map(point).collect();
    points.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let (mut pieces, mut missing) = (vec![Vec::new()], Vec::new());
    for (x, ends) in points {
        match (ends, pieces.last_mut()) {
            (Some((low, high)), Some(piece)) => piece.push([x, low, high]),
            _ => {
                missing.push(x);
                pieces.push(Vec::new());
            }
        }
    }
    pieces.retain(|piece| !piece.is_empty());
    (pieces, missing)
}

/// The axis of a variable: numbers as they ask for, words beside one another.
fn ticks(variable: &Variable) -> Ticks {
    match variable.numbers() {
        Some(_) => Ticks::Fitting,
        None => {
            let words = variable.values.iter().enumerate();
            let words = words.map(|(index, value)| (index as f64, value.clone()));
            let last = variable.values.len() as f64 - 1.0;
            Ticks::Words([-0.3, last + 0.3], words.collect())
        }
    }
}

/// Case and head joints, and what else is chosen.
pub fn heading(scene: &str, chosen: &[(&str, &str)]) -> String {
    let (case, head_joints) = split(scene);
    let mut heading = format!("{case}, {} head joints", head_joints.name());
    for (name, value) in chosen {
        heading.push_str(&format!(", {name} {value}"));
    }
    heading
}

fn split(scene: &str) -> (&str, HeadJoints) {
    match scene.strip_suffix("@open") {
        Some(case) => (case, HeadJoints::Open),
        None => (scene, HeadJoints::Contact),
    }
}

/// Values of others, where nothing but the overburden is changed, on a wall of a built-in case: a key of
/// one value may change it as well, and so may a file that has the name of one.
fn known(
    table: &SweepTable,
    scene: &str,
    x: &Variable,
    rows: &[&Vec<Value>],
) -> Option<Vec<PlotPoint>> {
    if x.kind != VariableKind::Overburden || table.keys().count() > 1 {
        return None;
    }
    let (case, head_joints) = split(scene);
    let wall = find(case).ok()?.first()?.scene(head_joints);
    let mut frictions = wall.joints().iter().map(|joint| short(joint.friction, 9));
    let wall = [
        ("blocks", wall.blocks().len().to_string()),
        ("joints", wall.joints().len().to_string()),
        ("friction", frictions.next()?),
    ];
    let differs = |row: &&Vec<Value>| {
        let mut known = wall.iter();
        known.any(|(name, value)| table.cell(row, name).csv() != *value)
    };
    if rows.iter().any(differs) {
        return None;
    }
    let last = x.numbers()?.into_iter().fold(0.0, f64::max);
    let mut points = of_overburden(case, head_joints);
    points.retain(|point| point.at[0] <= last);
    Some(points)
}

/// Multipliers that somebody else gives of this case under any overburden, for a setting of head
/// joints: the values of all built-in cases that are the same wall. What is known of the closed form
/// holds for both settings.
fn of_overburden(case: &str, head_joints: HeadJoints) -> Vec<PlotPoint> {
    let cases = find(case).unwrap_or_default();
    let Some(base) = cases.first().and_then(|case| bare(&case.geometry)) else {
        return Vec::new();
    };
    let mut points = Vec::new();
    for case in library() {
        let (Geometry::Wall(wall), true) =
            (&case.geometry, bare(&case.geometry) == Some(base.clone()))
        else {
            continue;
        };
        let own = case
            .references
            .iter()
            .filter(|r| is_multiplier(r, head_joints));
        points.extend(own.map(|r| PlotPoint {
            at: [wall.overburden, r.value],
            below: 0.0,
            filling: Filling::Open,
            name: None,
            tooltip: format!(
                "{} {}: {}: {}, {}",
                r.method,
                number(r.value, 6),
                case.name,
                r.kind.name(),
                r.source
            ),
        }));
    }
    points
}

/// A wall without what differs between the cases.
fn bare(geometry: &Geometry) -> Option<Wall> {
    match geometry {
        Geometry::Wall(wall) => Some(Wall {
            overburden: 0.0,
            ..wall.clone()
        }),
        Geometry::Blocks(_) | Geometry::Arch(_) => None,
    }
}

fn is_multiplier(reference: &Reference, head_joints: HeadJoints) -> bool {
    let holds = reference.head_joints.is_none_or(|only| only == head_joints);
    let of_lambda = matches!(
        reference.quantity,
        Quantity::Lambda | Quantity::Lower | Quantity::Upper
    );
    holds && of_lambda && kind(&reference.method) != Kind::Outside
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_overburdens_of_the_library_are_points_of_paper_1() {
        let points = of_overburden("paper-1", HeadJoints::Open);
        for at in [0.0, 0.25, 1.0, 10.0] {
            assert!(points.iter().any(|point| point.at[0] == at), "{at}");
        }
        let associative = |p: &&PlotPoint| p.tooltip.starts_with("associative") && p.at[0] == 1.0;
        assert_eq!(points.iter().find(associative).unwrap().at[1], 0.558296);
        let stack = of_overburden("stack", HeadJoints::Open);
        assert!(stack.iter().all(|point| point.at[0] == 0.0));
        assert!(of_overburden("no-such", HeadJoints::Open).is_empty());
    }
}
