//! The form of a case: a coursed wall, explicit blocks, or an arch.

use std::ops::Range;

use toml::Spanned;

use super::arch::arch;
use super::blocks::assembly;
use super::bodies::ReadFile;
use super::explain::missing_key;
use super::file::CaseFile;
use super::wall::wall;
use crate::case::complaint::{Complaint, Document};
use crate::case::geometry::Geometry;

/// The one geometry of a file, and warnings about its courses and about files beside it: the first key
/// that belongs to one form decides which, and a key of another is refused.
pub(super) fn geometry(
    document: &Document,
    file: &CaseFile,
    read_file: ReadFile,
    warnings: &mut Vec<Complaint>,
) -> Result<Geometry, Complaint> {
    let keys = form_keys(file);
    let first = |key: &&FormKey| (key.forms.len(), key.span.start);
    let Some(form) = keys.iter().min_by_key(first).map(|key| key.forms[0]) else {
        return Err(missing_key(document, 0..0, "unit"));
    };
    if let Some(key) = keys.iter().find(|key| !key.forms.contains(&form)) {
        let title = format!("`{}` beside {}", key.name, form.name());
        return Err(document
            .complain(
                key.span.clone(),
                title,
                format!("goes with {}", key.forms[0].name()),
            )
            .help(format!(
                "remove `{}`: a case is either a coursed wall, or blocks, or an arch",
                key.name
            )));
    }
    match form {
        Form::Wall => wall(document, file, warnings).map(Geometry::Wall),
        Form::Blocks => assembly(document, file, read_file, warnings).map(Geometry::Blocks),
        Form::Arch => arch(document, file).map(Geometry::Arch),
    }
}

/// The forms of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Wall,
    Blocks,
    Arch,
}

impl Form {
    fn name(self) -> &'static str {
        match self {
            Form::Wall => "a coursed wall",
            Form::Blocks => "explicit blocks",
            Form::Arch => "an arch",
        }
    }
}

/// A key that belongs to some forms only, the first of them its own.
struct FormKey {
    name: &'static str,
    span: Range<usize>,
    forms: &'static [Form],
}

/// Every such key of the file.
fn form_keys(file: &CaseFile) -> Vec<FormKey> {
    const WALL: &[Form] = &[Form::Wall];
    const BLOCKS: &[Form] = &[Form::Blocks];
    const OF_BLOCKS: &[Form] = &[Form::Blocks, Form::Wall];
    const FORCES: &[Form] = &[Form::Blocks, Form::Arch, Form::Wall];
    let spans = [
        ("unit", WALL, file.unit.as_ref().map(Spanned::span)),
        ("courses", WALL, file.courses.as_ref().map(Spanned::span)),
        ("repeat", WALL, file.repeat.as_ref().map(Spanned::span)),
        ("pieces", WALL, file.pieces.as_ref().map(Spanned::span)),
        ("bond", WALL, file.bond.as_ref().map(Spanned::span)),
        ("units", WALL, file.units.as_ref().map(Spanned::span)),
        ("first", WALL, file.first.as_ref().map(Spanned::span)),
        ("overlap", WALL, file.overlap.as_ref().map(Spanned::span)),
        (
            "overburden",
            WALL,
            file.overburden.as_ref().map(Spanned::span),
        ),
        ("arch", &[Form::Arch], file.arch.as_ref().map(Spanned::span)),
        ("blocks", BLOCKS, file.blocks.as_ref().map(Spanned::span)),
        ("block", OF_BLOCKS, file.block.first().map(Spanned::span)),
        ("support", BLOCKS, file.support.first().map(Spanned::span)),
        ("live", FORCES, file.live.as_ref().map(Spanned::span)),
        ("load", FORCES, file.load.first().map(Spanned::span)),
    ];
    let keys = spans.into_iter().filter_map(|(name, forms, span)| {
        let span = span?;
        Some(FormKey { name, span, forms })
    });
    keys.collect()
}
