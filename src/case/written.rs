//! Values as a case file has them.

use crate::scene::Vector;

/// A vector as TOML writes it.
pub(super) fn pair(vector: Vector) -> String {
    format!("[{:?}, {:?}]", vector.x, vector.y)
}

/// A text as TOML writes it.
pub(crate) fn quoted(text: &str) -> String {
    toml::Value::String(text.to_owned()).to_string()
}
