//! Supports that move: what is seen is the state that is reached first, where it is the only one.

use crate::share::share;
use trilith::answer::{Bracket, Status};
use trilith::case::Case;
use trilith::method::{Settings, methods};
use trilith::run::{Row, answer};
use trilith::scene::HeadJoints;

/// Courses from below, the units of the lowest that sink or are raised, and friction: plain walls and
/// walls with openings.
const WALLS: [(&[&str], &str, f64); 10] = [
    (&["1111", "h111h", "1111", "h111h"], "3-4", 0.65),
    (&["11111", "h1111h", "11111", "h1111h"], "4-5", 0.65),
    (&["111111", "h11111h", "111111", "h11111h"], "1-2", 0.6),
    (&["11111", "h1111h", "11111", "h1111h"], "3", 0.7),
    (
        &["11gg11", "h1hggh1h", "11gg11", "1hLh1", "111111"],
        "5-6",
        0.65,
    ),
    (
        &["111111", "h11111h", "11gg11", "h1hggh1h", "1hLh1", "111111"],
        "5-6",
        0.7,
    ),
    (
        &[
            "111111111",
            "h11111111h",
            "11gg1gg11",
            "h1hgghhggh1h",
            "1hLLh1",
            "111111111",
        ],
        "7-9",
        0.65,
    ),
    (
        &["111111", "h11111h", "111111", "h11111h", "111111"],
        "1-3",
        0.65,
    ),
    (
        &["1111111111", "h111111111h", "1111111111", "h111111111h"],
        "8-10",
        0.5,
    ),
    (&["111", "h11h", "111", "h11h", "111", "h11h"], "3", 0.75),
];

fn text(courses: &[&str], units: &str, friction: f64, moves: &str) -> String {
    format!(
        "unit = {{ length = 4, height = 2, weight = 1 }}\npieces = {{ L = {{ units = 3 }} }}\ncourses = \
         {courses:?}\nfriction = {friction}\n[[move]]\nunits = \"{units}\"\ndirection = [0, -1]\n{moves}\n"
    )
}

fn solved(case: &Case, head_joints: HeadJoints, method: &str) -> Row {
    let methods = methods();
    let method = methods.iter().find(|known| known.name() == method);
    let sides = case.sides(head_joints);
    answer(&sides, *method.expect("its name"), Settings::default())
}

/// What it reads as a change of the reaction: larger is later, whichever way the support moves.
fn change(row: &Row) -> Option<Bracket> {
    row.sides()
        .next()
        .and_then(|(_, outcome)| outcome.bracket())
}

/// What a scene's pushover is beside its states.
enum Seen {
    Refused,
    Unique,
    AmongStates,
}

/// No state is later than associative friction allows; where the search finds one state alone, or else no other
/// can be, what is seen is that state, to the error that is stated. In contact, where there are several, what is seen is no later
/// than associative friction allows either.
fn compared(text: &str, head_joints: HeadJoints, by_search: bool) -> Seen {
    let case = Case::read("a.toml", text.as_bytes()).unwrap_or_else(|e| panic!("{e}"));
    let [most, states, seen] =
        ["associative", "interval", "pushover"].map(|method| solved(&case, head_joints, method));
    let most_change = change(&most).expect("it gives way").upper;
    let of_states = change(&states).expect("a state is found");
    let name = format!("{text}{}", head_joints.name());
    assert_eq!(states.status(), Status::Verified, "{name}");
    assert!(of_states.upper <= most_change * (1.0 + 1e-6), "{name}");
    let (_, outcome) = seen.sides().next().expect("it ran");
    let (Some(found), Some(error)) = (change(&seen), outcome.evidence.stated_error()) else {
        return Seen::Refused;
    };
    println!("{name}: {found:?} ± {error} for {of_states:?}, at most {most_change}");
    assert!(found.lower <= found.upper, "{name}");
    assert!(found.lower <= most_change * (1.0 + error), "{name}");
    assert!(found.upper >= of_states.lower * (1.0 - error), "{name}");
    let is_one = of_states.upper - of_states.lower < 1e-6 * of_states.upper;
    if !(is_one && (by_search || most_change < of_states.lower * (1.0 + 1e-5))) {
        return Seen::AmongStates;
    }
    assert!(found.lower <= of_states.upper * (1.0 + error), "{name}");
    Seen::Unique
}

/// How many of the ten walls, both ways, have one state, and how many are refused.
fn counted(moves: &str, head_joints: &[HeadJoints], by_search: bool) -> [usize; 2] {
    let (mut unique, mut refused) = (0, 0);
    for &(courses, units, friction) in &WALLS[..share(WALLS.len())] {
        for sense in ["away", "against"] {
            let moves = format!("moves = \"{sense}\"\n{moves}");
            let text = text(courses, units, friction, &moves);
            for &head_joints in head_joints {
                match compared(&text, head_joints, by_search) {
                    Seen::Refused => refused += 1,
                    Seen::Unique => unique += 1,
                    Seen::AmongStates => {}
                }
            }
        }
    }
    println!("{unique} with one state, {refused} refused");
    [unique, refused]
}

