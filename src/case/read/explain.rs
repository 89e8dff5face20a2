//! What the TOML reader found wrong, in our words where we have better ones.
//!
//! Only the help lines depend on the wording of `toml` and serde: a message that is not recognised
//! is passed on as it is, with its place.

use std::ops::Range;

use super::missing::{example, missing_key};
use super::unknown_key::unknown_key;
use crate::case::complaint::{Complaint, Document};

pub(crate) fn explain(document: &Document, error: &toml::de::Error) -> Complaint {
    explained(document, error).in_document(document)
}

fn explained(document: &Document, error: &toml::de::Error) -> Complaint {
    let message = error.message();
    let span = error.span().unwrap_or(0..0);
    if message == "missing field `weight`" && key_of_line(document, span.start) == "live" {
        Complaint::at(span, "a live load of nothing", "no `weight` in here")
            .help("write `live = { weight = [1, 0.3] }`")
    } else if let Some(key) = message.strip_prefix("missing field ") {
        missing_key(span, key.trim_matches('`'))
    } else if message.starts_with("unknown field ") {
        unknown_key(span, message)
    } else if let Some(length) = message.strip_prefix("invalid length ") {
        match length.split_once(", expected ") {
            Some((_, "an array of length 2")) => {
                Complaint::at(span, "not as many as belong here", "here")
                    .help(format!("write two names, as in `{}`", example("between")))
            }
            // A list is read as a table whose keys are not named.
            Some((_, table)) => wrong_type(document, span, &format!("sequence, expected {table}")),
            None => syntax(document, span, message),
        }
    } else if message == "duplicate field `joint`" {
        // The reader does not say where.
        let place = document
            .text
            .find("[[joint]]")
            .map(|at| at..at + "[[joint]]".len());
        Complaint::at(
            place.unwrap_or(span),
            "`joint` beside `joints`",
            "the two are one key",
        )
        .help("write all joints as `[[joint]]`, or all of them in `joints = [...]`")
    } else if message == "duplicate key" {
        let title = format!("the key `{}` is written twice", document.at(span.clone()));
        Complaint::at(span, title, "the second time here").help("remove one of the two")
    } else if let Some(types) = message.strip_prefix("invalid type: ") {
        wrong_type(document, span, types)
    } else {
        syntax(document, span, message)
    }
}

/// `types` is `string "0.65", expected a number`.
fn wrong_type(document: &Document, span: Range<usize>, types: &str) -> Complaint {
    let (found, expected) = types.rsplit_once(", expected ").unwrap_or((types, ""));
    let expected = match expected {
        "a sequence" => "a list",
        other => other,
    };
    // The value itself is underlined below the title, so its type is enough.
    let found = match found.split(' ').next().unwrap_or_default() {
        "map" => "a table",
        "sequence" => "a list",
        "integer" => "a whole number",
        "floating" => "a number with decimals",
        "boolean" => "true or false",
        "string" => "a text in quotes",
        _ => "something else",
    };
    let before = document.text.get(..span.start).unwrap_or_default();
    if (expected, found) == ("a number", "a list") && before.trim_end().ends_with(['[', ',']) {
        let complaint = Complaint::at(
            span,
            "a block has one outline, and no holes",
            "a corner is two numbers",
        );
        return complaint.help("write `corners = [[0, 0], [4, 0], ...]`; a block with a hole is cut into two through it");
    }
    let help = match expected {
        "a list" | "two numbers" => list_help(document, span.start),
        "a string" => text_help(document, span.clone()),
        _ => type_help(document.at(span.clone()), expected),
    };
    let sound = match expected {
        "a number" | "a whole number" | "a coefficient of friction" => "1",
        _ => "",
    };
    Complaint::at(
        span.clone(),
        format!("expected {expected}, found {found}"),
        format!("expected {expected}"),
    )
    .help(help)
    .mended(span, sound)
}

