//! One case: drawings, replay, certificates, record.

use maud::{Markup, PreEscaped, html};

use super::{replay, residuals};
use crate::method::{Kind, entry};
use crate::picture::{Options, View, common_size, figure};
use crate::record::record;
use crate::report::terms::terms;
use crate::run::{CaseResult, Row};
use crate::scene::HeadJoints;

/// The panel of a case.
pub fn panel(result: &CaseResult) -> Markup {
    let (foremost, further) = drawn(result);
    let all: Vec<View> = (foremost.iter().chain(&further))
        .map(|row| view(result, row))
        .collect();
    let size = common_size(&all, WIDTH);
    html! {
        @if result.case.title != result.case.name { p.title { (result.case.title) } }
        @if !result.case.source.is_empty() { p.small { "Source: " (result.case.source) } }
        @for conclusion in &result.conclusions {
            @if let Some(terms) = terms(result, conclusion) {
                p.small { (conclusion.head_joints.name()) ": " (terms.to_string()) }
            }
        }
        h3 { "Mechanisms" }
        (drawings(result, &foremost, size))
        @if !further.is_empty() {
            details {
                summary { (further.len()) " more: other methods and head joints" }
                (drawings(result, &further, size))
            }
        }
        @for row in &result.rows {
            (replay::replay(result, row))
        }
        @if let Some(residuals) = residuals::in_full(result) {
            details { summary { "Certificates" } (residuals) }
        }
        details {
            summary { "Record" }
            div.scroll tabindex="0" role="region" aria-label={"Record of " (result.case.name)} {
                pre { (record(result)) }
            }
        }
    }
}

/// The drawing of the foremost answer of a case that is not the closed form's.
pub fn foremost(result: &CaseResult) -> Option<String> {
    let (rows, further) = drawn(result);
    let mut rows = rows.into_iter().chain(further).chain(&result.rows);
    let row = rows.find(|row| row.kind() != Kind::ClosedForm)?;
    let options = Options {
        framed: false,
        ..Options::for_pictures(3)
    };
    Some(figure(&result.case.name, &[view(result, row)], &options))
}

/// Rows to draw: the foremost methods with the head joints that published mechanisms are of, and
/// what else has a mechanism. The closed form does not see head joints: it is drawn once.
fn drawn(result: &CaseResult) -> (Vec<&Row>, Vec<&Row>) {
    let open = result
        .rows
        .iter()
        .any(|row| row.head_joints == HeadJoints::Open);
    let main = |row: &Row| (row.head_joints == HeadJoints::Open) == open;
    let is_foremost =
        |row: &Row| entry(&row.method).is_some_and(|entry| entry.drawn_first) && main(row);
    let can_be_drawn = |row: &&Row| {
        if row.kind() == Kind::ClosedForm {
            row.crack.is_some() && main(row)
        } else {
            row.outcome.evidence.mechanism().is_some()
        }
    };
    let (mut foremost, mut further): (Vec<&Row>, Vec<&Row>) = result
        .rows
        .iter()
        .filter(can_be_drawn)
        .partition(|row| is_foremost(row));
    if foremost.is_empty() {
        std::mem::swap(&mut foremost, &mut further);
    }
    if foremost.is_empty() {
        // The wall as it stands, with what a method says of it.
        let mut own = result
            .rows
            .iter()
            .filter(|row| row.kind() != Kind::ClosedForm);
        foremost.extend(own.next());
    }
    (foremost, further)
}

/// The view of a row, with the crack of the closed form for the same scene.
fn view<'a>(result: &'a CaseResult, row: &'a Row) -> View<'a> {
    let same =
        |other: &&Row| other.kind() == Kind::ClosedForm && other.head_joints == row.head_joints;
    let closed = result.rows.iter().find(same);
    let (scene, row) = result.governing(row);
    View {
        scene,
        row,
        macro_slope: closed.and_then(|row| row.crack).map(|crack| crack.tan_beta),
    }
}

/// Pixels that a drawing is wide where the page does not make it narrower.
const WIDTH: f64 = 400.0;

/// Drawings of these rows with so many pixels for a unit of length, and so high, so that they can be
/// compared.
fn drawings(result: &CaseResult, rows: &[&Row], (scale, height): (f64, f64)) -> Markup {
    let options = Options {
        forces: false,
        framed: false,
        width: WIDTH,
        scale: Some(scale),
        height,
    };
    let svg = |row: &Row| figure(&result.case.name, &[view(result, row)], &options);
    html! {
        div.drawings {
            @for row in rows { figure.drawing { (PreEscaped(svg(row))) } }
        }
    }
}
