//! The ranges of all methods beside that of the macro-block model (the paper's Fig. 6).

use kuva::plot::ForestPlot;
use kuva::plot::annotations::ShadedRegion;
use kuva::render::layout::{Layout, TickFormat};
use kuva::render::plots::Plot;
use maud::{Markup, PreEscaped, html};

use super::plot;
use crate::answer::Bracket;
use crate::run::{CaseResult, Row};

/// Pixels for each method.
const LINE: f64 = 24.0;

/// A plot a case that the closed form covers; `None` where it covers none.
pub fn ranges(results: &[CaseResult]) -> Option<Markup> {
    let covered: Vec<(&CaseResult, &Row)> = results
        .iter()
        .filter_map(|result| {
            let mut rows = result.rows.iter();
            let closed = rows.find(|row| row.method == "macro-block")?;
            closed.outcome.bracket.map(|_| (result, closed))
        })
        .collect();
    let largest = covered
        .iter()
        .filter_map(|(_, closed)| closed.outcome.bracket);
    let largest = largest.map(|bracket| bracket.upper).fold(0.0, f64::max);
    (!covered.is_empty()).then(|| {
        html! {
            p { "The shaded range is the macro-block model's, λ" sub { "low" } " to λ" sub { "upp" }
                "; every other method is a mark, or a line where it gives a range. The closed form claims "
                "to contain the true multiplier; its upper value is weak, so that containing says little." }
            div.plots {
                @for (index, (result, closed)) in covered.iter().enumerate() {
                    figure {
                        (PreEscaped(one(result, closed, 1.05 * largest, index)))
                        figcaption { (result.case.name) ": " (result.case.title) }
                    }
                }
            }
        }
    })
}

fn one(result: &CaseResult, closed: &Row, largest: f64, index: usize) -> String {
    let mut forest = ForestPlot::new()
        .with_marker_size(4.0)
        .with_whisker_width(2.2)
        .with_cap_size(4.0)
        .with_show_null_line(false);
    let mut count = 0;
    for row in &result.rows {
        let Some(bracket) = row.outcome.bracket else {
            continue;
        };
        // The closed form does not see head joints.
        if row.method == closed.method && row.head_joints != closed.head_joints {
            continue;
        }
        let label = match row.method == closed.method {
            true => row.method.clone(),
            false => format!("{}, {}", row.method, row.head_joints.name()),
        };
        let middle = (bracket.lower + bracket.upper) / 2.0;
        let color = plot::color(&row.method);
        // A wide range is a line: a mark in its middle would look like an answer.
        let mark = if bracket.relative_width() > 0.1 {
            0.0
        } else {
            1.0
        };
        let Bracket { lower, upper } = bracket;
        forest = forest.with_weighted_colored_row(label, middle, lower, upper, mark, color);
        count += 1;
    }
    let plots: Vec<Plot> = vec![forest.into()];
    let range = closed.outcome.bracket.unwrap_or(Bracket::point(0.0));
    let shaded = ShadedRegion::vertical(range.lower, range.upper)
        .with_color(plot::color(&closed.method))
        .with_opacity(0.1);
    let layout = Layout::auto_from_plots(&plots)
        .with_width(560.0)
        .with_height(110.0 + LINE * f64::from(count))
        .with_x_axis_min(0.0)
        .with_x_axis_max(largest)
        .with_x_tick_format(TickFormat::Fixed(1))
        .with_x_label("collapse multiplier λ")
        .with_shaded_region(shaded)
        .with_body_size(12)
        .with_tick_size(12)
        .with_label_size(13);
    let name = format!("Ranges of λ of {}", result.case.name);
    plot::svg(plots, layout, &format!("range{index}"), &name)
}
