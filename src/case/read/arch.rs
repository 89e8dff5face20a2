//! A generated arch from a file.

use toml::Spanned;

use super::checks::{positive, whole, within};
use super::file::CaseFile;
use super::forces::{Loadable, forces};
use super::friction::friction;
use super::values::{FrictionTable, FrictionValue, Number};
use crate::case::complaint::{Complaint, Document};
use crate::scene::{Arch, Forces};

/// Embraces in degrees; beyond 270 the springers would meet.
const EMBRACES: std::ops::RangeInclusive<f64> = 1.0..=270.0;

/// Most voussoirs: their joints are still far longer than what the joint search tells apart.
const MOST_VOUSSOIRS: usize = 1000;

/// The thinnest ring over its mean radius.
const THINNEST: f64 = 1e-3;

/// The arch of a file.
pub(super) fn arch(document: &Document, file: &CaseFile) -> Result<Arch, Complaint> {
    let table = file.arch.as_ref().expect("the form is an arch");
    let written = table.get_ref();
    let mean_radius = positive(document, "mean_radius", &written.mean_radius)?;
    let thickness = positive(document, "thickness", &written.thickness)?;
    if !(THINNEST..2.0).contains(&(thickness / mean_radius)) {
        return Err(document
            .complain(
                written.thickness.span(),
                format!("a ring of thickness {thickness} on a mean radius of {mean_radius}"),
                "out of range",
            )
            .help("write a thickness from 0.001 to less than 2 times the mean radius"));
    }
    let embrace = within(document, "embrace", &written.embrace, EMBRACES)?;
    let voussoirs = whole(document, "voussoirs", &written.voussoirs, MOST_VOUSSOIRS)?;
    // A voussoir of a right angle and more could not be cut, and has no proper trapezoid at 180°.
    if embrace / voussoirs as f64 > 90.0 {
        return Err(document
            .complain(
                written.voussoirs.span(),
                format!("too few voussoirs for {embrace} degrees: {voussoirs}"),
                "here",
            )
            .help("write a voussoir for every 90 degrees at least"));
    }
    no_head_friction(document, file)?;
    let one = |key, value: &Option<Spanned<Number>>| match value {
        None => Ok(1.0),
        Some(value) => positive(document, key, value),
    };
    let mut arch = Arch {
        mean_radius,
        thickness,
        embrace,
        voussoirs: voussoirs as u32,
        specific_weight: one("specific_weight", &written.specific_weight)?,
        friction: friction(document, file)?,
        forces: Forces::default(),
    };
    let assembly = arch.assembly().map_err(|error| {
        document
            .complain(
                table.span(),
                error.to_string(),
                "no such voussoir can be cut",
            )
            .help("check radius, thickness, embrace and number of voussoirs")
    })?;
    arch.forces = forces(document, file, &Loadable::of(&assembly))?;
    Ok(arch)
}

fn no_head_friction(document: &Document, file: &CaseFile) -> Result<(), Complaint> {
    match file.friction.get_ref() {
        FrictionValue::Classes(FrictionTable {
            head: Some(head), ..
        }) => Err(document
            .complain(
                head.span(),
                "an arch has no head joints",
                "its joints are radial",
            )
            .help("remove `head`: `bed` is between voussoirs, `base` at the springers")),
        _ => Ok(()),
    }
}
