//! Blocks of any simple shape: bent inwards, curved, with corners on straight edges.

use std::f64::consts::PI;
use std::fmt::Write;

use trilith::answer::Outcome;
use trilith::case::Case;
use trilith::inside::Layout;
use trilith::inside::case_table;
use trilith::inside::thrust;
use trilith::method::{Settings, methods};
use trilith::run::{CaseResult, Plan, run};
use trilith::scene::HeadJoints;

fn read(toml: &str, csv: &str) -> Case {
    let beside = |_: &str| Ok(csv.as_bytes().to_vec());
    let case = Case::read_with("a.toml", toml.as_bytes(), &beside);
    case.unwrap_or_else(|complaint| panic!("{complaint}"))
}

fn result(case: &Case, names: &[&str]) -> CaseResult {
    let wanted = methods()
        .into_iter()
        .filter(|method| names.contains(&method.name()));
    let plan = Plan {
        methods: wanted.collect(),
        settings: Settings::default(),
        head_joints: None,
    };
    run(std::slice::from_ref(case), &plan, &|_| {}).remove(0)
}

fn answer(case: &Case, method: &str) -> Outcome {
    result(case, &[method]).rows.remove(0).outcome
}

#[track_caller]
fn lambda(case: &Case) -> f64 {
    let bracket = answer(case, "associative").bracket();
    bracket.expect("there is a multiplier").lower
}

/// A block on the ground, from `corners`.
fn alone(corners: &str, push: &str) -> Case {
    let text = format!(
        "friction = 1.5\npush = \"{push}\"\n[[support]]\nname = \"ground\"\n\
         corners = [[-9, -1], [9, -1], [9, 0], [-9, 0]]\n[[block]]\nname = \"A\"\ncorners = {corners}\n"
    );
    read(&text, "")
}

const L: &str = "[[0, 0], [2, 0], [2, 1], [1, 1], [1, 3], [0, 3]]";

/// An L of two rectangles has its centroid at (0.75, 1.25): it rocks at 1.25 / 1.25 to the right and at
/// 0.75 / 1.25 to the left, and the pushover says so too, within 0.1 %.
#[test]
fn an_l_rocks_about_its_toe() {
    for (push, expected) in [("right", 1.0), ("left", 0.6)] {
        let case = alone(L, push);
        assert!((lambda(&case) - expected).abs() < 1e-9, "{push}");
        let seen = answer(&case, "pushover")
            .bracket()
            .expect("it is pushed over");
        assert!(
            (seen.lower - expected).abs() < 1e-3 * expected,
            "{push}: {seen:?}"
        );
        assert!(
            (seen.upper - expected).abs() < 1e-3 * expected,
            "{push}: {seen:?}"
        );
    }
}

/// Corners on straight edges change nothing: the scene is the same, to the last bit.
#[test]
fn corners_on_straight_edges_are_left_out() {
    let more =
        "[[0, 0], [0.5, 0], [2, 0], [2, 0.25], [2, 1], [1, 1], [1, 2], [1, 3], [0, 3], [0, 1]]";
    let scene = |corners| alone(corners, "right").scene(HeadJoints::Contact);
    assert_eq!(scene(more), scene(L));
}

/// A stone on the step of another: two stones of one height, and one of them an L around the other,
/// carry the stone above as two plain ones do.
#[test]
fn an_l_and_a_filling_stone_meet_along_both_edges() {
    let text = format!(
        "friction = 0.65\n[[support]]\nname = \"ground\"\n\
         corners = [[-9, -1], [9, -1], [9, 0], [-9, 0]]\n[[block]]\nname = \"L\"\ncorners = {L}\n\
         [[block]]\nname = \"filling\"\ncorners = [[1, 1], [2, 1], [2, 3], [1, 3]]\n\
         [[block]]\nname = \"top\"\ncorners = [[0, 3], [2, 3], [2, 4], [0, 4]]\n"
    );
    let scene = read(&text, "").scene(HeadJoints::Contact);
    let lengths: f64 = scene.joints().iter().map(|joint| joint.length()).sum();
    // Base 2, step 1, upright 2, above 1 and 1.
    assert_eq!(scene.joints().len(), 5);
    assert!((lengths - 7.0).abs() < 1e-12, "{lengths}");
}

