//! Malformed scenes: every one gets a message of its own with file, line, offending text and what to
//! write instead. The messages are one catalogue, `snapshots/malformed.snap`.

use std::collections::HashSet;
use std::fmt::Write;
use std::path::Path;

use trilith::case::Case;

/// Two blocks above each other, inline.
const INLINE: &str = r#"friction = 0.65

[[support]]
name = "ground"
corners = [[-5, -1], [5, -1], [5, 0], [-5, 0]]

[[block]]
name = "A"
corners = [[0, 0], [2, 0], [2, 1], [0, 1]]

[[block]]
name = "B"
corners = [[0, 1], [2, 1], [2, 2], [0, 2]]

[[load]]
block = "B"
at = [0, 2]
live = [1, 0]
"#;

/// The same blocks from a CSV.
const BESIDE: &str = r#"friction = 0.65

[blocks]
csv = "blocks.csv"
supports = ["ground"]
"#;

const CSV: &str = "\
block,x,y
ground,-5,-1
ground,5,-1
ground,5,0
ground,-5,0
# the blocks
A,0,0
A,2,0
A,2,1
A,0,1
B,0,1
B,2,1
B,2,2
B,0,2
";

const ARCH: &str = r#"friction = 0.65

[arch]
mean_radius = 10.0
thickness = 1.5
embrace = 180
voussoirs = 9
"#;

const BOND: &str = r#"friction = 0.65
unit = { length = 4.0, height = 1.75, weight = 1.0 }
bond = "running"
courses = 4
units = 3
"#;

const WALL: &str = r#"friction = 0.65
unit = { length = 4.0, height = 1.75, weight = 1.0 }
courses = ["h1h", "11"]
repeat = 2
"#;

/// Which part of a case a mistake is in.
#[derive(Clone, Copy)]
enum In {
    Inline,
    Beside,
    Csv,
    Arch,
    Bond,
    Wall,
}
use In::{Arch, Beside, Bond, Csv, Inline, Wall};

