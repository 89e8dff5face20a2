//! What a setting may be, and how it is written.

use std::fmt;
use std::ops::RangeInclusive;

use crate::number::nine_digits;

/// What a setting may be.
#[derive(Clone, Debug, PartialEq)]
pub enum Allowed {
    /// A whole number.
    Whole(RangeInclusive<usize>),
    /// A number.
    Number(RangeInclusive<f64>),
    /// `true` or `false`.
    Switch,
    /// One of these words, each with its meaning.
    Words(&'static [(&'static str, &'static str)]),
}

impl Allowed {
    /// Whether the text is one of these values.
    pub(super) fn holds(&self, text: &str) -> bool {
        match self {
            Allowed::Whole(range) => text.parse().is_ok_and(|value| range.contains(&value)),
            Allowed::Number(range) => text.parse().is_ok_and(|value| range.contains(&value)),
            Allowed::Switch => text.parse::<bool>().is_ok(),
            Allowed::Words(words) => words.iter().any(|(word, _)| *word == text),
        }
    }
}

impl fmt::Display for Allowed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Allowed::Whole(range) => {
                write!(
                    f,
                    "a whole number from {} to {}",
                    range.start(),
                    range.end()
                )
            }
            Allowed::Number(range) => {
                let [least, most] = [range.start(), range.end()].map(|end| nine_digits(*end));
                write!(f, "a number from {least} to {most}")
            }
            Allowed::Switch => f.write_str("one of false, true"),
            Allowed::Words(words) => {
                let words: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
                write!(f, "one of {}", words.join(", "))
            }
        }
    }
}

/// The type of a setting.
pub(super) trait SettingValue: Sized {
    /// The value that a text stands for, as far as the type alone tells.
    fn read(text: &str) -> Option<Self>;

    /// The text that stands for the value.
    fn written(&self) -> String;
}

/// The types that Rust itself reads and writes.
macro_rules! parsed {
    ($($Type:ty: $written:expr),+) => {$(
        impl SettingValue for $Type {
            fn read(text: &str) -> Option<Self> {
                text.parse().ok()
            }

            fn written(&self) -> String {
                $written(self)
            }
        }
    )+};
}

parsed!(usize: usize::to_string, bool: bool::to_string, f64: |value: &f64| nine_digits(*value));
