//! The blocks and supports of a file: gathered from the CSV and from inline tables, each named once.

use std::collections::HashMap;

use toml::Spanned;

use super::checks::{MOST_BLOCKS, coordinates, positive, unknown_block};
use super::csv::{CsvBlock, outlines};
use super::explain::missing_key;
use super::file::{BlocksTable, BodyTable, CaseFile};
use super::outline::Outline;
use super::values::Pair;
use crate::case::complaint::{Complaint, Document, Place};
use crate::scene::Point;

/// Reads the file of this name in the folder of a case; the error says in words why it cannot.
pub type ReadFile<'a> = &'a dyn Fn(&str) -> Result<Vec<u8>, String>;

/// A block or a support.
pub(super) struct Body {
    pub outline: Outline,
    /// The weight and its place, where it is given.
    pub weight: Option<(f64, Place)>,
    /// Where the weight acts, where it is not the centroid.
    pub centre: Option<Point>,
    pub moves: bool,
    /// Whether its weight stands in a CSV.
    of_csv: bool,
}

/// Bodies in order, each found by its name.
#[derive(Default)]
struct Bodies {
    list: Vec<Body>,
    places: HashMap<String, usize>,
}

impl Bodies {
    fn push(&mut self, body: Body) {
        let name = body.outline.name.clone();
        self.places.insert(name, self.list.len());
        self.list.push(body);
    }

    fn named(&mut self, name: &str) -> Option<&mut Body> {
        let place = *self.places.get(name)?;
        Some(&mut self.list[place])
    }

    fn names(&self) -> impl Iterator<Item = &str> + Clone {
        self.list.iter().map(|body| body.outline.name.as_str())
    }
}

/// All bodies, those of the CSV first, and warnings about it; at least one moves and one does not.
pub(super) fn bodies(
    document: &Document,
    file: &CaseFile,
    read_file: ReadFile,
) -> Result<(Vec<Body>, Vec<Complaint>), Complaint> {
    let table = file.blocks.as_ref();
    let mut bodies = Bodies::default();
    let mut warnings = Vec::new();
    let csv = table.and_then(|table| table.get_ref().csv.as_ref());
    if let Some(csv) = csv {
        let (blocks, found) = outlines(&csv_beside(document, csv, read_file)?)?;
        warnings = found;
        for CsvBlock { outline, weight } in blocks {
            bodies.push(Body {
                outline,
                weight,
                centre: None,
                moves: true,
                of_csv: true,
            });
        }
    }
    let inline = (file.block.iter().map(|body| (body, true)))
        .chain(file.support.iter().map(|body| (body, false)));
    for (body, moves) in inline {
        add(document, &mut bodies, body, moves, csv.is_some())?;
    }
    if let Some(table) = table {
        hold(document, &mut bodies, table.get_ref())?;
    }
    let bodies = bodies.list;
    not_too_many(&bodies)?;
    no_weight_of_a_support(&bodies)?;
    let place = |moves: bool| bodies.iter().find(|body| body.moves == moves);
    match (place(true), place(false)) {
        (Some(_), Some(_)) => Ok((bodies, warnings)),
        (Some(body), None) => Err(no_support(&body.outline.place)),
        (None, Some(body)) => Err(nothing_moves(&body.outline.place)),
        (None, None) => {
            let place = table.map_or(0..0, Spanned::span);
            Err(document
                .complain(place, "no blocks", "neither a CSV nor `[[block]]`")
                .help("add `csv = \"blocks.csv\"` to `[blocks]`, or a `[[block]]` with corners"))
        }
    }
}

fn not_too_many(bodies: &[Body]) -> Result<(), Complaint> {
    let Some(body) = bodies.get(MOST_BLOCKS) else {
        return Ok(());
    };
    let title = format!("more than {MOST_BLOCKS} blocks");
    let complaint = body.outline.place.complain(title, "the first too many");
    Err(complaint.help("write fewer blocks"))
}

fn no_weight_of_a_support(bodies: &[Body]) -> Result<(), Complaint> {
    for body in bodies.iter().filter(|body| !body.moves) {
        // The weights of a CSV stand in a column, also beside its supports.
        if let Some((_, place)) = body.weight.as_ref().filter(|_| !body.of_csv) {
            let title = format!("`{}` is a support", body.outline.name);
            return Err(place
                .complain(title, "its weight is never used")
                .help("remove the weight"));
        }
    }
    Ok(())
}

fn no_support(block: &Place) -> Complaint {
    block
        .complain("no support", "this block, as all others, may move")
        .help(
            "add a `[[support]]` with corners, or name blocks that never move: \
             `supports = [\"ground\"]` in `[blocks]`",
        )
}

fn nothing_moves(support: &Place) -> Complaint {
    let label = "this body, as all others, is a support";
    support
        .complain("no block may move", label)
        .help("add a `[[block]]`, or take one out of `supports`")
}

