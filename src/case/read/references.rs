//! References from a file.

use super::checks::{HEAD_JOINTS, choose, not_negative, positive};
use super::file::ReferenceTable;
use crate::case::complaint::{Complaint, Document};
use crate::case::reference::{Quantity, Reference, SourceKind, known_method_names};
use crate::scene::HeadJoints;

/// Judges a reference of a case that runs with these `head_joints`.
pub(super) fn reference(
    document: &Document,
    table: &ReferenceTable,
    of_case: &[HeadJoints],
) -> Result<Reference, Complaint> {
    let head_joints = match &table.head_joints {
        None => None,
        Some(word) => {
            let words = HEAD_JOINTS.map(|head_joints| (head_joints.name(), head_joints));
            let head_joints = choose(document, "head_joints", words, word)?;
            // It would never be compared with anything, and nobody would notice.
            if !of_case.contains(&head_joints) {
                let title = format!(
                    "the case does not run with {} head joints",
                    head_joints.name()
                );
                return Err(document
                    .complain(word.span(), title, "never compared with a result")
                    .help("write `head_joints = \"both\"` at the top, or drop this reference"));
            }
            Some(head_joints)
        }
    };
    let methods = known_method_names().map(|name| (name, name));
    let kinds = SourceKind::ALL.map(|kind| (kind.name(), kind));
    let quantities = Quantity::ALL.map(|quantity| (quantity.name(), quantity));
    Ok(Reference {
        method: choose(document, "method", methods, &table.method)?.to_owned(),
        head_joints,
        quantity: choose(document, "quantity", quantities, &table.quantity)?,
        value: not_negative(document, "value", &table.value)?,
        tolerance: positive(document, "tolerance", &table.tolerance)?,
        source: table.source.clone(),
        kind: choose(document, "kind", kinds, &table.kind)?,
        note: table.note.clone().unwrap_or_default(),
        deviation: table.deviation.clone(),
    })
}