/// A small stone on the step of a tall L lies lower than the L's centroid: what it weighs comes down on
/// the L all the same, and it stands.
#[test]
fn a_low_stone_on_a_tall_l_stands() {
    let text = "friction = 0.65\n[[support]]\nname = \"ground\"\n\
                corners = [[-9, -1], [9, -1], [9, 0], [-9, 0]]\n[[block]]\nname = \"L\"\n\
                corners = [[0, 0], [2, 0], [2, 1], [1, 1], [1, 6], [0, 6]]\n[[block]]\nname = \"stone\"\n\
                corners = [[1, 1], [2, 1], [2, 1.5], [1, 1.5]]\nweight = 3.0\n";
    let case = read(text, "");
    // As one body about (2, 0): (2 · 0.5 + 5 · 3.5 ... ) by moments of its three rectangles.
    let (weights, x, y) = ([2.0, 5.0, 3.0], [1.0, 0.5, 1.5], [0.5, 3.5, 1.25]);
    let arm = |at: [f64; 3], toe: f64| -> f64 {
        weights
            .iter()
            .zip(at)
            .map(|(w, at)| w * (toe - at).abs())
            .sum()
    };
    let expected = arm(x, 2.0) / arm(y, 0.0);
    let found = lambda(&case);
    assert!((found - expected).abs() < 1e-9, "{found} {expected}");
}

/// A semicircle of voussoirs; with `chords`, their curved sides as so many. The outlines of one chord
/// carry the weights and centres of the others.
fn arch(chords: usize) -> [Case; 2] {
    const VOUSSOIRS: usize = 9;
    let on = |radius: f64, angle: f64| (radius * angle.cos(), radius * angle.sin());
    let angle = |k: f64| PI - PI * k / VOUSSOIRS as f64;
    let outline = |k: usize, chords: usize| {
        let at = |i: usize| angle(k as f64 + i as f64 / chords as f64);
        let inner = (0..=chords).map(|i| on(9.25, at(i)));
        let outer = (0..=chords).rev().map(|i| on(10.75, at(i)));
        inner.chain(outer).collect::<Vec<_>>()
    };
    let toml = |extra: &str| {
        format!(
            "friction = 1.2\n[blocks]\ncsv = \"a.csv\"\nsupports = [\"left\", \"right\"]\n{extra}"
        )
    };
    let csv = |chords: usize| {
        let mut text = String::from("block,x,y\n");
        let mut rows = |name: &str, corners: Vec<(f64, f64)>| {
            for (x, y) in corners {
                let _ = writeln!(text, "{name},{x:?},{y:?}");
            }
        };
        (0..VOUSSOIRS).for_each(|k| rows(&format!("v{k}"), outline(k, chords)));
        rows(
            "left",
            vec![(-12.0, -1.0), (-8.0, -1.0), (-8.0, 0.0), (-12.0, 0.0)],
        );
        rows(
            "right",
            vec![(8.0, -1.0), (12.0, -1.0), (12.0, 0.0), (8.0, 0.0)],
        );
        text
    };
    let curved = read(&toml(""), &csv(chords));
    let mut own = String::new();
    for (k, block) in curved
        .scene(HeadJoints::Contact)
        .blocks()
        .iter()
        .enumerate()
    {
        let (centre, weight) = (block.shape.centroid(), block.shape.area());
        let _ = writeln!(
            own,
            "[[block]]\nname = \"v{k}\"\nweight = {weight:?}\ncentre = [{:?}, {:?}]",
            centre.x, centre.y
        );
    }
    let straight = read(&toml(&own), &csv(1));
    [curved, straight]
}

/// Voussoirs whose intrados bends inwards along 20 chords: λ_A of the straight ones of the same weights
/// to 1e-9.
#[test]
fn curved_voussoirs_are_as_strong_as_straight_ones_of_the_same_weights() {
    let [curved, straight] = arch(20).map(|case| lambda(&case));
    assert!(
        (curved - straight).abs() < 1e-9 * straight,
        "{curved} {straight}"
    );
}

/// The pushover sees convex pieces of them, and the same multiplier within 0.5 %.
#[test]
#[ignore = "two pushovers of an arch, one of 180 pieces"]
fn curved_voussoirs_are_pushed_over_as_straight_ones() {
    let [curved, straight] = arch(20);
    let expected = lambda(&curved);
    for case in [curved, straight] {
        let seen = answer(&case, "pushover");
        let bracket = seen
            .bracket()
            .unwrap_or_else(|| panic!("{}", seen.reason()));
        for end in [bracket.lower, bracket.upper] {
            assert!(
                (end - expected).abs() < 5e-3 * expected,
                "{bracket:?} {expected}"
            );
        }
    }
}

