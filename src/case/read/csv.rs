//! Corners from a CSV: a header `block,x,y`, then one corner a row.
//!
//! Read here and not by a CSV crate: names and numbers need no quoting, and a complaint needs the
//! place of every cell, also behind blank lines and remarks.

use std::ops::Range;

use super::checks::LARGEST;
use super::outline::Outline;
use crate::case::complaint::{Complaint, Document, Place, shorten};
use crate::scene::Point;

const HEADER: [&str; 3] = ["block", "x", "y"];

const ROWS: &str = "write a header `block,x,y`, then one corner a row, such as `A,0,1.75`";

/// A cell's text and its place.
type CsvCell<'a> = (&'a str, Range<usize>);

/// The outlines of a CSV, in the order of their first rows. Rows of a block stand together; blank
/// lines and lines that begin with `#` are left out.
pub(super) fn outlines(document: &Document) -> Result<Vec<Outline>, Complaint> {
    let mut rows = rows(document);
    let Some((line, header)) = rows.next() else {
        let complaint = document.complain(0..0, "a CSV without rows", "nothing in here");
        return Err(complaint.help(ROWS));
    };
    let names: Vec<&str> = header.iter().map(|(text, _)| *text).collect();
    if names != HEADER {
        return Err(document
            .complain(
                line,
                "the header of the CSV is not `block,x,y`",
                "the first row",
            )
            .help(ROWS));
    }
    let mut outlines: Vec<Outline> = Vec::new();
    for (line, cells) in rows {
        let (name, corner) = corner(document, line.clone(), &cells)?;
        let place = Place::new(document, line.clone());
        match outlines.iter().position(|outline| outline.name == name) {
            Some(known) if known + 1 == outlines.len() => {
                outlines[known].corners.push(corner);
                outlines[known].places.push(place);
            }
            Some(_) => {
                return Err(document
                    .complain(
                        line,
                        format!("block `{name}` comes a second time"),
                        "here again",
                    )
                    .help("write the rows of a block one below the other, and each name once"));
            }
            None => outlines.push(Outline {
                name: name.to_owned(),
                place: place.clone(),
                corners: vec![corner],
                places: vec![place],
            }),
        }
    }
    if outlines.is_empty() {
        let complaint = document.complain(line, "a CSV without corners", "no row below");
        return Err(complaint.help(ROWS));
    }
    Ok(outlines)
}

/// Name and corner of a row.
fn corner<'a>(
    document: &Document,
    line: Range<usize>,
    cells: &[CsvCell<'a>],
) -> Result<(&'a str, Point), Complaint> {
    let [(name, _), x, y] = cells else {
        let title = format!("a row of {} columns", cells.len());
        let help = match cells.len() {
            4 | 5 => "write three, `block,x,y`, and numbers with a decimal point, not a comma",
            _ => "write three: `block,x,y`",
        };
        return Err(document
            .complain(line, title, "three are expected")
            .help(help));
    };
    if name.is_empty() {
        return Err(document
            .complain(line, "a corner of no block", "no name in the first column")
            .help("write the block's name in every row"));
    }
    Ok((
        name,
        Point::new(coordinate(document, x)?, coordinate(document, y)?),
    ))
}

fn coordinate(document: &Document, (text, place): &CsvCell) -> Result<f64, Complaint> {
    let complain = |title: String, help: String| {
        let complaint = document.complain(place.clone(), title, "here");
        Err(complaint.help(help))
    };
    match text.parse::<f64>() {
        Ok(number) if number.abs() <= LARGEST => Ok(number + 0.0),
        Ok(_) => complain(
            format!("`{text}` is no coordinate"),
            format!("write a number from -{LARGEST:e} to {LARGEST:e}"),
        ),
        Err(_) => complain(
            format!("`{}` is not a number", shorten(text, 60)),
            "write a number with a decimal point, such as `1.75`".into(),
        ),
    }
}

/// Rows with their places and cells, from the header on.
fn rows(document: &Document) -> impl Iterator<Item = (Range<usize>, Vec<CsvCell<'_>>)> {
    let mut start = 0;
    let lines = document.text.split('\n').map(move |line| {
        let at = start;
        start += line.len() + 1;
        (at, line.trim_end_matches('\r'))
    });
    let lines = lines.map(|(at, line)| match line.strip_prefix('\u{feff}') {
        // A byte order mark, as spreadsheets write it.
        Some(rest) if at == 0 => (line.len() - rest.len(), rest),
        _ => (at, line),
    });
    let rows = lines.filter(|(_, line)| !(line.trim().is_empty() || line.trim().starts_with('#')));
    rows.map(|(at, line)| {
        let mut begin = at;
        let cells = line.split(',').map(|cell| {
            let lead = cell.len() - cell.trim_start().len();
            let text = cell.trim();
            let place = begin + lead..begin + lead + text.len();
            begin += cell.len() + 1;
            (text, place)
        });
        (at..at + line.len(), cells.collect())
    })
}
