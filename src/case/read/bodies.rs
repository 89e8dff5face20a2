//! The blocks and supports of a file: gathered from the CSV and from inline tables, each named once.

use std::collections::HashMap;

use toml::Spanned;

use super::checks::{MOST_BLOCKS, Written, coordinates, not_negative, positive, unknown};
use super::csv::{CsvBlock, outlines};
use super::file::{BlocksTable, BodyTable, CaseFile};
use super::missing::missing_key;
use super::outline::Outline;
use super::values::{Number, Pair};
use crate::case::complaint::{Complaint, Document, Place};
use crate::scene::Point;

/// Reads the file of this name in the folder of a case; the error says in words why it cannot.
pub type ReadFile<'a> = &'a dyn Fn(&str) -> Result<Vec<u8>, String>;

/// A block or a support.
pub(super) struct Body {
    pub outline: Outline,
    /// The layer of the drawing that it comes from; empty where none is said.
    pub layer: String,
    pub weight: Option<(f64, Place)>,
    /// Weight over area and thickness, where that is given.
    pub specific_weight: Option<(f64, Place)>,
    pub friction: Option<(f64, Place)>,
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

/// All bodies, those of the CSV first; at least one moves and one does not.
pub(super) fn bodies(
    document: &Document,
    file: &CaseFile,
    read_file: ReadFile,
    warnings: &mut Vec<Complaint>,
) -> Result<Vec<Body>, Complaint> {
    let table = file.blocks.as_ref();
    let mut bodies = Bodies::default();
    let csv = table.and_then(|table| table.get_ref().csv.as_ref());
    if let Some(csv) = csv {
        let (blocks, found) = outlines(&csv_beside(document, csv, read_file)?)?;
        warnings.extend(found);
        for CsvBlock {
            outline,
            weight,
            layer,
        } in blocks
        {
            bodies.push(Body {
                outline,
                layer,
                weight,
                specific_weight: None,
                friction: None,
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
        hold(&mut bodies, table.get_ref())?;
    }
    let bodies = bodies.list;
    not_too_many(&bodies)?;
    nothing_of_a_support(&bodies)?;
    let place = |moves: bool| bodies.iter().find(|body| body.moves == moves);
    match (place(true), place(false)) {
        (Some(_), Some(_)) => Ok(bodies),
        (Some(body), None) => {
            let label = "this block, as all others, may move";
            Err(body.outline.place.complain("no support", label).help(
                "add a `[[support]]` with corners, or name blocks that never move: \
                 `supports = [\"ground\"]` in `[blocks]`",
            ))
        }
        (None, Some(body)) => {
            let label = "this body, as all others, is a support";
            let complaint = body.outline.place.complain("no block may move", label);
            Err(complaint.help("add a `[[block]]`, or take one out of `supports`"))
        }
        (None, None) => {
            let place = table.map_or(0..0, Spanned::span);
            let complaint = Complaint::at(place, "no blocks", "neither a CSV nor `[[block]]`");
            Err(complaint
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

fn nothing_of_a_support(bodies: &[Body]) -> Result<(), Complaint> {
    for body in bodies.iter().filter(|body| !body.moves) {
        // The weights of a CSV stand in a column, also beside its supports.
        let weight = body.weight.as_ref().filter(|_| !body.of_csv);
        let help = "write it as `base` of the case's `friction`, or in a `[[joint]]` between it and a block";
        let never = [
            ("weight", weight, "remove the weight"),
            (
                "specific weight",
                body.specific_weight.as_ref(),
                "remove the specific weight",
            ),
            ("friction", body.friction.as_ref(), help),
        ];
        for (what, value, help) in never {
            if let Some((_, place)) = value {
                let title = format!("`{}` is a support", body.outline.name);
                let complaint = place.complain(title, format!("its {what} is never used"));
                return Err(complaint.help(help));
            }
        }
    }
    Ok(())
}

fn csv_beside(
    document: &Document,
    csv: &Spanned<String>,
    read_file: ReadFile,
) -> Result<Document, Complaint> {
    let name = csv.get_ref().as_str();
    let complain = |title: String, help: &str| Err(csv.wrong(title, "here").help(help));
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
        return Err(missing_key(table.span(), "name"));
    };
    let name = short_name(written)?;
    no_course(body)?;
    let centre = body.centre.as_ref();
    let centre = centre.map(|pair| coordinates(pair, "a centre"));
    let centre = centre.transpose()?;
    let placed = |key, value: &Option<Spanned<Number>>, check: Check| match value {
        Some(value) => Ok(Some((
            check(key, value)?,
            Place::new(document, value.span()),
        ))),
        None => Ok(None),
    };
    one_weight(body)?;
    let weight = placed("weight", &body.weight, positive)?;
    let specific_weight = placed("specific_weight", &body.specific_weight, positive)?;
    let friction = placed("friction", &body.friction, not_negative)?;
    let gives = [
        weight.is_some() || specific_weight.is_some(),
        centre.is_some(),
        friction.is_some(),
    ];
    let twice = |known: &Body| {
        let has = [
            known.weight.is_some() || known.specific_weight.is_some(),
            known.centre.is_some(),
            known.friction.is_some(),
        ];
        gives.iter().zip(has).any(|(gives, has)| *gives && has)
    };
    let again = |title: String| written.wrong(title, "here again");
    match (&body.corners, bodies.named(name)) {
        (Some(corners), None) => bodies.push(Body {
            outline: inline_outline(document, written, corners.get_ref())?,
            layer: String::new(),
            weight,
            specific_weight,
            friction,
            centre,
            moves,
            of_csv: false,
        }),
        (Some(_), Some(known)) => {
            let rows = known.outline.rows();
            return Err(again(format!("two bodies are named `{name}`"))
                .help(format!("rename one; the other is at {rows}")));
        }
        (None, Some(known)) if gives.contains(&true) && !twice(known) => {
            known.weight = weight.or(known.weight.take());
            known.specific_weight = specific_weight.or(known.specific_weight.take());
            known.friction = friction.or(known.friction.take());
            known.centre = centre.or(known.centre);
        }
        (None, Some(_)) => {
            return Err(again(format!("`{name}` is there already")).help(
                "without corners this table may give the block of the CSV its weight, the centre of it \
                 and its friction, once",
            ));
        }
        (None, None) if !csv => return Err(missing_key(written.span(), "corners")),
        (None, None) => return Err(unknown("block", written, bodies.names())),
    }
    Ok(())
}

/// Refuses a weight in two forms.
pub(super) fn one_weight(body: &BodyTable) -> Result<(), Complaint> {
    match (&body.specific_weight, &body.weight) {
        (Some(value), Some(_)) => {
            let complaint = value.wrong("`specific_weight` beside `weight`", "which of the two?");
            Err(complaint.help("remove one of them"))
        }
        _ => Ok(()),
    }
}

/// What a number of a key has to be.
type Check = fn(&str, &Spanned<Number>) -> Result<f64, Complaint>;

/// Refuses what places a block in a course.
fn no_course(body: &BodyTable) -> Result<(), Complaint> {
    let keys = [("course", &body.course), ("piece", &body.piece)];
    for (key, value) in keys {
        if let Some(value) = value {
            let title = format!("`{key}` of an explicit block");
            let complaint = value.wrong(title, "goes with a coursed wall");
            return Err(complaint.help(format!("remove `{key}`")));
        }
    }
    Ok(())
}

/// The name without spaces around it.
pub(super) fn short_name(name: &Spanned<String>) -> Result<&str, Complaint> {
    let trimmed = name.get_ref().trim();
    let count = trimmed.chars().count();
    if (1..=60).contains(&count) && !trimmed.chars().any(char::is_control) {
        return Ok(trimmed);
    }
    Err(name
        .wrong("a name that names nothing", "here")
        .help("write a short name, such as `\"A\"`"))
}

/// The outline of the corners in a `[[block]]` or `[[support]]`.
fn inline_outline(
    document: &Document,
    name: &Spanned<String>,
    corners: &[Spanned<Pair>],
) -> Result<Outline, Complaint> {
    let corner = |pair| coordinates(pair, "a corner");
    let place = |pair: &Spanned<Pair>| Place::new(document, pair.span());
    Ok(Outline {
        name: name.get_ref().trim().to_owned(),
        place: Place::new(document, name.span()),
        corners: corners.iter().map(corner).collect::<Result<_, _>>()?,
        places: corners.iter().map(place).collect(),
    })
}

/// Turns the blocks of `supports` into supports.
fn hold(bodies: &mut Bodies, table: &BlocksTable) -> Result<(), Complaint> {
    for word in &table.supports {
        let Some(body) = bodies.named(word.get_ref()) else {
            return Err(unknown("block", word, bodies.names()));
        };
        if !std::mem::replace(&mut body.moves, false) {
            let title = format!("`{}` is a support already", word.get_ref());
            let complaint = word.wrong(title, "here again");
            return Err(complaint.help("name each support once"));
        }
    }
    Ok(())
}
