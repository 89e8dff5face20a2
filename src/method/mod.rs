//! The methods: one file or folder each, one table that says all about them, one small trait.

mod at_once;
mod auto;
mod contract;
pub mod limit;
mod macro_block;
pub mod pushover;
mod settings;
pub(crate) mod table;

pub(crate) use at_once::borrowed;
pub use auto::Auto;
pub use contract::Method;
pub use macro_block::MacroBlock;
pub use settings::{
    Accuracy, Allowed, AutoSettings, BoundSettings, Collapse, Engine, IntervalSettings,
    ProgramSettings, PushoverSettings, SequentialSettings, Setting, SettingError, Settings,
};
pub(crate) use table::{
    Changes, Kind, Look, METHODS, Mark, MethodEntry, entry, expected_cost, kind, method_look,
    without_lower_bounds,
};
pub use table::{defaults, methods};
