//! Settings that are one of a few words.

/// Makes the type of a setting from its words. The comment above a word is its meaning in the help.
macro_rules! choices {
    ($(
        $(#[doc = $about:literal])+
        $Choice:ident {$(
            $(#[doc = $meaning:literal])+
            $Word:ident = $word:literal,
        )+}
    )+) => {$(
        $(#[doc = $about])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $Choice {$(
            $(#[doc = $meaning])+
            $Word,
        )+}

        impl $Choice {
            /// The words, each with its meaning.
            pub(super) const WORDS: &[(&str, &str)] = &[$(($word, concat!($($meaning),+))),+];
        }

        impl SettingValue for $Choice {
            fn read(text: &str) -> Option<Self> {
                match text {
                    $($word => Some(Self::$Word),)+
                    _ => None,
                }
            }

            fn written(&self) -> String {
                match self {
                    $(Self::$Word => $word.to_owned(),)+
                }
            }
        }
    )+};
}

use super::value::SettingValue;

choices! {
    /// How accurate the pushover has to be; everything else about it follows. The error is of either end
    /// of its bracket against the limit, relative to λ.
    Accuracy {
        /// An error of about 1 % of λ, and of 1.5 % above 30 courses.
        Coarse = "coarse",
        /// An error of about 0.2 % of λ, and of 0.3 % above 30 courses.
        Normal = "normal",
        /// An error of about 0.05 % of λ, and of 0.15 % above 30 courses.
        Fine = "fine",
    }

    /// What a pushover calls collapse.
    Collapse {
        /// Blocks run away and do not slow down.
        Runaway = "runaway",
        /// A joint has slipped by a thousandth of the course height, though it may come to rest.
        FirstSlip = "first-slip",
    }

    /// What solves the linear programs.
    Engine {
        /// An interior point that knows the structure of joints and blocks; Clarabel where it gives up.
        Structured = "structured",
        /// Clarabel, which solves any cone program.
        Clarabel = "clarabel",
    }
}
