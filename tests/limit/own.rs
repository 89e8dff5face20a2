//! What single courses, joints and blocks of a case have of their own. Analytic answers of single keys
//! stand in `cases/limits/`; here are relations between ways to write one scene.

use trilith::answer::Outcome;
use trilith::case::Case;
use trilith::method::{Method, Settings, methods};
use trilith::scene::{HeadJoints, Irregularity, Joint, Push, Scene};

fn read(text: &str) -> Case {
    Case::read("a.toml", text.as_bytes()).unwrap_or_else(|complaint| panic!("{complaint}\n{text}"))
}

fn method(name: &str) -> &'static dyn Method {
    let mut all = methods().into_iter();
    all.find(|method| method.name() == name).expect("a method")
}

fn solved(scene: &Scene, name: &str) -> Outcome {
    method(name).solve(scene, &Settings::default())
}

/// The multiplier of associative friction, which is proved to 1e-6.
#[track_caller]
fn lambda(scene: &Scene) -> f64 {
    let outcome = solved(scene, "associative");
    let bracket = outcome
        .bracket()
        .unwrap_or_else(|| panic!("{}", outcome.reason()));
    assert!(bracket.upper - bracket.lower <= 1e-6 * bracket.upper);
    bracket.lower
}

/// A wall of three courses of 3 × 1 units and these keys.
fn wall(keys: &str) -> Case {
    of_friction(0.6, keys)
}

fn of_friction(friction: f64, keys: &str) -> Case {
    read(&format!(
        "unit = {{ length = 3.0, height = 1.0, weight = 1.0 }}\ncourses = [\"111\", \"h11h\", \"111\"]\n\
         friction = {friction}\n{keys}\n"
    ))
}

/// All that a case can have of its own, in one wall.
const ALL: &str = "heights = [0.8, 1.3, 1.0]\noverburden = 0.5\nopen_head_joints = [1]\n\
                   live = { weight = [1, 0.25] }\n\
                   joints = [{ course = 1, friction = 0.5 }, { course = 2, friction = 0.35 },\n\
                   { between = [\"course 2 piece 2\", \"course 3 piece 2\"], friction = 0.2 },\n\
                   { between = [\"course 3 piece 1\", \"course 3 piece 2\"], open = true }]\n\
                   [[block]]\ncourse = 2\npiece = 1\nfriction = 0.1\nspecific_weight = 2.0";

fn written_as_blocks(case: &Case) -> Case {
    let files = case.as_blocks("blocks.csv");
    let beside = |_: &str| Ok(files.csv.clone().into_bytes());
    let read = Case::read_with("a.toml", files.toml.as_bytes(), &beside);
    read.unwrap_or_else(|complaint| panic!("{complaint}\n{}", files.toml))
}

/// As explicit blocks the same scene: every joint with its friction, those that are open left out.
#[test]
fn a_wall_of_its_own_kind_is_the_same_as_blocks() {
    let case = wall(ALL);
    let blocks = written_as_blocks(&case);
    for head_joints in [HeadJoints::Contact, HeadJoints::Open] {
        for push in [Push::Right, Push::Left] {
            let laid = case.pushed(head_joints, push).without_wall();
            assert_eq!(blocks.pushed(head_joints, push), laid);
        }
    }
}

/// The base of a wall whose ground moves is of several supports as blocks.
#[test]
fn the_friction_of_a_base_stays_where_the_ground_moves() {
    let case = wall(
        "joints = [{ course = 1, friction = 0.25 }]\n\
         [[move]]\nunits = \"2-2\"\ndirection = [0, -1]\nmoves = \"away\"",
    );
    let [wall, blocks] = [&case, &written_as_blocks(&case)].map(|case| {
        let scene = case.scene(HeadJoints::Contact);
        let frictions = scene.joints().iter().map(|joint| joint.friction);
        frictions.collect::<Vec<f64>>()
    });
    let rough = |all: &[f64]| all.iter().filter(|&&friction| friction == 0.25).count();
    assert_eq!(rough(&wall), 3);
    assert_eq!((rough(&blocks), blocks.len()), (3, wall.len()));
}

