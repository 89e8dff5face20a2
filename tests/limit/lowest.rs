//! The lowest verified multiplier that the interval finds on each case of the library, held from one
//! side: `tests/lowest.csv` has them, and they may only fall.
//!
//! The values are read from the records, which the record tests hold to what is computed, so that a
//! lost branch cannot be accepted with `INSTA_UPDATE` alone. Where the search has found a lower
//! state, `TRILITH_LOWEST=update cargo test --test limit lowest` writes it down; a higher one it never
//! writes, nor does it drop a case.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Records print five decimals.
const PRINTED: f64 = 1.01e-5;

/// What is kept of a case and its head joints.
#[derive(Clone, Debug)]
struct Lowest {
    /// The lowest verified λ that the interval has found.
    found: f64,
    /// The lowest that any other code has verified, where that is lower, and which code it was.
    known: String,
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// Case and head joints, with the lower end of a verified interval, of every record. Not of supports
/// that move: where one moves away, the unsafe end is the upper one, and `moves` holds both.
fn recorded() -> BTreeMap<(String, String), f64> {
    let mut found = BTreeMap::new();
    for file in fs::read_dir(root().join("snapshots")).expect("the records are there") {
        let path = file.expect("a file").path();
        // Records that wait for a review are none yet.
        if path.extension().is_none_or(|extension| extension != "snap") {
            continue;
        }
        let name = path.file_stem().expect("a name").to_string_lossy();
        if root().join(format!("cases/moves/{name}.toml")).exists() {
            continue;
        }
        for line in fs::read_to_string(&path).expect("a record").lines() {
            let words: Vec<&str> = line.split_whitespace().collect();
            if let ["interval", head_joints, "verified", lower, ..] = words[..] {
                let lower = lower.parse().unwrap_or_else(|_| panic!("{line}"));
                found.insert((name.to_string(), head_joints.to_owned()), lower);
            }
        }
    }
    found
}

fn kept(path: &Path) -> BTreeMap<(String, String), Lowest> {
    let text = fs::read_to_string(path).expect("tests/lowest.csv is there");
    let rows = text.lines().skip(1).map(|line| {
        let cells: Vec<&str> = line.splitn(4, ',').collect();
        let [case, head_joints, found, known] = cells[..] else {
            panic!("not four cells: {line}");
        };
        let found = found.parse().unwrap_or_else(|_| panic!("{line}"));
        let known = known.to_owned();
        let lowest = Lowest { found, known };
        ((case.to_owned(), head_joints.to_owned()), lowest)
    });
    rows.collect()
}

#[test]
fn the_lowest_state_of_every_case_may_only_fall() {
    let path = root().join("tests/lowest.csv");
    let (recorded, mut kept) = (recorded(), kept(&path));
    let update = std::env::var("TRILITH_LOWEST").is_ok_and(|word| word == "update");
    let mut wrong = Vec::new();
    for ((case, head_joints), &lower) in &recorded {
        let key = (case.clone(), head_joints.clone());
        match kept.get_mut(&key) {
            Some(lowest) if lower > lowest.found + PRINTED => wrong.push(format!(
                "{case} {head_joints}: lowest state at {lower}, {} was found before",
                lowest.found
            )),
            Some(lowest) if lower < lowest.found - PRINTED => {
                if update {
                    lowest.found = lower;
                } else {
                    wrong.push(format!("{case} {head_joints}: write down {lower}"));
                }
            }
            Some(_) => {}
            None if update => {
                let known = ",".to_owned();
                kept.insert(
                    key,
                    Lowest {
                        found: lower,
                        known,
                    },
                );
            }
            None => wrong.push(format!("{case} {head_joints}: write down {lower}")),
        }
    }
    for (case, head_joints) in kept.keys() {
        if !recorded.contains_key(&(case.clone(), head_joints.clone())) {
            wrong.push(format!("{case} {head_joints}: no verified state any more"));
        }
    }
    if update {
        let mut text = "case,head_joints,found,known_lower,known_by\n".to_owned();
        for ((case, head_joints), Lowest { found, known }) in &kept {
            text += &format!("{case},{head_joints},{found:.5},{known}\n");
        }
        fs::write(&path, text).expect("the table can be written");
    }
    assert!(
        wrong.is_empty(),
        "{}\n`TRILITH_LOWEST=update cargo test --test limit lowest` writes down what is new or lower",
        wrong.join("\n")
    );
}

/// Where another code has verified a lower state than the interval finds, and by how much.
#[test]
fn what_other_codes_found_below_is_listed() {
    for ((case, head_joints), Lowest { found, known }) in kept(&root().join("tests/lowest.csv")) {
        let Some((lower, by)) = known.split_once(',') else {
            panic!("{case}: two cells are to follow: {known}");
        };
        if lower.is_empty() {
            continue;
        }
        let lower: f64 = lower.parse().unwrap_or_else(|_| panic!("{case}: {known}"));
        assert!(!by.is_empty(), "{case}: say which code");
        if found > lower + PRINTED {
            let above = 100.0 * (found / lower - 1.0);
            println!("{case} {head_joints}: {found}, {above:.2} % above {lower} of {by}");
        }
    }
}
