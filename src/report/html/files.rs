//! Figures and tables that other commands wrote, taken into the page.

use std::path::Path;

use maud::{Markup, html};

use super::table::{Cell, sortable};

/// A file taken into the page.
pub enum Attached {
    /// An SVG, by name and text.
    Figure(String, String),
    /// A CSV, by name, columns and rows.
    Table(String, Vec<String>, Vec<Vec<String>>),
}

/// Every SVG and CSV of a folder by name, figures first.
///
/// # Errors
/// What cannot be read, in words.
pub fn attached(folder: &Path) -> Result<Vec<Attached>, String> {
    let failed = |path: &Path, error: String| format!("cannot read {}: {error}", path.display());
    let entries = std::fs::read_dir(folder).map_err(|e| failed(folder, e.to_string()))?;
    let mut paths = Vec::new();
    for entry in entries {
        paths.push(entry.map_err(|e| failed(folder, e.to_string()))?.path());
    }
    paths.sort();
    let (mut figures, mut tables) = (Vec::new(), Vec::new());
    for path in paths {
        let name = path
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        match path.extension().and_then(|extension| extension.to_str()) {
            Some("svg") => {
                let text = std::fs::read_to_string(&path);
                figures.push(Attached::Figure(
                    name,
                    text.map_err(|e| failed(&path, e.to_string()))?,
                ));
            }
            Some("csv") => {
                let read = || -> Result<(Vec<String>, Vec<Vec<String>>), csv::Error> {
                    let mut reader = csv::Reader::from_path(&path)?;
                    let owned =
                        |record: &csv::StringRecord| record.iter().map(str::to_owned).collect();
                    let heading = owned(reader.headers()?);
                    let rows = reader.records().map(|record| record.map(|r| owned(&r)));
                    Ok((heading, rows.collect::<Result<_, _>>()?))
                };
                let (heading, rows) = read().map_err(|e| failed(&path, e.to_string()))?;
                tables.push(Attached::Table(name, heading, rows));
            }
            _ => {}
        }
    }
    figures.extend(tables);
    Ok(figures)
}

/// The files one below the other; `None` without any.
pub fn section(files: &[Attached]) -> Option<Markup> {
    (!files.is_empty()).then(|| {
        html! { @for file in files { (shown(file)) } }
    })
}

fn shown(file: &Attached) -> Markup {
    match file {
        // As an image it can neither run scripts nor ask for anything.
        Attached::Figure(name, svg) => html! {
            figure { img alt=(name) src={"data:image/svg+xml," (percent(svg))}; figcaption { (name) } }
        },
        Attached::Table(name, columns, rows) => {
            let columns: Vec<&str> = columns.iter().map(String::as_str).collect();
            let rows: Vec<Vec<Cell>> = rows
                .iter()
                .map(|row| row.iter().map(|cell| Cell::text(cell.as_str())).collect())
                .collect();
            html! {
                details { summary { (name) ", " (rows.len()) " rows" } (sortable(name, &columns, &rows)) }
            }
        }
    }
}

/// Percent-encoded as far as a data address asks for.
fn percent(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + text.len() / 4);
    for byte in text.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' => out.push(byte as char),
            b' ' | b'-' | b'.' | b',' | b'/' | b':' | b';' | b'=' | b'(' | b')' | b'_' | b'!'
            | b'*' => {
                out.push(byte as char);
            }
            _ => out.push_str(&format!("%{byte:02X}")),
        }
    }
    out
}
