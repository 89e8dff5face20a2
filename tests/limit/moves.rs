//! Supports that move, against elementary statics: the reaction at which they give way.

use trilith::answer::Status;
use trilith::case::{self, Case};
use trilith::method::{Settings, methods};
use trilith::run::{Row, answer};
use trilith::scene::HeadJoints;

/// The answer of a method for a case in this text.
fn solved(text: &str, method: &str) -> Row {
    let case = Case::read("a.toml", text.as_bytes()).unwrap_or_else(|e| panic!("{e}"));
    let methods = methods();
    let method = methods.iter().find(|known| known.name() == method);
    let sides = case.sides(HeadJoints::Contact);
    answer(&sides, method.expect("its name"), Settings::default())
}

/// Both methods that prove something find this reaction, to a part of the weight, which is 1.
#[track_caller]
fn gives_way_at(text: &str, reaction: f64) {
    for method in ["associative", "interval"] {
        let row = solved(text, method);
        assert_eq!(row.status(), Status::Verified, "{method}: {}", row.reason());
        let found = row.bracket().expect("verified");
        let off = (found.lower - reaction)
            .abs()
            .max((found.upper - reaction).abs());
        assert!(off < 3e-6, "{method}: {found:?} for {reaction}");
    }
}

const BEAM: &str = "friction = 0.6
[blocks]
[[block]]
name = \"beam\"
corners = [[0, 1], [4, 1], [4, 2], [0, 2]]
weight = 1.0
[[support]]
name = \"left\"
corners = [[0, 0], [1, 0], [1, 1], [0, 1]]
[[support]]
name = \"right\"
corners = [[3, 0], [4, 0], [4, 1], [3, 1]]
[[move]]
support = \"right\"
direction = [0, -1]
moves = \"away\"
";

/// Moments about the edge at (1, 1): the push of 0.1 W half a length above it adds to the weight's.
#[test]
fn a_push_may_act_all_the_while() {
    gives_way_at(BEAM, 1.0 / 3.0);
    gives_way_at(&format!("{BEAM}pushed = 0.1\n"), 1.05 / 3.0);
}

/// Beam and support turn as one about the edge at (1, 1): the weight sinks by its arm of 1, and the
/// support's middle by √(2.5² + 0.5²).
#[test]
fn a_support_may_turn() {
    let reaction = 1.0 / (2.5f64.powi(2) + 0.25).sqrt();
    let turning = format!("{BEAM}about = [1, 1]\n");
    gives_way_at(&turning, reaction);
    let pushover = solved(&turning, "pushover");
    assert_eq!(pushover.status(), Status::NotApplicable);
    assert!(
        pushover.reason().contains("none that turns"),
        "{}",
        pushover.reason()
    );
}

/// Of two props that sink alike the outer one bears all: moments about the edge at (1, 1), 2 W / 5.
#[test]
fn two_supports_move_as_one() {
    let beam = BEAM.replace("[4, 1], [4, 2]", "[6, 1], [6, 2]");
    let right = "corners = [[3, 0], [4, 0], [4, 1], [3, 1]]";
    let props = "corners = [[5, 0], [6, 0], [6, 1], [5, 1]]\n[[support]]\nname = \"middle\"\n\
                 corners = [[2.5, 0], [3.5, 0], [3.5, 1], [2.5, 1]]";
    let again = "[[move]]\nsupport = \"middle\"\ndirection = [0, -1]\nmoves = \"away\"\n";
    gives_way_at(&format!("{}{again}", beam.replace(right, props)), 0.4);
}

/// A slope flatter than the angle of friction holds the wedge, so that nothing is left of the wall's
/// reaction; by friction alone it stands at any larger one, within W tan(β + φ) / (1 − μ tan(β + φ)).
#[test]
fn a_wedge_that_rests_by_friction_needs_no_wall() {
    let wedge = "friction = 0.3
[blocks]
[[block]]
name = \"wedge\"
corners = [[0, 0], [10, 2], [0, 2]]
weight = 1.0
[[support]]
name = \"slope\"
corners = [[0, 0], [5, -2], [11, -2], [11, 2], [10, 2]]
[[support]]
name = \"wall\"
corners = [[-1, 0], [0, 0], [0, 2], [-1, 2]]
[[move]]
support = \"wall\"
direction = [-1, 0]
moves = \"away\"
";
    gives_way_at(wedge, 0.0);
    let steep = (0.2f64.atan() + 0.3f64.atan()).tan();
    let pushed = steep / (1.0 - 0.3 * steep);
    gives_way_at(&wedge.replace("away", "against"), pushed);
}

/// The bound is what the reaction of every state stays on one side of, and `lower` is never above
/// `upper`, whichever way the support moves.
#[test]
fn forces_and_mechanism_swap_their_roles() {
    let wall = |moves: &str| {
        format!(
            "unit = {{ length = 2, height = 1, weight = 1 }}\ncourses = [\"111\", \"h11h\", \"111\", \
             \"h11h\"]\nfriction = 0.7\n[[move]]\nunits = \"3\"\ndirection = [0, -1]\nmoves = \"{moves}\"\n"
        )
    };
    for (moves, sign) in [("away", -1.0), ("against", 1.0)] {
        let text = wall(moves);
        let [most, states] = ["associative", "interval"].map(|method| {
            let ends = solved(&text, method).bracket().expect("it gives way");
            assert!(ends.lower <= ends.upper + 1e-9, "{moves}: {ends:?}");
            ends
        });
        let beyond = [states.lower, states.upper].map(|state| sign * (state - most.upper));
        assert!(
            beyond.iter().all(|&beyond| beyond < 1e-5),
            "{moves}: {beyond:?}"
        );
    }
}

/// Nothing of a scene that no support moves in changes, and the answer speaks of no reaction.
#[test]
fn a_case_without_a_move_has_no_reaction() {
    let case = case::find("block-slender")
        .expect("it is built in")
        .remove(0);
    let sides = case.sides(HeadJoints::Contact);
    let methods = methods();
    let row = answer(&sides, &methods[1], Settings::default());
    assert!(row.reaction.is_none());
    assert!(!row.reason().contains("reaction"));
}

/// Between two fixed supports any thrust holds a block: no largest one is known, and what λ = 0 stands for
/// is no reaction that a reader should take for one.
#[test]
fn a_reaction_without_a_limit_is_said_to_have_none() {
    let clamped = "friction = 0.5
[[block]]
name = \"b\"
weight = 1.0
corners = [[0, 0], [1, 0], [1, 1], [0, 1]]
[[support]]
name = \"ground\"
corners = [[-1, -1], [2, -1], [2, 0], [-1, 0]]
[[support]]
name = \"left\"
corners = [[-1, 0], [0, 0], [0, 1], [-1, 1]]
[[support]]
name = \"right\"
corners = [[1, 0], [2, 0], [2, 1], [1, 1]]
[[move]]
support = \"right\"
direction = [1, 0]
moves = \"away\"
";
    for (text, limited) in [(BEAM, true), (clamped, false)] {
        let row = solved(text, "associative");
        let reaction = row.reaction.as_ref().expect("a support moves");
        assert_eq!(reaction.limited, limited, "{reaction:?}");
    }
    gives_way_at(clamped, 0.0);
}
