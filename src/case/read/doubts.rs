//! Values that are possible and look like a slip of the unit: the case runs, with a warning.

use toml::Spanned;

use super::file::CaseFile;
use super::values::{FrictionValue, Number};
use crate::case::complaint::{Complaint, Document};

/// Coefficients of friction between these are no stone's and may be angles in degrees. Of those
/// below, some are used where blocks must not slide.
const ANGLES: std::ops::Range<f64> = 10.5..90.0;

/// An embrace of three quarters of a turn, in radians: below, an embrace in degrees is no arch.
const RADIANS: f64 = 1.5 * std::f64::consts::PI;

/// Warnings about a file that can be read.
pub(super) fn doubts(document: &Document, file: &CaseFile) -> Vec<Complaint> {
    let mut found = Vec::new();
    let one = match file.friction.get_ref() {
        FrictionValue::One(number) => Some(Spanned::new(file.friction.span(), Number(*number))),
        FrictionValue::Classes(_) => None,
    };
    let classes = match file.friction.get_ref() {
        FrictionValue::One(_) => [None, None, None],
        FrictionValue::Classes(table) => {
            [Some(&table.bed), table.head.as_ref(), table.base.as_ref()]
        }
    };
    for value in one.iter().chain(classes.into_iter().flatten()) {
        let number = value.get_ref().0;
        if ANGLES.contains(&number) {
            let title = format!("a coefficient of friction of {number}: is this an angle?");
            let help = format!(
                "the coefficient is the tangent of the angle: write `{:.3}` for {number} degrees",
                number.to_radians().tan()
            );
            let warning = document.complain(value.span(), title, "taken as tan φ");
            found.push(warning.help(help).into_warning());
        }
    }
    if let Some(arch) = &file.arch {
        let embrace = &arch.get_ref().embrace;
        let number = embrace.get_ref().0;
        if number <= RADIANS {
            let title = format!("an embrace of {number} degrees: is this in radians?");
            let help = format!("write degrees: `{:.3}`", number.to_degrees());
            let warning = document.complain(embrace.span(), title, "taken as degrees");
            found.push(warning.help(help).into_warning());
        }
    }
    found
}