/// Name of the scene, where the mistake is, and what it writes instead of what.
const MALFORMED: &[(&str, In, &str, &str)] = &[
    (
        "overlapping blocks",
        Inline,
        "[[0, 1], [2, 1]",
        "[[0, 0.9], [2, 0.9]",
    ),
    (
        "a block in the ground",
        Inline,
        "[[0, 0], [2, 0]",
        "[[0, -0.1], [2, -0.1]",
    ),
    (
        "overlapping blocks of a CSV",
        Csv,
        "B,0,1\nB,2,1",
        "B,0,0.9\nB,2,0.9",
    ),
    (
        "one block twice",
        Csv,
        "B,0,1\nB,2,1\nB,2,2\nB,0,2",
        "B,0,0\nB,2,0\nB,2,1\nB,0,1",
    ),
    (
        "a floating block",
        Inline,
        "[[0, 1], [2, 1], [2, 2]",
        "[[0, 1.5], [2, 1.5], [2, 2]",
    ),
    (
        "a floating block of a CSV",
        Csv,
        "B,0,1\nB,2,1",
        "B,0,1.5\nB,2,1.5",
    ),
    (
        "a block on a corner",
        Inline,
        "[[0, 1], [2, 1], [2, 2], [0, 2]]",
        "[[0, 1], [1, 2], [0, 3], [-1, 2]]",
    ),
    (
        "a gap of rounding",
        Inline,
        "[[0, 1], [2, 1]",
        "[[0, 1.0001], [2, 1.0001]",
    ),
    (
        "an outline of a CSV that crosses itself",
        Csv,
        "B,2,2\nB,0,2",
        "B,0,3\nB,2,2",
    ),
    (
        "a clockwise outline that touches itself",
        Csv,
        "B,0,1\nB,2,1\nB,2,2\nB,0,2",
        "B,0,2\nB,1,1\nB,2,2\nB,2,1\nB,0,1",
    ),
    (
        "an outline that comes straight back",
        Inline,
        "[2, 2], [0, 2]]",
        "[2, 2], [3, 2], [0, 2]]",
    ),
    (
        "an outline that crosses itself",
        Inline,
        "[[0, 1], [2, 1], [2, 2], [0, 2]]",
        "[[0, 1], [2, 2], [2, 1], [0, 3]]",
    ),
    (
        "a sliver",
        Inline,
        "[2, 2], [0, 2]]",
        "[2, 1.001], [0, 1.001]]",
    ),
    (
        "a sliver of a CSV",
        Csv,
        "B,2,2\nB,0,2",
        "B,2,1.001\nB,0,1.001",
    ),
    (
        "no area",
        Inline,
        "[[0, 1], [2, 1], [2, 2], [0, 2]]",
        "[[0, 1], [1, 1], [2, 1]]",
    ),
    (
        "two corners",
        Inline,
        "[[0, 1], [2, 1], [2, 2], [0, 2]]",
        "[[0, 1], [2, 1]]",
    ),
    (
        "one corner of a CSV",
        Csv,
        "B,0,1\nB,2,1\nB,2,2\nB,0,2\n",
        "B,0,1\n",
    ),
    ("a closed outline", Inline, "[0, 2]]", "[0, 2], [0, 1]]"),
    ("a corner twice", Csv, "B,2,2\n", "B,2,2\nB,2,2\n"),
    (
        "a corner of three numbers",
        Inline,
        "[[0, 1], [2, 1]",
        "[[0, 1, 0], [2, 1]",
    ),
    (
        "a corner that is no list",
        Inline,
        "[[0, 1], [2, 1]",
        "[0, 1, [2, 1]",
    ),
    (
        "a coordinate that is not finite",
        Inline,
        "[[0, 1], [2, 1]",
        "[[0, nan], [2, 1]",
    ),
    (
        "a coordinate out of range",
        Inline,
        "[[0, 1], [2, 1]",
        "[[0, 1], [2e13, 1]",
    ),
    (
        "a block far away",
        Inline,
        "[[0, 1], [2, 1], [2, 2], [0, 2]]",
        "[[3e8, 1], [300000002, 1], [300000002, 2], [3e8, 2]]",
    ),
    (
        "two blocks of one name",
        Inline,
        "name = \"B\"",
        "name = \"A\"",
    ),
    (
        "a name in the CSV and inline",
        Beside,
        "supports = [\"ground\"]\n",
        "supports = [\"ground\"]\n[[block]]\nname = \"B\"\ncorners = [[5, 0], [6, 0], [6, 1]]\n",
    ),
    ("an empty name", Inline, "name = \"B\"", "name = \" \""),
    (
        "a block without corners",
        Inline,
        "corners = [[0, 1], [2, 1], [2, 2], [0, 2]]\n",
        "",
    ),
    ("no support", Beside, "supports = [\"ground\"]", ""),
    (
        "nothing but supports",
        Beside,
        "[\"ground\"]",
        "[\"ground\", \"A\", \"B\"]",
    ),
    ("an unknown support", Beside, "[\"ground\"]", "[\"grund\"]"),
    (
        "a support named twice",
        Beside,
        "[\"ground\"]",
        "[\"ground\", \"ground\"]",
    ),
    (
        "a weight that is not positive",
        Inline,
        "name = \"B\"",
        "name = \"B\"\nweight = 0",
    ),
    (
        "a weight of a support",
        Inline,
        "name = \"ground\"",
        "name = \"ground\"\nweight = 1",
    ),
    (
        "a weight of no block",
        Beside,
        "supports = [\"ground\"]\n",
        "supports = [\"ground\"]\n[[block]]\nname = \"C\"\nweight = 2\n",
    ),
    (
        "a CSV that is not there",
        Beside,
        "blocks.csv",
        "stones.csv",
    ),
    ("a CSV elsewhere", Beside, "blocks.csv", "../blocks.csv"),
    ("an empty CSV", Csv, CSV, "\n# nothing\n"),
    ("a CSV of a header", Csv, CSV, "block,x,y\n"),
    ("a CSV without header", Csv, "block,x,y\n", ""),
    ("a CSV of other columns", Csv, "block,x,y", "name,x,y"),
    (
        "a CSV with semicolons and columns of another kind",
        Csv,
        CSV,
        "stone;x;z\nA;0;0\n",
    ),
    ("a CSV with bars", Csv, CSV, "block|x|y\nA|0|0\n"),
    ("a CSV of two columns x", Csv, "block,x,y", "block,x,y,X"),
    (
        "a comma and a point in one number",
        Csv,
        CSV,
        "block;x;y\nA;1.000,5;0\n",
    ),
    (
        "decimal points beside decimal commas",
        Csv,
        CSV,
        "block;x;y\nA;0,5;0\nA;1.234;0\n",
    ),
    (
        "two weights of one block",
        Csv,
        CSV,
        "Block;X;Y;Weight\nA;0;0;2\nA;1;0;3\n",
    ),
    (
        "a weight below zero",
        Csv,
        CSV,
        "block\tx\ty\tweight\nA\t0\t0\t-2\n",
    ),
    ("a long row", Csv, CSV, "block;x;y\nA;0;0;1\n"),
    ("a row of two columns", Csv, "B,2,2", "B,2"),
    ("a row with decimal commas", Csv, "B,0,1\n", "B,0,0,1,0\n"),
    ("a cell that is no number", Csv, "B,2,2", "B,two,2"),
    ("a cell that is not finite", Csv, "B,2,2", "B,inf,2"),
    ("a row without a name", Csv, "B,2,2", ",2,2"),
    ("rows of a block apart", Csv, "B,0,2\n", "B,0,2\nA,1,0.5\n"),
    (
        "a load on no block",
        Inline,
        "block = \"B\"",
        "block = \"lintel\"",
    ),
    (
        "a load on a support",
        Inline,
        "block = \"B\"",
        "block = \"ground\"",
    ),
    (
        "a load beside its block",
        Inline,
        "at = [0, 2]",
        "at = [0, 2.5]",
    ),
    ("a load without a force", Inline, "live = [1, 0]\n", ""),
    ("a load that acts nowhere", Inline, "at = [0, 2]\n", ""),
    (
        "a line load of one point",
        Inline,
        "at = [0, 2]",
        "along = [[0, 2]]",
    ),
    (
        "nothing that pushes",
        Arch,
        "[arch]",
        "live = \"loads\"\n[arch]",
    ),
    ("two geometries", Arch, "[arch]", "overburden = 1.0\n[arch]"),
    (
        "an arch with head joints",
        Arch,
        "[arch]",
        "head_joints = \"open\"\n[arch]",
    ),
    (
        "an arch of a solid disc",
        Arch,
        "thickness = 1.5",
        "thickness = 20.0",
    ),
    (
        "an arch of one voussoir",
        Arch,
        "voussoirs = 9",
        "voussoirs = 1",
    ),
    (
        "a letter that is not in the legend",
        Wall,
        "\"h1h\"",
        "\"hLh\"",
    ),
    (
        "a letter that has its meaning already",
        Wall,
        "repeat = 2",
        "pieces = { h = { units = 2 } }",
    ),
    (
        "a word for a letter",
        Wall,
        "repeat = 2",
        "pieces = { lintel = { units = 2 } }",
    ),
    (
        "a piece without a length",
        Wall,
        "repeat = 2",
        "pieces = { L = { weight = 2 } }",
    ),
    (
        "a piece of two lengths",
        Wall,
        "repeat = 2",
        "pieces = { L = { units = 2, length = 8 } }",
    ),
    (
        "the weight of a gap",
        Wall,
        "repeat = 2",
        "pieces = { D = { units = 2, gap = true, weight = 1 } }",
    ),
    (
        "pieces that are no table",
        Wall,
        "repeat = 2",
        "pieces = [\"L\"]",
    ),
    (
        "a legend beside a bond",
        Bond,
        "units = 3",
        "units = 3\npieces = { L = { units = 2 } }",
    ),
    (
        "a piece of no course",
        Wall,
        "repeat = 2",
        "repeat = 2\n[[block]]\ncourse = 5\npiece = 1\nweight = 2",
    ),
    (
        "a block of a course without a piece",
        Wall,
        "repeat = 2",
        "repeat = 2\n[[block]]\ncourse = 1\nweight = 2",
    ),
    (
        "a gap with a name",
        Wall,
        "\"11\"]\nrepeat = 2",
        "\"1g1\"]\n[[block]]\ncourse = 2\npiece = 2\nname = \"door\"",
    ),
    (
        "one name for two blocks of courses",
        Wall,
        "repeat = 2",
        "[[block]]\ncourse = 1\npiece = 1\nname = \"course 2 piece 1\"",
    ),
    (
        "one block of a course twice",
        Wall,
        "repeat = 2",
        "[[block]]\ncourse = 1\npiece = 1\nweight = 2\n[[block]]\ncourse = 1\npiece = 1\nweight = 3",
    ),
    (
        "corners of a block in a course",
        Wall,
        "repeat = 2",
        "[[block]]\ncourse = 1\npiece = 1\ncorners = [[0, 0]]",
    ),
    (
        "a course of an explicit block",
        Inline,
        "name = \"B\"",
        "name = \"B\"\ncourse = 2",
    ),
    (
        "a load on no block of a wall",
        Wall,
        "repeat = 2",
        "[[load]]\nblock = \"course 9 piece 1\"\nat = [0, 0]\nlive = [1, 0]",
    ),
    (
        "a Flemish bond that does not close",
        Bond,
        "\"running\"",
        "\"flemish\"",
    ),
    (
        "more overlap than half a unit",
        Bond,
        "units = 3",
        "units = 3\noverlap = 0.7",
    ),
    (
        "a count beyond all whole numbers",
        Wall,
        "repeat = 2",
        "repeat = 18446744073709551615",
    ),
    (
        "a count beyond those of a processor",
        Wall,
        "repeat = 2",
        "repeat = 340282366920938463463374607431768211455",
    ),
    (
        "a wall of too many blocks",
        Wall,
        "repeat = 2",
        "repeat = 20001",
    ),
    (
        "a bond of too many blocks",
        Bond,
        "courses = 4",
        "courses = 28572",
    ),
    (
        "a live load where its kind is asked for",
        Arch,
        "[arch]",
        "live = [0, 1]\n[arch]",
    ),
    ("a push that is no word", Wall, "repeat = 2", "push = 1"),
    ("cohesion", Wall, "repeat = 2", "cohesion = 0.1"),
    (
        "cohesion beside friction",
        Wall,
        "friction = 0.65",
        "friction = { bed = 0.65, cohesion = 0.1 }",
    ),
    (
        "tensile strength",
        Wall,
        "weight = 1.0 }",
        "weight = 1.0, tensile_strength = 0.2 }",
    ),
    (
        "a tie",
        Inline,
        "[[load]]",
        "[[tie]]\nblock = \"A\"\n[[load]]",
    ),
    (
        "a settlement",
        Inline,
        "name = \"ground\"",
        "name = \"ground\"\nsettlement = 0.01",
    ),
    (
        "compressive strength",
        Beside,
        "[blocks]",
        "[blocks]\ncompressive_strength = 5",
    ),
    ("Young's modulus", Arch, "[arch]", "[arch]\nyoung = 1e9"),
    (
        "heights of too few courses",
        Wall,
        "repeat = 2",
        "repeat = 2\nheights = [1.0, 2.0, 1.5]",
    ),
    (
        "heights of a bond",
        Bond,
        "units = 3",
        "units = 3\nheights = [1.0, 2.0]",
    ),
    (
        "a height below zero",
        Wall,
        "repeat = 2",
        "heights = [1.0, -2.0]",
    ),
    (
        "a height of another unit",
        Wall,
        "repeat = 2",
        "heights = [1.0, 17500]",
    ),
    (
        "heights that are no list",
        Wall,
        "repeat = 2",
        "heights = 2.0",
    ),
    (
        "heights of blocks",
        Inline,
        "friction = 0.65",
        "friction = 0.65\nheights = [1.0]",
    ),
    (
        "open head joints of no course",
        Wall,
        "repeat = 2",
        "open_head_joints = [1, 3]",
    ),
    (
        "open head joints among open ones",
        Wall,
        "repeat = 2",
        "head_joints = \"open\"\nopen_head_joints = [1]",
    ),
    (
        "open head joints that are no list",
        Wall,
        "repeat = 2",
        "open_head_joints = 1",
    ),
    (
        "a joint of no course",
        Wall,
        "repeat = 2",
        "joints = [{ course = 3, friction = 0.3 }]",
    ),
    (
        "a joint of a course without friction",
        Wall,
        "repeat = 2",
        "joints = [{ course = 2 }]",
    ),
    (
        "a bed that is open",
        Wall,
        "repeat = 2",
        "joints = [{ course = 2, friction = 0.3, open = true }]",
    ),
    (
        "a bed twice",
        Wall,
        "repeat = 2",
        "joints = [{ course = 2, friction = 0.3 }, { course = 2, friction = 0.4 }]",
    ),
    (
        "a joint of nothing",
        Wall,
        "repeat = 2",
        "joints = [{ friction = 0.3 }]",
    ),
    (
        "a joint of a course and of blocks",
        Wall,
        "repeat = 2",
        "joints = [{ course = 2, between = [\"ground\", \"course 1 piece 1\"], friction = 0.3 }]",
    ),
    (
        "joints in two forms",
        Wall,
        "repeat = 2",
        "joints = [{ course = 2, friction = 0.3 }]\n[[joint]]\ncourse = 1\nfriction = 0.4",
    ),
    (
        "joints that are no tables",
        Wall,
        "repeat = 2",
        "joints = [0.3]",
    ),
    (
        "a friction of a joint below zero",
        Wall,
        "repeat = 2",
        "joints = [{ course = 2, friction = -0.3 }]",
    ),
    (
        "a course of a joint of blocks",
        Inline,
        "[[load]]",
        "[[joint]]\ncourse = 2\nfriction = 0.3\n[[load]]",
    ),
    (
        "a joint of one block",
        Inline,
        "[[load]]",
        "[[joint]]\nbetween = [\"A\"]\nfriction = 0.3\n[[load]]",
    ),
    (
        "a joint of no block",
        Inline,
        "[[load]]",
        "[[joint]]\nbetween = [\"A\", \"C\"]\nfriction = 0.3\n[[load]]",
    ),
    (
        "a joint of which nothing is said",
        Inline,
        "[[load]]",
        "[[joint]]\nbetween = [\"A\", \"B\"]\n[[load]]",
    ),
    (
        "a joint of bodies that do not touch",
        Inline,
        "[[load]]",
        "[[joint]]\nbetween = [\"ground\", \"B\"]\nfriction = 0.3\n[[load]]",
    ),
    (
        "a class of a joint of a support",
        Inline,
        "[[load]]",
        "[[joint]]\nbetween = [\"ground\", \"A\"]\nclass = \"head\"\n[[load]]",
    ),
    (
        "a bed joint that is open",
        Inline,
        "[[load]]",
        "[[joint]]\nbetween = [\"A\", \"B\"]\nopen = true\n[[load]]",
    ),
    (
        "a friction of a support",
        Inline,
        "name = \"ground\"",
        "name = \"ground\"\nfriction = 0.5",
    ),
    (
        "a friction of a block below zero",
        Inline,
        "name = \"B\"",
        "name = \"B\"\nfriction = -0.5",
    ),
    (
        "two weights of one block inline",
        Inline,
        "name = \"B\"",
        "name = \"B\"\nweight = 1\nspecific_weight = 2",
    ),
    (
        "a specific weight of a block of courses twice",
        Wall,
        "repeat = 2",
        "[[block]]\ncourse = 1\npiece = 1\nweight = 1\nspecific_weight = 2",
    ),
    (
        "a specific weight of a support",
        Inline,
        "name = \"ground\"",
        "name = \"ground\"\nspecific_weight = 2",
    ),
    (
        "a live load of weights that is one number",
        Wall,
        "repeat = 2",
        "live = { weight = 0.3 }",
    ),
    (
        "a live load of three numbers",
        Wall,
        "repeat = 2",
        "live = { weight = [1, 0, 0.3] }",
    ),
    (
        "a live load against the push",
        Wall,
        "repeat = 2",
        "live = { weight = [-1, 0.3] }",
    ),
    (
        "a live load of nothing",
        Wall,
        "repeat = 2",
        "live = { weight = [0, 0] }",
    ),
    (
        "a live load of another key",
        Wall,
        "repeat = 2",
        "live = { wieght = [1, 0.3] }",
    ),
    (
        "an overburden of an arch",
        Arch,
        "friction = 0.65",
        "friction = 0.65\noverburden = 0.5",
    ),
    (
        "an overburden below zero",
        Inline,
        "friction = 0.65",
        "friction = 0.65\noverburden = -0.5",
    ),
    (
        "a hole",
        Inline,
        "name = \"B\"",
        "name = \"B\"\nholes = [[0.5, 1.5]]",
    ),
    (
        "an outline of two rings",
        Inline,
        "corners = [[0, 1], [2, 1], [2, 2], [0, 2]]",
        "corners = [[[0, 1], [2, 1], [2, 2], [0, 2]], [[0.5, 1.2], [1, 1.2], [1, 1.8]]]",
    ),
    (
        "an overburden on an apex",
        Inline,
        INLINE,
        "friction = 0.65\noverburden = 0.5\n[[support]]\nname = \"ground\"\n\
         corners = [[-5, -1], [5, -1], [5, 0], [-5, 0]]\n[[block]]\nname = \"A\"\n\
         corners = [[0, 0], [2, 0], [1, 1]]\n",
    ),
    (
        "an overburden under a support",
        Inline,
        INLINE,
        "friction = 0.65\noverburden = 0.5\n[[support]]\nname = \"ground\"\n\
         corners = [[-5, -1], [5, -1], [5, 0], [-5, 0]]\n[[support]]\nname = \"press\"\n\
         corners = [[0, 1], [2, 1], [2, 2], [0, 2]]\n[[block]]\nname = \"A\"\n\
         corners = [[0, 0], [2, 0], [2, 1], [0, 1]]\n",
    ),
];

