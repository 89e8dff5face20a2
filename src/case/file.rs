//! The case file as TOML has it. Every value keeps its span, so that a complaint can point at it.

use std::fmt;

use serde::de::{Deserialize, Deserializer, SeqAccess, Visitor};
use toml::Spanned;

use super::complaint::{Complaint, Document};
use super::explain::explain;

/// A whole file.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File {
    pub title: Option<String>,
    pub source: Option<String>,
    pub unit: Spanned<Unit>,
    pub courses: Spanned<Courses>,
    pub repeat: Option<Spanned<Whole>>,
    pub bond: Option<Spanned<String>>,
    pub units: Option<Spanned<Whole>>,
    pub first: Option<Spanned<String>>,
    pub overlap: Option<Spanned<Number>>,
    pub friction: Spanned<Number>,
    pub overburden: Option<Spanned<Number>>,
    pub head_joints: Option<Spanned<String>>,
    pub push: Option<Spanned<String>>,
    #[serde(default)]
    pub references: Vec<Reference>,
}

/// The keys of [`File`], to tell a key in the wrong table from one that does not exist.
pub(super) const CASE_KEYS: [&str; 14] = [
    "title",
    "source",
    "unit",
    "courses",
    "repeat",
    "bond",
    "units",
    "first",
    "overlap",
    "friction",
    "overburden",
    "head_joints",
    "push",
    "references",
];

/// What every unit is like.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of the unit's size")]
pub(super) struct Unit {
    pub length: Spanned<Number>,
    pub height: Spanned<Number>,
    pub thickness: Option<Spanned<Number>>,
    pub weight: Spanned<Number>,
}

/// A value to compare with.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a `[[references]]` table")]
pub(super) struct Reference {
    pub method: Spanned<String>,
    pub head_joints: Option<Spanned<String>>,
    pub quantity: Spanned<String>,
    pub value: Spanned<Number>,
    pub tolerance: Spanned<Number>,
    pub source: String,
    pub kind: Spanned<String>,
    pub note: Option<String>,
    pub deviation: Option<String>,
}

/// `courses` in its three forms.
#[derive(Debug)]
pub(super) enum Courses {
    /// One course string.
    One(String),
    /// Course strings from bottom to top.
    List(Vec<Spanned<String>>),
    /// A number of courses, with `bond`.
    Count(i64),
}

/// A number, with or without a decimal point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Number(pub f64);

/// A whole number.
#[derive(Clone, Copy, Debug)]
pub(super) struct Whole(pub i64);

/// Reads the text; no value in it has been judged yet.
pub(super) fn parse(document: &Document) -> Result<File, Complaint> {
    toml::from_str(&document.text).map_err(|error| explain(document, &error))
}

impl<'de> Deserialize<'de> for Courses {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(CoursesVisitor)
    }
}

struct CoursesVisitor;

impl<'de> Visitor<'de> for CoursesVisitor {
    type Value = Courses;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("courses")
    }

    fn visit_str<E>(self, text: &str) -> Result<Courses, E> {
        Ok(Courses::One(text.to_owned()))
    }

    fn visit_i64<E>(self, count: i64) -> Result<Courses, E> {
        Ok(Courses::Count(count))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Courses, A::Error> {
        let mut list = Vec::new();
        while let Some(item) = items.next_element()? {
            list.push(item);
        }
        Ok(Courses::List(list))
    }
}

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NumberVisitor)
    }
}

/// Our own, so that the message says "a number" and not "f64".
struct NumberVisitor;

impl Visitor<'_> for NumberVisitor {
    type Value = Number;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number")
    }

    fn visit_f64<E>(self, value: f64) -> Result<Number, E> {
        Ok(Number(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Number, E> {
        Ok(Number(value as f64))
    }
}

impl<'de> Deserialize<'de> for Whole {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(WholeVisitor)
    }
}

struct WholeVisitor;

impl Visitor<'_> for WholeVisitor {
    type Value = Whole;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a whole number")
    }

    fn visit_i64<E>(self, value: i64) -> Result<Whole, E> {
        Ok(Whole(value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_of_keys_is_the_one_that_serde_knows() {
        let error = toml::from_str::<File>("nonsense = 1").unwrap_err();
        let known: Vec<&str> = error.message().split('`').skip(3).step_by(2).collect();
        assert_eq!(known, CASE_KEYS);
    }
}
