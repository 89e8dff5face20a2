//! The ranges of all methods beside that of the macro-block model (the paper's Fig. 6).

use maud::{Markup, PreEscaped, html};

use crate::answer::Status;
use crate::case::{Quantity, SourceKind};
use crate::method::{Kind, Look, Mark, method_look};
use crate::picture::palette::INK;
use crate::picture::{
    Filling, KNOWN, LegendEntry, RangeMark, Ranges, Sample, dashed_line, ranges as drawn,
};
use crate::run::{CaseResult, Row};
use crate::scene::HeadJoints;

/// A plot a case that has a multiplier; `None` where none has.
pub fn ranges(results: &[CaseResult]) -> Option<Markup> {
    let figures: Vec<(&CaseResult, String)> = results
        .iter()
        .filter_map(|result| Some((result, range_figure(result)?)))
        .collect();
    (!figures.is_empty()).then(|| {
        html! {
            p { "Each plot shows the answers near enough to be told apart; the strip above it has the whole "
                "range of the macro-block model, λ" sub { "low" } " to λ" sub { "upp" } ", where it applies. "
                "The closed form claims to contain the true multiplier; its upper value is weak, so that "
                "containing says little." }
            div.plots {
                @for (result, figure) in &figures {
                    figure { (PreEscaped(figure)) figcaption { (result.case.title) } }
                }
            }
        }
    })
}

/// The ranges of a case as SVG; `None` where no method but the closed form has a multiplier.
pub fn range_figure(result: &CaseResult) -> Option<String> {
    let both = result.case.head_joints.len() > 1;
    let mut rows: Vec<&Row> = result.rows.iter().filter(|row| is_shown(row)).collect();
    rows.sort_by_key(|row| row.head_joints == HeadJoints::Contact);
    let ranges: Vec<RangeMark> = rows.iter().map(|row| mark(row, both)).collect();
    let closed =
        (result.rows.iter()).find(|row| row.kind() == Kind::ClosedForm && row.bracket().is_some());
    let shaded = closed.and_then(|row| {
        let ends = row.bracket()?;
        let colour = method_look(&row.method, 0).colour;
        Some((row.method.clone(), [ends.lower, ends.upper], colour))
    });
    let bounds = rows
        .iter()
        .filter(|row| row.kind() == Kind::AssociativeBounds && row.status() == Status::Verified);
    let bounds: Vec<(String, f64)> = bounds
        .filter_map(|row| Some((row.scene_name(), row.reads(row.outcome.bracket()?.upper))))
        .collect();
    let moves = rows.iter().find_map(|row| row.reaction.as_ref());
    let label = match moves {
        Some(reaction) => format!("reaction of {} at collapse", reaction.support),
        None => "collapse multiplier λ".to_owned(),
    };
    let mut entries = Vec::new();
    let disc = |filling, words: &str| {
        let look = Look {
            colour: INK,
            mark: Mark::Circle,
        };
        LegendEntry::new(Sample::Point(look, filling), words)
    };
    if rows.iter().any(|row| row.status() == Status::Verified) {
        entries.push(disc(Filling::Full, "verified"));
    }
    if rows.iter().any(|row| row.status() != Status::Verified) {
        entries.push(disc(Filling::Open, "not proved"));
    }
    if !bounds.is_empty() {
        let words = match moves {
            Some(_) => "the reaction with associative friction, a proved bound",
            None => "λ with associative friction, a proved upper bound",
        };
        entries.push(LegendEntry::new(Sample::Line(dashed_line(INK)), words));
    }
    if ranges.iter().any(|range| !range.known.is_empty()) {
        entries.push(LegendEntry::new(
            Sample::Point(KNOWN, Filling::Open),
            "published or analytic",
        ));
    }
    if ranges.is_empty() {
        return None;
    }
    let picture = Ranges {
        ranges,
        shaded,
        bounds,
        label,
    };
    Some(drawn(&picture, &entries, &result.case.name))
}

/// Whether a row is a line of the plot: it has a multiplier, and is not the closed form's, which is shaded.
fn is_shown(row: &Row) -> bool {
    row.bracket().is_some() && row.kind() != Kind::ClosedForm
}

fn mark(row: &Row, both: bool) -> RangeMark {
    let ends = row
        .bracket()
        .map_or([0.0; 2], |ends| [ends.lower, ends.upper]);
    let known = row.references.iter().filter(|reference| {
        reference.kind != SourceKind::Independent
            && matches!(
                reference.quantity,
                Quantity::Lambda | Quantity::Reaction | Quantity::Lower | Quantity::Upper
            )
    });
    RangeMark {
        name: match both {
            true => format!("{}, {}", row.method, row.head_joints.name()),
            false => row.method.clone(),
        },
        ends,
        look: method_look(&row.method, 0),
        filling: match row.status() {
            Status::Verified => Filling::Full,
            _ => Filling::Open,
        },
        known: known.map(|reference| reference.value).collect(),
    }
}
