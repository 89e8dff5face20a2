//! Plots of a sweep: curves of λ, a plot a scene; fields of cells where two values vary much.

use super::curves::{KNOWN, curves, heading};
use super::points::{SweepTable, Variable, VariableKind};
use crate::method::{Mark, look};
use crate::number::{ends_of, number};
use crate::picture::palette::{INK, SCALE, tone_of};
use crate::picture::{
    Cells, Field, Filling, PictureCell, Plot, Sample, cells, dashed_line, plots, share_axes,
};
use crate::run::Value;

/// Most plots of one sweep that anybody looks at.
const MOST_PLOTS: usize = 24;

/// Values of a second variable from which on a field of cells shows more than a plot each.
const MANY: usize = 5;

/// The plots of a sweep as one SVG, below one another.
///
/// # Errors
/// Why there is no plot: nothing varies, or too much.
pub fn sweep_picture(table: &SweepTable) -> Result<String, String> {
    Ok(drawn(table, true)?.concat())
}

/// The plots of a sweep, an SVG each.
pub fn sweep_pictures(table: &SweepTable) -> Result<Vec<String>, String> {
    drawn(table, false)
}

fn drawn(table: &SweepTable, together: bool) -> Result<Vec<String>, String> {
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
        let title = format!("{title} and {}", y.label());
        return Ok(vec![fields(table, &title, x, y)]);
    }
    let counts = others.iter().map(|other| other.values.len());
    let count = counts.product::<usize>() * scenes.len();
    if count > MOST_PLOTS {
        let names: Vec<&str> = variables.iter().map(|v| v.name.as_str()).collect();
        return Err(format!(
            "no plot: {} vary together, which would take {count} plots; fix one of them",
            names.join(", ")
        ));
    }
    let mut panels = Vec::new();
    for scene in scenes {
        for chosen in combinations(&others) {
            let of_panel = |row: &&Vec<Value>| {
                let is = |(name, value): &(&str, &str)| table.words(row, name) == *value;
                is(&("case", scene)) && chosen.iter().all(is)
            };
            let rows: Vec<&Vec<Value>> = table.rows.iter().filter(of_panel).collect();
            if !rows.is_empty() {
                panels.push(curves(table, scene, &chosen, x, &rows));
            }
        }
    }
    share_axes(&mut panels);
    Ok(match together {
        true => vec![plots(&title, &panels, &legend(&panels))],
        false => panels
            .chunks(1)
            .map(|one| plots("", one, &legend(one)))
            .collect(),
    })
}

/// Fields of cells over two variables, a field a scene and method: the lower end of λ on one scale.
fn fields(table: &SweepTable, title: &str, x: &Variable, y: &Variable) -> String {
    let lower = |row: &Vec<Value>| table.number(row, "lower");
    let [least, most] = ends_of(table.rows.iter().filter_map(lower));
    let cell = |row: &Vec<Value>| {
        let of = |variable: &Variable| {
            let value = table.words(row, &variable.name);
            variable.values.iter().position(|known| known == value)
        };
        let value = lower(row);
        let share = value.map(|value| (value - least) / (most - least).max(f64::MIN_POSITIVE));
        Some(PictureCell {
            place: [of(x)?, of(y)?],
            tone: tone_of(share),
            word: value.map_or("-".to_owned(), |value| number(value, 4)),
            tooltip: format!(
                "{} to {}, {}",
                table.cell(row, "lower").csv(),
                table.cell(row, "upper").csv(),
                table.words(row, "status")
            ),
        })
    };
    let mut fields = Vec::new();
    for scene in table.distinct("case") {
        for method in table.distinct("method") {
            let is_own = |row: &&Vec<Value>| {
                table.words(row, "case") == scene && table.words(row, "method") == method
            };
            fields.push(Field {
                name: format!("{}: {method}", heading(scene, &[])),
                cells: table.rows.iter().filter(is_own).filter_map(cell).collect(),
            });
        }
    }
    let label = format!("{} (to the right) × {} (upwards)", x.label(), y.label());
    let scale = Sample::Scale(&SCALE, [least, most].map(|end| number(end, 4)));
    cells(&Cells {
        title: title.to_owned(),
        legend: vec![(scale, "lower end of λ")],
        x_label: &label,
        xs: x.values.iter().map(String::as_str).collect(),
        ys: y.values.iter().map(String::as_str).collect(),
        fields,
        words: "A cell has the lowest that was found; a dash: no answer.",
    })
}

/// What the marks of these curves mean.
fn legend(panels: &[Plot]) -> Vec<(Sample, &'static str)> {
    let is_known = panels.iter().any(|panel| !panel.marks.is_empty());
    let shade = (
        Sample::Shade(INK, 0.22),
        "from the lowest to the highest that a method found",
    );
    let known = (
        Sample::Point(KNOWN, Filling::Open),
        "published or by another code",
    );
    let line = (Sample::Line(dashed_line(INK)), "lowest found");
    let none = Sample::Point(look(INK, Mark::Cross), Filling::Full);
    let has_range = panels.iter().any(|panel| !panel.ranges.is_empty());
    let misses = panels.iter().any(|panel| !panel.missing.is_empty());
    let all = [
        (has_range, shade),
        (is_known, known),
        (has_range, line),
        (misses, (none, "no answer")),
    ];
    let there = all.into_iter().filter(|(is_there, _)| *is_there);
    there.map(|(_, entry)| entry).collect()
}

/// The variable with the most numbers: the overburden, where it has as many.
fn abscissa(variables: &[Variable]) -> Option<&Variable> {
    let rank = |variable: &&Variable| {
        let is_overburden = variable.kind == VariableKind::Overburden;
        (
            variable.numbers().is_some(),
            variable.values.len(),
            is_overburden,
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
            values.map(move |value| [before.as_slice(), &[(&variable.name, value)]].concat())
        };
        all = all.into_iter().flat_map(with).collect();
    }
    all
}
