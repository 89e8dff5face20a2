//! Plots of a sweep: curves of λ, a plot a scene; fields of cells where two values vary much.

use super::curves::{KNOWN, curves};
use super::fields::fields;
use super::points::{SweepTable, Variable, VariableKind};
use crate::picture::palette::INK;
use crate::picture::{Filling, LegendEntry, Plot, Sample, dashed_line, plots};
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
    Ok(match drawn(table)? {
        Drawn::Fields(svg) => svg,
        Drawn::Curves(title, panels) => plots(&title, &panels, &legend(&panels)),
    })
}

/// The plots of a sweep, an SVG each.
pub fn sweep_pictures(table: &SweepTable) -> Result<Vec<String>, String> {
    let one = |panel: Plot| {
        let panel = [panel];
        plots("", &panel, &legend(&panel))
    };
    Ok(match drawn(table)? {
        Drawn::Fields(svg) => vec![svg],
        Drawn::Curves(_, panels) => panels.into_iter().map(one).collect(),
    })
}

/// What is drawn of a sweep.
enum Drawn {
    /// Fields of cells.
    Fields(String),
    /// Curves, with what stands above all of them.
    Curves(String, Vec<Plot>),
}

fn drawn(table: &SweepTable) -> Result<Drawn, String> {
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
        return Ok(Drawn::Fields(fields(table, &title, x, y)));
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
    for scene in scenes {
        for chosen in combinations(&others) {
            let of_panel = |row: &&Vec<Value>| {
                table.words(row, "case") == scene
                    && chosen
                        .iter()
                        .all(|(name, value)| table.words(row, name) == *value)
            };
            let rows: Vec<&Vec<Value>> = table.rows.iter().filter(of_panel).collect();
            if rows.is_empty() {
                continue;
            }
            panels.push(curves(table, scene, &chosen, x, &rows));
        }
    }
    Ok(Drawn::Curves(title, panels))
}

/// What the marks of these curves mean.
fn legend(panels: &[Plot]) -> Vec<LegendEntry> {
    let known = panels.iter().any(|panel| !panel.marks.is_empty());
    let mut entries = vec![LegendEntry::new(
        Sample::Shade(INK, 0.22),
        "between the ends of a method's range",
    )];
    if known {
        entries.push(LegendEntry::new(
            Sample::Point(KNOWN, Filling::Open),
            "published or by another code",
        ));
    }
    entries.push(LegendEntry::new(
        Sample::Line(dashed_line(INK)),
        "lower end",
    ));
    entries
}

/// The variable with the most numbers: the overburden, where it has as many.
fn abscissa(variables: &[Variable]) -> Option<&Variable> {
    let rank = |variable: &&Variable| {
        let is_number = variable.numbers().is_some();
        (
            is_number,
            variable.values.len(),
            variable.kind == VariableKind::Overburden,
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
