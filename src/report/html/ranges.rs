//! The ranges of all methods beside that of the macro-block model (the paper's Fig. 6).

use maud::{Markup, PreEscaped, html};

use crate::answer::Status;
use crate::case::{Quantity, SourceKind};
use crate::method::{Kind, method_look};
use crate::picture::palette::INK;
use crate::picture::{Filling, KNOWN, RangeMark, Ranges, Sample, dashed_line, ranges as drawn};
use crate::run::{CaseResult, Row};
use crate::scene::HeadJoints;

/// A plot a case that has a multiplier; `None` where none has.
pub fn ranges(results: &[CaseResult]) -> Option<Markup> {
    let figures = results.iter();
    let figures = figures.filter_map(|result| Some((result, range_figure(result)?)));
    let figures: Vec<(&CaseResult, String)> = figures.collect();
    (!figures.is_empty()).then(|| {
        html! {
            p { "Each plot shows the answers near enough to be told apart; the strip above it has the whole "
                "range of the macro-block model, λ" sub { "low" } " to λ" sub { "upp" } ", where it applies. "
                "The closed form claims to contain the true multiplier, but its range is too wide to confirm "
                "much." }
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
    // The closed form's is shaded.
    let with_ends = result.rows.iter().filter(|row| row.bracket().is_some());
    let (closed, mut rows): (Vec<&Row>, Vec<&Row>) =
        with_ends.partition(|row| row.kind() == Kind::ClosedForm);
    if rows.is_empty() {
        return None;
    }
    rows.sort_by_key(|row| row.head_joints == HeadJoints::Contact);
    let ranges: Vec<RangeMark> = rows.iter().map(|row| mark(row, both)).collect();
    let shaded = closed.first().and_then(|row| {
        let ends = row.bracket()?;
        let colour = method_look(&row.method, 0).colour;
        Some((row.method.clone(), [ends.lower, ends.upper], colour))
    });
    let is_verified = |row: &Row| row.status() == Status::Verified;
    let bounds = rows.iter();
    let bounds = bounds.filter(|row| row.kind() == Kind::AssociativeBounds && is_verified(row));
    let bounds = bounds.filter_map(|row| Some(row.reads(row.outcome.bracket()?.upper)));
    let bounds: Vec<f64> = bounds.collect();
    let moves = rows.iter().find_map(|row| row.reaction.as_ref());
    let label = match moves {
        Some(reaction) => format!("reaction of {} at collapse", reaction.support),
        None => "collapse multiplier λ".to_owned(),
    };
    let mut entries = Vec::new();
    if rows.iter().any(|row| is_verified(row)) {
        entries.push((Sample::disc(Filling::Full), "verified"));
    }
    if !rows.iter().all(|row| is_verified(row)) {
        entries.push((Sample::disc(Filling::Open), "not proved"));
    }
    if !bounds.is_empty() {
        let words = match moves {
            Some(_) => "the reaction with associative friction, a proved bound",
            None => "λ with associative friction, a proved upper bound",
        };
        entries.push((Sample::Line(dashed_line(INK)), words));
    }
    if ranges.iter().any(|range| !range.known.is_empty()) {
        entries.push((Sample::Point(KNOWN, Filling::Open), "published or analytic"));
    }
    let picture = Ranges {
        ranges,
        shaded,
        bounds,
        label,
    };
    Some(drawn(&picture, &entries, &result.case.name))
}

fn mark(row: &Row, both: bool) -> RangeMark {
    let ends = row.bracket();
    let ends = ends.map_or([0.0; 2], |ends| [ends.lower, ends.upper]);
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
