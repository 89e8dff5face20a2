//! The form of a case: a coursed wall, explicit blocks, or an arch.

use super::arch::arch;
use super::blocks::assembly;
use super::bodies::ReadFile;
use super::file::{CaseFile, Form, FormKey};
use super::missing::missing_key;
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
    let keys = file.form_keys();
    let first = |key: &&FormKey| (key.forms.len(), key.span.start);
    let Some(form) = keys.iter().min_by_key(first).map(|key| key.forms[0]) else {
        return Err(missing_key(0..0, "unit"));
    };
    if let Some(FormKey {
        name, forms, span, ..
    }) = keys.iter().find(|key| !key.forms.contains(&form))
    {
        let title = format!("`{name}` beside {}", form.name());
        let goes: Vec<&str> = forms.iter().map(|form| form.name()).collect();
        let label = format!("goes with {}", goes.join(" or "));
        return Err(Complaint::at(span.clone(), title, label).help(format!(
            "remove `{name}`: a case is either a coursed wall, or blocks, or an arch"
        )));
    }
    match form {
        Form::Wall => wall(document, file, warnings).map(Geometry::Wall),
        Form::Blocks => assembly(document, file, read_file, warnings).map(Geometry::Blocks),
        Form::Arch => arch(file).map(Geometry::Arch),
    }
}
