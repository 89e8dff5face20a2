//! The chart of one small case: complete, within its definitions, the same bytes twice.

use trilith::answer::Status;
use trilith::case::find;
use trilith::inside::{chart, chart::Chart, chart::Measurement};

/// The stack has an exact answer, min(μ, b/H) = 0.4.
#[test]
fn a_chart_shows_every_rung_with_its_error() {
    let cases = find("stack").unwrap();
    let planned = Chart::new(&cases, None, &[]);
    let entries = planned.measurements(&planned.run(None, &|_| {}).unwrap());
    assert_eq!(entries.len(), chart::ladder(5, &[]).len());
    let of =
        |method: &str| -> &Measurement { entries.iter().find(|e| e.row.method == method).unwrap() };
    assert_eq!(of("macro-block").error(), None, "it does not apply");
    assert!(of("associative").error().unwrap() < 1e-6);
    assert!(of("pushover").error().unwrap() < 2e-3);
    assert!(of("associative").runs > 1, "quick ones are repeated");
    for entry in &entries {
        let wrong = entry.error().is_some_and(|error| error > 0.01);
        let claims = matches!(entry.row.status(), Status::Verified | Status::Bracketed);
        assert!(!(wrong && claims), "{entry:?}");
    }
    let text = chart::csv(&entries);
    assert_eq!(text.lines().count(), entries.len() + 1);
    assert!(
        text.lines()
            .nth(1)
            .unwrap()
            .starts_with("stack,macro-block,default,not-applicable,,,")
    );
    let picture = chart::picture(&entries, None);
    assert_eq!(picture, chart::picture(&entries, None), "the same bytes");
    for word in [
        "no answer",
        "CPU time, seconds",
        "error against 0.4 (analytic)",
        "floor: the references",
        "loose setting",
        "interval",
    ] {
        assert!(picture.contains(word), "{word}");
    }
    let front = chart::front(&entries.iter().collect::<Vec<_>>());
    let errors: Vec<f64> = front.iter().filter_map(|entry| entry.error()).collect();
    assert!(
        errors.is_sorted_by(|a, b| a > b) && !errors.is_empty(),
        "{errors:?}"
    );
    let summaries = chart::summaries(&entries);
    let associative = summaries
        .iter()
        .find(|s| s.method == "associative")
        .unwrap();
    assert_eq!((associative.scenes, associative.within), (1, [1.0; 3]));
}
