//! What the paper claims about the overburden and about its bounds, and where a claim fails.

use crate::share::share;
use trilith::answer::Status;
use trilith::inside::run_rows;
use trilith::inside::{sweep, sweep::Sweep};
use trilith::run::Row;
use trilith::scene::HeadJoints;

/// The rows of an embedded sweep whose text is changed first.
fn rows(name: &str, change: impl Fn(String) -> String) -> Vec<Row> {
    let path = format!("cases/sweeps/{name}.sweep.toml");
    let found = sweep::embedded().find(|(known, _)| *known == path);
    let (path, text) = found.expect("the sweep is built in");
    let changed = change(text.to_owned());
    assert_ne!(changed, text, "the change finds nothing to change");
    let sweep = Sweep::read(path, changed.as_bytes()).unwrap_or_else(|c| panic!("{c}"));
    run_rows(&sweep.tasks(), None, &|_| {}).expect("no journal, no error")
}

/// Both ends of a row that has a number.
fn ends(row: &Row) -> [f64; 2] {
    let bracket = row.bracket().expect("it has a number");
    [bracket.lower, bracket.upper]
}

/// All but the pushover, which takes its time.
fn quick(text: String) -> String {
    text.replace(", \"pushover\"", "")
}

/// As [`quick`], with two starts for each search instead of all: hundredths of the time.
fn two_starts(text: String) -> String {
    quick(text) + "\n[settings]\nstarts = 2\n"
}

/// Overburden ratios 0, 1, … 10.
fn eleven(text: String) -> String {
    text.replace("count = 40", "count = 11")
}

fn find<'a>(rows: &'a [Row], case: &str, method: &str, overburden: &str) -> &'a Row {
    let is = |row: &&Row| row.parameter("overburden") == Some(overburden);
    let mut found = rows.iter().filter(is);
    let found = found.find(|row| row.scene_name() == case && row.method == method);
    found.unwrap_or_else(|| panic!("no row {case} {method} at {overburden}"))
}

/// The macro range of the same wall as a row's, where the closed form applies.
fn range(rows: &[Row], of: &Row) -> Option<[f64; 2]> {
    let same = |row: &&Row| row.scene_name() == of.scene_name() && row.parameters == of.parameters;
    let found = rows
        .iter()
        .find(|row| same(row) && row.method == "macro-block")?;
    let bracket = found.bracket()?;
    Some([bracket.lower, bracket.upper])
}

/// The rows whose λ is not within the macro range, "BELOW" or "above", with their ratio to it.
fn outside(rows: &[Row]) -> Vec<(&Row, f64)> {
    let micro = rows.iter().filter(|row| row.method != "macro-block");
    let outside = micro.filter_map(|row| {
        let [low, high] = range(rows, row)?;
        let bracket = row.bracket()?;
        let (lower, upper) = (bracket.lower, bracket.upper);
        match (lower < low, upper > high) {
            (true, _) => Some((row, lower / low)),
            (_, true) => Some((row, upper / high)),
            _ => None,
        }
    });
    outside.collect()
}

fn told(row: &Row) -> String {
    format!("{} {} {:?}", row.scene_name(), row.method, row.parameters)
}

/// Section 3.1.1: "the bounds computed by macro-block model always contain the load factor by
/// micro-block model whatever overload amount".
fn assert_contained(rows: &[Row]) {
    let outside = outside(rows);
    let told: Vec<String> = outside
        .iter()
        .map(|(row, ratio)| format!("{} {ratio}", told(row)))
        .collect();
    assert!(told.is_empty(), "outside of the macro range: {told:#?}");
    let judged = rows.iter().filter(|row| row.bracket().is_some()).count();
    assert_eq!(judged, rows.len(), "a row without λ would prove nothing");
}

#[test]
fn the_macro_range_contains_the_micro_values_and_all_fall_with_the_overburden() {
    let rows = rows("fig-7", |text| quick(eleven(text)));
    assert_contained(&rows);
    for case in ["paper-1", "paper-1@open"] {
        for method in ["macro-block", "associative", "interval"] {
            let at = |ratio: u32| {
                let row = find(&rows, case, method, &ratio.to_string());
                ends(row)
            };
            for end in [0, 1] {
                let value = |ratio| at(ratio)[end];
                for ratio in 0..10 {
                    assert!(value(ratio + 1) < value(ratio), "{case} {method} {ratio}");
                }
                // "For overloads larger than three or four times the wall self weight, the load
                // factors remain almost constant": by how much they still fall up to ten.
                let falls = [[0, 3], [3, 10], [4, 10]].map(|[a, b]| 1.0 - value(b) / value(a));
                let allowed = match method {
                    "macro-block" => [0.22, 0.031, 0.021],
                    _ => [0.11, 0.0145, 0.0095],
                };
                let [early, from_three, from_four] = falls;
                assert!(early > allowed[0], "{case} {method}: {falls:?}");
                assert!(from_three < allowed[1], "{case} {method}: {falls:?}");
                assert!(from_four < allowed[2], "{case} {method}: {falls:?}");
            }
        }
    }
    // "As the overload increases, also tan β tends to be constant": of the closed form. That of the
    // micro mechanisms is the same at every overburden.
    let slope = |method, ratio: u32| {
        let row = find(&rows, "paper-1", method, &ratio.to_string());
        row.crack.expect("it has a crack").tan_beta
    };
    assert!(slope("macro-block", 0) - slope("macro-block", 3) > 0.12);
    assert!((slope("macro-block", 3) - slope("macro-block", 10)).abs() < 0.013);
    for ratio in 0..=10 {
        assert!((slope("associative", ratio) - 16.0 / 21.0).abs() < 1e-8);
    }
}

