//! Plots of a sweep: curves of λ, a plot a scene; fields of cells where two values vary much.

use super::known::of_overburden;
use super::points::{SweepTable, Variable};
use crate::method::{Look, Mark, method_look};
use crate::number::number;
use crate::picture::palette::{INK, SCALE, tone_of};
use crate::picture::{
    Between, Cells, Field, Filling, LegendEntry, Line, Marks, PictureCell, Plot, PlotAxis,
    PlotPoint, Ticks, cells, dashed_line, plots,
};
use crate::scene::HeadJoints;

/// Most plots of one sweep that anybody looks at.
const MOST_PLOTS: usize = 24;

/// Values of a second variable from which on a field of cells shows more than a plot each.
const MANY: usize = 5;

/// Relative width from which on a bracket is a band.
const WIDE: f64 = 2e-3;

/// The plots of a sweep as SVG, or why there is none.
///
/// # Errors
/// Why there is no plot: nothing varies, or too much.
pub fn sweep_picture(table: &SweepTable) -> Result<String, String> {
    let variables = table.variables();
    let scenes = table.distinct("case");
    let Some(x) = abscissa(&variables) else {
        return Err("no plot: nothing varies".to_owned());
    };
    let others: Vec<&Variable> = variables.iter().filter(|other| *other != x).collect();
    let title = match &table.partial {
        Some(partial) => format!("{partial}. λ over {}", x.label()),
        None => format!("λ over {}", x.label()),
    };
    if let [y] = others.as_slice()
        && y.values.len() >= MANY
    {
        return Ok(fields(table, &format!("{title} and {}", y.label()), x, y));
    }
    let count = others
        .iter()
        .map(|other| other.values.len())
        .product::<usize>()
        * scenes.len();
    if count > MOST_PLOTS {
        let names: Vec<&str> = variables.iter().map(|v| v.name.as_str()).collect();
        return Err(format!(
            "no plot: {} vary together, which would take {count} plots; fix one of them",
            names.join(", ")
        ));
    }
    let mut panels = Vec::new();
    let mut known = false;
    for scene in scenes {
        for chosen in combinations(&others) {
            let of_panel = |row: &&Vec<String>| {
                table.cell(row, "case") == scene
                    && chosen
                        .iter()
                        .all(|(name, value)| table.cell(row, name) == *value)
            };
            let rows: Vec<&Vec<String>> = table.rows.iter().filter(of_panel).collect();
            if rows.is_empty() {
                continue;
            }
            let plot = curves(table, scene, &chosen, x, &rows);
            known |= !plot.marks.is_empty();
            panels.push(plot);
        }
    }
    let mut entries = vec![LegendEntry::shade(
        INK,
        0.22,
        "between the ends of a method's range",
    )];
    if known {
        entries.push(LegendEntry::point(
            KNOWN,
            Filling::Open,
            "published or by another code",
        ));
    }
    entries.push(LegendEntry::line(dashed_line(INK), "lower end"));
    Ok(plots(&title, &panels, &entries))
}

/// How values from elsewhere look.
const KNOWN: Look = Look {
    colour: INK,
    mark: Mark::Circle,
};

/// The variable with the most numbers: the overburden, where it has as many.
fn abscissa(variables: &[Variable]) -> Option<&Variable> {
    let rank = |variable: &&Variable| {
        let is_number = variable.numbers().is_some();
        (
            is_number,
            variable.values.len(),
            variable.name == "overburden",
        )
    };
    // Of equal ones the first.
    variables.iter().rev().max_by_key(rank)
}

/// Every combination of values of these variables; one without any where there are none.
fn combinations<'a>(variables: &[&'a Variable]) -> Vec<Vec<(&'a str, &'a str)>> {
    let mut all = vec![Vec::new()];
    for variable in variables {
        let with = |before: Vec<(&'a str, &'a str)>| {
            let values = variable.values.iter();
            let longer = values.map(move |value| {
                let mut longer = before.clone();
                longer.push((variable.name.as_str(), value.as_str()));
                longer
            });
            longer.collect::<Vec<_>>()
        };
        all = all.into_iter().flat_map(with).collect();
    }
    all
}

/// The curves of all methods on one scene.
fn curves(
    table: &SweepTable,
    scene: &str,
    chosen: &[(&str, &str)],
    x: &Variable,
    rows: &[&Vec<String>],
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
            .filter(|row| table.cell(row, "method") == method);
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
    plot.marks.extend(known(scene, chosen, x));
    plot
}

/// Points of a curve as abscissa and both ends, in pieces: a point without an answer ends one.
fn pieces<'a>(
    table: &SweepTable,
    x: &Variable,
    rows: impl Iterator<Item = &'a Vec<String>>,
) -> Vec<Vec<[f64; 3]>> {
    let numbers = x.numbers();
    let place = |row: &[String]| {
        let value = table.cell(row, &x.name);
        let index = x.values.iter().position(|known| known == value)?;
        Some(
            numbers
                .as_ref()
                .map_or(index as f64, |numbers| numbers[index]),
        )
    };
    let point = |row: &'a Vec<String>| {
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
fn heading(scene: &str, chosen: &[(&str, &str)]) -> String {
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

/// Values of others, where the overburden alone varies.
fn known(scene: &str, chosen: &[(&str, &str)], x: &Variable) -> Option<Marks> {
    if x.name != "overburden" || !chosen.is_empty() {
        return None;
    }
    let (case, head_joints) = split(scene);
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

/// Fields of cells over two variables, a field a scene and method: the lower end of λ on one scale.
fn fields(table: &SweepTable, title: &str, x: &Variable, y: &Variable) -> String {
    let lower = |row: &Vec<String>| table.number(row, "lower");
    let values = || table.rows.iter().filter_map(lower);
    let [least, most] = values().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| {
        [low.min(v), high.max(v)]
    });
    let place = |row: &Vec<String>| {
        let column = x
            .values
            .iter()
            .position(|v| v == table.cell(row, &x.name))?;
        let line = y
            .values
            .iter()
            .position(|v| v == table.cell(row, &y.name))?;
        Some([column, line])
    };
    let cell = |row: &Vec<String>| {
        let value = lower(row);
        let share = value.map(|value| (value - least) / (most - least).max(f64::MIN_POSITIVE));
        Some(PictureCell {
            place: place(row)?,
            tone: tone_of(share),
            word: value.map_or("-".to_owned(), |value| number(value, 4)),
            tooltip: format!(
                "{} to {}, {}",
                table.cell(row, "lower"),
                table.cell(row, "upper"),
                table.cell(row, "status")
            ),
        })
    };
    let mut names = Vec::new();
    for scene in table.distinct("case") {
        for method in table.distinct("method") {
            names.push((format!("{}: {method}", heading(scene, &[])), scene, method));
        }
    }
    let fields = names.iter().map(|(name, scene, method)| {
        let own = table.rows.iter().filter(|row| {
            table.cell(row, "case") == *scene && table.cell(row, "method") == *method
        });
        Field {
            name,
            cells: own.filter_map(cell).collect(),
        }
    });
    let label = format!("{} (to the right) × {} (upwards)", x.label(), y.label());
    cells(&Cells {
        title: title.to_owned(),
        legend: vec![LegendEntry::scale(
            &SCALE,
            [least, most].map(|end| number(end, 4)),
            "lower end of λ",
        )],
        x_label: &label,
        xs: x.values.iter().map(String::as_str).collect(),
        ys: y.values.iter().map(String::as_str).collect(),
        fields: fields.collect(),
        words: "A cell has the lower end of the answer's range; a dash: no answer.",
    })
}
