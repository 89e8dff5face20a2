//! What the manual and README say beside other engines is what the records of this program have.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

/// Records and README print five decimals.
const PRINTED: f64 = 1.01e-5;

fn read(path: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(path);
    fs::read_to_string(&path).unwrap_or_else(|why| panic!("{}: {why}", path.display()))
}

/// Lower and upper end of one number or two, as `0.35582` or `0.35570 - 0.35590`; `None` of words.
fn ends(text: &str) -> Option<[f64; 2]> {
    let mut ends = text.split(" - ").map(|end| end.trim().parse().ok());
    let lower = ends.next()??;
    Some([lower, ends.next().flatten().unwrap_or(lower)])
}

fn assert_alike(row: &str, found: [f64; 2], expected: [f64; 2]) {
    for (found, expected) in found.into_iter().zip(expected) {
        let off = (found - expected).abs();
        assert!(off <= PRINTED, "{row}: {found}, not {expected}");
    }
}

/// The ends that are stored of each scene (`paper-3@open`, or `paper-1` in contact) and method.
fn stored() -> BTreeMap<(String, String), [f64; 2]> {
    let table = read("tests/reference/witnesses.csv");
    let rows = table.lines().skip(1).filter_map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        let end = |k: usize| cells[k].parse().ok();
        let key = (cells[0].to_owned(), cells[1].to_owned());
        Some((key, [end(3)?, end(4)?]))
    });
    rows.collect()
}

/// The ends that the record of a scene has of a method.
fn recorded(scene: &str, method: &str) -> Option<[f64; 2]> {
    let (name, joints) = match scene.split_once('@') {
        Some((name, joints)) => (name, joints),
        None => (scene, "contact"),
    };
    // The pushover of paper-3 has a record of its own.
    let records = [format!("{name}.{method}"), name.to_owned()];
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("snapshots");
    let texts = records
        .iter()
        .filter_map(|record| fs::read_to_string(folder.join(format!("{record}.snap"))).ok());
    texts.into_iter().find_map(|text| {
        let heading = text.lines().find(|line| line.starts_with("method "))?;
        let column = |name| heading.find(name).expect("records have this column");
        let lambda = column("lambda")..column("stated");
        let row = text.lines().find(|line| {
            let mut words = line.split_whitespace();
            words.next() == Some(method) && words.next() == Some(joints)
        });
        ends(&row?[lambda])
    })
}

#[test]
fn witnesses_stand_beside_what_the_records_have() {
    let mut compared = 0;
    for ((scene, method), stored) in stored() {
        if !["associative", "interval", "pushover"].contains(&method.as_str()) {
            continue;
        }
        let row = format!("{scene}, {method}");
        let recorded = recorded(&scene, &method).unwrap_or_else(|| panic!("{row}: no record"));
        assert_alike(&row, stored, recorded);
        compared += 1;
    }
    assert!(compared >= 60, "{compared} rows");
}

#[test]
fn the_table_of_engines_has_what_is_stored() {
    let readme = read("README.md");
    let stored = stored();
    let columns = ["associative", "interval", "pushover", "box2d", "lmgc90"];
    let heading = "| scene | λ_A | verified | rapier | Box2D | LMGC90 |";
    let rows = readme.lines().skip_while(|line| *line != heading).skip(2);
    let mut compared = 0;
    for row in rows.take_while(|line| line.starts_with('|')) {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let scene = cells[1].replace(", contact", "").replace(", open", "@open");
        for (method, cell) in columns.iter().zip(&cells[2..]) {
            let Some(told) = ends(cell) else { continue };
            let stored = stored[&(scene.clone(), (*method).to_owned())];
            assert_alike(&format!("{scene}, {method}"), told, stored);
            compared += 1;
        }
    }
    assert!(compared >= 40, "{compared} cells");
}
