//! Fields of coloured cells over two variables of a sweep.

use super::curves::heading;
use super::points::{SweepTable, Variable};
use crate::number::number;
use crate::picture::palette::{SCALE, tone_of};
use crate::picture::{Cells, Field, LegendEntry, PictureCell, Sample, cells};
use crate::run::Value;

/// Fields of cells over two variables, a field a scene and method: the lower end of λ on one scale.
pub fn fields(table: &SweepTable, title: &str, x: &Variable, y: &Variable) -> String {
    let lower = |row: &Vec<Value>| table.number(row, "lower");
    let values = || table.rows.iter().filter_map(lower);
    let [least, most] = values().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| {
        [low.min(v), high.max(v)]
    });
    let place = |row: &Vec<Value>| {
        let of = |variable: &Variable| {
            let value = table.words(row, &variable.name);
            variable.values.iter().position(|known| known == value)
        };
        Some([of(x)?, of(y)?])
    };
    let cell = |row: &Vec<Value>| {
        let value = lower(row);
        let share = value.map(|value| (value - least) / (most - least).max(f64::MIN_POSITIVE));
        Some(PictureCell {
            place: place(row)?,
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
    let mut names = Vec::new();
    for scene in table.distinct("case") {
        for method in table.distinct("method") {
            names.push((format!("{}: {method}", heading(scene, &[])), scene, method));
        }
    }
    let fields = names.iter().map(|(name, scene, method)| {
        let own = table.rows.iter().filter(|row| {
            table.words(row, "case") == *scene && table.words(row, "method") == *method
        });
        Field {
            name,
            cells: own.filter_map(cell).collect(),
        }
    });
    let label = format!("{} (to the right) × {} (upwards)", x.label(), y.label());
    cells(&Cells {
        title: title.to_owned(),
        legend: vec![LegendEntry::new(
            Sample::Scale(&SCALE, [least, most].map(|end| number(end, 4))),
            "lower end of λ",
        )],
        x_label: &label,
        xs: x.values.iter().map(String::as_str).collect(),
        ys: y.values.iter().map(String::as_str).collect(),
        fields: fields.collect(),
        words: "A cell has the lower end of the answer's range; a dash: no answer.",
    })
}