/// The joint that course `above` lies on, or the one between two blocks, by what it is.
fn friction_of<'a>(scene: &'a Scene, is: impl Fn(&Joint) -> bool + 'a) -> Vec<f64> {
    let joints = scene.joints().iter().filter(move |joint| is(joint));
    joints.map(|joint| joint.friction).collect()
}

/// A named joint goes before its course, a course before blocks, and of two blocks the smaller counts.
#[test]
fn what_is_nearer_goes_first() {
    let scene = wall(ALL).scene(HeadJoints::Contact);
    let name = |block: usize| scene.block_name(block);
    let on_base = friction_of(&scene, |joint| {
        joint.normal.y == 1.0 && joint.ends[0].y == 0.0
    });
    assert_eq!(on_base, [0.5; 3]);
    // Blocks 3 to 6 are course 2, the first of them of friction 0.1: its bed is the course's.
    let bed = friction_of(&scene, |joint| {
        (joint.ends[0].y - 0.8).abs() < 1e-9 && joint.normal.y > 0.5
    });
    assert_eq!(bed, [0.35; 6]);
    let above = |joint: &Joint| (joint.ends[0].y - 2.1).abs() < 1e-9 && joint.normal.y > 0.5;
    for joint in scene.joints().iter().filter(|joint| above(joint)) {
        let expected = match (name(joint.to).as_str(), joint.from) {
            ("course 3 piece 1", trilith::scene::Side::Block(3)) => 0.1,
            ("course 3 piece 2", trilith::scene::Side::Block(4)) => 0.2,
            _ => 0.6,
        };
        assert_eq!(joint.friction, expected, "{}", name(joint.to));
    }
    // Of seven head joints two of course 1 and one of course 3 are open.
    assert_eq!(scene.left_out(), 3);
}

/// Head joints that are open in every course are those of an open wall, and in some lie between.
#[test]
fn head_joints_open_by_course() {
    let wall = |keys: &str| {
        read(&format!(
            "unit = {{ length = 4.0, height = 1.75, weight = 1.0 }}\nrepeat = 3\n\
             courses = [\"h1111h\", \"11111\"]\nfriction = 0.65\n{keys}\n"
        ))
    };
    let contact = wall("").scene(HeadJoints::Contact);
    let open = wall("").scene(HeadJoints::Open);
    let all = wall("open_head_joints = [1, 2, 3, 4, 5, 6]").scene(HeadJoints::Contact);
    assert_eq!(all.joints(), open.joints());
    let some = lambda(&wall("open_head_joints = [5, 6]").scene(HeadJoints::Contact));
    assert!(lambda(&open) - 1e-7 < some && some < lambda(&contact) + 1e-7);
    // paper-1 by other code: 0.639969 and 0.642859.
    assert!((lambda(&all) - 0.639969).abs() < 1e-6);
}

/// The overburden of a coursed wall is that of its blocks, where all of them are of one weight.
#[test]
fn overburden_on_blocks_is_that_of_the_wall() {
    for keys in [
        "",
        "heights = [0.8, 1.3, 1.0]",
        "live = { weight = [1, 0.3] }",
    ] {
        for ratio in [0.3, 2.0] {
            let laid = of_friction(3.0, &format!("overburden = {ratio}\n{keys}"));
            let bare = written_as_blocks(&of_friction(3.0, keys));
            let files = of_friction(3.0, keys).as_blocks("blocks.csv");
            let beside = |_: &str| Ok(files.csv.clone().into_bytes());
            let text = format!("overburden = {ratio}\n{}", files.toml);
            let blocks = Case::read_with("a.toml", text.as_bytes(), &beside).unwrap();
            for push in [Push::Right, Push::Left] {
                let [wall, blocks, bare] = [&laid, &blocks, &bare]
                    .map(|case| lambda(&case.pushed(HeadJoints::Contact, push)));
                assert!((wall - blocks).abs() < 1e-7, "{wall} {blocks}");
                assert!((wall - bare).abs() > 1e-3, "{wall} {bare}");
            }
        }
    }
}

