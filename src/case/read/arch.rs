//! A generated arch from a file.

use super::checks::{Written, positive, positive_or_one, whole, within};
use super::file::CaseFile;
use super::forces::{Loadable, forces};
use super::friction::friction;
use super::values::{FrictionTable, FrictionValue};
use crate::case::complaint::Complaint;
use crate::scene::{Arch, Forces};

/// Embraces in degrees; beyond 270 the springers would meet.
const EMBRACES: std::ops::RangeInclusive<f64> = 1.0..=270.0;

/// Most voussoirs: their joints are still far longer than what the joint search tells apart.
const MOST_VOUSSOIRS: usize = 1000;

/// The thinnest ring over its mean radius.
const THINNEST: f64 = 1e-3;

pub(super) fn arch(file: &CaseFile) -> Result<Arch, Complaint> {
    let table = file.arch.as_ref().expect("the form is an arch");
    let written = table.get_ref();
    let mean_radius = positive("mean_radius", &written.mean_radius)?;
    let thickness = positive("thickness", &written.thickness)?;
    if !(THINNEST..2.0).contains(&(thickness / mean_radius)) {
        let title = format!("a ring of thickness {thickness} on a mean radius of {mean_radius}");
        let complaint = written.thickness.wrong(title, "out of range");
        return Err(
            complaint.help("write a thickness from 0.001 to less than 2 times the mean radius")
        );
    }
    let embrace = within("embrace", &written.embrace, EMBRACES)?;
    let voussoirs = whole("voussoirs", &written.voussoirs, MOST_VOUSSOIRS)?;
    // A voussoir of a right angle and more could not be cut, and has no proper trapezoid at 180°.
    if embrace / voussoirs as f64 > 90.0 {
        let title = format!("too few voussoirs for {embrace} degrees: {voussoirs}");
        let complaint = written.voussoirs.wrong(title, "here");
        return Err(complaint.help("write a voussoir for every 90 degrees at least"));
    }
    no_head_friction(file)?;
    let mut arch = Arch {
        mean_radius,
        thickness,
        embrace,
        voussoirs: voussoirs as u32,
        specific_weight: positive_or_one("specific_weight", written.specific_weight.as_ref())?,
        friction: friction(file)?,
        forces: Forces::default(),
    };
    let assembly = arch.assembly().map_err(|error| {
        table
            .wrong(error.to_string(), "no such voussoir can be cut")
            .help("check radius, thickness, embrace and number of voussoirs")
    })?;
    arch.forces = forces(file, &Loadable::of(&assembly))?;
    Ok(arch)
}

fn no_head_friction(file: &CaseFile) -> Result<(), Complaint> {
    match file.friction.get_ref() {
        FrictionValue::Classes(FrictionTable {
            head: Some(head), ..
        }) => Err(head
            .wrong("an arch has no head joints", "its joints are radial")
            .help("remove `head`: `bed` is between voussoirs, `base` at the springers")),
        _ => Ok(()),
    }
}
