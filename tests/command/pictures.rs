//! Every picture read back: ticks say where they stand, no two labels cover each other, none leaves the
//! picture.

use crate::draw::all;
use crate::share::share;
use crate::svg::{assert_true_ticks, axes, faults, texts};
use trilith::case::{find, library};
use trilith::inside::{chart, chart::Chart, chart::Measurement};
use trilith::inside::{manual, page};
use trilith::inside::{sweep::SweepTable, sweep::sweep_picture};
use trilith::method::{Method, Settings, methods as all_methods};
use trilith::run::{CaseResult, Plan, run};
use trilith::scene::HeadJoints;

fn methods(names: &[&str]) -> Vec<&'static dyn Method> {
    let all = all_methods().into_iter();
    all.filter(|method| names.contains(&method.name()))
        .collect()
}

fn results(cases: &[trilith::case::Case], names: &[&str]) -> Vec<CaseResult> {
    let plan = Plan {
        methods: methods(names),
        settings: Settings::default(),
        head_joints: None,
    };
    run(cases, &plan, &|_| {})
}

/// Every drawing of a page.
fn pictures(html: &str) -> Vec<String> {
    let parts = html.split("<svg").skip(1);
    let whole = |part: &str| {
        let inside = part.split_once("</svg>").expect("a drawing ends").0;
        format!("<svg{inside}</svg>")
    };
    parts.map(whole).collect()
}

#[track_caller]
fn assert_clear(picture: &str, what: &str) {
    let faults = faults(picture);
    assert!(faults.is_empty(), "{what}: {faults:#?}");
    for class in ["x-tick", "y-tick"] {
        assert_true_ticks(&axes(picture, class, false));
    }
}

/// Ranges and drawings of the whole library, on the report's page and in the manual; paper-3,
/// which takes long, apart.
#[test]
fn the_librarys_pictures_are_clear() {
    let mut cases = library();
    cases.retain(|case| case.name != "paper-3");
    let mut results = results(&cases, &["macro-block", "associative"]);
    let paper = find("paper-1").unwrap();
    results.extend(self::results(
        &paper,
        &["macro-block", "associative", "sequential", "interval"],
    ));
    let settings = Settings::default();
    let report = page(&results, &settings, &[], None);
    for html in [report, manual(&results, &settings, None)] {
        let pictures = pictures(&html);
        assert!(pictures.len() > cases.len(), "{}", pictures.len());
        let mut all = Vec::new();
        for (index, picture) in pictures.iter().enumerate() {
            let name = texts(picture).first().map(|text| text.words.clone());
            let faults = faults(picture).into_iter();
            all.extend(faults.map(|fault| format!("{index} {name:?}: {fault}")));
            for class in ["x-tick", "y-tick"] {
                assert_true_ticks(&axes(picture, class, false));
            }
        }
        assert!(all.is_empty(), "{all:#?}");
        assert!(html.len() < 25_000_000);
    }
}

fn clear_chart(case: &str) -> Vec<Measurement> {
    let cases = find(case).unwrap();
    let chart = Chart::new(&cases, None, &[]);
    let entries = chart.measurements(&chart.run(None, &|_| {}).unwrap());
    let picture = chart::picture(&entries, None);
    let faults = faults(&picture);
    assert!(faults.is_empty(), "{faults:#?}");
    for class in ["x-tick", "y-tick"] {
        let axes = axes(&picture, class, true);
        assert!(axes.iter().any(|ticks| ticks.len() > 3), "{axes:?}");
        assert_true_ticks(&axes);
    }
    entries
}

#[test]
fn a_chart_is_clear() {
    assert!(!clear_chart("stack").is_empty());
}