/// Forces through an arch of a few voussoirs run in one line, inside the ring; through a pier level by
/// level, weight and push adding up from the top.
#[test]
fn thrust_runs_inside_the_arch_and_adds_up_in_a_pier() {
    let [arch, _] = arch(1);
    let outcome = answer(&arch, "associative");
    let scene = arch.scene(HeadJoints::Contact);
    let line = thrust(
        &scene,
        outcome.evidence.forces().expect("forces prove it").1,
    )
    .lines;
    assert_eq!(line.len(), 1);
    // One point a joint.
    assert_eq!(line[0].len(), 10);
    for point in &line[0] {
        assert!(
            (9.25 - 1e-6..=10.75 + 1e-6).contains(&point.coords.norm()),
            "{point}"
        );
    }
    let pier = read(
        "friction = 0.65\nunit = { length = 1.0, height = 1.0, weight = 3.0 }\ncourses = \"1\"\nrepeat = 4\n",
        "",
    );
    let outcome = answer(&pier, "associative");
    let lambda = outcome.bracket().expect("it rocks").lower;
    let scene = pier.scene(HeadJoints::Contact);
    let way = thrust(
        &scene,
        outcome.evidence.forces().expect("forces prove it").1,
    );
    assert_eq!(way.courses.len(), 4);
    for (course, of) in way.courses.iter().enumerate() {
        let weight = 3.0 * (4 - course) as f64;
        assert!((of.level - course as f64).abs() < 1e-12);
        assert!((of.force.y - weight).abs() < 1e-6 * weight, "{of:?}");
        // On what is above, against the push.
        assert!(
            (of.force.x + lambda * weight).abs() < 1e-6 * weight,
            "{of:?}"
        );
    }
    // It rocks about its toe, where the resultant on the ground acts.
    assert!((way.courses[0].x.expect("it presses") - 1.0).abs() < 1e-6);
    assert_eq!(way.lines.len(), 1);
}

#[track_caller]
fn assert_says(case: &Case, words: &[&str]) {
    let table = case_table(&result(case, &["interval"]), Layout::default());
    for word in words {
        assert!(table.contains(word), "no `{word}` in\n{table}");
    }
}

/// What comes first says tilt, the answer base shear, mechanism and what moves first.
#[test]
fn answers_are_given_in_the_terms_of_engineers() {
    // A block of 2 x 1 on the ground slides at μ = 0.3: arctan 0.3 = 16.70 degrees.
    let block = |corners: &str| {
        let text = format!(
            "friction = 0.3\n[[support]]\nname = \"ground\"\n\
             corners = [[-9, -1], [9, -1], [9, 0], [-9, 0]]\n[[block]]\nname = \"A\"\n\
             corners = {corners}\n"
        );
        read(&text, "")
    };
    assert_says(
        &block("[[0, 0], [2, 0], [2, 1], [0, 1]]"),
        &[
            "the ground tilt by 16.6°",
            "base shear is 0.6",
            "the block slides to the right on the base",
            "A moves first",
        ],
    );
    // One of 1 x 5 rocks about (1, 0) at 0.2.
    assert_says(
        &block("[[0, 0], [1, 0], [1, 5], [0, 5]]"),
        &[
            "the ground tilt by 11.3°",
            "base shear is 1",
            "rocks about the toe at (1, 0), on the base",
        ],
    );
    // The upper half of a pier with a slippery bed slides on course 2.
    let pier = read(
        "friction = { bed = 0.1, base = 0.6 }\nunit = { length = 3.0, height = 1.0, weight = 1.0 }\n\
         courses = \"1\"\nrepeat = 2\nlive = \"loads\"\n[[load]]\nblock = \"course 2 piece 1\"\n\
         at = [1.5, 1.5]\nlive = [1.0, 0.0]\n",
        "",
    );
    assert_says(
        &pier,
        &[
            "the upper part, 1 of 2 blocks, slides to the right on course 1",
            "base shear is 0.1",
        ],
    );
    let table = case_table(&result(&pier, &["interval"]), Layout::default());
    assert!(!table.contains("tilt"), "the push is no tilt:\n{table}");
    let [arch, _] = arch(1);
    assert_says(&arch, &["4 hinges ("]);
}

