//! Drawings as geometry: how much is drawn, where, and what the captions say.

use crate::scenes;

use trilith::answer::{Outcome, Status};
use trilith::case::find;
use trilith::inside::parts;
use trilith::inside::{Options, View, figure};
use trilith::method::limit::{Associative, Interval};
use trilith::method::{MacroBlock, Method, Settings};
use trilith::run::{Row, answer};
use trilith::scene::{HeadJoints, Push, Scene};

fn row(scene: &Scene, method: &dyn Method) -> Row {
    answer(std::slice::from_ref(scene), method, Settings::default())
}

fn drawn(scene: &Scene, row: &Row, macro_slope: Option<f64>) -> String {
    let view = View {
        scene,
        row: std::borrow::Cow::Borrowed(row),
        macro_slope,
    };
    figure("a wall", &[view], &Options::for_pictures(1))
}

fn paper_1() -> Scene {
    find("paper-1").unwrap()[0].scene(HeadJoints::Open)
}

/// Value of an attribute of the first element of a class.
fn attribute<'a>(svg: &'a str, class: &str, name: &str) -> Option<&'a str> {
    let element = &svg[svg.find(&format!("class=\"{class}\""))?..];
    let element = &element[..element.find('>')?];
    let value = &element[element.find(&format!(" {name}=\""))? + name.len() + 3..];
    Some(&value[..value.find('"')?])
}

/// Outlines of a path, absolute.
fn outlines(d: &str) -> Vec<Vec<[f64; 2]>> {
    let mut found: Vec<Vec<[f64; 2]>> = Vec::new();
    let mut at = [0.0; 2];
    let starts: Vec<usize> = d
        .char_indices()
        .filter(|(_, c)| c.is_alphabetic())
        .map(|(i, _)| i)
        .collect();
    for (k, &start) in starts.iter().enumerate() {
        let end = starts.get(k + 1).copied().unwrap_or(d.len());
        let text = d[start + 1..end].replace('-', " -");
        let numbers: Vec<f64> = text
            .split_whitespace()
            .map(|n| n.parse().unwrap())
            .collect();
        match (&d[start..=start], numbers.as_slice()) {
            ("M", &[x, y]) => {
                at = [x, y];
                found.push(Vec::new());
            }
            ("l", &[x, y]) => at = [at[0] + x, at[1] + y],
            ("h", &[x]) => at[0] += x,
            ("v", &[y]) => at[1] += y,
            ("z", []) => continue,
            other => panic!("{other:?}"),
        }
        found.last_mut().unwrap().push(at);
    }
    found
}

/// Every outline of every element of a class.
pub fn all(svg: &str, class: &str) -> Vec<Vec<[f64; 2]>> {
    let mark = format!("class=\"{class}\"");
    let at = svg.match_indices(&mark).map(|(i, _)| i);
    at.flat_map(|i| outlines(attribute(&svg[i..], class, "d").unwrap()))
        .collect()
}

#[test]
fn a_wall_is_drawn_whole_and_inside_its_frame() {
    let scene = paper_1();
    let interval = row(&scene, &Interval);
    let svg = drawn(&scene, &interval, Some(0.6597));
    assert_eq!(all(&svg, "part").len(), 33);
    assert_eq!(all(&svg, "before").len(), 33);
    let size = |name| {
        let value = svg.split(&format!(" {name}=\"")).nth(1).unwrap();
        value.split('"').next().unwrap().parse::<f64>().unwrap()
    };
    let (width, height) = (size("width"), size("height"));
    for class in [
        "part",
        "before",
        "support",
        "opening",
        "sliding",
        "crack",
        "macro-crack",
    ] {
        let found = all(&svg, class);
        assert!(!found.is_empty(), "{class}");
        for [x, y] in found.into_iter().flatten() {
            assert!(
                (0.0..=width).contains(&x) && (0.0..=height).contains(&y),
                "{class} {x} {y}"
            );
        }
    }
    assert!(!svg.contains("-0\"") && !svg.contains("NaN") && !svg.contains("inf"));
    assert_eq!(svg, drawn(&scene, &interval, Some(0.6597)));
}

#[test]
fn drawings_at_a_given_scale_show_a_wall_in_the_same_size() {
    let scene = paper_1();
    let options = Options {
        scale: Some(7.0),
        ..Options::for_pictures(1)
    };
    for method in [&Interval as &dyn Method, &Associative] {
        let row = row(&scene, method);
        let view = View {
            scene: &scene,
            row: std::borrow::Cow::Borrowed(&row),
            macro_slope: None,
        };
        let before = all(&figure("a wall", &[view], &options), "before").concat();
        let xs = || before.iter().map(|point| point[0]);
        let width = xs().fold(0.0, f64::max) - xs().fold(f64::INFINITY, f64::min);
        // Five units of 4.
        assert!((width - 7.0 * 20.0).abs() < 0.05, "{width}");
    }
}

