//! What README shows and says is what the program draws and answers.
//!
//! The labelled sketch of a wall is paper-1 as it is solved, so that its crack, its tint and its
//! numbers are true; `.github/wall.svg` is held equal to what is drawn here.

use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::Command;

use trilith::answer::{Crack, Mechanism, Status};
use trilith::scene::{HeadJoints, Point, RegularWall, Scene};
use trilith::{case, method, run};

const INK: &str = "#222";
const FAINT: &str = "#5f5b53";
const CRACK: &str = "#7a3e9d";
const LOAD: &str = "#b3006b";
/// Pixels for a unit of length, size of the picture, and where the wall's lower-left corner lies.
const SCALE: f64 = 18.0;
const SIZE: [f64; 2] = [640.0, 352.0];
const CORNER: [f64; 2] = [140.0, 270.0];

type Pixel = [f64; 2];

fn at(x: f64, y: f64) -> Pixel {
    [CORNER[0] + SCALE * x, CORNER[1] - SCALE * y]
}

#[derive(Default)]
struct Sketch(String);

impl Sketch {
    /// A path through points, with attributes.
    fn path(&mut self, points: &[Pixel], closed: bool, look: &str) {
        let points: Vec<String> = points
            .iter()
            .map(|[x, y]| format!("{x:.1} {y:.1}"))
            .collect();
        let (points, end) = (points.join("L"), if closed { "z" } else { "" });
        let _ = writeln!(self.0, "<path d=\"M{points}{end}\" {look}/>");
    }

    fn line(&mut self, from: Pixel, to: Pixel, colour: &str, more: &str) {
        let look = format!("fill=\"none\" stroke=\"{colour}\" {more}");
        self.path(&[from, to], false, &look);
    }

    fn arrow(&mut self, from: Pixel, to: Pixel, colour: &str) {
        let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
        let length = dx.hypot(dy);
        let [ux, uy] = [dx / length, dy / length];
        let foot = [to[0] - 8.0 * ux, to[1] - 8.0 * uy];
        let head = [
            to,
            [foot[0] - 3.5 * uy, foot[1] + 3.5 * ux],
            [foot[0] + 3.5 * uy, foot[1] - 3.5 * ux],
        ];
        self.line(from, foot, colour, "stroke-width=\"1.8\"");
        self.path(&head, true, &format!("fill=\"{colour}\""));
    }

    /// A line between two ends with strokes across.
    fn dimension(&mut self, from: Pixel, to: Pixel, colour: &str) {
        self.line(from, to, colour, "");
        let across = if from[0] == to[0] {
            [4.0, 0.0]
        } else {
            [0.0, 4.0]
        };
        for [x, y] in [from, to] {
            let ends = [
                [x - across[0], y - across[1]],
                [x + across[0], y + across[1]],
            ];
            self.line(ends[0], ends[1], colour, "");
        }
    }

    /// Text that starts, is centred or ends at a point.
    fn text(&mut self, [x, y]: Pixel, anchor: &str, colour: &str, text: &str) {
        let _ = writeln!(
            self.0,
            "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\" fill=\"{colour}\">{text}</text>"
        );
    }
}

/// What is drawn: the wall, how it moves, its crack, and λ.
struct Solved {
    scene: Scene,
    wall: RegularWall,
    mechanism: Mechanism,
    crack: Crack,
    lambda: f64,
}

/// paper-1 with open head joints, where the collapse multiplier is unique.
fn solved() -> Solved {
    let cases = case::find("paper-1").expect("it is built in");
    let plan = run::Plan {
        methods: method::methods()
            .into_iter()
            .filter(|m| m.name() == "associative")
            .collect(),
        settings: method::Settings::default(),
        head_joints: Some(HeadJoints::Open),
    };
    let results = run::run(&cases, &plan, &|_| {});
    let row = &results[0].rows[0];
    assert_eq!(row.status(), Status::Verified);
    let scene = results[0].scene(row).clone();
    let wall = *scene.regular().expect("it is laid in running bond");
    Solved {
        wall,
        mechanism: row
            .outcome
            .evidence
            .mechanism()
            .cloned()
            .expect("verified by a mechanism"),
        crack: row.crack.expect("it rocks"),
        lambda: row.bracket().expect("verified").upper,
        scene,
    }
}

