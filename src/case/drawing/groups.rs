//! The text of a DXF file: group codes and values, a line each, with their places.
//!
//! Read here and not by the `dxf` crate: that one passes over what it does not know (a HATCH, of which
//! nobody would hear) and keeps no lines, which complaints are to name.

use std::ops::Range;

use crate::case::complaint::{Complaint, Document};

/// A group: a code that says what the value is.
#[derive(Debug)]
pub(super) struct Group<'a> {
    pub code: i32,
    /// The value.
    pub text: &'a str,
    /// Where it stands.
    pub place: Range<usize>,
}

impl Group<'_> {
    /// Whether something of this kind begins here.
    pub fn begins(&self, kind: &str) -> bool {
        self.code == 0 && self.text == kind
    }
}

/// The text of a drawing. DXF before 2007 is in a code page of its time: what is not UTF-8 is read as
/// Latin-1, in which names may look odd and numbers do not.
///
/// # Errors
/// A binary drawing, or one of another format.
pub(super) fn document(path: &str, bytes: &[u8]) -> Result<Document, Complaint> {
    let begins = |with: &[u8]| bytes.starts_with(with);
    let wrong = |what: &str| {
        Err(Complaint::new(format!("{path} is {what}"))
            .help("save the drawing as DXF in text form (ASCII), of any version from R12 on"))
    };
    if begins(b"AutoCAD Binary DXF") {
        return wrong("a DXF in binary form");
    }
    if begins(b"AC10") {
        return wrong("a DWG and not a DXF");
    }
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes.iter().map(|&byte| char::from(byte)).collect(),
    };
    // Some old programs end lines by a carriage return alone.
    let text = match text.contains('\n') {
        true => text,
        false => text.replace('\r', "\n"),
    };
    Ok(Document {
        path: path.to_owned(),
        text: text.into(),
    })
}

/// All groups of a drawing, up to its end.
///
/// # Errors
/// A line where a code is expected and none stands.
pub(super) fn groups(document: &Document) -> Result<Vec<Group<'_>>, Complaint> {
    let mut start = 0;
    let mut lines = document.text.split('\n').map(|line| {
        let at = start;
        start += line.len() + 1;
        let lead = line.len() - line.trim_start().len();
        at + lead..at + lead + line.trim().len()
    });
    let mut groups = Vec::new();
    while let Some(code) = lines.next() {
        let text = document.at(code.clone()).trim_start_matches('\u{feff}');
        if text.is_empty() && groups.is_empty() {
            // An empty line before the first group.
            continue;
        }
        let Ok(number) = text.parse() else {
            if text.is_empty() && lines.all(|line| document.at(line).is_empty()) {
                break;
            }
            let label = "a group code is expected here, a whole number";
            return Err(Complaint::at(code, "not a DXF", label)
                .help("name a DXF in text form (ASCII); save the drawing again if it is one"));
        };
        let Some(place) = lines.next() else {
            let complaint = Complaint::at(code, "a DXF that ends within a group", "no value below");
            return Err(complaint.help(CUT_OFF));
        };
        let group = Group {
            code: number,
            text: document.at(place.clone()),
            place,
        };
        let ends = group.begins("EOF");
        groups.push(group);
        if ends {
            return Ok(groups);
        }
    }
    Err(Complaint::at(AT_THE_END, "a DXF without an end", "no `EOF`").help(CUT_OFF))
}

/// The end of a drawing.
pub(super) const AT_THE_END: Range<usize> = usize::MAX..usize::MAX;

const CUT_OFF: &str = "save the drawing again: the file is cut off";
