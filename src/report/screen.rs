//! A case for people: first what it comes to, then one line an answer, below it what is to be known of
//! them in sentences, last what they all come to for each setting of the head joints.

use anstyle::Style;

use super::governing::Governing;
use super::styles::{grid_column, of_verdict};
use super::terms::terms;
use crate::judge::Verdict;
use crate::record::{self, LEGEND, Note};
use crate::run::{CaseResult, values};
use crate::text::{Layout, bold, ended, grid, sentence};

/// Columns of a screen: those of the record, as many as there is room for, and how soon each is left
/// out.
const COLUMNS: [(&str, usize); 13] = [
    ("method", 0),
    ("head_joints", 0),
    ("lambda", 0),
    ("times_demand", 0),
    ("stated_percent", 1),
    ("lambda_reference", 2),
    ("status", 0),
    ("error_percent", 0),
    ("verdict_words", 0),
    ("slope", 3),
    ("slope_reference", 6),
    ("width_c", 4),
    ("width_e", 5),
];

/// What is said of one case: its title, a table, notes, checks that do not hold, and the best answer
/// for each setting of the head joints. Where lines may be of any length, the table is that of the
/// record, whose columns stand at the same place in every case.
pub fn case_table(result: &CaseResult, layout: Layout) -> String {
    let mut text = layout.paragraph(
        &result.case.name,
        bold(),
        &format!(": {}", result.case.title),
    );
    if let Some(governing) = Governing::of(result) {
        text.push_str(&layout.paragraph("in short  ", bold(), &governing.text()));
    }
    text.push_str(&answers(result, layout));
    for note in record::notes(result) {
        text.push_str(&said(&note, layout));
    }
    text.push_str(&layout.paragraph("", Style::new(), &record::tally(&result.checks)));
    if let Some(partial) = result.partial() {
        text.push_str(&layout.paragraph("", Style::new(), &partial));
    }
    let open = result.checks.iter().filter(|c| c.verdict > Verdict::Holds);
    for check in open {
        let lead = format!("  {:<8}  ", check.verdict.name());
        let words = format!("{}: {}", check.head_joints.name(), ended(&check.text));
        text.push_str(&layout.paragraph(&lead, of_verdict(check.verdict), &words));
    }
    text.push_str(&layout.paragraph("answer", bold(), ""));
    for conclusion in &result.conclusions {
        let lead = format!("  {:<8}  ", conclusion.head_joints.name());
        let mut words = sentence(&conclusion.to_string());
        if let Some(terms) = terms(result, conclusion).map(|terms| terms.to_string()) {
            words = format!("{words} {}", sentence(&terms));
        }
        text.push_str(&layout.paragraph(&lead, bold(), &words));
    }
    text + "\n"
}

fn answers(result: &CaseResult, layout: Layout) -> String {
    let demands = result.case.demand.is_some();
    if layout.columns().is_none() && !demands {
        let lines = record::lines(result);
        let lines: String = lines.into_iter().map(|line| line + "\n").collect();
        return format!("{}\n{lines}", record::heading());
    }
    let shown = COLUMNS
        .iter()
        .filter(|(name, _)| demands || *name != "times_demand");
    let (names, spare): (Vec<&str>, Vec<usize>) = shown.copied().unzip();
    let shown = |row| {
        let cells = values(row, &names);
        cells.iter().map(|cell| cell.shown()).collect()
    };
    let rows: Vec<Vec<String>> = result.rows.iter().map(shown).collect();
    let moves = result.rows.iter().any(|row| row.reaction.is_some());
    let columns = names.iter().zip(spare).map(|(name, spare)| {
        let column = grid_column(name).spare(spare);
        match *name {
            "lambda" if moves => column.headed("reaction"),
            _ => column,
        }
    });
    grid(layout, 0, &columns.collect::<Vec<_>>(), &rows)
}

fn said(note: &Note, layout: Layout) -> String {
    let (method, joints) = (&note.method, note.joints().join(" and "));
    let words = format!("{method}, {joints}: {}", ended(&note.text));
    layout.paragraph("  ", Style::new(), &words)
}

/// Columns from which references have room, as a rule.
const WITH_REFERENCES: usize = 100;

/// What the error is, where references have no room.
const ERROR: &str = "Error: how far the farther end of an answer is from its reference value. Stated: how far off the \
     method says that it may be.";

/// What stands below the last case; `more` says how to get the columns that a narrow screen leaves out.
pub fn legend(layout: Layout, more: &str) -> String {
    let words = match layout.columns() {
        None => LEGEND.to_owned(),
        Some(columns) if columns < WITH_REFERENCES => format!("{ERROR} {more}"),
        Some(_) => format!("{LEGEND} {more}"),
    };
    layout.paragraph("", Style::new(), &words)
}
