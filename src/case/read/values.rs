//! Values of a case file that come in more forms than one, or whose message should be ours.

use std::fmt;
use std::marker::PhantomData;

use serde::de::value::MapAccessDeserializer;
use serde::de::{Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};
use toml::Spanned;

/// Coefficients of friction by class of joint.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FrictionTable {
    pub bed: Spanned<Number>,
    pub head: Option<Spanned<Number>>,
    pub base: Option<Spanned<Number>>,
}

/// `friction` in its two forms.
#[derive(Debug)]
pub(super) enum FrictionValue {
    /// One coefficient for all joints.
    One(f64),
    /// A table of classes.
    Classes(FrictionTable),
}

/// Two numbers, `[x, y]`.
#[derive(Clone, Debug)]
pub(super) struct Pair(pub Vec<Spanned<Number>>);

/// A table whose keys are free, in their order.
#[derive(Debug)]
pub(super) struct Entries<T>(pub Vec<(Spanned<String>, Spanned<T>)>);

/// `courses` in its three forms.
#[derive(Debug)]
pub(super) enum CoursesValue {
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
pub(super) struct WholeNumber(pub i64);

impl<'de> Deserialize<'de> for FrictionValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(FrictionVisitor)
    }
}

struct FrictionVisitor;

impl<'de> Visitor<'de> for FrictionVisitor {
    type Value = FrictionValue;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a coefficient of friction")
    }

    fn visit_f64<E>(self, value: f64) -> Result<FrictionValue, E> {
        Ok(FrictionValue::One(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<FrictionValue, E> {
        Ok(FrictionValue::One(value as f64))
    }

    fn visit_u64<E>(self, value: u64) -> Result<FrictionValue, E> {
        Ok(FrictionValue::One(value as f64))
    }

    fn visit_i128<E>(self, value: i128) -> Result<FrictionValue, E> {
        Ok(FrictionValue::One(value as f64))
    }

    fn visit_u128<E>(self, value: u128) -> Result<FrictionValue, E> {
        Ok(FrictionValue::One(value as f64))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<FrictionValue, A::Error> {
        FrictionTable::deserialize(MapAccessDeserializer::new(map)).map(FrictionValue::Classes)
    }
}

impl<'de> Deserialize<'de> for Pair {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_seq(PairVisitor)
    }
}

struct PairVisitor;

impl<'de> Visitor<'de> for PairVisitor {
    type Value = Pair;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("two numbers")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Pair, A::Error> {
        let mut numbers = Vec::new();
        while let Some(item) = items.next_element()? {
            numbers.push(item);
        }
        Ok(Pair(numbers))
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Entries<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(EntriesVisitor(PhantomData))
    }
}

struct EntriesVisitor<T>(PhantomData<T>);

impl<'de, T: Deserialize<'de>> Visitor<'de> for EntriesVisitor<T> {
    type Value = Entries<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a table of pieces")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Entries<T>, A::Error> {
        let mut entries = Vec::new();
        while let Some(entry) = map.next_entry()? {
            entries.push(entry);
        }
        Ok(Entries(entries))
    }
}

impl<'de> Deserialize<'de> for CoursesValue {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(CoursesVisitor)
    }
}

struct CoursesVisitor;

impl<'de> Visitor<'de> for CoursesVisitor {
    type Value = CoursesValue;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("courses")
    }

    fn visit_str<E>(self, text: &str) -> Result<CoursesValue, E> {
        Ok(CoursesValue::One(text.to_owned()))
    }

    fn visit_i64<E>(self, count: i64) -> Result<CoursesValue, E> {
        Ok(CoursesValue::Count(count))
    }

    fn visit_u64<E>(self, _: u64) -> Result<CoursesValue, E> {
        Ok(CoursesValue::Count(i64::MAX))
    }

    fn visit_i128<E>(self, count: i128) -> Result<CoursesValue, E> {
        Ok(CoursesValue::Count(nearest(count)))
    }

    fn visit_u128<E>(self, _: u128) -> Result<CoursesValue, E> {
        Ok(CoursesValue::Count(i64::MAX))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<CoursesValue, A::Error> {
        let mut list = Vec::new();
        while let Some(item) = items.next_element()? {
            list.push(item);
        }
        Ok(CoursesValue::List(list))
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

    fn visit_u64<E>(self, value: u64) -> Result<Number, E> {
        Ok(Number(value as f64))
    }

    fn visit_i128<E>(self, value: i128) -> Result<Number, E> {
        Ok(Number(value as f64))
    }

    fn visit_u128<E>(self, value: u128) -> Result<Number, E> {
        Ok(Number(value as f64))
    }
}

impl<'de> Deserialize<'de> for WholeNumber {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(WholeVisitor)
    }
}

struct WholeVisitor;

impl Visitor<'_> for WholeVisitor {
    type Value = WholeNumber;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a whole number")
    }

    fn visit_i64<E>(self, value: i64) -> Result<WholeNumber, E> {
        Ok(WholeNumber(value))
    }

    fn visit_u64<E>(self, _: u64) -> Result<WholeNumber, E> {
        Ok(WholeNumber(i64::MAX))
    }

    fn visit_i128<E>(self, value: i128) -> Result<WholeNumber, E> {
        Ok(WholeNumber(nearest(value)))
    }

    fn visit_u128<E>(self, _: u128) -> Result<WholeNumber, E> {
        Ok(WholeNumber(i64::MAX))
    }
}

/// The number, or the end of the range that it lies beyond: the checks of a count refuse either, and
/// say how large it may be.
fn nearest(value: i128) -> i64 {
    i64::try_from(value).unwrap_or(if value < 0 { i64::MIN } else { i64::MAX })
}
