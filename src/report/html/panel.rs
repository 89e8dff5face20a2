//! One case: drawings, replay, certificates, record.

use maud::{Markup, PreEscaped, html};

use super::residuals;
use crate::case::{Case, geometry_words, push_words};
use crate::judge::governing;
use crate::method::{Kind, entry};
use crate::number::number;
use crate::picture::{Options, View, common_size, figure, replay as drawn_replay};
use crate::record::record;
use crate::report::governing::Governing;
use crate::report::terms::terms;
use crate::run::{CaseResult, Row};
use crate::scene::HeadJoints;

pub fn panel(result: &CaseResult) -> Markup {
    let (foremost, further) = drawn(result);
    let all = foremost.iter().chain(&further);
    let all: Vec<View> = all.map(|row| view(result, row)).collect();
    let size = common_size(&all, WIDTH);
    html! {
        (verdict(result))
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
            (replay(result, row))
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

/// What the case comes to beside the drawing of that answer, and what it is.
pub fn verdict(result: &CaseResult) -> Markup {
    let Case {
        name,
        title,
        source,
        pushes,
        ..
    } = &result.case;
    let said = Governing::of(result).map(|governing| governing.sentences());
    html! {
        @if title != name { p.title { (title) } }
        div.verdict {
            div {
                @if let Some((first, others)) = said {
                    p.headline.said { (first) }
                    p.answer { (others.join(" ")) }
                }
                dl.inputs {
                    dt { "Made of" } dd { (geometry_words(&result.case)) }
                    @if result.case.motion.is_none() { dt { "Pushed" } dd { (push_words(pushes)) } }
                    @for (head_joints, scenes) in &result.scenes {
                        dt { "Head joints " (head_joints.in_words()) }
                        dd { (scenes[0].blocks().len()) " blocks, " (scenes[0].joints().len()) " joints" }
                    }
                    @if !source.is_empty() { dt { "Source" } dd { (source) } }
                }
            }
            @if let Some(svg) = governing_drawing(result) { figure.drawing { (PreEscaped(svg)) } }
        }
    }
}

/// The drawing of the answer that governs; of any other where that has nothing to draw.
fn governing_drawing(result: &CaseResult) -> Option<String> {
    let first = governing(&result.conclusions).map(|at| &result.conclusions[at]);
    let governs = |row: &&Row| {
        first.is_some_and(|of| {
            row.head_joints == of.head_joints && of.methods.first() == Some(&row.method)
        })
    };
    let (rows, further) = drawn(result);
    let mut others = rows.into_iter().chain(further).chain(&result.rows);
    let row = result.rows.iter().find(governs);
    let row = row.filter(|row| row.outcome.evidence.mechanism().is_some());
    let row = row.or_else(|| others.find(|row| row.kind() != Kind::ClosedForm))?;
    let options = Options {
        framed: false,
        ..Options::for_pictures(2)
    };
    Some(figure(&result.case.name, &[view(result, row)], &options))
}

/// Rows to draw: the foremost methods with the head joints that published mechanisms are of, and
/// what else has a mechanism. The closed form does not see head joints: it is drawn once.
fn drawn(result: &CaseResult) -> (Vec<&Row>, Vec<&Row>) {
    let is_open = |row: &Row| row.head_joints == HeadJoints::Open;
    let open = result.rows.iter().any(is_open);
    let main = |row: &Row| is_open(row) == open;
    let is_foremost =
        |row: &Row| entry(&row.method).is_some_and(|entry| entry.drawn_first) && main(row);
    let can_be_drawn = |row: &&Row| {
        if row.kind() == Kind::ClosedForm {
            row.crack.is_some() && main(row)
        } else {
            row.outcome.evidence.mechanism().is_some()
        }
    };
    let rows = result.rows.iter().filter(can_be_drawn);
    let (mut foremost, mut further): (Vec<&Row>, Vec<&Row>) =
        rows.partition(|row| is_foremost(row));
    if foremost.is_empty() {
        std::mem::swap(&mut foremost, &mut further);
    }
    if foremost.is_empty() {
        // The wall as it stands, with what a method says of it.
        let mut rows = result.rows.iter();
        foremost.extend(rows.find(|row| row.kind() != Kind::ClosedForm));
    }
    (foremost, further)
}

/// The view of a row, with the crack of the closed form for the same scene.
fn view<'a>(result: &'a CaseResult, row: &'a Row) -> View<'a> {
    let mut same = result
        .rows
        .iter()
        .filter(|other| other.head_joints == row.head_joints);
    let closed = same.find(|other| other.kind() == Kind::ClosedForm);
    let (scene, row) = result.governing(row);
    View {
        scene,
        row,
        macro_slope: closed.and_then(|row| Some(row.crack?.tan_beta)),
    }
}

/// Pixels that a drawing is wide where the page does not make it narrower.
const WIDTH: f64 = 400.0;

/// Drawings of these rows with so many pixels for a unit of length, and so high, so that they can be
/// compared.
fn drawings(result: &CaseResult, rows: &[&Row], (scale, height): (f64, f64)) -> Markup {
    let options = Options {
        framed: false,
        width: WIDTH,
        scale: Some(scale),
        height,
        ..Options::for_pictures(3)
    };
    let svg = |row: &Row| figure(&result.case.name, &[view(result, row)], &options);
    html! {
        div.drawings {
            @for row in rows { figure.drawing { (PreEscaped(svg(row))) } }
        }
    }
}

/// The pushover's collapse, replayed: poses that a little script plays over a drawing, with their times;
/// nothing where the row holds no recording.
fn replay(result: &CaseResult, row: &Row) -> Markup {
    let title = format!("Collapse of {}", result.case.name);
    let Some(replay) = drawn_replay(result.scene(row), row, &title) else {
        return html! {};
    };
    // A string in a script must not be able to close it.
    let data = serde_json::to_string(&replay.poses).unwrap_or_default();
    let data = data.replace("</", "<\\/");
    let frames = replay.poses.frames.len();
    let id = format!("replay-{}-{}", result.case.name, row.head_joints.name());
    // The replay is of the larger λ, which is the farther change of a reaction.
    let lambda = row.outcome.bracket().map_or(0.0, |bracket| bracket.upper);
    let (what, upper) = match row.reaction {
        Some(_) => ("a reaction of", row.reads(lambda)),
        None => ("λ =", lambda),
    };
    html! {
        h3.replay-title id=(id) { "The collapse, replayed" }
        figure.replay aria-labelledby=(id) {
            (PreEscaped(replay.svg))
            div.controls {
                button.play type="button" { "Play" }
                label { span { "Time" }
                    input type="range" min="0" max=(frames - 1) value="0" step="1"
                        aria-label="Frame of the replay"; }
                output { "t = 0" }
            }
            figcaption { "Pushover at " (what) " " (number(upper, 5)) ", " (row.head_joints.name())
                " head joints: the motion without damping after the collapse was called, as large as it \
                 is, until the farthest corner had moved by " (number(replay.farthest, 2)) ". Time t is in √(L/g), L \
                 being the unit of length: 0.319 s where that is the metre."
                @if row.head_joints == HeadJoints::Open {
                    " Blocks of a course do not touch each other here, and may overlap."
                } }
            script type="application/json" { (PreEscaped(data)) }
        }
    }
}