/// What to write instead of `written` where `expected` is wanted.
fn type_help(written: &str, expected: &str) -> String {
    let bare = written.trim_matches(['"', '\'']);
    match expected {
        "a number" | "a whole number" => number_help(written, bare, expected == "a whole number"),
        "courses" => {
            format!(
                "write `{}`, or `courses = 6` with `bond`",
                example("courses")
            )
        }
        "a coefficient of friction" if !written.starts_with('[') => {
            number_help(written, bare, false)
        }
        "a coefficient of friction" => {
            "write `friction = 0.65`, or `friction = { bed = 0.65, head = 0.4, base = 0.5 }`".into()
        }
        "a live load" => "write `live = \"weight\"`, every weight sideways, `live = { weight = [1, 0.3] }`, \
                          0.3 of it upwards too, or `live = \"loads\"`; a live force stands in a `[[load]]`, \
                          as `live = [1.0, 0.0]`"
            .into(),
        "an `[arch]` table" => "write `[arch]` in a line of its own, its keys below".into(),
        "a `[blocks]` table" => "write `[blocks]` in a line of its own, its keys below".into(),
        "a `[[joint]]` table" => {
            format!("write `{}`, or `[[joint]]` in a line of its own", example("joints"))
        }
        "a `[[block]]` or `[[support]]` table" | "a `[[load]]` table" | "a `[[move]]` table" => {
            "write the key in two brackets in a line of its own, `[[block]]`, its keys below".into()
        }
        "a table of pieces" | "a table of a piece" => format!("write `{}`", example("pieces")),
        "a table of the unit's size" => format!("write `{}`", example("unit")),
        _ => format!("write {expected}"),
    }
}

/// The line that byte `at` is in, and where it begins.
fn line_of(text: &str, at: usize) -> Option<(usize, &str)> {
    let start = text.get(..at)?.rfind('\n').map_or(0, |newline| newline + 1);
    Some((start, text[start..].lines().next()?))
}

/// The key of the line that byte `at` is in.
fn key_of_line(document: &Document, at: usize) -> &str {
    let (_, line) = line_of(&document.text, at).unwrap_or_default();
    let key = line.split('=').next().unwrap_or_default();
    key.trim_matches(|c: char| "[] \t\r".contains(c))
}

/// What to write where a text in quotes is wanted: the forms of the key, where it has few.
fn text_help(document: &Document, span: Range<usize>) -> String {
    let key = key_of_line(document, span.start);
    let words = match key {
        "push" => "\"right\"`, `push = \"left\"` or `push = \"both\"",
        "head_joints" => "\"contact\"`, `head_joints = \"open\"` or `head_joints = \"both\"",
        "bond" => "\"running\"",
        "first" => "\"half\"` or `first = \"whole\"",
        _ => {
            let written = document.at(span);
            let bare = written.trim_matches(['"', '\'']);
            return match written.starts_with(['[', '{']) {
                true => format!("write a text in quotes: `{key} = \"...\"`"),
                false => format!("put it in quotes: `\"{bare}\"`"),
            };
        }
    };
    format!("write `{key} = {words}`")
}

/// What to write for the list of a key, which stands before byte `at` in its line.
fn list_help(document: &Document, at: usize) -> String {
    let key = key_of_line(document, at);
    match key {
        "corners" | "along" | "supports" | "between" | "heights" | "open_head_joints"
        | "joints" => {
            format!("write `{}`", example(key))
        }
        // Of the weights, in a table of its own.
        "live" if line_of(&document.text, at).is_some_and(|(_, line)| line.contains('{')) => {
            "write `live = { weight = [1, 0.3] }`".into()
        }
        "at" | "dead" | "live" => format!("write `{key} = [1.0, 0.0]`"),
        "block" | "support" | "load" | "joint" => {
            format!("write `[[{key}]]`, with two brackets, above each {key}")
        }
        "references" => "write `[[references]]`, with two brackets, above each reference".into(),
        _ => "write a list in brackets, such as `[1.0, 0.0]`".into(),
    }
}

fn number_help(written: &str, bare: &str, whole: bool) -> String {
    let point = bare.replace(',', ".");
    match point.parse::<f64>() {
        Ok(_) if bare.contains(',') => format!("write a decimal point and no quotes: `{point}`"),
        Ok(value) if whole && (bare == written || value.fract() != 0.0) => {
            format!(
                "write a whole number, such as `{:.0}`",
                value.clamp(1.0, 1e4)
            )
        }
        Ok(_) => format!("write the number without quotes: `{bare}`"),
        Err(_) if whole => "write a whole number, such as `3`".into(),
        Err(_) => "write a number, such as `0.65`".into(),
    }
}

