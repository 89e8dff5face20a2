//! Colours that people with any kind of colour vision can tell apart: those of Okabe and Ito, and
//! light tints of them. Marks differ in line style as well.

/// What stands still.
pub const STILL: &str = "#eeece7";
/// The largest part that moves, and the moving macro-block.
pub const LARGEST: &str = "#a9d4ee";
/// Further parts; neighbours get different ones.
pub const PARTS: [&str; 5] = ["#f6cf86", "#93d1bb", "#e3b9d0", "#f4eea3", "#cfc4ea"];
/// Outlines of blocks.
pub const BLOCK_LINE: &str = "#57534b";
/// Blocks where they were.
pub const BEFORE: &str = "#b9b4a8";
/// Supports.
pub const SUPPORT: &str = "#cdc7bb";
/// Edge of supports.
pub const SUPPORT_LINE: &str = "#8b8475";
/// Joints that slide.
pub const SLIDING: &str = "#d55e00";
/// Joints that open.
pub const OPENING: &str = "#0072b2";
/// Crack lines of c and e.
pub const CRACK: &str = "#7a3e9d";
/// The macro-block's crack.
pub const MACRO_CRACK: &str = "#000";
/// Contact forces.
pub const FORCE: &str = "#b3006b";
/// Small print.
pub const FAINT: &str = "#5f5b53";
