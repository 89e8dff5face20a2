//! The sweep file as TOML has it. Every value keeps its span, so that a complaint can point at it.

use std::collections::BTreeMap;

use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserialize, MapAccess, SeqAccess};
use toml::{Spanned, Table, Value};

use crate::case::{Complaint, Document, explain, listed, nearest, read_by_visitor};

#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File {
    pub title: Option<String>,
    pub source: Option<String>,
    pub case: Spanned<CaseSource>,
    pub head_joints: Option<Spanned<String>>,
    pub methods: Option<Spanned<WordList>>,
    #[serde(default)]
    pub settings: BTreeMap<Spanned<String>, Spanned<Scalar>>,
    #[serde(default)]
    pub vary: Vec<BTreeMap<Spanned<String>, Spanned<Values>>>,
}

#[derive(Debug)]
pub(super) enum CaseSource {
    Named(Vec<Spanned<String>>),
    /// A case written into the sweep.
    Inline(Table),
    One(String),
}

#[derive(Debug)]
pub(super) struct WordList(pub Vec<Spanned<String>>);

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Scalar(pub Value);

/// What a key runs through.
#[derive(Debug)]
pub(super) enum Values {
    List(Vec<Spanned<Scalar>>),
    /// Evenly from one number to another.
    ValueRange(ValueRange),
}

/// `{ from = 0, to = 10, count = 40 }`.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ValueRange {
    pub from: Spanned<Scalar>,
    pub to: Spanned<Scalar>,
    pub count: Spanned<Scalar>,
    pub spacing: Option<Spanned<String>>,
}

/// Reads the text; no value in it has been judged yet.
pub(super) fn parse(document: &Document) -> Result<File, Complaint> {
    toml::from_str(&document.text).map_err(|error| complaint(document, &error))
}

/// The keys at the top of a sweep file.
const KEYS: [&str; 7] = [
    "title",
    "source",
    "case",
    "head_joints",
    "methods",
    "settings",
    "vary",
];

/// What the TOML reader found wrong, in the words of a sweep.
fn complaint(document: &Document, error: &toml::de::Error) -> Complaint {
    let span = error.span().unwrap_or(0..0);
    // unknown field `a`, expected one of `b`, `c`: every second piece is a word.
    let words: Vec<&str> = error.message().split('`').skip(1).step_by(2).collect();
    let (key, known) = words.split_first().unwrap_or((&"", &[]));
    if error.message().starts_with("unknown field ") {
        let in_range = known.contains(&"from");
        let dotted = span.start > 0 && document.text.as_bytes().get(span.start - 1) == Some(&b'.');
        let help = if in_range && dotted {
            format!("put a key with a dot in quotes, such as `\"unit.{key}\" = [4.0, 5.0]`")
        } else if let Some(near) = nearest(key, known.iter().copied()) {
            format!("did you mean `{near}`?")
        } else if in_range {
            "write a range as `{ from = 0, to = 10, count = 40 }`".into()
        } else if KEYS.contains(key) {
            format!("move `{key}` up, above the first line that begins with `[`")
        } else {
            format!(
                "to vary a key of the case, put `{key} = [...]` under `[[vary]]`; the keys here are {}",
                listed(known.iter().copied())
            )
        };
        return Complaint::at(span, format!("unknown key `{key}`"), "no such key here").help(help);
    }
    if error.message().starts_with("missing field ") {
        let (title, help) = match *key {
            "case" => (
                "a sweep without a case",
                "add `case = \"paper-1\"`, or a table `[case]`",
            ),
            _ => (
                "an incomplete range",
                "write a range as `{ from = 0, to = 10, count = 40 }`",
            ),
        };
        let first_line = 0..document.text.lines().next().map_or(0, str::len);
        let span = if *key == "case" { first_line } else { span };
        return Complaint::at(span, title, format!("`{key}` is missing")).help(help);
    }
    if let Some(types) = error.message().strip_prefix("invalid type: ")
        && let Some((_, expected)) = types.rsplit_once(", expected ")
        && let Some((_, help)) = EXPECTED.iter().find(|(known, _)| *known == expected)
    {
        let title = format!("expected {expected}");
        return Complaint::at(span, title, "not this").help(*help);
    }
    explain(document, error)
}

const A_CASE: &str = "a case";
const WORDS: &str = "a list of words";
const VALUES: &str = "a list of values or a range";
const SCALAR: &str = "a number, a word, true or false";

/// What to write where something else is expected.
const EXPECTED: [(&str, &str); 6] = [
    (
        A_CASE,
        "write `case = \"paper-1\"`, a list of cases, or a table `[case]`",
    ),
    (WORDS, "write `methods = [\"associative\", \"interval\"]`"),
    (
        VALUES,
        "write `[0.4, 0.5]`, or `{ from = 0, to = 10, count = 40 }`",
    ),
    (SCALAR, "write one value, such as `0.65` or `\"running\"`"),
    (
        "a sequence",
        "write `[[vary]]`, with two brackets, above the keys that vary together",
    ),
    ("a map", "write `key = value` lines below it"),
];

read_by_visitor!(CaseSource, A_CASE, {
    fn visit_str<E>(self, text: &str) -> Result<CaseSource, E> {
        Ok(CaseSource::One(text.to_owned()))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, items: A) -> Result<CaseSource, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(items)).map(CaseSource::Named)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<CaseSource, A::Error> {
        Table::deserialize(MapAccessDeserializer::new(map)).map(CaseSource::Inline)
    }
});

read_by_visitor!(WordList, WORDS, {
    fn visit_seq<A: SeqAccess<'de>>(self, items: A) -> Result<WordList, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(items)).map(WordList)
    }
});

read_by_visitor!(Scalar, SCALAR, {
    fn visit_bool<E>(self, value: bool) -> Result<Scalar, E> {
        Ok(Scalar(Value::Boolean(value)))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Scalar, E> {
        Ok(Scalar(Value::Integer(value)))
    }

    fn visit_f64<E>(self, value: f64) -> Result<Scalar, E> {
        Ok(Scalar(Value::Float(value)))
    }

    fn visit_str<E>(self, text: &str) -> Result<Scalar, E> {
        Ok(Scalar(Value::String(text.to_owned())))
    }
});

read_by_visitor!(Values, VALUES, {
    fn visit_seq<A: SeqAccess<'de>>(self, items: A) -> Result<Values, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(items)).map(Values::List)
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<Values, A::Error> {
        ValueRange::deserialize(MapAccessDeserializer::new(map)).map(Values::ValueRange)
    }
});
