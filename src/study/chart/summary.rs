//! Each method with each setting over all scenes.

use anstyle::Style;
use indexmap::IndexSet;

use super::measurement::Measurement;
use crate::number::number;
use crate::run::{Heading, Value, csv_of};
use crate::text::{Layout, grid, numbers, words};

/// What one method with one setting is worth over all scenes that it ran on.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    pub method: String,
    /// What is not as by default.
    pub setting: String,
    pub scenes: usize,
    /// Shifted geometric mean of the CPU time, seconds.
    pub seconds: f64,
    /// Share of the scenes with an answer within 0.1, 1 and 5 % of the reference.
    pub within: [f64; 3],
    /// Share of the scenes with an answer.
    pub answered: f64,
}

/// Shift of the geometric mean, seconds: below it, being faster counts for little.
pub const SHIFT: f64 = 1e-3;

/// Relative errors that count.
pub const WITHIN: [f64; 3] = [1e-3, 1e-2, 5e-2];

/// One line a method and setting, in the order in which they first come.
pub fn summaries(entries: &[Measurement]) -> Vec<Summary> {
    let name = |entry: &'_ Measurement| (entry.row.method.clone(), entry.setting().to_owned());
    let names: IndexSet<(String, String)> = entries.iter().map(name).collect();
    let summary = |(method, setting): (String, String)| {
        let of_name = |e: &&Measurement| e.row.method == method && e.setting() == setting;
        let own: Vec<&Measurement> = entries.iter().filter(of_name).collect();
        let count = own.len() as f64;
        let share = |limit: f64| {
            let good = own
                .iter()
                .filter(|e| e.error().is_some_and(|error| error <= limit));
            good.count() as f64 / count
        };
        let logs = own.iter().map(|entry| (entry.row.seconds + SHIFT).ln());
        Summary {
            scenes: own.len(),
            seconds: (logs.sum::<f64>() / count).exp() - SHIFT,
            within: WITHIN.map(share),
            answered: share(f64::INFINITY),
            method,
            setting,
        }
    };
    names.into_iter().map(summary).collect()
}

pub fn table(summaries: &[Summary], layout: Layout) -> String {
    let columns = [
        words("method"),
        words("setting"),
        numbers("scenes").spare(1),
        numbers("mean ms"),
        numbers("0.1 %"),
        numbers("1 %"),
        numbers("5 %"),
        numbers("answers"),
    ];
    let percent = |share: f64| format!("{:.0} %", 100.0 * share);
    let line = |s: &Summary| {
        let words = [s.method.clone(), s.setting.clone()];
        let effort = [s.scenes.to_string(), number(1e3 * s.seconds, 3)];
        let shares = [s.within[0], s.within[1], s.within[2], s.answered].map(percent);
        [words.as_slice(), &effort, &shares].concat()
    };
    let lines: Vec<Vec<String>> = summaries.iter().map(line).collect();
    let legend = "mean: the geometric mean of the CPU time over the scenes, shifted by 1 ms. The \
                  percentages are shares of the scenes: those whose answer (verified, bracketed or \
                  estimate) lies within 0.1, 1 and 5 % of the reference, where the farther end of a \
                  range counts, and those with an answer at all. The reference of a scene is its \
                  collapse multiplier without dilatancy, or the range from its lowest to its highest \
                  state: the error is max(|a - r|, |b - R|) / r.";
    let legend = layout.paragraph("", Style::new(), legend);
    format!("{}\n{legend}", grid(layout, 0, &columns, &lines))
}

const COLUMNS: [Heading<Summary>; 8] = [
    ("method", |s| s.method.as_str().into()),
    ("setting", |s| s.setting.as_str().into()),
    ("scenes", |s| Value::Count(s.scenes)),
    ("seconds", |s| Value::Number(s.seconds)),
    ("within_0.1", |s| Value::Number(s.within[0])),
    ("within_1", |s| Value::Number(s.within[1])),
    ("within_5", |s| Value::Number(s.within[2])),
    ("answered", |s| Value::Number(s.answered)),
];

pub fn csv(summaries: &[Summary]) -> String {
    csv_of(&COLUMNS, summaries)
}
