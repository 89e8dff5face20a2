//! Models of COMPAS: read, written, read again, and refused where they are not plane. What compas_dem
//! itself writes and reads is tried in `src/python/tests/`.

use std::path::Path;
use std::process::Command;

use serde_json::{Value, json};
use trilith::case::{Case, DrawingOptions, Imported};
use trilith::scene::{HeadJoints, Scene};

fn read(model: &str) -> Result<Imported, String> {
    let options = DrawingOptions {
        friction: Some(0.65),
        ..DrawingOptions::default()
    };
    let read = Case::from_drawing("model.json", model.as_bytes(), &options);
    read.map_err(|complaint| complaint.to_string())
}

/// A mesh of a prism over an outline in x–z, from y = `front` to `back`, with its points moved.
fn mesh(
    outline: &[[f64; 2]],
    front: f64,
    back: f64,
    moved: impl Fn([f64; 3]) -> [f64; 3],
) -> Value {
    let count = outline.len();
    let points = [front, back]
        .into_iter()
        .flat_map(|y| outline.iter().map(move |[x, z]| [*x, y, *z]));
    let vertices: serde_json::Map<String, Value> = points
        .enumerate()
        .map(|(k, point)| {
            let [x, y, z] = moved(point);
            (k.to_string(), json!({"x": x, "y": y, "z": z}))
        })
        .collect();
    let mut faces = serde_json::Map::new();
    faces.insert("0".to_owned(), (0..count).collect());
    faces.insert("1".to_owned(), (count..2 * count).rev().collect());
    for k in 0..count {
        let next = (k + 1) % count;
        faces.insert(
            (k + 2).to_string(),
            json!([next, k, count + k, count + next]),
        );
    }
    json!({"vertex": vertices, "face": faces})
}

fn assembly(blocks: &[(Value, bool)]) -> String {
    let node = |(k, (mesh, is_support)): (usize, &(Value, bool))| {
        let block = json!({"dtype": "compas_assembly.datastructures/Block", "data": mesh});
        (
            k.to_string(),
            json!({"block": block, "is_support": is_support}),
        )
    };
    let nodes: serde_json::Map<String, Value> = blocks.iter().enumerate().map(node).collect();
    let graph = json!({"dtype": "compas.datastructures/Graph", "data": {"node": nodes}});
    json!({"dtype": "compas_assembly.datastructures/Assembly", "data": {"graph": graph}})
        .to_string()
}

const GROUND: [[f64; 2]; 4] = [[-1.0, -1.0], [3.0, -1.0], [3.0, 0.0], [-1.0, 0.0]];
const BLOCK: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [0.0, 2.0]];

fn two(front: f64, back: f64, moved: impl Fn([f64; 3]) -> [f64; 3] + Copy) -> String {
    assembly(&[
        (mesh(&GROUND, -0.5, 0.5, moved), true),
        (mesh(&BLOCK, front, back, moved), false),
    ])
}

fn corners(scene: &Scene) -> Vec<[f64; 2]> {
    let all = scene
        .blocks()
        .iter()
        .flat_map(|block| block.shape.corners().to_vec());
    all.map(|corner| corner.into()).collect()
}

#[test]
fn the_plane_of_a_model_is_found_whichever_way_it_stands() {
    let expected = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [0.0, 2.0]];
    let (sine, cosine) = 0.3_f64.sin_cos();
    let ways: [fn([f64; 3]) -> [f64; 3]; 2] = [|p| p, |[x, y, z]| [-y, x, z]];
    for way in ways {
        let case = read(&two(-0.25, 0.25, way)).unwrap().case;
        let scene = case.scene(HeadJoints::Contact);
        assert_eq!(corners(&scene), expected);
        assert_eq!(scene.joints().len(), 1);
        // 1 x 2 of depth 0.5.
        assert_eq!(scene.blocks()[0].dead(), [0.0, -1.0, 0.0]);
    }
    let turned = move |[x, y, z]: [f64; 3]| [cosine * x - sine * y, sine * x + cosine * y, z];
    // A face has to be off the axes, so that only the third kind of plane fits.
    let case = read(&two(-0.25, 0.25, turned)).unwrap().case;
    let found = corners(&case.scene(HeadJoints::Contact));
    for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
        assert!((found - expected).abs() < 1e-12, "{found} for {expected}");
    }
}

#[test]
fn models_that_are_not_plane_are_refused_with_the_blocks_name() {
    let beside = read(&two(0.0, 0.5, |p| p)).unwrap_err();
    assert!(
        beside.contains("the middle of the block `1` lies 0.2500 beside that of `0`"),
        "{beside}"
    );
    assert!(beside.contains("model.json:1"), "{beside}");
    let pyramid = |[x, y, z]: [f64; 3]| match z > 1.0 {
        true => [0.5 + (x - 0.5) / 2.0, y / 2.0, z],
        false => [x, y, z],
    };
    let sunk = BLOCK.map(|[x, z]| [x, z - 0.3]);
    let solid = |outline, is_support| (mesh(outline, -0.5, 0.5, |p| p), is_support);
    let overlap = read(&assembly(&[solid(&GROUND, true), solid(&sunk, false)])).unwrap_err();
    assert!(
        overlap.contains("`0` (at ") && overlap.contains("overlap, 3.000e-1 deep"),
        "{overlap}"
    );
    let refused = read(&two(-0.5, 0.5, pyramid)).unwrap_err();
    assert!(
        refused.contains("the block `1` is no prism across the plane x–z"),
        "{refused}"
    );
}