/// Path, text of the case, and text of the CSV beside it, with one mistake.
fn malformed((name, place, from, to): (&str, In, &str, &str)) -> (String, String) {
    let (toml, part) = match place {
        Inline => (INLINE, INLINE),
        Beside => (BESIDE, BESIDE),
        Csv => (BESIDE, CSV),
        Arch => (ARCH, ARCH),
        Bond => (BOND, BOND),
        Wall => (WALL, WALL),
    };
    assert!(
        part.contains(from),
        "{name}: {from:?} is not in the good case"
    );
    let changed = part.replacen(from, to, 1);
    match place {
        Csv => (toml.to_owned(), changed),
        _ => (changed, CSV.to_owned()),
    }
}

fn read(toml: &str, csv: &str) -> Result<Case, String> {
    let beside = |name: &str| match name {
        "blocks.csv" => Ok(csv.as_bytes().to_vec()),
        _ => Err("there is no such file".to_owned()),
    };
    let case = Case::read_with("scene.toml", toml.as_bytes(), &beside);
    case.map_err(|complaint| complaint.to_string())
}

#[test]
fn the_good_cases_are_good() {
    for toml in [INLINE, BESIDE, ARCH, BOND, WALL] {
        read(toml, CSV).unwrap_or_else(|complaint| panic!("{complaint}"));
    }
}

