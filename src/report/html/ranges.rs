//! The ranges of all methods beside that of the macro-block model (the paper's Fig. 6).

use maud::{Markup, PreEscaped, html};

use crate::answer::Bracket;
use crate::method::{Kind, method_look};
use crate::picture::{RangeMark, Ranges, ranges as drawn};
use crate::run::{CaseResult, Row};

/// A plot a case that the closed form covers; `None` where it covers none.
pub fn ranges(results: &[CaseResult]) -> Option<Markup> {
    let covered: Vec<(&CaseResult, &Row)> = results
        .iter()
        .filter_map(|result| {
            let mut rows = result.rows.iter();
            let closed = rows.find(|row| row.kind() == Kind::ClosedForm)?;
            closed.outcome.bracket.map(|_| (result, closed))
        })
        .collect();
    let rows = covered.iter().flat_map(|(result, _)| &result.rows);
    let uppers = rows.filter_map(|row| Some(row.outcome.bracket?.upper));
    let largest = 1.05 * uppers.fold(0.0, f64::max);
    (!covered.is_empty()).then(|| {
        html! {
            p { "The shaded range is the macro-block model's, λ" sub { "low" } " to λ" sub { "upp" }
                "; every other method is a mark, or a line where it gives a range. The closed form claims "
                "to contain the true multiplier; its upper value is weak, so that containing says little." }
            div.plots {
                @for (result, closed) in &covered {
                    figure {
                        (PreEscaped(one(result, closed, largest)))
                        figcaption { (result.case.name) ": " (result.case.title) }
                    }
                }
            }
        }
    })
}

fn one(result: &CaseResult, closed: &Row, largest: f64) -> String {
    let mut ranges = Vec::new();
    for row in &result.rows {
        let Some(bracket) = row.outcome.bracket else {
            continue;
        };
        let is_closed_form = row.method == closed.method;
        // The closed form does not see head joints.
        if is_closed_form && row.head_joints != closed.head_joints {
            continue;
        }
        ranges.push(RangeMark {
            name: if is_closed_form {
                row.method.clone()
            } else {
                format!("{}, {}", row.method, row.head_joints.name())
            },
            ends: [bracket.lower, bracket.upper],
            colour: method_look(&row.method, 0).colour,
            marked: bracket.relative_width(row.multiplier_unit) <= 0.1,
        });
    }
    let shaded = closed.outcome.bracket.unwrap_or(Bracket::point(0.0));
    let picture = Ranges {
        ranges,
        shaded: [shaded.lower, shaded.upper],
        shade: method_look(&closed.method, 0).colour,
        largest,
        label: "collapse multiplier λ",
    };
    drawn(&picture, &format!("Ranges of λ of {}", result.case.name))
}