/// The CSV beside the case.
fn csv_beside(
    document: &Document,
    csv: &Spanned<String>,
    read_file: ReadFile,
) -> Result<Document, Complaint> {
    let name = csv.get_ref().as_str();
    let complain = |title: String, help: &str| {
        let complaint = document.complain(csv.span(), title, "here");
        Err(complaint.help(help))
    };
    if name.is_empty() || name.contains(['/', '\\']) || name.starts_with('.') {
        let title = format!("`{name}` is no file beside the case");
        return complain(
            title,
            "put the CSV into the folder of the case and write its bare name",
        );
    }
    let path = match document.path.rfind(['/', '\\']) {
        Some(folder) => format!("{}{name}", &document.path[..=folder]),
        None => name.to_owned(),
    };
    match read_file(name) {
        Ok(bytes) => Document::read(&path, &bytes),
        Err(why) => complain(
            format!("cannot read {path}: {why}"),
            "put the CSV into the folder of the case; it holds rows `block,x,y`",
        ),
    }
}

/// Adds an inline body, or its weight to the one of the CSV, where there is a `csv`.
fn add(
    document: &Document,
    bodies: &mut Bodies,
    table: &Spanned<BodyTable>,
    moves: bool,
    csv: bool,
) -> Result<(), Complaint> {
    let body = table.get_ref();
    let Some(written) = &body.name else {
        return Err(missing_key(document, table.span(), "name"));
    };
    let name = short_name(document, written)?;
    no_course(document, body)?;
    let centre = body.centre.as_ref();
    let centre = centre.map(|pair| coordinates(document, pair, "a centre"));
    let centre = centre.transpose()?;
    let weight = match &body.weight {
        None => None,
        Some(value) => {
            let weight = positive(document, "weight", value)?;
            Some((weight, Place::new(document, value.span())))
        }
    };
    let gives = weight.is_some() || centre.is_some();
    let twice = |known: &Body| {
        (weight.is_some() && known.weight.is_some()) || (centre.is_some() && known.centre.is_some())
    };
    let again = |title: String| document.complain(written.span(), title, "here again");
    match (&body.corners, bodies.named(name)) {
        (Some(corners), None) => bodies.push(Body {
            outline: inline_outline(document, written, corners.get_ref())?,
            weight,
            centre,
            moves,
            of_csv: false,
        }),
        (Some(_), Some(known)) => {
            let rows = known.outline.rows();
            return Err(again(format!("two bodies are named `{name}`"))
                .help(format!("rename one; the other is at {rows}")));
        }
        (None, Some(known)) if gives && !twice(known) => {
            known.weight = weight.or(known.weight.take());
            known.centre = centre.or(known.centre);
        }
        (None, Some(_)) => {
            return Err(again(format!("`{name}` is there already")).help(
                "without corners this table may give the block of the CSV its weight and the centre of \
                 it, once",
            ));
        }
        (None, None) if !csv => return Err(missing_key(document, written.span(), "corners")),
        (None, None) => {
            return Err(unknown_block(document, written, bodies.names()));
        }
    }
    Ok(())
}

/// Refuses what places a block in a course.
fn no_course(document: &Document, body: &BodyTable) -> Result<(), Complaint> {
    let keys = [("course", &body.course), ("piece", &body.piece)];
    for (key, value) in keys {
        if let Some(value) = value {
            let title = format!("`{key}` of an explicit block");
            return Err(document
                .complain(value.span(), title, "goes with a coursed wall")
                .help(format!("remove `{key}`")));
        }
    }
    Ok(())
}

/// The name without spaces around it.
pub(super) fn short_name<'a>(
    document: &Document,
    name: &'a Spanned<String>,
) -> Result<&'a str, Complaint> {
    let trimmed = name.get_ref().trim();
    let count = trimmed.chars().count();
    if (1..=60).contains(&count) && !trimmed.chars().any(char::is_control) {
        return Ok(trimmed);
    }
    Err(document
        .complain(name.span(), "a name that names nothing", "here")
        .help("write a short name, such as `\"A\"`"))
}

/// The outline of the corners in a `[[block]]` or `[[support]]`.
fn inline_outline(
    document: &Document,
    name: &Spanned<String>,
    corners: &[Spanned<Pair>],
) -> Result<Outline, Complaint> {
    let corner = |pair| coordinates(document, pair, "a corner");
    let place = |pair: &Spanned<Pair>| Place::new(document, pair.span());
    Ok(Outline {
        name: name.get_ref().trim().to_owned(),
        place: Place::new(document, name.span()),
        corners: corners.iter().map(corner).collect::<Result<_, _>>()?,
        places: corners.iter().map(place).collect(),
    })
}

/// Turns the blocks of `supports` into supports.
fn hold(document: &Document, bodies: &mut Bodies, table: &BlocksTable) -> Result<(), Complaint> {
    for word in &table.supports {
        let Some(body) = bodies.named(word.get_ref()) else {
            return Err(unknown_block(document, word, bodies.names()));
        };
        if !std::mem::replace(&mut body.moves, false) {
            let title = format!("`{}` is a support already", word.get_ref());
            return Err(document
                .complain(word.span(), title, "here again")
                .help("name each support once"));
        }
    }
    Ok(())
}
