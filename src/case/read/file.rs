//! The case file as TOML has it. Every value keeps its span, so that a complaint can point at it.

use std::ops::Range;

use toml::Spanned;

use super::values::{CoursesValue, FrictionValue, LiveValue, Number, Pair, Pieces, WholeNumber};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    Wall,
    Blocks,
    Arch,
}

impl Form {
    pub fn name(self) -> &'static str {
        match self {
            Form::Wall => "a coursed wall",
            Form::Blocks => "explicit blocks",
            Form::Arch => "an arch",
        }
    }
}

/// A key that is written and goes with some forms only, the first of them its own.
pub(super) struct FormKey {
    pub name: &'static str,
    pub forms: &'static [Form],
    /// Whether it goes with a bond and not with course strings.
    pub of_bond: bool,
    pub span: Range<usize>,
}

/// What a key goes with: forms, and whether with a bond alone. No forms: with all of them.
type Goes = (&'static [Form], bool);

const WITH_ALL: Goes = (&[], false);
const WALL: Goes = (&[Form::Wall], false);
const BOND: Goes = (&[Form::Wall], true);
const BLOCKS: Goes = (&[Form::Blocks], false);
const ARCH: Goes = (&[Form::Arch], false);
const OF_BLOCKS: Goes = (&[Form::Blocks, Form::Wall], false);
const FORCES: Goes = (&[Form::Blocks, Form::Arch, Form::Wall], false);

/// What a key is called in files, where it is not the field's name.
macro_rules! key_name {
    ($key:ident) => {
        stringify!($key)
    };
    ($key:ident $name:literal) => {
        $name
    };
}

/// Declares the keys at the top of a case file, each with its type and what it goes with.
macro_rules! case_keys {
    ($($(#[$attribute:meta])* $key:ident $(($name:literal))?: $value:ty => $goes:ident,)*) => {
        /// A whole file. Which of the keys go together is judged later, where it can be said well.
        #[derive(Debug, serde::Deserialize)]
        #[serde(deny_unknown_fields)]
        pub(super) struct CaseFile {
            $($(#[$attribute])* pub $key: $value,)*
        }

        /// The keys at the top of a case file, to tell a key in the wrong table from one that does
        /// not exist.
        pub(in crate::case) const CASE_KEYS: &[&str] = &[$(key_name!($key $($name)?)),*];

        impl CaseFile {
            /// The keys that are written and go with some forms only.
            pub fn form_keys(&self) -> Vec<FormKey> {
                let keys = [$((key_name!($key $($name)?), $goes, self.$key.place())),*];
                let keys = keys.into_iter().filter_map(|(name, (forms, of_bond), span)| {
                    let span = span.filter(|_| !forms.is_empty())?;
                    Some(FormKey { name, forms, of_bond, span })
                });
                keys.collect()
            }
        }
    };
}

case_keys! {
    title: Option<String> => WITH_ALL,
    source: Option<String> => WITH_ALL,
    unit: Option<Spanned<UnitTable>> => WALL,
    courses: Option<Spanned<CoursesValue>> => WALL,
    repeat: Option<Spanned<WholeNumber>> => WALL,
    heights: Option<Spanned<Vec<Spanned<Number>>>> => WALL,
    pieces: Option<Spanned<Pieces>> => WALL,
    bond: Option<Spanned<String>> => BOND,
    units: Option<Spanned<WholeNumber>> => BOND,
    first: Option<Spanned<String>> => BOND,
    overlap: Option<Spanned<Number>> => BOND,
    overburden: Option<Spanned<Number>> => OF_BLOCKS,
    open_head_joints: Option<Spanned<Vec<Spanned<WholeNumber>>>> => WALL,
    arch: Option<Spanned<ArchTable>> => ARCH,
    blocks: Option<Spanned<BlocksTable>> => BLOCKS,
    #[serde(default)] block: Vec<Spanned<BodyTable>> => OF_BLOCKS,
    #[serde(default)] support: Vec<Spanned<BodyTable>> => BLOCKS,
    #[serde(default, alias = "joints")] joint: Vec<Spanned<JointTable>> => OF_BLOCKS,
    live: Option<Spanned<LiveValue>> => FORCES,
    #[serde(default)] load: Vec<Spanned<LoadTable>> => FORCES,
    #[serde(default, rename = "move")] moves("move"): Vec<Spanned<MoveTable>> => FORCES,
    friction: Spanned<FrictionValue> => WITH_ALL,
    head_joints: Option<Spanned<String>> => WITH_ALL,
    push: Option<Spanned<String>> => WITH_ALL,
    demand: Option<Spanned<Number>> => WITH_ALL,
    #[serde(default)] references: Vec<ReferenceTable> => WITH_ALL,
}

/// Where a key is written first, if it is and goes with some forms only.
pub(super) trait Place {
    fn place(&self) -> Option<Range<usize>> {
        None
    }
}

impl Place for Option<String> {}
impl Place for Spanned<FrictionValue> {}
impl Place for Vec<ReferenceTable> {}

impl<T> Place for Option<Spanned<T>> {
    fn place(&self) -> Option<Range<usize>> {
        self.as_ref().map(Spanned::span)
    }
}

impl<T> Place for Vec<Spanned<T>> {
    fn place(&self) -> Option<Range<usize>> {
        self.first().map(Spanned::span)
    }
}

/// A generated arch.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "an `[arch]` table")]
pub(super) struct ArchTable {
    pub mean_radius: Spanned<Number>,
    pub thickness: Spanned<Number>,
    pub embrace: Spanned<Number>,
    pub voussoirs: Spanned<WholeNumber>,
    pub specific_weight: Option<Spanned<Number>>,
}

/// What all explicit blocks share.
#[derive(Debug, Default, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a `[blocks]` table")]
pub(super) struct BlocksTable {
    pub csv: Option<Spanned<String>>,
    #[serde(default)]
    pub supports: Vec<Spanned<String>>,
    pub specific_weight: Option<Spanned<Number>>,
    pub thickness: Option<Spanned<Number>>,
    pub tolerance: Option<Spanned<Number>>,
    pub gap: Option<Spanned<Number>>,
    pub radial: Option<bool>,
}

/// A block or a support; in a coursed wall, what a block of a course has of its own.
#[derive(Debug, serde::Deserialize)]
#[serde(
    deny_unknown_fields,
    expecting = "a `[[block]]` or `[[support]]` table"
)]
pub(super) struct BodyTable {
    pub name: Option<Spanned<String>>,
    pub corners: Option<Spanned<Vec<Spanned<Pair>>>>,
    pub weight: Option<Spanned<Number>>,
    pub specific_weight: Option<Spanned<Number>>,
    pub friction: Option<Spanned<Number>>,
    pub centre: Option<Spanned<Pair>>,
    pub course: Option<Spanned<WholeNumber>>,
    pub piece: Option<Spanned<WholeNumber>>,
}

/// A force on a block.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a `[[load]]` table")]
pub(super) struct LoadTable {
    pub block: Spanned<String>,
    pub at: Option<Spanned<Pair>>,
    pub along: Option<Spanned<Vec<Spanned<Pair>>>>,
    pub dead: Option<Spanned<Pair>>,
    pub live: Option<Spanned<Pair>>,
}

/// What the case says itself of a joint: of one between two bodies, or of the bed that a course lies on.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a `[[joint]]` table")]
pub(super) struct JointTable {
    pub between: Option<Spanned<[Spanned<String>; 2]>>,
    pub course: Option<Spanned<WholeNumber>>,
    pub class: Option<Spanned<String>>,
    pub friction: Option<Spanned<Number>>,
    pub open: Option<Spanned<bool>>,
}

/// A support that moves.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a `[[move]]` table")]
pub(super) struct MoveTable {
    pub support: Option<Spanned<String>>,
    pub units: Option<Spanned<String>>,
    pub direction: Spanned<Pair>,
    pub moves: Spanned<String>,
    pub about: Option<Spanned<Pair>>,
    pub rate: Option<Spanned<Number>>,
    pub pushed: Option<Spanned<Number>>,
}

/// What every unit is like.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table of the unit's size")]
pub(super) struct UnitTable {
    pub length: Spanned<Number>,
    pub height: Spanned<Number>,
    pub thickness: Option<Spanned<Number>>,
    pub weight: Option<Spanned<Number>>,
}

/// A value to compare with.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a `[[references]]` table")]
pub(super) struct ReferenceTable {
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
