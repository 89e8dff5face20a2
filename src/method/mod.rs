//! The methods: one file or folder each, one table that says all about them, one small trait.

#[macro_use]
mod tuned;

mod at_once;
mod auto;
mod contract;
mod entries;
pub mod limit;
mod macro_block;
pub mod pushover;
mod settings;

pub(crate) use at_once::borrowed;
pub use auto::Auto;
pub use contract::Method;
pub use entries::{
    Changes, Cost, Kind, Look, METHODS, Mark, MethodEntry, Rung, Scenes, defaults, entry, kind,
    methods, without_lower_bounds,
};
pub(crate) use entries::{expected_cost, method_look};
pub use macro_block::MacroBlock;
pub use settings::{
    Accuracy, Allowed, AutoSettings, Collapse, Engine, IntervalSettings, ProgramSettings,
    PushoverSettings, SequentialSettings, Setting, SettingError, Settings,
};