fn blocks(sketch: &mut Sketch, solved: &Solved) {
    let fastest = solved.mechanism.fastest(&solved.scene);
    for (i, block) in solved.scene.blocks().iter().enumerate() {
        let moves = solved.mechanism.speed(&solved.scene, i, None) > 1e-6 * fastest;
        let fill = if moves { "#a9d4ee" } else { "#eeece7" };
        let corners: Vec<Pixel> = block.shape.corners().iter().map(|c| at(c.x, c.y)).collect();
        let look = format!("fill=\"{fill}\" stroke=\"#57534b\" stroke-width=\"0.9\"");
        sketch.path(&corners, true, &look);
    }
}

/// c, e and β over the toe.
fn crack(sketch: &mut Sketch, solved: &Solved) {
    let (wall, [c, e]) = (
        &solved.wall,
        [solved.crack.c, solved.crack.e].map(Option::unwrap),
    );
    let (right, top) = (wall.length, wall.height);
    let slope = ((c + e) / 2.0 - wall.overlap) / top;
    assert!((slope - solved.crack.tan_beta).abs() < 1e-12);
    let lines = [at(right - c, top), at(right, 0.0), at(right - e, top)];
    let look = format!("fill=\"none\" stroke=\"{CRACK}\" stroke-width=\"1.6\"");
    sketch.path(&lines, false, &look);
    for (name, width, above) in [("c", c, 44.0), ("e", e, 66.0)] {
        let [from, to] = [at(right - width, top), at(right, top)].map(|[x, y]| [x, y - above]);
        sketch.dimension(from, to, CRACK);
        sketch.text(
            [from[0] - 8.0, from[1] + 4.5],
            "end",
            CRACK,
            &format!("{name} = {width}"),
        );
    }
    let foot = at(right - wall.overlap, 0.0);
    let head = at(right - wall.overlap - slope * top, top);
    sketch.line(
        foot,
        head,
        INK,
        "stroke-width=\"1.6\" stroke-dasharray=\"7 4\"",
    );
    sketch.line(
        foot,
        [foot[0], foot[1] - 104.0],
        INK,
        "stroke-dasharray=\"2 3\"",
    );
    let (radius, beta) = (84.0, slope.atan());
    let arc = (0..=12).map(|i| beta * f64::from(i) / 12.0);
    let arc: Vec<Pixel> = arc
        .map(|angle| {
            [
                foot[0] - radius * angle.sin(),
                foot[1] - radius * angle.cos(),
            ]
        })
        .collect();
    sketch.path(&arc, false, &format!("fill=\"none\" stroke=\"{INK}\""));
    let middle = [
        foot[0] - 67.0 * (beta / 2.0).sin(),
        foot[1] - 67.0 * (beta / 2.0).cos(),
    ];
    sketch.text(middle, "middle", INK, "β");
    let [x, y] = at(right, 0.0);
    let _ = writeln!(
        sketch.0,
        "<circle cx=\"{x}\" cy=\"{y}\" r=\"4\" fill=\"{CRACK}\"/>"
    );
    sketch.text([x + 10.0, y - 6.0], "start", CRACK, "toe");
}

/// The overburden, and what one block carries.
fn loads(sketch: &mut Sketch, solved: &Solved) {
    let wall = &solved.wall;
    let [left, top] = at(0.0, wall.height);
    let columns = 20;
    for column in 0..columns {
        let x = left + SCALE * wall.length * (f64::from(column) + 0.5) / f64::from(columns);
        sketch.arrow([x, top - 24.0], [x, top - 2.0], FAINT);
    }
    sketch.line(
        [left, top - 24.0],
        [left + SCALE * wall.length, top - 24.0],
        FAINT,
        "",
    );
    assert_eq!(wall.overburden, 0.0);
    sketch.text([left - 10.0, top - 16.0], "end", FAINT, "overburden");
    sketch.text([left - 10.0, top - 1.0], "end", FAINT, "(if any)");
    // The block that holds this point, in the part that stands still.
    let inside = Point::new(8.0, 2.5 * wall.unit_height);
    let centres = solved.scene.blocks().iter().map(|b| b.shape.centroid());
    let centre = centres.min_by(|a, b| (a - inside).norm().total_cmp(&(b - inside).norm()));
    let centre = centre.map(|c| at(c.x, c.y)).unwrap();
    sketch.arrow(centre, [centre[0], centre[1] + 40.0], LOAD);
    sketch.arrow(centre, [centre[0] + 40.0, centre[1]], LOAD);
    sketch.text(
        [centre[0] + 7.0, centre[1] + 38.0],
        "start",
        LOAD,
        "weight W",
    );
    sketch.text([centre[0] + 45.0, centre[1] + 4.5], "start", LOAD, "λ W");
    let _ = writeln!(
        sketch.0,
        "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"3\" fill=\"{LOAD}\"/>",
        centre[0], centre[1]
    );
}

