//! Corners from a CSV: a header with the columns `block`, `x`, `y` and, where wanted, `weight`, then
//! one corner a row.

use std::collections::HashMap;

use super::checks::{LARGEST, SMALLEST};
use super::outline::Outline;
use super::spreadsheet::{Cell, Decimals, Row, Separator, Table, first_texts, table};
use crate::case::complaint::{Complaint, Document, Place};
use crate::scene::Point;

const COLUMNS: [&str; 5] = ["block", "x", "y", "weight", "layer"];

/// The columns that must be there.
const NEEDED: usize = 3;

const ROWS: &str = "write a header `block,x,y`, then one corner a row, such as `A,0,1.75`; columns \
                    `weight` and `layer` may follow";

/// An outline, and the weight that its rows give it.
pub(super) struct CsvBlock {
    pub outline: Outline,
    pub weight: Option<(f64, Place)>,
    /// The layer of the drawing that it comes from; empty where none is said.
    pub layer: String,
}

/// The outlines of a CSV, in the order of their first rows, and warnings about it. Rows of a block
/// stand together; blank lines and lines that begin with `#` are left out.
pub(super) fn outlines(document: &Document) -> Result<(Vec<CsvBlock>, Vec<Complaint>), Complaint> {
    let (blocks, found) = blocks(document).map_err(|complaint| complaint.in_document(document))?;
    let found = found.map(|complaint| complaint.in_document(document));
    Ok((blocks, found.into_iter().collect()))
}

fn blocks(document: &Document) -> Result<(Vec<CsvBlock>, Option<Complaint>), Complaint> {
    let table = table(document, &COLUMNS, NEEDED, ROWS)?;
    let mut blocks: Vec<CsvBlock> = Vec::new();
    let mut places: HashMap<String, usize> = HashMap::new();
    let mut decimals = Decimals::default();
    for row in &table.rows {
        let corner = corner(&table, row, &mut decimals)?;
        let line = row.line.clone();
        let place = Place::new(document, line.clone());
        let known = places.get(corner.name).copied();
        let block = match known {
            Some(known) if known + 1 == blocks.len() => &mut blocks[known],
            Some(_) => {
                let title = format!("block `{}` comes a second time", corner.name);
                return Err(Complaint::at(line, title, "here again")
                    .help("write the rows of a block one below the other, and each name once"));
            }
            None => {
                places.insert(corner.name.to_owned(), blocks.len());
                blocks.push(CsvBlock {
                    outline: Outline {
                        name: corner.name.to_owned(),
                        place: place.clone(),
                        corners: Vec::new(),
                        places: Vec::new(),
                    },
                    weight: None,
                    layer: corner.layer.to_owned(),
                });
                blocks.last_mut().expect("it was pushed")
            }
        };
        block.outline.corners.push(corner.point);
        block.outline.places.push(place);
        if let Some((weight, cell)) = corner.weight {
            weigh(document, block, weight, cell)?;
        }
    }
    if blocks.is_empty() {
        let complaint = Complaint::at(table.header, "a CSV without corners", "no row below");
        return Err(complaint.help(ROWS));
    }
    Ok((blocks, left_aside(&table)))
}

/// Gives a block the weight in one of its rows, which all rows that have one agree in.
fn weigh(
    document: &Document,
    block: &mut CsvBlock,
    weight: f64,
    cell: &Cell,
) -> Result<(), Complaint> {
    match &block.weight {
        Some((known, _)) if *known != weight => {
            let title = format!("block `{}` has two weights", block.outline.name);
            let label = format!("above it is {known}");
            Err(Complaint::at(cell.place.clone(), title, label)
                .help("write the weight in one row of the block, or the same in all"))
        }
        Some(_) => Ok(()),
        None => {
            block.weight = Some((weight, Place::new(document, cell.place.clone())));
            Ok(())
        }
    }
}

/// A word about columns that are not read.
fn left_aside(table: &Table) -> Option<Complaint> {
    let first = table.others.first()?;
    let title = format!("columns that are not read: {}", first_texts(&table.others));
    let warning = Complaint::at(first.place.clone(), title, "left aside");
    let help = "the columns that count are `block`, `x`, `y`, `weight` and `layer`";
    Some(warning.help(help).into_warning())
}

/// A row.
struct Corner<'a> {
    name: &'a str,
    point: Point,
    weight: Option<(f64, &'a Cell<'a>)>,
    layer: &'a str,
}

fn corner<'a>(
    table: &Table,
    row: &'a Row<'a>,
    decimals: &mut Decimals,
) -> Result<Corner<'a>, Complaint> {
    let most = table
        .columns
        .iter()
        .flatten()
        .max()
        .map_or(0, |last| last + 1);
    let header = table.columns.iter().flatten().count() + table.others.len();
    let too_many = row.cells.iter().skip(header.max(most));
    if row.cells.len() < NEEDED.max(needed(table)) || too_many.clone().any(|c| !c.text.is_empty()) {
        let title = format!("a row of {} columns", row.cells.len());
        let count = header.max(most);
        let help = match table.separator {
            Separator::Comma if row.cells.len() > count => {
                "write numbers with a decimal point, or part the columns by semicolons".to_owned()
            }
            separator => format!("part the cells by {}, as in the header", separator.name()),
        };
        let label = format!("the header has {count}");
        return Err(Complaint::at(row.line.clone(), title, label).help(help));
    }
    let cell = |column: usize| table.columns[column].and_then(|place| row.cells.get(place));
    let [Some(name), Some(x), Some(y)] = [cell(0), cell(1), cell(2)] else {
        let title = format!("a row of {} columns", row.cells.len());
        let complaint = Complaint::at(row.line.clone(), title, "a cell is missing");
        return Err(complaint.help(ROWS));
    };
    if name.text.is_empty() {
        let (title, label) = ("a corner of no block", "no name in its column");
        let complaint = Complaint::at(row.line.clone(), title, label);
        return Err(complaint.help("write the block's name in every row"));
    }
    let mut number = |cell: &Cell, smallest: f64, what: &str| {
        let complain = |title: String, help: String| {
            let complaint = Complaint::at(cell.place.clone(), title, "here");
            Err(complaint.help(help))
        };
        match decimals.number(&cell.text, table.separator) {
            Ok(number) if (smallest..=LARGEST).contains(&number) => Ok(number + 0.0),
            Ok(_) => complain(
                format!("`{}` is no {what}", cell.text),
                format!("write a number from {smallest:e} to {LARGEST:e}"),
            ),
            Err((title, help)) => complain(title, help),
        }
    };
    Ok(Corner {
        name: &name.text,
        point: Point::new(
            number(x, -LARGEST, "coordinate")?,
            number(y, -LARGEST, "coordinate")?,
        ),
        weight: match cell(3).filter(|cell| !cell.text.is_empty()) {
            Some(cell) => Some((number(cell, SMALLEST, "weight")?, cell)),
            None => None,
        },
        layer: cell(4).map_or("", |cell| &cell.text),
    })
}

/// Cells that a row must have for the columns that must be there.
fn needed(table: &Table) -> usize {
    let needed = table.columns[..NEEDED].iter().flatten();
    needed.max().map_or(0, |last| last + 1)
}
