//! Curves of λ over one variable of a sweep, with bands for ranges and values from elsewhere.

use super::known::of_overburden;
use super::points::{SweepTable, Variable, VariableKind};
use crate::case::find;
use crate::method::{Look, Mark, method_look};
use crate::number::{number, short};
use crate::picture::palette::INK;
use crate::picture::{Between, Filling, Line, Marks, Plot, PlotAxis, PlotPoint, Ticks};
use crate::run::Value;
use crate::scene::HeadJoints;

/// Relative width from which on a bracket is a band.
const WIDE: f64 = 2e-3;

/// How values from elsewhere look.
pub const KNOWN: Look = Look {
    colour: INK,
    mark: Mark::Circle,
};

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
        let of_method = rows
            .iter()
            .filter(|row| table.words(row, "method") == method);
        let pieces = pieces(table, x, of_method.copied());
        let last = pieces.len().saturating_sub(1);
        for (index, points) in pieces.into_iter().enumerate() {
            let wide = points
                .iter()
                .any(|[_, low, high]| high - low > WIDE * high.abs().max(1e-3));
            let line = |end: usize, name: bool, dashed: bool| Line {
                points: points.iter().map(|point| [point[0], point[end]]).collect(),
                colour,
                name: (name && index == last).then(|| method.to_owned()),
                dashed,
            };
            plot.lines.push(line(2, true, false));
            if wide {
                plot.lines.push(line(1, false, true));
                plot.ranges.push(Between { points, colour });
            }
        }
    }
    plot.marks.extend(known(table, scene, x, rows));
    plot
}

/// Points of a curve as abscissa and both ends, in pieces: a point without an answer ends one.
fn pieces<'a>(
    table: &SweepTable,
    x: &Variable,
    rows: impl Iterator<Item = &'a Vec<Value>>,
) -> Vec<Vec<[f64; 3]>> {
    let numbers = x.numbers();
    let place = |row: &[Value]| {
        let value = table.words(row, &x.name);
        let index = x.values.iter().position(|known| known == value)?;
        Some(
            numbers
                .as_ref()
                .map_or(index as f64, |numbers| numbers[index]),
        )
    };
    let point = |row: &'a Vec<Value>| {
        let ends = table.number(row, "lower").zip(table.number(row, "upper"));
        Some((place(row)?, ends))
    };
    let mut points: Vec<_> = rows.filter_map(point).collect();
    points.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let mut pieces = vec![Vec::new()];
    for (x, ends) in points {
        match (ends, pieces.last_mut()) {
            (Some((low, high)), Some(piece)) => piece.push([x, low, high]),
            _ => pieces.push(Vec::new()),
        }
    }
    pieces.retain(|piece| !piece.is_empty());
    pieces
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

/// A scene's name as case and head joints.
fn split(scene: &str) -> (&str, HeadJoints) {
    match scene.strip_suffix("@open") {
        Some(case) => (case, HeadJoints::Open),
        None => (scene, HeadJoints::Contact),
    }
}

/// Values of others, where nothing but the overburden is changed, on a wall of a built-in case: a key of
/// one value may change it as well, and so may a file that has the name of one.
fn known(table: &SweepTable, scene: &str, x: &Variable, rows: &[&Vec<Value>]) -> Option<Marks> {
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
    let points = of_overburden(case, head_joints).into_iter();
    let points = points.filter(|point| point.overburden <= last);
    let points: Vec<PlotPoint> = points
        .map(|point| PlotPoint {
            at: [point.overburden, point.lambda],
            below: 0.0,
            filling: Filling::Open,
            name: None,
            tooltip: format!(
                "{} {}: {}",
                point.method,
                number(point.lambda, 6),
                point.source
            ),
        })
        .collect();
    (!points.is_empty()).then_some(Marks {
        look: KNOWN,
        points,
    })
}