fn syntax(document: &Document, span: Range<usize>, message: &str) -> Complaint {
    if let Some(comma) = decimal_comma(&document.text, span.start) {
        let point = document.at(comma.clone()).replace(',', ".");
        return Complaint::at(
            comma.clone(),
            "a number with a decimal comma",
            "a comma parts values",
        )
        .help(format!("write a decimal point: `{point}`"))
        .mended(comma, point);
    }
    let rest = document.at(span.start..document.text.len());
    let written = rest.lines().next().unwrap_or_default().trim();
    let word = document.at(span.clone()).trim();
    let unquoted = message.starts_with("string values must be quoted");
    if unquoted && (written.is_empty() || written.starts_with('#')) {
        return Complaint::at(
            span.clone(),
            "a key without a value",
            "nothing behind the `=`",
        )
        .help("write a value behind the `=`, such as `friction = 0.65`")
        .mended(span, "");
    }
    let help = if unquoted && !word.contains([' ', '"', '\'']) {
        format!("put words in quotes: `\"{word}\"`")
    } else {
        let help = SYNTAX.iter().find(|(part, _)| message.contains(part));
        help.map_or(ANY_SYNTAX, |(_, help)| help).into()
    };
    let complaint = Complaint::at(span.clone(), format!("not TOML: {message}"), "here");
    match unquoted && !word.contains([' ', '"', '\'']) {
        true => complaint.help(help).mended(span, format!("\"{word}\"")),
        false => complaint.help(help),
    }
}

const BOTH_SIDES: &str = "write digits on both sides of the decimal point, as in `0.5`";

/// What to write, by a part of the reader's message.
const SYNTAX: [(&str, &str); 6] = [
    (
        "must be quoted",
        "write one value a line, and words in quotes",
    ),
    ("mantissa", BOTH_SIDES),
    ("fraction", BOTH_SIDES),
    ("overflow", "write a number up to 1e12"),
    (
        "escape",
        "write two backslashes for one, or put the text in 'single quotes'",
    ),
    (
        "basic string",
        "end the text with a quotation mark in the same line",
    ),
];

const ANY_SYNTAX: &str =
    "write one `key = value` a line: words in \"quotes\", lists in [ ], remarks behind #";

/// A number with a decimal comma, `= 0,65`, in the line of byte `at` and not behind it.
fn decimal_comma(text: &str, at: usize) -> Option<Range<usize>> {
    let (start, line) = line_of(text, at)?;
    let digit = |byte: Option<&u8>| byte.is_some_and(u8::is_ascii_digit);
    let bytes = line.as_bytes();
    let commas = line.match_indices(',').map(|(comma, _)| comma);
    commas
        .filter(|&comma| start + comma <= at && comma > 0)
        .filter(|&comma| digit(bytes.get(comma - 1)) && digit(bytes.get(comma + 1)))
        .filter_map(|comma| {
            let number = |c: char| c.is_ascii_digit() || "+-._".contains(c);
            let head = line[..comma].trim_end_matches(number);
            let tail = line[comma + 1..].trim_start_matches(|c: char| c.is_ascii_digit());
            head.trim_end()
                .ends_with('=')
                .then(|| start + head.len()..start + line.len() - tail.len())
        })
        .next_back()
}

#[cfg(test)]
mod tests {
    use super::super::file::CaseFile;
    use super::*;

    fn shown(text: &str) -> String {
        let document = Document {
            path: "a.toml".into(),
            text: text.into(),
        };
        let error = toml::from_str::<CaseFile>(text).unwrap_err();
        explain(&document, &error).to_string()
    }

    #[test]
    fn decimal_commas_are_found_in_tables_too() {
        let text = "unit = { length = 4,0, height = 1.75 }";
        assert!(shown(text).contains("write a decimal point: `4.0`"));
        assert!(shown("friction = \"0,65\"").contains("no quotes: `0.65`"));
        assert!(!shown("courses = [1,2\nunit = {}").contains("decimal"));
    }

    #[test]
    fn common_slips_get_help() {
        for (text, help) in [
            ("friction =", "write a value behind the `=`"),
            ("friction = .5", "both sides of the decimal point"),
            ("friction = 1e999", "up to 1e12"),
            ("repeat = 3.0", "such as `3`"),
            ("[references]\nmethod = 'a'", "write `[[references]]`"),
            ("unit = 4", "write `unit = {"),
            ("[[references]]\npush = 'left'", "move `push` up"),
            ("[unit]\nlenght = 1", "did you mean `length`?"),
            ("[arch]\nthickness = 1", "add `mean_radius = "),
            ("[[block]]\nname = 'A'\ncorners = 3", "write `corners = [["),
            ("[block]\nname = 'A'", "write `[[block]]`"),
            ("[blocks]\nsupports = 'A'", "write `supports = ["),
            ("friction = ['a']", "write `friction = 0.65`, or"),
            ("friction = { bad = 1 }", "did you mean `bed`?"),
            ("friction = { head = 1 }", "add `bed = 0.65`"),
            ("arch = 3", "write `[arch]`"),
            ("block = [3]", "write the key in two brackets"),
            ("[[load]]\nblock = 'A'\nat = 3", "write `at = [1.0, 0.0]`"),
        ] {
            let shown = shown(text);
            assert!(shown.contains(help), "{text:?} gives\n{shown}");
        }
    }
}