#[test]
#[ignore = "forty pushovers: in release"]
fn walls_give_way_where_the_states_are() {
    let [unique, refused] = counted("", &[HeadJoints::Open, HeadJoints::Contact], true);
    assert!(
        unique >= share(15) && refused <= share(2),
        "{unique} {refused}"
    );
}

/// The same on ground that turns about the left toe. Four of these have a later state that the search does not find,
/// at the associative reaction, and that is what is seen.
#[test]
#[ignore = "twenty pushovers: in release"]
fn walls_on_ground_that_turns_give_way_where_the_states_are() {
    let [unique, refused] = counted("about = [0, 0]", &[HeadJoints::Open], false);
    assert!(
        unique >= share(10) && refused <= share(2),
        "{unique} {refused}"
    );
}

/// Two props that sink alike under a beam, the outer one bearing all at the end: 2 W / 5 by moments
/// about the edge of what stays.
#[test]
fn supports_that_sink_as_one_are_seen_to() {
    let prop = |name: &str, left: f64| {
        let right = left + 1.0;
        format!(
            "[[support]]\nname = \"{name}\"\ncorners = [[{left}, 0], [{right}, 0], [{right}, 1], [{left}, \
             1]]\n"
        )
    };
    let sinks = |name: &str| {
        format!("[[move]]\nsupport = \"{name}\"\ndirection = [0, -1]\nmoves = \"away\"\n")
    };
    let text = format!(
        "friction = 0.6\n[blocks]\n[[block]]\nname = \"beam\"\ncorners = [[0, 1], [6, 1], [6, 2], [0, \
         2]]\nweight = 1.0\n{}{}{}{}{}",
        prop("left", 0.0),
        prop("middle", 2.5),
        prop("right", 5.0),
        sinks("right"),
        sinks("middle"),
    );
    let case = Case::read("a.toml", text.as_bytes()).unwrap_or_else(|e| panic!("{e}"));
    let row = solved(&case, HeadJoints::Contact, "pushover");
    let (found, error) = row.bracket().zip(row.stated_error()).expect("it is seen");
    let slack = 0.4 * error;
    assert!(
        found.lower - slack <= 0.4 && 0.4 <= found.upper + slack,
        "{found:?}"
    );
}

/// The right one of two props under a beam of length 6 turns about a point at their tops, so that nothing slips. The
/// beam turns about an edge of the left prop, (1, 1) where the right one sinks and (0, 1) where it is raised, and
/// touches it with the edge at x = 5 or 6 at which it moves as little as it may, or as much as it must: the reaction
/// does the work of the weight.
#[test]
fn a_support_that_turns_is_seen_to() {
    let prop = |name: &str, left: f64| {
        let right = left + 1.0;
        format!(
            "[[support]]\nname = \"{name}\"\ncorners = [[{left}, 0], [{right}, 0], [{right}, 1], [{left}, \
             1]]\n"
        )
    };
    let mut sharp = 0;
    for pin in [-2.0f64, 1.0, 3.0, 9.0] {
        for (moves, edge) in [("away", 1.0), ("against", 0.0)] {
            let text = format!(
                "friction = 0.6\n[blocks]\n[[block]]\nname = \"beam\"\ncorners = [[0, 1], [6, 1], [6, 2], \
                 [0, 2]]\nweight = 1.0\n{}{}[[move]]\nsupport = \"right\"\ndirection = [0, -1]\nabout = \
                 [{pin}, 1]\nmoves = \"{moves}\"\n",
                prop("left", 0.0),
                prop("right", 5.0),
            );
            let [one, other] = [5.0, 6.0].map(|x: f64| (x - pin).abs() / (x - edge));
            let turned = match moves {
                "away" => one.min(other),
                _ => one.max(other),
            };
            let reaction = turned * (3.0 - edge) / (5.5 - pin).hypot(0.5);
            let case = Case::read("a.toml", text.as_bytes()).unwrap_or_else(|e| panic!("{e}"));
            let proved = solved(&case, HeadJoints::Contact, "associative");
            let bracket = proved.bracket().expect("it gives way");
            let off = (bracket.lower - reaction).abs();
            assert!(off < 1e-5, "{text}{reaction}: {bracket:?}");
            let row = solved(&case, HeadJoints::Contact, "pushover");
            let seen = row.bracket().zip(row.stated_error());
            let (found, error) = seen.unwrap_or_else(|| panic!("{text}{}", row.reason()));
            let slack = reaction * error;
            assert!(
                found.lower - slack <= reaction && reaction <= found.upper + slack,
                "{text}{reaction}: {found:?} ± {error}"
            );
            sharp += usize::from(found.upper - found.lower < 5e-3 * reaction);
        }
    }
    // Two say that blocks slide away before, and how far.
    assert!(sharp >= 6, "{sharp}");
}
