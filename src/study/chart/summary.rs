//! Each method with each setting over all scenes.

use indexmap::IndexSet;

use super::table::Measurement;
use crate::run::{self, Value};

/// What one method with one setting is worth over all scenes that it ran on.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    /// Name of the method.
    pub method: String,
    /// What is not as by default.
    pub setting: String,
    /// Number of scenes.
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

/// The summary as a fixed-width table.
pub fn table(summaries: &[Summary]) -> String {
    let mut text = format!(
        "{:<12} {:<34} {:>6} {:>10} {:>8} {:>8} {:>8} {:>8}\n",
        "method", "setting", "scenes", "mean ms", "0.1 %", "1 %", "5 %", "answers"
    );
    for s in summaries {
        let percent = |share: f64| format!("{:.0} %", 100.0 * share);
        let line = format!(
            "{:<12} {:<34} {:>6} {:>10.3} {:>8} {:>8} {:>8} {:>8}",
            s.method,
            s.setting,
            s.scenes,
            1e3 * s.seconds,
            percent(s.within[0]),
            percent(s.within[1]),
            percent(s.within[2]),
            percent(s.answered),
        );
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text.push_str(
        "\nmean: geometric mean of the CPU time over the scenes, shifted by 1 ms; shares of the \
         scenes whose answer\n(verified, bracketed or estimate) lies within that of the reference, \
         the farther end of a bracket counting;\nno answer lies within nothing. A scene's reference \
         is its collapse multiplier without dilatancy,\nthe range of its lowest and highest state \
         where there are several: the error is max(|a - r|, |b - R|) / r.\n",
    );
    text
}

/// The summary as CSV.
///
/// # Errors
/// Those of the CSV writer; none is expected in memory.
pub fn csv(summaries: &[Summary]) -> Result<String, csv::Error> {
    let headings = [
        "method",
        "setting",
        "scenes",
        "seconds",
        "within_0.1",
        "within_1",
        "within_5",
        "answered",
    ];
    let line = |s: &Summary| {
        let [a, b, c] = s.within;
        let mut line = vec![s.method.as_str().into(), s.setting.as_str().into()];
        line.push(Value::Count(s.scenes));
        line.extend([s.seconds, a, b, c, s.answered].map(Value::Number));
        line
    };
    run::csv(headings, summaries.iter().map(line))
}
