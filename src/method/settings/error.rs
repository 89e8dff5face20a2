//! What is wrong with a setting that somebody wrote.

use super::value::Allowed;

/// Why a setting cannot be set.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SettingError {
    /// No setting has this name.
    #[error("there is no setting `{name}`")]
    Unknown {
        /// The name as it was written.
        name: String,
        /// The setting whose name differs by a letter or two.
        nearest: Option<&'static str>,
        /// The names of all settings.
        known: Vec<&'static str>,
    },
    /// The setting cannot have this value.
    #[error("`{name}` is `{value}`")]
    Value {
        /// The setting.
        name: &'static str,
        /// The value as it was written.
        value: String,
        /// What it may be.
        allowed: Allowed,
    },
}

impl SettingError {
    /// What to write instead.
    pub fn advice(&self) -> String {
        match self {
            SettingError::Unknown { nearest, known, .. } => {
                let all = format!("settings are {}", known.join(", "));
                match nearest {
                    Some(near) => format!("did you mean `{near}`? {all}"),
                    None => all,
                }
            }
            SettingError::Value { allowed, .. } => format!("write {allowed}"),
        }
    }
}
