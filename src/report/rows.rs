//! CSV and JSON: the same rows twice.

use serde_json::{Value as Json, json};

use super::governing::Governing;
use super::terms::terms;
use crate::answer::Outcome;
use crate::external::{SceneFile, answers};
use crate::judge::Conclusion;
use crate::mechanics::{Mechanism, MovingPart, Thrust, thrust};
use crate::run::{self, COLUMNS, CaseResult, Column, Partial, Row, Value};
use crate::scene::Push;

fn for_programs() -> impl Iterator<Item = &'static Column> {
    COLUMNS.iter().filter(|column| column.is_for_programs())
}

fn rows(results: &[CaseResult]) -> impl Iterator<Item = &Row> {
    results.iter().flat_map(|result| &result.rows)
}

/// CSV with a heading line: numbers with 9 significant digits, empty where there is nothing to vouch
/// for.
pub fn csv(results: &[CaseResult]) -> String {
    let headings = for_programs().map(|column| column.name);
    let line = |row| for_programs().map(|column| (column.value)(row)).collect();
    run::csv(headings, rows(results).map(line))
}

/// JSON: a list of the CSV's rows with numbers as numbers and `null` where CSV is empty, and with
/// the self-checks that ran, in words. Where a recording was asked for, `recording` has the
/// `frames` of what follows the collapse, an `interval` apart (in √(L/g), L being the case's length
/// unit): for each block `[x, y, rotation]`, the displacement of its centroid in that unit and its
/// rotation in radians, counter-clockwise. `conclusion` has what all rows
/// about the scene come to, the same in each of them: `difference` is how far λ_A is above the lowest
/// state, relative to that, and `explained` whether nothing but that is to be explained.
/// `in_short` is what the case comes to: the λ of the setting and side that governs, and in words what it
/// means. `tilt_degrees` is arctan λ where the live load is every weight sideways, `base_shear` what
/// the supports carry along x, in the direction of the push, and `base_shear_from_push` the part of it
/// that is λ times the live load, in the `unit_of_force` where the case says no weight; `first_blocks` and `first_joints` move fastest in the `mechanism`, of which `moving` has every
/// part: its `blocks`, what it does in `words`, and the `centre` that it turns about. `thrust` has the lines of
/// thrust of a row's forces, and the resultant on each stretch of level bed joints without a gap, as under
/// a pier: its ends, the force on what is above, and where it acts.
/// Where a support moves, `lower` and `upper` are of its reaction, and `reaction` has the one that it
/// starts with: λ in `sides` is the change from there, a fall where it `moves` away.
/// Where results are partial, a last object says so in `partial`, and its columns are `null`.
pub fn json(results: &[CaseResult], partial: Option<&Partial>) -> String {
    let of_case = |result: &'_ CaseResult| -> Vec<Json> {
        result.rows.iter().map(|row| object(result, row)).collect()
    };
    let rows = results.iter().flat_map(of_case);
    let list: Json = rows.chain(partial.map(mark)).collect();
    format!("{list:#}\n")
}

/// As `json`, a row a line, each with its `head_joints` and with the `sides` that it was pushed
/// to, the row's own side first: the scene and every answer of the method, in the formats of outside
/// programs and in full digits, so that another program can confirm each claim.
pub fn json_with_states(results: &[CaseResult], partial: Option<&Partial>) -> String {
    let mut lines = Vec::new();
    for result in results {
        for row in &result.rows {
            let mut object = object(result, row);
            object["head_joints"] = row.head_joints.name().into();
            let sides = row.sides().map(|(push, outcome)| {
                let mut side = side(push, outcome);
                side["scene"] = json!(SceneFile::from(result.side(row.head_joints, push)));
                side["answers"] = json!(answers(outcome));
                side
            });
            object["sides"] = sides.collect();
            lines.push(object.to_string());
        }
    }
    lines.extend(partial.map(|partial| mark(partial).to_string()));
    format!("[\n{}\n]\n", lines.join(",\n"))
}

/// The last object of partial results.
fn mark(partial: &Partial) -> Json {
    let mut object = json!({"partial": partial.to_string()});
    for column in for_programs() {
        object[column.name] = Json::Null;
    }
    object
}

fn digits(number: f64) -> Json {
    Value::Number(number).json()
}

