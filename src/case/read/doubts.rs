//! Values that are possible and look like a slip of the unit: the case runs, with a warning.

use toml::Spanned;

use super::checks::Written;
use super::file::CaseFile;
use super::values::FrictionValue;
use crate::case::complaint::Complaint;

/// Coefficients of friction between these are no stone's and may be angles in degrees. Of those
/// below, some are used where blocks must not slide.
const ANGLES: std::ops::Range<f64> = 10.5..90.0;

/// An embrace of three quarters of a turn, in radians: below, an embrace in degrees is no arch.
const RADIANS: f64 = 1.5 * std::f64::consts::PI;

/// Warnings about a file that can be read.
pub(super) fn doubts(file: &CaseFile) -> Vec<Complaint> {
    let mut found = Vec::new();
    let mut coefficients = match file.friction.get_ref() {
        FrictionValue::One(number) => vec![Spanned::new(file.friction.span(), *number)],
        FrictionValue::Classes(table) => {
            let others = [&table.head, &table.base].into_iter().flatten();
            [&table.bed].into_iter().chain(others).cloned().collect()
        }
    };
    let joints = file
        .joint
        .iter()
        .filter_map(|joint| joint.get_ref().friction.as_ref());
    let blocks = file
        .block
        .iter()
        .filter_map(|block| block.get_ref().friction.as_ref());
    coefficients.extend(joints.chain(blocks).cloned());
    for value in coefficients {
        let number = value.get_ref().0;
        if ANGLES.contains(&number) {
            let title = format!("a coefficient of friction of {number}: is this an angle?");
            let help = format!(
                "the coefficient is the tangent of the angle: write `{:.3}` for {number} degrees",
                number.to_radians().tan()
            );
            found.push(value.wrong(title, "taken as tan φ").help(help));
        }
    }
    if let Some(arch) = &file.arch {
        let embrace = &arch.get_ref().embrace;
        let number = embrace.get_ref().0;
        if number <= RADIANS {
            let title = format!("an embrace of {number} degrees: is this in radians?");
            let help = format!("write degrees: `{:.3}`", number.to_degrees());
            found.push(embrace.wrong(title, "taken as degrees").help(help));
        }
    }
    found.into_iter().map(Complaint::into_warning).collect()
}
