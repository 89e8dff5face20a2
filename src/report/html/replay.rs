//! The pushover's collapse, replayed: poses that a little script plays over a drawing, with
//! their times.

use maud::{Markup, PreEscaped, html};

use crate::number::number;
use crate::picture::{Replay, replay as drawn};
use crate::run::{CaseResult, Row};
use crate::scene::HeadJoints;

/// The replay of a row; nothing where it holds no recording.
pub fn replay(result: &CaseResult, row: &Row) -> Markup {
    let title = format!("Collapse of {}", result.case.name);
    let Some(Replay {
        svg,
        poses,
        farthest,
    }) = drawn(result.scene(row), row, &title)
    else {
        return html! {};
    };
    // A string in a script must not be able to close it.
    let data = serde_json::to_string(&poses)
        .unwrap_or_default()
        .replace("</", "<\\/");
    let frames = poses.frames.len();
    let id = format!("replay-{}-{}", result.case.name, row.head_joints.name());
    // The replay is of the larger λ, which is the farther change of a reaction.
    let lambda = row.outcome.bracket().map_or(0.0, |bracket| bracket.upper);
    let (what, upper) = match row.reaction {
        Some(_) => ("a reaction of", row.reads(lambda)),
        None => ("λ =", lambda),
    };
    html! {
        h3 id=(id) { "The collapse, replayed" }
        figure.replay aria-labelledby=(id) {
            (PreEscaped(svg))
            div.controls {
                button.play type="button" { "Play" }
                label { span { "Time" }
                    input type="range" min="0" max=(frames - 1) value="0" step="1"
                        aria-label="Frame of the replay"; }
                output { "t = 0" }
            }
            figcaption { "Pushover at " (what) " " (number(upper, 5)) ", " (row.head_joints.name())
                " head joints: the motion without damping after the collapse was called, as large as it \
                 is, until the farthest corner had moved by " (number(farthest, 2)) ". Time t is in √(L/g), L \
                 being the unit of length: 0.319 s where that is the metre."
                @if row.head_joints == HeadJoints::Open {
                    " Blocks of a course do not touch each other here, and may overlap."
                } }
            script type="application/json" { (PreEscaped(data)) }
        }
    }
}
