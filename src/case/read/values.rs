//! Values of a case file that come in more forms than one, or whose message should be ours.

use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserialize, MapAccess, SeqAccess};
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
    One(Number),
    Classes(FrictionTable),
}

/// `live` in its two forms.
#[derive(Debug)]
pub(super) enum LiveValue {
    /// What pushes, by a word.
    Word(String),
    /// How the weights do.
    OfWeight(LiveTable),
}

/// How the weights push.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct LiveTable {
    pub weight: Spanned<Pair>,
}

/// Two numbers, `[x, y]`.
#[derive(Clone, Debug)]
pub(super) struct Pair(pub Vec<Spanned<Number>>);

/// The pieces of a wall by their letters, in their order.
#[derive(Debug)]
pub(super) struct Pieces(pub Vec<(Spanned<String>, Spanned<PieceTable>)>);

/// A piece of a coursed wall that has a letter of its own.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of a piece")]
pub(super) struct PieceTable {
    pub units: Option<Spanned<Number>>,
    pub length: Option<Spanned<Number>>,
    pub gap: Option<bool>,
    pub weight: Option<Spanned<Number>>,
}

/// `courses` in its three forms.
#[derive(Debug)]
pub(super) enum CoursesValue {
    One(String),
    /// Course strings from bottom to top.
    List(Vec<Spanned<String>>),
    /// A number of courses, with `bond`.
    Count(i64),
}

/// A number, with or without a decimal point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Number(pub f64);

#[derive(Clone, Copy, Debug)]
pub(super) struct WholeNumber(pub i64);

/// Lets a visitor take whole numbers of any size.
macro_rules! visit_whole_numbers {
    ($of:ident, $value:expr) => {
        fn visit_i64<E>(self, number: i64) -> Result<$of, E> {
            Ok($value(i128::from(number)))
        }

        fn visit_u64<E>(self, number: u64) -> Result<$of, E> {
            Ok($value(i128::from(number)))
        }

        fn visit_i128<E>(self, number: i128) -> Result<$of, E> {
            Ok($value(number))
        }

        fn visit_u128<E>(self, number: u128) -> Result<$of, E> {
            Ok($value(i128::try_from(number).unwrap_or(i128::MAX)))
        }
    };
}

/// Reads a value by a visitor, which says in our words what it expects.
macro_rules! read_by_visitor {
    ($of:ident, $expecting:expr, { $($visit:tt)* }) => {
        impl<'de> ::serde::de::Deserialize<'de> for $of {
            fn deserialize<D: ::serde::de::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                struct Forms;

                impl<'de> ::serde::de::Visitor<'de> for Forms {
                    type Value = $of;

                    fn expecting(&self, f: &mut ::std::fmt::Formatter<'_>) -> ::std::fmt::Result {
                        f.write_str($expecting)
                    }

                    $($visit)*
                }

                deserializer.deserialize_any(Forms)
            }
        }
    };
}

pub(crate) use read_by_visitor;

read_by_visitor!(Number, "a number", {
    fn visit_f64<E>(self, number: f64) -> Result<Number, E> {
        Ok(Number(number))
    }

    visit_whole_numbers!(Number, |number| Number(number as f64));
});

read_by_visitor!(WholeNumber, "a whole number", {
    visit_whole_numbers!(WholeNumber, |number| WholeNumber(nearest(number)));
});

read_by_visitor!(FrictionValue, "a coefficient of friction", {
    fn visit_f64<E>(self, number: f64) -> Result<FrictionValue, E> {
        Ok(FrictionValue::One(Number(number)))
    }

    visit_whole_numbers!(FrictionValue, |number| FrictionValue::One(Number(
        number as f64
    )));

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<FrictionValue, A::Error> {
        FrictionTable::deserialize(MapAccessDeserializer::new(map)).map(FrictionValue::Classes)
    }
});

read_by_visitor!(LiveValue, "a live load", {
    fn visit_str<E>(self, text: &str) -> Result<LiveValue, E> {
        Ok(LiveValue::Word(text.to_owned()))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<LiveValue, A::Error> {
        LiveTable::deserialize(MapAccessDeserializer::new(map)).map(LiveValue::OfWeight)
    }
});

read_by_visitor!(Pair, "two numbers", {
    fn visit_seq<A: SeqAccess<'de>>(self, items: A) -> Result<Pair, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(items)).map(Pair)
    }
});

read_by_visitor!(CoursesValue, "courses", {
    fn visit_str<E>(self, text: &str) -> Result<CoursesValue, E> {
        Ok(CoursesValue::One(text.to_owned()))
    }

    visit_whole_numbers!(CoursesValue, |number| CoursesValue::Count(nearest(number)));

    fn visit_seq<A: SeqAccess<'de>>(self, items: A) -> Result<CoursesValue, A::Error> {
        Vec::deserialize(SeqAccessDeserializer::new(items)).map(CoursesValue::List)
    }
});

read_by_visitor!(Pieces, "a table of pieces", {
    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Pieces, A::Error> {
        let mut pieces = Vec::new();
        while let Some(piece) = map.next_entry()? {
            pieces.push(piece);
        }
        Ok(Pieces(pieces))
    }
});

/// The number, or the end of the range that it lies beyond: the checks of a count refuse either, and
/// say how large it may be.
fn nearest(number: i128) -> i64 {
    number.clamp(i64::MIN.into(), i64::MAX.into()) as i64
}