const WALL: &str = "friction = 0.65\nunit = { length = 4.0, height = 1.75, weight = 1.0 }\n";

/// A weight, a name and loads by course and piece are those of the same blocks written out; and a
/// letter's weight is that of each of its pieces.
#[test]
fn blocks_of_courses_have_their_own_weights_names_and_loads() {
    let own = format!(
        "{WALL}pieces = {{ L = {{ units = 2, weight = 5.0 }}, D = {{ length = 4.0, gap = true }} }}\n\
         courses = [\"1D1\", \"h1*2h\", \"hLh\"]\n[[block]]\ncourse = 1\npiece = 3\n\
         name = \"jamb\"\nweight = 2.5\n[[load]]\nblock = \"jamb\"\nat = [10.0, 1.75]\n\
         dead = [0.0, -0.5]\nlive = [0.25, 0.0]\n"
    );
    let case = read(&own, "");
    let scene = case.scene(HeadJoints::Contact);
    let names = &scene.labels().blocks;
    assert_eq!(
        names[..2],
        ["course 1 piece 1".to_owned(), "jamb".to_owned()]
    );
    let weights: Vec<f64> = scene
        .blocks()
        .iter()
        .map(|block| -block.loads[0].dead.y)
        .collect();
    assert_eq!(weights, [1.0, 2.5, 0.5, 1.0, 1.0, 0.5, 0.5, 5.0, 0.5]);
    assert_eq!(scene.blocks()[1].loads[1].live.x, 0.25);
    assert!(scene.regular().is_err());
    let files = case.as_blocks("a.csv");
    let blocks = read(&files.toml, &files.csv);
    assert!((lambda(&case) - lambda(&blocks)).abs() < 1e-9);
}

/// Tables as people save them are one table.
#[test]
fn tables_are_read_however_they_are_saved() {
    let toml = "friction = 0.65\n[blocks]\ncsv = \"a.csv\"\nsupports = [\"ground\"]\n";
    let plain = "block,x,y\nground,-5,-1\nground,5,-1\nground,5,0\nground,-5,0\n\
                 A,0,0\nA,2.5,0\nA,2.5,1\nA,0,1\n";
    let expected = read(toml, plain).scene(HeadJoints::Contact);
    let commas = plain.replace('.', "#").replace(',', ";").replace('#', ",");
    let header_last = plain
        .lines()
        .map(|line| line.split(',').rev().collect::<Vec<_>>().join("\t"))
        .collect::<Vec<_>>()
        .join("\r\n");
    for csv in [
        commas.clone(),
        format!("\u{feff}sep=;\n{commas}\n;;\n"),
        header_last,
        plain.replace("block,x,y", " Block , X ,Y"),
        plain.replace("A,", "\"A\",").replace("2.5", "\"2,5\""),
    ] {
        let case = read(toml, &csv);
        assert_eq!(case.scene(HeadJoints::Contact), expected, "{csv}");
        assert_eq!(case.warnings, [], "{csv}");
    }
    let with_remark = plain.lines().map(|line| format!("{line},old\n"));
    let case = read(
        toml,
        &with_remark.collect::<String>().replace("y,old", "y,note"),
    );
    assert_eq!(case.scene(HeadJoints::Contact), expected);
    assert!(
        case.warnings[0]
            .to_string()
            .contains("columns that are not read: `note`")
    );
}

/// A wall of 300 by 300 blocks from a table: every joint is found. Its time is that of reading.
#[test]
#[ignore = "90000 blocks"]
fn ninety_thousand_blocks_are_read() {
    const SIDE: usize = 300;
    let mut csv = String::from("block,x,y\n");
    let mut body = |name: &str, x: f64, y: f64, wide: f64| {
        for (right, up) in [(0.0, 0.0), (wide, 0.0), (wide, 1.0), (0.0, 1.0)] {
            let _ = writeln!(csv, "{name},{},{}", x + right, y + up);
        }
    };
    body("ground", -10.0, -1.0, 320.0);
    for course in 0..SIDE {
        for piece in 0..SIDE {
            let x = piece as f64 + 0.5 * (course % 2) as f64;
            body(&format!("{course}-{piece}"), x, course as f64, 1.0);
        }
    }
    let toml = "friction = 0.65\n[blocks]\ncsv = \"a.csv\"\nsupports = [\"ground\"]\n";
    assert_eq!(
        read(toml, &csv).scene(HeadJoints::Contact).joints().len(),
        269_101
    );
}