/// The charts of the first wall of the paper and of one with openings; in contact the interval's answer lies
/// at the floor where both ends meet the independent range, and the closed form far above it.
#[test]
#[ignore = "takes a minute in release"]
fn the_charts_of_the_walls_are_clear() {
    let walls = ["paper-1", "openings-4"].iter().take(share(2));
    let mut charts: Vec<_> = walls.map(|case| clear_chart(case)).collect();
    let mut entries = charts.swap_remove(0);
    entries.retain(|entry| entry.row.head_joints == HeadJoints::Contact);
    let error = |method: &str| {
        let mut own = entries.iter().filter(|entry| entry.row.method == method);
        let default = own.find(|entry| entry.setting() == "default");
        default.and_then(|entry| entry.error()).unwrap()
    };
    assert!(error("interval") <= 1e-6, "{}", error("interval"));
    // The upper end, 0.94545, from the highest state, 0.642859, relative to the lowest, 0.638982.
    assert!(
        (error("macro-block") - 0.4736).abs() < 1e-3,
        "{}",
        error("macro-block")
    );
    let front = chart::front(&entries.iter().collect::<Vec<_>>());
    assert!(!front.is_empty());
    for member in front {
        assert!(member.vouches() && !member.loose, "{}", member.name());
    }
}

/// A sweep's CSV: 11 values of x, some of y and z, two methods, both settings; one point without an answer.
fn swept(ys: usize, zs: usize) -> SweepTable {
    let mut text = "case,method,status,lower,upper,tan_beta,c,e,residual,reason,x".to_owned();
    text.push_str(if ys > 0 { ",y" } else { "" });
    text.push_str(if zs > 0 { ",z" } else { "" });
    text.push_str(",blocks\n");
    for case in ["wall", "wall@open"] {
        for method in ["macro-block", "associative", "interval"] {
            for x in 0..11 {
                for y in 0..ys.max(1) {
                    for z in 0..zs.max(1) {
                        let at = 0.25 * f64::from(x);
                        let low = 0.5 + 0.013 * at + 0.01 * (y + z) as f64;
                        let high = if method == "macro-block" {
                            low + 0.3
                        } else {
                            low
                        };
                        let ends = if x == 4 {
                            ",".to_owned()
                        } else {
                            format!("{low},{high}")
                        };
                        text.push_str(&format!("{case},{method},verified,{ends},,,,,,{at}"));
                        text.push_str(&if ys > 0 {
                            format!(",{y}")
                        } else {
                            String::new()
                        });
                        text.push_str(&if zs > 0 {
                            format!(",{z}")
                        } else {
                            String::new()
                        });
                        text.push_str(",33\n");
                    }
                }
            }
        }
    }
    SweepTable::parse("swept", text.as_bytes()).unwrap()
}

/// Published values stand on the curves of the wall that they are of, and on no other's: not where a key of
/// one value changes the wall, nor where a file has the name of a built-in case.
#[test]
fn published_values_stand_on_the_curves_of_their_own_wall() {
    let marked = |key: &str, value: &str, [blocks, joints, friction]: [&str; 3]| {
        let mut text = format!("case,method,lower,upper,overburden{key},blocks,joints,friction\n");
        for overburden in 0..=10 {
            text.push_str(&format!(
                "paper-1,associative,0.6,0.6,{overburden}{value},{blocks},{joints},{friction}\n"
            ));
        }
        let table = SweepTable::parse("swept", text.as_bytes()).unwrap();
        let picture = sweep_picture(&table).unwrap();
        picture.contains("published or by another code")
    };
    assert!(marked("", "", ["33", "83", "0.65"]));
    assert!(!marked(",unit.height", ",2", ["33", "83", "0.65"]));
    for other in [
        ["34", "83", "0.65"],
        ["33", "84", "0.65"],
        ["33", "83", "0.4"],
    ] {
        assert!(!marked("", "", other), "{other:?}");
    }
}