#[test]
fn every_malformed_scene_has_its_own_message() {
    let mut catalogue = String::new();
    let mut titles = HashSet::new();
    for &scene in MALFORMED {
        let (toml, csv) = malformed(scene);
        let shown = match read(&toml, &csv) {
            Ok(_) => panic!("{} is read without a complaint", scene.0),
            Err(shown) => shown,
        };
        assert!(
            shown.contains("scene.toml:") || shown.contains("blocks.csv:"),
            "{shown}"
        );
        assert!(shown.contains("= help: "), "{shown}");
        titles.insert(shown.clone());
        let _ = write!(catalogue, "## {}\n{shown}\n\n", scene.0);
    }
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(Path::new(env!("CARGO_MANIFEST_DIR")).join("snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!("malformed", catalogue));
    assert_eq!(titles.len(), MALFORMED.len());
}

/// Deterministic noise (xorshift): the same mutations in every run.
fn noise(state: &mut u64) -> usize {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    (*state >> 16) as usize
}

/// One to three bytes changed, in the case or in the CSV: a case or a complaint, never a panic.
#[test]
fn broken_bytes_are_complained_about_and_never_panic() {
    let odd = b"\"'[]{}=#*,.-+0919ABhgyx_ \n\r\t\\\0\x7f\xc3\xa9\xffe;";
    let mut state = 0x2545_F491_4F6C_DD1D;
    let mut complaints = 0;
    for round in 0..4000 {
        let toml = [INLINE, BESIDE, BESIDE, ARCH, BOND, WALL][round % 6];
        let mut bytes = [toml.as_bytes().to_vec(), CSV.as_bytes().to_vec()];
        let broken = &mut bytes[usize::from(round % 6 == 1)];
        for _ in 0..=noise(&mut state) % 3 {
            if broken.is_empty() {
                break;
            }
            let at = noise(&mut state) % broken.len();
            let new = odd[noise(&mut state) % odd.len()];
            match noise(&mut state) % 4 {
                0 => broken[at] = new,
                1 => broken.insert(at, new),
                2 => drop(broken.remove(at)),
                _ if round % 7 == 0 => broken.truncate(at + 1),
                _ => broken.swap(at, 0),
            }
        }
        let [toml, csv] = bytes;
        let case = Case::read_with("a.toml", &toml, &|_| Ok(csv.clone()));
        if let Err(complaint) = case {
            complaints += 1;
            let shown = complaint.to_string();
            assert!(
                shown.contains("help: ") && complaint.line().is_some(),
                "{shown}"
            );
        }
    }
    assert!(complaints > 1000, "{complaints}");
}
