//! Supports that move, against elementary statics: the reaction at which they give way.

use trilith::answer::{Certificate, Status};
use trilith::case::{self, Case};
use trilith::inside::{Refusal, prove};
use trilith::method::{Settings, methods};
use trilith::run::{Row, answer};
use trilith::scene::{HeadJoints, Scene};

/// The answer of a method for a case in this text.
fn solved(text: &str, method: &str) -> Row {
    let case = Case::read("a.toml", text.as_bytes()).unwrap_or_else(|e| panic!("{e}"));
    let methods = methods();
    let method = methods.iter().find(|known| known.name() == method);
    let sides = case.sides(HeadJoints::Contact);
    answer(&sides, *method.expect("its name"), Settings::default())
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
    gives_way_at(&format!("{BEAM}about = [1, 1]\n"), reaction);
}

/// compas_pr2d's arch of 12 trapezoids (rise 4, span 10, thickness 0.5) that act at the mean of their corners,
/// or else at their centroids; the left springing moves along its joint's normal. The weight is 1.
fn arch_of_trapezoids(friction: f64, mean: bool, moves: &str) -> String {
    let (radius, low): (f64, f64) = (5.125, -1.125);
    let at = |joint: usize, radius: f64| {
        let half = (5.0 / 5.125f64).asin();
        let angle = half * (1.0 - joint as f64 / 6.0);
        [radius * angle.sin(), low + radius * angle.cos()]
    };
    let [inner, outer] = [at(12, radius), at(12, radius + 0.5)];
    let along = [2.0 * (outer[0] - inner[0]), 2.0 * (outer[1] - inner[1])];
    let away = [along[1], -along[0]].map(|part| -part);
    let beyond = |[x, y]: [f64; 2], by: [f64; 2]| [x + by[0], y + by[1]];
    let ground = |name: &str, corners: [[f64; 2]; 4]| {
        format!("[[support]]\nname = \"{name}\"\ncorners = {corners:?}\n")
    };
    let mut text = format!("friction = {friction}\n[blocks]\n");
    for joint in 0..12 {
        let corners = [
            at(joint, radius),
            at(joint, radius + 0.5),
            at(joint + 1, radius + 0.5),
            at(joint + 1, radius),
        ];
        let middle = [0, 1].map(|k| corners.iter().map(|corner| corner[k]).sum::<f64>() / 4.0);
        text += &format!(
            "[[block]]\nname = \"v{joint}\"\nweight = {}\ncorners = {corners:?}\n",
            1.0 / 12.0
        );
        text += &match mean {
            true => format!("centre = {middle:?}\n"),
            false => String::new(),
        };
    }
    let mirrored = |[x, y]: [f64; 2]| [-x, y];
    let left = [inner, outer, beyond(outer, away), beyond(inner, away)];
    let right = [left[3], left[2], left[1], left[0]].map(mirrored);
    text += &(ground("left", left) + &ground("right", right));
    text + &format!("[[move]]\nsupport = \"left\"\ndirection = {away:?}\nmoves = \"{moves}\"\n")
}

/// Values of science.md, section 10, by another form of the problem: power for 0.4 of motion and weights of 9.81.
/// The first is the notebook's own, 26.159042627806343.
#[test]
fn the_arch_of_compas_pr2d_gives_way_as_by_others() {
    for (friction, mean, moves, power) in [
        (0.3, true, "against", 26.159_042_628),
        (3.0, true, "against", 26.160_520_922),
        (0.3, false, "against", 26.156_295),
        (0.3, true, "away", 25.150_463),
    ] {
        let reaction = power / 0.4 / (12.0 * 9.81);
        gives_way_at(&arch_of_trapezoids(friction, mean, moves), reaction);
    }
}

/// What `bound` proves and the scene that it is about.
fn certified(text: &str) -> (Scene, Row, Certificate) {
    let case = Case::read("a.toml", text.as_bytes()).unwrap_or_else(|e| panic!("{e}"));
    let row = solved(text, "bound");
    let (_, outcome) = row.sides().next().expect("it ran");
    let certificate = outcome.evidence.certificate();
    let certificate = certificate.unwrap_or_else(|| panic!("{text}{}", row.reason()));
    let certificate = Certificate::clone(certificate);
    (case.scene(HeadJoints::Contact), row, certificate)
}

const TWO: &str =
    "[[move]]\nsupport = \"left\"\ndirection = [-1, -1]\nrate = 0.3\nmoves = \"away\"\n";

/// Supports that sink, rise, turn and move as one are proved to give way no earlier than where states are found.
#[test]
fn no_state_of_a_support_that_moves_lies_before_what_is_proved() {
    let turns = format!("{BEAM}about = [1, 1]\n");
    let two = format!("{BEAM}{TWO}");
    let arch = |moves| arch_of_trapezoids(0.3, true, moves);
    let texts = [BEAM.into(), turns, two, arch("away"), arch("against")];
    let raised = texts[..3]
        .iter()
        .map(|text| text.replace("away", "against"));
    for text in texts.iter().cloned().chain(raised) {
        let (scene, row, certificate) = certified(&text);
        let proved = prove(&scene, &certificate).unwrap_or_else(|e| panic!("{e}"));
        let found = row.bracket().expect("it gives way");
        assert_eq!(row.status(), Status::Verified, "{text}{found:?}");
        let states = solved(&text, "interval");
        let (_, outcome) = states.sides().next().expect("it ran");
        let first = outcome.bracket().expect("it gives way").lower;
        assert!(
            proved.lower <= first && first - proved.lower < 1e-5,
            "{text}"
        );
    }
}

/// Neither another motion of the support nor another number is what was proved.
#[test]
fn a_changed_certificate_of_a_support_proves_nothing() {
    let (scene, _, certificate) = certified(BEAM);
    let refused = |change: &dyn Fn(&mut Certificate)| {
        let mut changed = certificate.clone();
        change(&mut changed);
        prove(&scene, &changed).expect_err("it is changed")
    };
    let less = |refusal| matches!(refusal, Refusal::Less { .. });
    let support = scene.blocks().len() - 1;
    // The last row of equilibrium is the support's own.
    let row = certificate.slices[0].balance.len() / (3 * support + 1) * 3 * support;
    assert!(less(refused(&|c| c.slices[0].balance[row] += 1.0)));
    assert!(less(refused(&|c| c.slices[0].sigma += 1.0)));
    assert!(less(refused(&|c| c.lower *= 1.001)));
    assert!(matches!(
        refused(&|c| c.opening.iter_mut().for_each(|v| *v = -*v)),
        Refusal::Locks { .. }
    ));
    assert_eq!(refused(&|c| c.opening.push(0.0)), Refusal::Size);
    for other in [
        BEAM.replace("away", "against"),
        BEAM.replace("[0, -1]", "[0.1, -1]"),
        format!("{BEAM}about = [1, 1]\n"),
        format!("{BEAM}pushed = 0.1\n"),
        format!("{BEAM}{TWO}"),
    ] {
        let (other, _, own) = certified(&other);
        assert_eq!(prove(&other, &certificate), Err(Refusal::OtherScene));
        let mut stolen = certificate.clone();
        stolen.scene.clone_from(&own.scene);
        let proved = prove(&other, &stolen);
        assert!(proved.is_err(), "{proved:?}");
    }
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
    let row = answer(&sides, methods[1], Settings::default());
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
