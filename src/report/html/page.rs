//! The page: its sections in order, style and script.

use maud::{Markup, html};

use super::document::{Document, document};
use super::{panel, prose, ranges, sortable, summary, sweep};
use crate::method::Settings;
use crate::run::{CaseResult, Partial};
use crate::study::sweep::SweepTable;
use crate::text::enumerated;

/// The page of results, with plots of sweeps, each under its own heading; it says so where results are
/// missing. It refers to nothing outside itself.
pub fn page(
    results: &[CaseResult],
    settings: &Settings,
    sweeps: &[SweepTable],
    partial: Option<&Partial>,
) -> String {
    let sections = sections(results, settings, sweeps);
    let said = partial.map_or("", |_| "PARTIAL: ");
    let names = names(results);
    let links = sections.iter();
    let links = links.map(|(id, title, _)| (id.clone(), title.clone()));
    document(&Document {
        title: format!("{said}trilith report: {names}"),
        class: "report",
        heading: "Collapse multipliers of dry-joint masonry",
        lead: names,
        links: links.collect(),
        body: html! {
            @if let Some(partial) = partial { p.headline.bad { (partial) } }
            @for (id, title, body) in &sections {
                section id=(id) aria-labelledby={(id) "-title"} {
                    h2 id={(id) "-title"} { (title) }
                    (body)
                }
            }
        },
    })
}

/// Cases that stand before the tables.
const FEW: usize = 4;

/// Sections as (id, heading, body), those without contents left out.
fn sections(
    results: &[CaseResult],
    settings: &Settings,
    sweeps: &[SweepTable],
) -> Vec<(String, String, Markup)> {
    let mut sections = Vec::new();
    let mut add = |id: &str, title: &str, body: Markup| {
        sections.push((id.to_owned(), title.to_owned(), body));
    };
    // A few cases stand first, each with its verdict; of many, a line each.
    let few = results.len() <= FEW;
    let cases = |add: &mut dyn FnMut(&str, &str, Markup)| {
        for result in results {
            let name = &result.case.name;
            add(&format!("case-{name}"), name, panel::panel(result));
        }
    };
    if few {
        cases(&mut add);
    } else {
        add("verdicts", "In short", summary::verdicts(results));
    }
    add("multipliers", "Multipliers", sortable::multipliers(results));
    if let Some(body) = ranges::ranges(results) {
        add("ranges", "Ranges", body);
    }
    for (index, table) in sweeps.iter().enumerate() {
        let id = format!("sweep-{}", index + 1);
        add(&id, &sweep::title(table), sweep::section(table));
    }
    if !few {
        cases(&mut add);
    }
    add("summary", "Checks", summary::summary(results));
    add("reading", "How to read it", prose::reading());
    add("limitations", "Known limitations", prose::limitations());
    add("made-with", "Made with", prose::made_with(settings));
    sections
}

fn names(results: &[CaseResult]) -> String {
    let names: Vec<String> = results.iter().map(|r| r.case.name.clone()).collect();
    match names.as_slice() {
        [] => "no cases".to_owned(),
        [first, second, third, more @ ..] if more.len() > 3 => {
            format!("{first}, {second}, {third} and {} more cases", more.len())
        }
        all => enumerated(all),
    }
}