/// No segment of a curve begins or ends where its method has no value, or passes over such a place; each of
/// those is marked. A curve that lies on another lets it be seen, and all panels have one axis.
#[test]
fn curves_end_where_there_is_no_value() {
    let count = 9;
    let misses = |seed: u64, at: u64| (seed * 7 + at * (at + seed)).is_multiple_of(5);
    for seed in 1..=20 {
        let mut text = "case,method,status,lower,upper,friction\n".to_owned();
        let mut missing = 0;
        for (case, factor) in [("wall", 1.0), ("wall@open", 0.4)] {
            for at in 0..count {
                let (friction, lambda) = (at + 1, factor * (0.1 + 0.05 * at as f64));
                text.push_str(&format!(
                    "{case},associative,verified,{lambda},{lambda},{friction}\n"
                ));
                let ends = match misses(seed, at) {
                    true => "undecided,,".to_owned(),
                    false => format!("verified,{lambda},{lambda}"),
                };
                missing += usize::from(misses(seed, at));
                text.push_str(&format!("{case},interval,{ends},{friction}\n"));
            }
        }
        let picture = sweep_picture(&SweepTable::parse("swept", text.as_bytes()).unwrap()).unwrap();
        assert_clear(&picture, "curves");
        assert_eq!(
            picture.matches("class=\"missing\"").count(),
            missing,
            "{text}"
        );
        assert_eq!(picture.contains(">no answer<"), missing > 0);
        let ticks = axes(&picture, "x-tick", false);
        assert_eq!(ticks.len(), 2);
        let heights = axes(&picture, "y-tick", false);
        let values = |axis: &Vec<(f64, f64)>| axis.iter().map(|of| of.0).collect::<Vec<_>>();
        assert_eq!(
            values(&heights[0]),
            values(&heights[1]),
            "one axis for both"
        );
        let [(first, x0), .., (last, x1)] = ticks[0][..] else {
            panic!("two ticks")
        };
        let place = |x: f64| (first + (x - x0) / (x1 - x0) * (last - first)).round() as u64 - 1;
        // Of each panel the curve of `associative`, then the pieces of `interval`.
        let curves = all(&picture, "curve");
        let whole = curves.iter().filter(|curve| curve.len() == count as usize);
        assert!(whole.count() >= 2);
        for curve in curves.iter().filter(|curve| curve.len() < count as usize) {
            let at: Vec<u64> = curve.iter().map(|point| place(point[0])).collect();
            assert!(at.windows(2).all(|pair| pair[1] == pair[0] + 1), "{at:?}");
            assert!(at.iter().all(|&at| !misses(seed, at)), "{seed}: {at:?}");
        }
        let on_another = curves.iter().filter(|curve| curve.len() > 1).count();
        assert_eq!(
            picture.matches("stroke-dasharray=\"8 8\"").count(),
            on_another - 2,
            "{seed}"
        );
    }
}

#[test]
fn sweeps_of_one_and_two_variables_have_their_plots() {
    for (ys, zs, headings) in [(0, 0, 2), (3, 0, 6), (2, 3, 12)] {
        let picture = sweep_picture(&swept(ys, zs)).unwrap();
        assert_clear(&picture, "curves");
        let plots = picture.matches(">collapse multiplier λ<").count();
        assert_eq!(plots, headings);
        // Three methods; the curve of each is broken where there is no answer, and named once.
        assert_eq!(picture.matches("class=\"name\"").count(), 3 * plots);
        let ticks = axes(&picture, "x-tick", false);
        assert_eq!(ticks.len(), plots, "{ticks:?}");
    }
    let fields = sweep_picture(&swept(6, 0)).unwrap();
    assert_clear(&fields, "fields");
    assert_eq!(fields.matches("<title>").count() - 1, 2 * 3 * 6 * 11);
    let why = sweep_picture(&swept(4, 4)).unwrap_err();
    assert!(why.contains("x, y, z vary together"), "{why}");
    let why = sweep_picture(&SweepTable::parse("none", b"case,method,lower,upper\n").unwrap());
    assert_eq!(why.unwrap_err(), "no plot: nothing varies");
}