/// Names of joints, and the dimensions l, h, s and H.
fn names(sketch: &mut Sketch, solved: &Solved) {
    let wall = &solved.wall;
    let (unit, h) = (2.0 * wall.overlap, wall.unit_height);
    let joints = [
        ("bed joint", at(0.0, 3.0 * h), at(0.8, 3.0 * h)),
        ("head joint", at(0.0, 0.5 * h), at(0.5 * unit, 0.5 * h)),
    ];
    for (name, edge, to) in joints {
        sketch.text([edge[0] - 18.0, edge[1] + 4.5], "end", INK, name);
        sketch.line([edge[0] - 13.0, edge[1]], to, INK, "");
        let [x, y] = to;
        let _ = writeln!(
            sketch.0,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2.6\" fill=\"{INK}\"/>"
        );
    }
    let under = |x: f64| [at(x, 0.0)[0], at(x, 0.0)[1] + 15.0];
    let (from, to) = (wall.overlap, wall.overlap + unit);
    sketch.dimension(under(from), under(to), INK);
    sketch.text(
        [under(to)[0] + 8.0, under(to)[1] + 4.5],
        "start",
        INK,
        "unit l × h, overlap s = l/2",
    );
    let [x, y] = at(wall.length, 0.0);
    let (x, top) = (x + 62.0, at(0.0, wall.height)[1]);
    sketch.dimension([x, y], [x, top], INK);
    sketch.text([x + 9.0, (y + top) / 2.0], "start", INK, "H");
}

fn sketch(solved: &Solved) -> String {
    let mut sketch = Sketch::default();
    let [left, base] = at(0.0, 0.0);
    let right = at(solved.wall.length, 0.0)[0];
    let ground = [left - 22.0, right + 22.0].map(|x| [[x, base], [x, base + 28.0]]);
    let ground = [ground[0][0], ground[1][0], ground[1][1], ground[0][1]];
    sketch.path(&ground, true, "fill=\"#dedad0\"");
    sketch.line(ground[0], ground[1], "#8b8475", "stroke-width=\"1.6\"");
    blocks(&mut sketch, solved);
    loads(&mut sketch, solved);
    crack(&mut sketch, solved);
    names(&mut sketch, solved);
    let middle = SIZE[0] / 2.0;
    let lines = [
        format!(
            "Every block carries its weight W, and λ W sideways. Push harder, and at λ = {:.3} the \
             blue blocks move.",
            solved.lambda
        ),
        format!(
            "c moves as one body, e moves at all; crack slope: tan β = ((c + e)/2 − s) / H = {:.4}.",
            solved.crack.tan_beta
        ),
    ];
    for (line, y) in lines.iter().zip([CORNER[1] + 50.0, CORNER[1] + 70.0]) {
        sketch.text([middle, y], "middle", INK, line);
    }
    let title =
        "A dry-joint wall pushed to the right until it collapses, with the names of its parts";
    let [width, height] = SIZE;
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
         width=\"{width}\" height=\"{height}\" role=\"img\" aria-label=\"{title}\" \
         font-family=\"'Helvetica Neue',Helvetica,Arial,'Liberation Sans','DejaVu Sans',sans-serif\" \
         font-size=\"13\" stroke-linejoin=\"round\">\n<title>{title}</title>\n\
         <rect width=\"100%\" height=\"100%\" rx=\"6\" fill=\"#fff\"/>\n{}</svg>\n",
        sketch.0
    )
}

/// Holds a picture of README equal to what is drawn today.
fn assert_kept(name: &str, drawn: &str) {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let kept = fs::read_to_string(package.join(".github").join(name)).unwrap_or_default();
    if kept != drawn {
        let new = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        fs::write(&new, drawn).expect("cargo's folder can be written to");
        let new = new.display();
        panic!("{name} changed: look at {new}, and copy it to .github/{name}");
    }
}

#[test]
fn the_sketch_is_the_wall_as_it_is_solved() {
    assert_kept("wall.svg", &sketch(&solved()));
}

fn trilith(folder: &Path, arguments: &[&str]) -> String {
    let mut program = Command::new(env!("CARGO_BIN_EXE_trilith"));
    let output = program.args(arguments).current_dir(folder).output();
    let output = output.expect("the program starts");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {errors}");
    assert_eq!(errors, "", "{arguments:?}");
    String::from_utf8(output.stdout).expect("output is UTF-8")
}