/// A row with the columns for programs, its self-checks, its recording, and the conclusion from all
/// rows about its scene.
fn object(result: &CaseResult, row: &Row) -> Json {
    let evidence = &row.outcome.evidence;
    let checks: Json = evidence.checks().iter().map(ToString::to_string).collect();
    let mut object = json!({"checks": checks});
    for column in for_programs() {
        object[column.name] = (column.value)(row).json();
    }
    let observed = evidence.observed();
    if let Some(recording) = observed.and_then(|observed| observed.recording.as_ref()) {
        object["recording"] = json!({
            "interval": digits(recording.interval),
            "frames": recording.frames.iter().map(frame).collect::<Json>(),
        });
    }
    if let Some(reaction) = &row.reaction {
        object["reaction"] = json!({
            "support": reaction.support,
            "moves": reaction.sense.name(),
            "start": reaction.start,
            "limited": reaction.limited,
            "weight": digits(reaction.weight),
        });
    }
    if row.other.is_some() {
        object["sides"] = row
            .sides()
            .map(|(push, outcome)| side(push, outcome))
            .collect();
    }
    let mut conclusions = result.conclusions.iter();
    let of_row = conclusions.find(|conclusion| conclusion.head_joints == row.head_joints);
    object["conclusion"] = of_row.map(|of| conclusion(result, of)).into();
    let governing = Governing::of(result).map(|governing| governing.json());
    object["in_short"] = governing.into();
    if let Some((_, forces)) = evidence.forces() {
        object["thrust"] = way_of(&thrust(result.scene(row), forces));
    }
    object
}

/// Lines of thrust as lists of points, and resultants on level bed joints.
fn way_of(thrust: &Thrust) -> Json {
    let pair = |x: f64, y: f64| json!([digits(x), digits(y)]);
    let lines = thrust.lines.iter().map(|line| {
        let points = line.iter().map(|point| pair(point.x, point.y));
        points.collect::<Vec<_>>()
    });
    let courses = thrust.courses.iter().map(|of| {
        json!({
            "level": digits(of.level),
            "ends": of.ends.map(digits),
            "force": pair(of.force.x, of.force.y),
            "x": of.x.map(digits),
        })
    });
    json!({"lines": lines.collect::<Json>(), "courses": courses.collect::<Json>()})
}

/// The conclusion as data, and its line.
fn conclusion(result: &CaseResult, of: &Conclusion) -> Json {
    let terms = terms(result, of);
    let terms = terms.as_ref();
    let digits = |number: Option<f64>| Value::from(number).json();
    let difference = of.difference.as_ref();
    let (lower, upper) = of.range().unzip();
    let reaction = of.reaction.as_ref();
    let reads = |lambda: f64| reaction.map_or(lambda, |reaction| reaction.at(lambda));
    let doubts: Json = of.doubts.iter().map(ToString::to_string).collect();
    json!({
        "push": of.push.name(),
        "other_side": of.other.as_deref().map(|other| conclusion(result, other)),
        "basis": of.basis.name(),
        "methods": of.methods,
        "status": of.status.name(),
        "lower": digits(lower),
        "upper": digits(upper),
        "highest_state": digits(of.highest_state.map(reads)),
        "seen": of.seen.as_ref().map(|seen| {
            let (one, other) = (reads(seen.bracket.lower), reads(seen.bracket.upper));
            [one.min(other), one.max(other)].map(|end| digits(Some(end)))
        }),
        "associative": digits(difference.and_then(|difference| difference.associative).map(reads)),
        "difference": digits(difference.and_then(|difference| difference.relative)),
        "explanation": difference.map(|difference| difference.explanation.name()),
        "explained": of.is_explained(),
        "doubts": doubts,
        "line": of.to_string(),
        "tilt_degrees": digits(terms.and_then(|terms| terms.tilt)),
        "base_shear": terms.and_then(|terms| terms.base_shear),
        "base_shear_from_push": terms.and_then(|terms| terms.push_shear),
        "unit_of_force": terms.and_then(|terms| terms.unit_of_force),
        "mechanism": terms.and_then(|terms| terms.mechanism.clone()),
        "moving": terms.map(|terms| terms.moving.iter().map(part).collect::<Json>()),
        "first_blocks": terms.map(|terms| terms.first_blocks.clone()),
        "first_joints": terms.map(|terms| terms.first_joints.clone()),
        "cracks": terms.filter(|_| of.reaction.is_some()).map(|terms| {
            let cracks = terms.cracks.iter();
            cracks.map(|(joint, opening)| json!([joint, digits(Some(*opening))])).collect::<Json>()
        }),
    })
}

/// A part that moves: its blocks, what it does, and what it turns about.
fn part(of: &MovingPart) -> Json {
    let centre = of.centre.map(|at| [at.x, at.y].map(digits));
    json!({"blocks": of.blocks, "words": of.words, "centre": centre})
}

/// One side of the push: what its answer is worth, and its range in full digits.
fn side(push: Push, outcome: &Outcome) -> Json {
    let bracket = outcome.bracket();
    json!({
        "push": push.name(),
        "status": outcome.status.name(),
        "lower": bracket.map(|bracket| bracket.lower),
        "upper": bracket.map(|bracket| bracket.upper),
        "reason": outcome.reason(),
    })
}

fn frame(moved: &Mechanism) -> Json {
    let motions = moved.motions.iter();
    let numbers = motions.map(|&of| <[f64; 3]>::from(of));
    numbers.map(|numbers| json!(numbers.map(digits))).collect()
}
