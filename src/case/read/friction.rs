//! Coefficients of friction from a file.

use toml::Spanned;

use super::checks::not_negative;
use super::file::CaseFile;
use super::values::{FrictionValue, Number};
use crate::case::complaint::Complaint;
use crate::scene::Friction;

/// The coefficients of friction; `head` and `base` are those of `bed` where they are left out.
pub(super) fn friction(file: &CaseFile) -> Result<Friction, Complaint> {
    match file.friction.get_ref() {
        FrictionValue::One(number) => {
            let number = Spanned::new(file.friction.span(), *number);
            Ok(not_negative("friction", &number)?.into())
        }
        FrictionValue::Classes(classes) => {
            let bed = not_negative("bed", &classes.bed)?;
            let other = |key, value: &Option<Spanned<Number>>| {
                value
                    .as_ref()
                    .map_or(Ok(bed), |value| not_negative(key, value))
            };
            Ok(Friction {
                bed,
                head: other("head", &classes.head)?,
                base: other("base", &classes.base)?,
            })
        }
    }
}
