//! The methods: one file or folder each, one table that says all about them, one small trait.

#[macro_use]
mod tuned;

mod at_once;
mod auto;
mod contract;
pub(crate) mod entries;
pub mod limit;
mod macro_block;
pub mod pushover;
mod settings;

pub(crate) use at_once::borrowed;
pub use auto::Auto;
pub use contract::Method;
pub(crate) use contract::{SoFar, Watch};
pub(crate) use entries::{
    Changes, Kind, Look, METHODS, Mark, MethodEntry, entry, expected_cost, kind, look, method_look,
    without_lower_bounds,
};
pub use entries::{defaults, methods};
pub use macro_block::MacroBlock;
pub use settings::{
    Accuracy, Allowed, AutoSettings, BoundSettings, Collapse, Engine, IntervalSettings,
    ProgramSettings, PushoverSettings, SequentialSettings, Setting, SettingError, Settings,
};