#[test]
fn the_drawing_of_wall_2_is_what_draw_writes() {
    let folder = tempfile::tempdir().unwrap();
    let drawn = trilith(
        folder.path(),
        &["draw", "paper-2", "--side-by-side", "-o", "-"],
    );
    assert_kept("paper-2.svg", &drawn);
}

const README: &str = include_str!("../../README.md");

/// The text of the first fenced block that begins so.
fn block(begin: &str) -> &str {
    let (_, rest) = README.split_once(begin).expect("README has the block");
    rest.split_once("\n```").expect("the block ends").0
}

#[test]
fn the_wall_of_your_own_has_the_verdict_that_is_told() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("garden.toml"), block("```toml\n")).unwrap();
    for head_joints in ["contact", "open"] {
        // Not the search, which takes seconds: it ends where λ_A with open head joints lies.
        let arguments = ["run", "garden.toml", "--head-joints", head_joints];
        let methods = ["--method", "sequential", "associative", "--format", "csv"];
        let out = trilith(folder.path(), &[&arguments[..], &methods[..]].concat());
        let lambda = |line: &str| line.split(',').nth(4).and_then(|field| field.parse().ok());
        let found: Vec<f64> = out.lines().filter_map(lambda).collect();
        let told = if head_joints == "open" {
            [0.44811, 0.4481]
        } else {
            [0.48201, 0.4481]
        };
        for (found, told) in found.iter().zip(told) {
            assert!(
                (found - told).abs() < 6e-5,
                "{head_joints}: {found} for {told}"
            );
        }
        assert_eq!(found.len(), 2, "{out}");
    }
    assert!(README.contains("λ = 0.448."));
}

#[test]
fn every_command_is_named_and_every_named_command_is_there() {
    let help = trilith(Path::new("."), &["--help"]);
    let listed = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    let listed = listed.take_while(|line| !line.is_empty());
    let names = listed.filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    let names: Vec<&str> = names
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    for name in names.iter().filter(|name| **name != "help") {
        assert!(
            README.contains(&format!("`{name}`")),
            "README does not name {name}"
        );
    }
    let typed = README
        .match_indices("`trilith ")
        .map(|(at, _)| &README[at + 9..]);
    for typed in typed {
        let end = typed.find(|c: char| !c.is_ascii_alphanumeric());
        let word = &typed[..end.unwrap_or(typed.len())];
        let known = word == "COMMAND" || names.contains(&word);
        assert!(known, "README types `trilith {word}`");
    }
}

/// The sweep and the call from Python, as they stand, of the wall that is told before.
#[test]
fn the_sweep_and_the_python_call_run_as_they_stand() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    fs::write(folder.join("garden.toml"), block("```toml\n")).unwrap();
    let sweep = block("here `garden.sweep.toml`:\n\n```toml\n");
    assert_eq!(sweep.lines().count(), 5);
    fs::write(folder.join("garden.sweep.toml"), sweep).unwrap();
    let out = trilith(folder, &["sweep", "garden.sweep.toml", "--out", "out"]);
    assert!(out.contains("20 points in out/sweep.csv"), "{out}");
    let given = [
        "sweep",
        "garden.toml",
        "--vary",
        "friction=0.4:0.8:5",
        "--out",
        "given",
    ];
    let methods = ["--method", "associative", "sequential"];
    trilith(folder, &[&given[..], &methods].concat());
    let points = |folder_of: &str| fs::read_to_string(folder.join(folder_of).join("sweep.csv"));
    assert_eq!(points("out").unwrap(), points("given").unwrap());

    let script = block("From Python it is a loop:\n\n```python\n");
    assert_eq!(script.lines().count(), 10);
    let python = Command::new("python3")
        .args(["-c", script])
        .env(
            "PYTHONPATH",
            concat!(env!("CARGO_MANIFEST_DIR"), "/src/python"),
        )
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .env("TRILITH_PROGRAM", env!("CARGO_BIN_EXE_trilith"))
        .current_dir(folder)
        .output();
    let Ok(python) = python else {
        return crate::skipped::skipped("no python3");
    };
    let errors = String::from_utf8_lossy(&python.stderr);
    assert!(python.status.success(), "{errors}");
    let out = String::from_utf8_lossy(&python.stdout);
    assert_eq!(out.lines().count(), 7, "{out}");
    assert!(
        out.lines()
            .take(6)
            .all(|line| line.contains(" verified 0.")),
        "{out}"
    );
}
