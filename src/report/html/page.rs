//! The page: its sections in order, style and script.

use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::{panel, prose, ranges, summary, sweep, table};
use crate::method::Settings;
use crate::run::{CaseResult, Partial};
use crate::study::sweep::SweepTable;

/// What a report is made of.
pub struct Report<'a> {
    /// Results, in the order of the page.
    pub results: &'a [CaseResult],
    /// Settings that they were computed with.
    pub settings: &'a Settings,
    /// Sweeps to plot, each under its own heading.
    pub sweeps: &'a [SweepTable],
    /// That results are missing, and why.
    pub partial: Option<&'a Partial>,
}

/// The page. It refers to nothing outside itself.
pub fn page(report: &Report) -> String {
    let results = report.results;
    let sections = sections(report);
    let markup = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                // Nothing outside this file is needed; nothing is even asked for.
                meta http-equiv="Content-Security-Policy"
                    content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'";
                link rel="icon" href="data:,";
                title { @if report.partial.is_some() { "PARTIAL: " } "trilith report: " (names(results)) }
                style { (PreEscaped(include_str!("style.css"))) }
            }
            body {
                a.skip href="#main" { "Skip to the results" }
                header {
                    p.brand { "trilith" }
                    h1 { "Collapse multipliers of dry-joint masonry" }
                    p.lead { (names(results)) }
                    nav aria-label="Sections" {
                        ul { @for (id, title, _) in &sections { li { a href={"#" (id)} { (title) } } } }
                    }
                }
                main #main {
                    @if let Some(partial) = report.partial { p.headline.bad { (partial) } }
                    @for (id, title, body) in &sections {
                        section id=(id) aria-labelledby={(id) "-title"} {
                            h2 id={(id) "-title"} { (title) }
                            (body)
                        }
                    }
                }
                footer { p { "Written by trilith " (env!("CARGO_PKG_VERSION")) ". One file, no network." } }
                script { (PreEscaped(include_str!("script.js"))) }
            }
        }
    };
    markup.into_string()
}

/// Sections as (id, heading, body), those without contents left out.
fn sections(report: &Report) -> Vec<(String, String, Markup)> {
    let results = report.results;
    let mut sections = vec![
        (
            "summary".into(),
            "Summary".into(),
            summary::summary(results),
        ),
        (
            "multipliers".into(),
            "Multipliers".into(),
            table::multipliers(results),
        ),
    ];
    let mut add = |id: &str, title: &str, body: Option<Markup>| {
        if let Some(body) = body {
            sections.push((id.to_owned(), title.to_owned(), body));
        }
    };
    add("ranges", "Ranges", ranges::ranges(results));
    for (index, table) in report.sweeps.iter().enumerate() {
        let body = sweep::section(table);
        add(
            &format!("sweep-{}", index + 1),
            &sweep::title(table),
            Some(body),
        );
    }
    for result in results {
        let name = &result.case.name;
        add(&format!("case-{name}"), name, Some(panel::panel(result)));
    }
    add("reading", "How to read it", Some(prose::reading()));
    add(
        "limitations",
        "Known limitations",
        Some(prose::limitations()),
    );
    add(
        "made-with",
        "Made with",
        Some(prose::made_with(report.settings)),
    );
    sections
}

fn names(results: &[CaseResult]) -> String {
    let names: Vec<&str> = results.iter().map(|r| r.case.name.as_str()).collect();
    match names.as_slice() {
        [] => "no cases".to_owned(),
        [one] => (*one).to_owned(),
        [first, second, third, more @ ..] if more.len() > 3 => {
            format!("{first}, {second}, {third} and {} more cases", more.len())
        }
        [all @ .., last] => format!("{} and {last}", all.join(", ")),
    }
}