#[test]
fn what_is_no_model_is_refused_in_words() {
    let whole = two(-0.5, 0.5, |p| p);
    let free = whole.replace("\"is_support\":true", "\"is_support\":false");
    for (text, expected) in [
        ("{\"dtype\": 1,\n }", "not JSON"),
        ("[1, 2]", "it has no `dtype`"),
        (
            "{\"dtype\": \"compas.datastructures/Mesh\"}",
            "its `dtype` is `compas.datastructures/Mesh`",
        ),
        (
            "{\"dtype\": \"compas_dem.models/BlockModel\"}",
            "a model without blocks",
        ),
        (&free, "no support"),
        (
            &whole.replace("\"face\"", "\"faces\""),
            "no mesh of a solid",
        ),
        (
            &whole.replace("\"y\":-0.5", "\"y\":null"),
            "a vertex without `y`",
        ),
        (
            &whole.replace("\"x\":3.0", "\"x\":1e300"),
            "a vertex without `x`",
        ),
    ] {
        let refused = read(text).unwrap_err();
        assert!(
            refused.contains(expected) && refused.contains("help: "),
            "{refused}"
        );
    }
    // A file that is cut off anywhere is refused too.
    for end in (0..whole.len()).step_by(97) {
        assert!(read(&whole[..end]).is_err());
    }
}

fn trilith(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let mut program = Command::new(env!("CARGO_BIN_EXE_trilith"));
    let output = program
        .args(arguments)
        .current_dir(folder)
        .output()
        .expect("it runs");
    let text = [output.stdout, output.stderr].concat();
    (
        output.status.code(),
        String::from_utf8(text).expect("it is text"),
    )
}

/// Walls, an arch and stones of any shape: corners, weights and names come back.
#[test]
fn a_model_that_is_written_is_read_as_the_same_blocks() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["paper-1", "oppenheim-7", "trilith", "column-tapered"] {
        let file = format!("{name}.json");
        let (status, said) = trilith(folder.path(), &["export", name, "--compas", &file]);
        assert_eq!(status, Some(0), "{said}");
        let text = std::fs::read_to_string(folder.path().join(&file)).unwrap();
        let back = read(&text).unwrap().case.scene(HeadJoints::Contact);
        let case = trilith::case::find(name).unwrap().remove(0);
        let own = case.scene(HeadJoints::Contact);
        assert_eq!(own.labels().blocks, back.labels().blocks, "{name}");
        for (a, b) in own.blocks().iter().zip(back.blocks()) {
            let (a_corners, b_corners) = (a.shape.corners(), b.shape.corners());
            let moved = a_corners.iter().zip(b_corners).map(|(a, b)| (a - b).norm());
            assert!(
                a_corners.len() == b_corners.len() && moved.fold(0.0, f64::max) <= 1e-12,
                "{name}"
            );
            assert!(
                (a.dead()[1] - b.dead()[1]).abs() <= 1e-12 * a.dead()[1].abs(),
                "{name}"
            );
        }
        let model: Value = serde_json::from_str(&text).unwrap();
        let node = &model["data"]["graph"]["node"]["0"];
        assert!(
            node["displacement"].is_array() && node["rotation"].is_number(),
            "{name}: {node}"
        );
        assert!(text.contains("\"c_np\":"), "{name}");
    }
    let both = ["export", "trilith", "--compas", "a.json", "--dxf", "a.dxf"];
    assert_eq!(trilith(folder.path(), &both).0, Some(2));
    let (status, said) = trilith(folder.path(), &["import", "trilith.json", "--units", "mm"]);
    assert!(
        status == Some(2) && said.contains("has no layers and no unit of length"),
        "{said}"
    );
    let run = [
        "run",
        "trilith.json",
        "--friction",
        "0.65",
        "--method",
        "associative",
    ];
    let (status, said) = trilith(folder.path(), &run);
    assert!(
        status == Some(0) && said.contains("from a model of COMPAS"),
        "{said}"
    );
    let (status, said) = trilith(
        folder.path(),
        &[&run[..], &["--progress", "lines"]].concat(),
    );
    assert!(
        status == Some(0) && said.contains("progress 1.0000 0.0\n"),
        "{said}"
    );
}

/// The ground that units sink with is a support of its own between what stays, and moves in the model.
#[test]
fn a_support_that_moves_is_one_of_the_model() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let wall = "unit = { length = 1, height = 1, weight = 1 }\ncourses = [\"1111\", \"h111h\"]\n\
                friction = 0.65\n[[move]]\nunits = \"2-3\"\ndirection = [0, -1]\nmoves = \"away\"\n";
    std::fs::write(folder.path().join("a.toml"), wall).expect("it can be written");
    let export = ["export", "a.toml", "--compas", "a.json"];
    let (status, said) = trilith(folder.path(), &export);
    assert_eq!(status, Some(0), "{said}");
    let text = std::fs::read_to_string(folder.path().join("a.json")).expect("it is written");
    let scene = read(&text)
        .expect("a model")
        .case
        .scene(HeadJoints::Contact);
    let own = Case::read("a.toml", wall.as_bytes()).expect("a case");
    let own = own.scene(HeadJoints::Contact);
    assert_eq!((scene.blocks().len(), scene.supports().len()), (9, 3));
    assert_eq!(scene.joints().len(), own.joints().len() - 2);
    let model: Value = serde_json::from_str(&text).expect("JSON");
    let graph = &model["data"]["graph"];
    let sinks = graph["node"]["9"]["displacement"][2].as_f64();
    assert!(sinks.is_some_and(|moved| moved < 0.0), "{graph}");
    // Units 2 and 3 stand on it, 1 and 4 on what stays.
    let on = |node: &str| {
        graph["edge"][node]
            .as_object()
            .map_or(0, |edges| edges.len())
    };
    assert_eq!([on("9"), on("10"), on("11")], [2, 1, 1]);
}