#[test]
fn cracks_start_at_the_toe_and_have_their_slopes() {
    let scene = paper_1();
    let svg = drawn(&scene, &row(&scene, &Interval), Some(0.6597));
    // Width 20 and height 10.5; lengths in pixels follow from the outline.
    let before: Vec<[f64; 2]> = all(&svg, "before").concat();
    let extent = |k: usize| {
        let of = |f: fn(f64, f64) -> f64, from| before.iter().map(|p| p[k]).fold(from, f);
        (of(f64::min, f64::INFINITY), of(f64::max, f64::NEG_INFINITY))
    };
    let ((left, right), (top, bottom)) = (extent(0), extent(1));
    let scale = (right - left) / 20.0;
    assert!(((bottom - top) / 10.5 - scale).abs() < 0.01);
    // c = 8 and e = 12 (science.md section 4, paper Table 1).
    let crack = &all(&svg, "crack")[0];
    for (point, [x, y]) in crack.iter().zip([[8.0, top], [0.0, bottom], [12.0, top]]) {
        assert!((point[0] - (right - x * scale)).abs() < 0.05, "{crack:?}");
        assert!((point[1] - y).abs() < 0.05);
    }
    // The macro-block's crack rises beside a strip of width s = 2 (Eq. 3).
    let crack = &all(&svg, "macro-crack")[0];
    assert!((crack[1][0] - (right - 2.0 * scale)).abs() < 0.05);
    let slope = (crack[1][0] - crack[2][0]) / (crack[1][1] - crack[2][1]);
    assert!((slope - 0.6597).abs() < 1e-3, "{slope}");
}

#[test]
fn captions_say_what_was_found() {
    let scene = paper_1();
    let interval = row(&scene, &Interval);
    let closed = row(&scene, &MacroBlock);
    let undecided = Row {
        outcome: Outcome::without_number(Status::Undecided, "<&why>"),
        ..interval.clone()
    };
    let rows = [&closed, &interval, &undecided];
    let views = rows.map(|row| View {
        scene: &scene,
        row: std::borrow::Cow::Borrowed(row),
        macro_slope: Some(0.6597),
    });
    let options = Options {
        forces: true,
        ..Options::for_pictures(4)
    };
    let svg = figure("paper-1: three", &views, &options);
    for words in [
        "λ = 0.48712 - 0.94545, estimate",
        "λ = 0.63997, verified",
        "tan β = 0.7619, c = 8, e = 12",
        "no multiplier: undecided",
        "&lt;&amp;why&gt;",
        "macro-block crack",
    ] {
        assert!(svg.contains(words), "{words}");
    }
    // Forces exist for the interval alone; what has no mechanism takes a line and no picture.
    assert_eq!(svg.matches("class=\"picture\"").count(), 3);
    assert_eq!(svg.matches("class=\"forces\"").count(), 1);
    assert_eq!(svg.matches("class=\"macro-block\"").count(), 1);
}

#[test]
fn rigid_parts_hold_every_block_once() {
    let scene = paper_1();
    let outcome = row(&scene, &Interval).outcome;
    let found = parts(&scene, outcome.evidence.mechanism().unwrap(), 1e-4);
    let mut blocks: Vec<usize> = found.iter().flat_map(|part| part.blocks.clone()).collect();
    blocks.sort_unstable();
    assert_eq!(blocks, (0..33).collect::<Vec<_>>());
    assert_eq!(found.iter().filter(|part| !part.moves).count(), 1);
}

#[test]
fn an_arch_collapses_with_four_hinges() {
    let scene = scenes::arch(0.15, 157.5, 7, 10.0);
    let associative = row(&scene, &Associative);
    let svg = drawn(&scene, &associative, None);
    assert_eq!(all(&svg, "part").len(), 7);
    let open = all(&svg, "opening").len();
    assert_eq!(open, 4, "an arch collapses with four hinges");
    assert!(all(&svg, "crack").is_empty() && all(&svg, "dimension").is_empty());
}

#[test]
fn a_push_to_the_left_is_the_mirror_image() {
    let right = paper_1();
    let left = scenes::mirrored(&right);
    assert_eq!(left.push(), Push::Left);
    let count = |scene: &Scene| {
        let svg = drawn(scene, &row(scene, &Associative), Some(0.6597));
        ["part", "opening", "sliding", "crack", "dimension"].map(|class| all(&svg, class).len())
    };
    assert_eq!(count(&right), count(&left));
}

#[test]
fn the_command_writes_one_drawing_or_says_what_is_wrong() {
    let folder = tempfile::tempdir().unwrap();
    let draw = |arguments: &[&str]| {
        let command = std::process::Command::new(env!("CARGO_BIN_EXE_trilith"))
            .current_dir(folder.path())
            .arg("draw")
            .args(arguments)
            .args(["-o", "wall.svg"])
            .output();
        let output = command.expect("the program starts");
        (
            output.status.code(),
            String::from_utf8(output.stderr).unwrap(),
        )
    };
    let file = folder.path().join("wall.svg");
    let (code, said) = draw(&["paper-1", "--method", "associative,paper-2"]);
    assert_eq!(code, Some(2), "{said}");
    assert!(
        said.contains("stands for 2 cases") && !file.exists(),
        "{said}"
    );
    assert_eq!(
        draw(&["sliding-block", "--method", "macro-block,associative"]).0,
        Some(0)
    );
    let svg = std::fs::read_to_string(&file).unwrap();
    assert!(
        svg.contains("no mechanism to draw: ") && svg.contains("λ = 0.3"),
        "{svg}"
    );
}