#[test]
#[ignore = "44 pushovers; about 15 s in release"]
fn the_pushover_lies_within_the_range_too_and_where_the_interval_lies() {
    let rows = rows("fig-7", eleven);
    assert_contained(&rows);
    for ratio in 0..=10 {
        let ratio = ratio.to_string();
        for case in ["paper-1", "paper-1@open"] {
            let [interval, pushover] =
                ["interval", "pushover"].map(|method| find(&rows, case, method, &ratio));
            let [low, high] = ends(interval);
            // The error that the pushover states, 0.2 %, on either side of what is verified.
            let within = low * 0.998..=high * 1.002;
            for end in ends(pushover) {
                assert!(
                    within.contains(&end),
                    "{case} {ratio}: {end} not in {within:?}"
                );
            }
        }
    }
}

/// Rows that lie outside of the range, as the sweep's file says and why: how many two starts and all
/// find, and which they are.
type Known = ([usize; 2], fn(&Row, f64) -> bool);

fn number(row: &Row, name: &str) -> f64 {
    let value = row.parameter(name).and_then(|text| text.parse().ok());
    value.unwrap_or_else(|| panic!("no number {name}"))
}

/// The whole wall slides off its base: λ = μ, which the closed form does not know.
fn slides(row: &Row, friction: f64) -> bool {
    row.bracket()
        .is_some_and(|bracket| (bracket.lower - friction).abs() < 1e-6)
}

#[test]
fn the_lowest_state_of_rough_joints_lies_below_the_range() {
    let rows = rows("study-friction", |text| {
        let bare = quick(text).replace("overburden = [0, 1, 4]", "overburden = [0]");
        bare.replace("{ from = 0.2, to = 1.2, count = 11 }", "[1.1]")
    });
    assert_eq!(rows.len(), 6);
    let outside = outside(&rows);
    let [(row, ratio)] = outside[..] else {
        panic!("{outside:#?}");
    };
    let is_of_contact = row.head_joints == HeadJoints::Contact && row.method == "interval";
    assert!(is_of_contact && (0.97..0.98).contains(&ratio), "{ratio}");
    // The closed form's slope makes its upper value smallest, and is too steep for the lower.
    let slope = |row: &Row| row.crack.expect("it has a crack").tan_beta;
    assert!((slope(row) - 16.0 / 21.0).abs() < 1e-8);
    assert!(slope(&rows[0]) > 0.93, "{}", slope(&rows[0]));
}

/// Holds that the `first` studies, each changed before, leave the range only where their files say so, and
/// so many times: `counts` chooses between what two starts and what all find.
fn assert_known(change: fn(String) -> String, counts: usize, first: usize) {
    let studies: [(&str, &[Known]); 4] = [
        (
            "study-friction",
            &[
                ([16, 16], |row, ratio| {
                    ratio < 1.0
                        && slides(row, number(row, "friction"))
                        && number(row, "friction") < 0.35
                }),
                ([12, 12], |row, ratio| {
                    let locked = number(row, "friction") > 0.95 && number(row, "overburden") > 0.0;
                    ratio > 1.0 && locked && row.head_joints == HeadJoints::Contact
                }),
                ([0, 1], |row, ratio| {
                    let rough = number(row, "friction") > 1.05 && number(row, "overburden") == 0.0;
                    let interval = rough && row.method == "interval";
                    interval
                        && row.head_joints == HeadJoints::Contact
                        && (0.97..0.98).contains(&ratio)
                }),
            ],
        ),
        (
            "study-unit-aspect",
            &[
                ([12, 12], |row, ratio| {
                    ratio < 1.0 && slides(row, 0.65) && number(row, "aspect") > 3.9
                }),
                ([1, 2], |row, ratio| {
                    let square = number(row, "aspect") == 1.0 && row.method == "interval";
                    square && row.head_joints == HeadJoints::Contact && (0.9..0.96).contains(&ratio)
                }),
            ],
        ),
        ("study-wall-aspect", &[]),
        ("study-overlap", &[]),
    ];
    for (name, known) in studies.into_iter().take(first) {
        let rows = rows(name, change);
        for row in &rows {
            let told = told(row);
            let reason = row.outcome.reason();
            assert_ne!(row.status(), Status::Failed, "{told}: {reason}");
        }
        let mut found = vec![0; known.len()];
        for (row, ratio) in outside(&rows) {
            let reason = known.iter().position(|(_, is)| is(row, ratio));
            let told = told(row);
            found[reason.unwrap_or_else(|| panic!("no reason for {name}: {told} {ratio}"))] += 1;
        }
        let expected: Vec<usize> = known.iter().map(|(each, _)| each[counts]).collect();
        assert_eq!(found, expected, "{name}: a deviation is gone or new");
    }
}

#[test]
fn elsewhere_the_range_fails_only_where_the_studies_say_so() {
    assert_known(two_starts, 0, 4);
}

#[test]
#[ignore = "192 whole searches: minutes in release"]
fn elsewhere_whole_searches_leave_the_range_only_where_the_studies_say_so() {
    assert_known(quick, 1, share(4));
}