/// What slides at λ where weights push sideways slides at λ / (1 + v λ) where v of them is lifted, and
/// the push to the left mirrors the sideways part alone. With the ground as it is: friction is cohesionless,
/// so this holds of every state and mechanism, as forces at rest only scale.
#[test]
fn lifted_weights_scale_every_multiplier() {
    for push in [Push::Right, Push::Left] {
        for lift in [0.3, -0.4] {
            let plain = lambda(&wall("overburden = 0.7").pushed(HeadJoints::Contact, push));
            let lifted = wall(&format!(
                "overburden = 0.7\nlive = {{ weight = [1, {lift}] }}"
            ));
            let found = lambda(&lifted.pushed(HeadJoints::Contact, push));
            let expected = plain / (1.0 + lift * plain);
            assert!((found - expected).abs() < 1e-6, "{found} {expected}");
        }
    }
}

/// The closed form declines each by its name, and takes heights that are all a unit's.
#[test]
fn the_closed_form_says_what_it_does_not_know() {
    let regular = |keys: &str| wall(keys).scene(HeadJoints::Contact).regular().cloned();
    assert!(regular("heights = [1.0, 1.0, 1.0]").is_ok());
    assert!(regular("open_head_joints = [2]").is_ok());
    for (keys, why) in [
        ("heights = [1.0, 1.2, 1.0]", Irregularity::Height(2)),
        (
            "live = { weight = [1, 0.1] }",
            Irregularity::PushedVertically,
        ),
        (
            "live = { weight = [1, -0.1] }",
            Irregularity::PushedVertically,
        ),
        ("live = { weight = [2, 0] }", Irregularity::OwnLoads),
        (
            "joints = [{ course = 2, friction = 0.3 }]",
            Irregularity::OwnFriction,
        ),
        (
            "[[block]]\ncourse = 1\npiece = 1\nfriction = 0.3",
            Irregularity::OwnFriction,
        ),
        (
            "[[block]]\ncourse = 1\npiece = 1\nspecific_weight = 0.3",
            Irregularity::OwnLoads,
        ),
    ] {
        assert_eq!(regular(keys), Err(why.clone()), "{keys}");
        let said = solved(&wall(keys).scene(HeadJoints::Contact), "macro-block").reason();
        assert!(said.contains(&why.to_string()), "{said}");
    }
}

/// The crack of courses of unequal height is measured with the whole height, and a large wall of them is
/// solved by the part that the crack can reach as well as whole.
#[test]
fn unequal_courses_crack_and_reduce() {
    let heights: Vec<f64> = (0..24).map(|row| [0.6, 1.5, 0.9][row % 3]).collect();
    let case = read(&format!(
        "unit = {{ length = 3.0, height = 1.0, weight = 1.0 }}\nbond = \"running\"\ncourses = 24\nunits = 14\n\
         friction = 0.75\nheights = {heights:?}\n"
    ));
    let scene = case.scene(HeadJoints::Open);
    let mut whole = Settings::default();
    whole.set("reduction", "false").expect("a setting");
    let [part, all] = [Settings::default(), whole].map(|settings| {
        let outcome = method("associative").solve(&scene, &settings);
        (
            outcome.bracket().expect("a multiplier"),
            outcome.work.modelled,
            outcome,
        )
    });
    assert!(
        part.1 < all.1 && all.1 == scene.blocks().len(),
        "{} {}",
        part.1,
        all.1
    );
    assert!((part.0.lower - all.0.lower).abs() < 1e-6);
    let crack = part.2.evidence.crack(&scene).expect("a crack");
    let (c, e) = (crack.c.unwrap(), crack.e.unwrap());
    let height: f64 = heights.iter().sum();
    assert!((crack.tan_beta - ((c + e) / 2.0 - 1.5) / height).abs() < 1e-12);
    assert!(1.5 < c && c <= e && e <= 42.0, "{c} {e}");
}
