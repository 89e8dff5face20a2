//! References from a file.

use toml::Spanned;

use super::checks::{HEAD_JOINTS, Written, choose, not_negative, positive};
use super::file::ReferenceTable;
use crate::case::complaint::{Complaint, shorten};
use crate::case::outside_name::outside_name;
use crate::case::printable::printable;
use crate::case::reference::{Quantity, Reference, SourceKind, known_method_names};
use crate::case::suggestion::{listed, nearest};
use crate::scene::HeadJoints;

/// Judges a reference of a case that runs with these `head_joints`, and of which a support moves or not.
pub(super) fn reference(
    table: &ReferenceTable,
    of_case: &[HeadJoints],
    moves: bool,
) -> Result<Reference, Complaint> {
    let head_joints = match &table.head_joints {
        None => None,
        Some(word) => {
            let words = HEAD_JOINTS.map(|head_joints| (head_joints.name(), head_joints));
            let head_joints = choose("head_joints", words, word)?;
            // It would never be compared with anything, and nobody would notice.
            if !of_case.contains(&head_joints) {
                let title = format!(
                    "the case does not run with {} head joints",
                    head_joints.name()
                );
                return Err(word
                    .wrong(title, "never compared with a result")
                    .help("write `head_joints = \"both\"` at the top, or drop this reference"));
            }
            Some(head_joints)
        }
    };
    let kinds = SourceKind::ALL.map(|kind| (kind.name(), kind));
    let quantities = Quantity::ALL.map(|quantity| (quantity.name(), quantity));
    let quantity = choose("quantity", quantities, &table.quantity)?;
    if quantity == Quantity::Reaction && !moves {
        let complaint = table
            .quantity
            .wrong("no support moves", "never compared with a result");
        return Err(complaint.help("add a `[[move]]`, or write `quantity = \"lambda\"`"));
    }
    Ok(Reference {
        method: method(&table.method)?,
        head_joints,
        quantity,
        value: not_negative("value", &table.value)?,
        tolerance: positive("tolerance", &table.tolerance)?,
        source: printable(&table.source),
        kind: choose("kind", kinds, &table.kind)?,
        note: printable(table.note.as_deref().unwrap_or_default()),
        deviation: table.deviation.as_deref().map(printable),
    })
}

/// A method of our own, or the name of an outside program, which a run may or may not be given. A
/// word that is nearly a method's is taken for a slip of the keyboard.
fn method(word: &Spanned<String>) -> Result<String, Complaint> {
    let name = word.get_ref();
    if known_method_names().any(|known| known == name) {
        return Ok(name.clone());
    }
    let title = format!("unknown method `{}`", shorten(name, 60));
    let complaint = word.wrong(title, "no method, and no name of a program");
    if let Some(near) = nearest(name, known_method_names()) {
        return Err(complaint
            .help(format!(
                "did you mean `method = \"{near}\"`? A program of yours needs a name that is less like it"
            ))
            .mended(word.span(), format!("\"{near}\"")));
    }
    if let Err(help) = outside_name(name) {
        let known = listed(known_method_names());
        return Err(complaint.help(format!("the methods are {known}; for a program, {help}")));
    }
    Ok(name.clone())
}
