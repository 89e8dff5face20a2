//! What a setting may be, and how it is written.

use std::fmt;
use std::ops::RangeInclusive;

use clap::ValueEnum;
use clap::builder::PossibleValue;

use super::choice::{Accuracy, Collapse, Engine};
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
    /// One of these words.
    Words(Vec<PossibleValue>),
}

impl Allowed {
    /// The words of a choice.
    pub(super) fn words<T: ValueEnum>() -> Self {
        let words = T::value_variants().iter();
        Allowed::Words(words.filter_map(T::to_possible_value).collect())
    }

    /// Whether the text is one of these values.
    pub(super) fn holds(&self, text: &str) -> bool {
        match self {
            Allowed::Whole(range) => text.parse().is_ok_and(|value| range.contains(&value)),
            Allowed::Number(range) => text.parse().is_ok_and(|value| range.contains(&value)),
            Allowed::Switch => text.parse::<bool>().is_ok(),
            Allowed::Words(words) => words.iter().any(|word| word.get_name() == text),
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
                let words: Vec<&str> = words.iter().map(PossibleValue::get_name).collect();
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

impl SettingValue for usize {
    fn read(text: &str) -> Option<Self> {
        text.parse().ok()
    }

    fn written(&self) -> String {
        self.to_string()
    }
}

impl SettingValue for f64 {
    fn read(text: &str) -> Option<Self> {
        text.parse().ok()
    }

    fn written(&self) -> String {
        nine_digits(*self)
    }
}

impl SettingValue for bool {
    fn read(text: &str) -> Option<Self> {
        text.parse().ok()
    }

    fn written(&self) -> String {
        self.to_string()
    }
}

/// The words of a type are its variants, with hyphens.
macro_rules! words {
    ($($Type:ty),+) => {$(
        impl SettingValue for $Type {
            fn read(text: &str) -> Option<Self> {
                Self::from_str(text, false).ok()
            }

            fn written(&self) -> String {
                let word = self.to_possible_value();
                word.map_or_else(String::new, |word| word.get_name().to_owned())
            }
        }
    )+};
}

words!(Accuracy, Collapse, Engine);
