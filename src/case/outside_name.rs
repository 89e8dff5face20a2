//! Names of outside programs.

/// Longest name of an outside program: what the column of tables holds.
const NAME_LENGTH: usize = 12;

/// Whether a word can name a program in tables.
///
/// # Errors
/// What to write instead.
pub(crate) fn outside_name(name: &str) -> Result<(), String> {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_.".contains(c);
    if (1..=NAME_LENGTH).contains(&name.len()) && name.chars().all(plain) {
        Ok(())
    } else {
        Err(format!(
            "use up to {NAME_LENGTH} letters, digits, `-`, `_` and `.`"
        ))
    }
}
