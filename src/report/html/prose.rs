//! How to read the report, what it cannot vouch for, and what it was made with.

use maud::{Markup, html};

use crate::answer::Status;
use crate::method::{METHODS, Setting, Settings};

pub fn reading() -> Markup {
    let statuses = Status::ALL.chunk_by(|a, b| meaning(*a) == meaning(*b));
    let statuses = statuses.map(|alike| {
        let words: Vec<&str> = alike.iter().map(|status| status.name()).collect();
        (words.join(", "), meaning(alike[0]))
    });
    html! {
        p { "λ is the multiplier of the horizontal live load at collapse; for a wall also the horizontal "
            "acceleration in units of g. Where a support moves, its reaction at collapse stands in place of λ. \
             Head joints (perpends) are " b { "open" } " where they carry nothing, "
            "as in dry-laid masonry before it is pushed, or in " b { "contact" } ", where they carry Coulomb "
            "friction. The crack's slope is tan β = ((c + e)/2 − s)/H: c is the width along the top that moves "
            "as one body, e the width that moves at all, s half a unit." }
        dl.facts { @for (word, meaning) in statuses { dt { (word) } dd { (meaning) } } }
        h3 { "Methods" }
        dl.facts { @for entry in METHODS { dt { (entry.name()) } dd { (entry.summary) } } }
        h3 { "Drawings" }
        p { "Blocks are shown displaced along their velocities, much amplified, over their outlines. "
            "Velocities are first order: distances between blocks mean openings and slips. Where more than twenty "
            "bodies move, colours tell how far each block moves. A legend stands below each drawing." }
        p { "Residuals are the largest violations after scaling total weight, height and live power to 1. "
            "The methods may use the same formulas to decide whether to go on; the verdict is the judge's own "
            "evaluation, from forces and mechanism on the whole scene, and no matrix, scaling or tolerance of a "
            "method enters it. The three limit analyses share one program, so that they do not confirm each "
            "other as the closed form, the pushover and an independent code do." }
        p { "A reference is published (p), analytic (a) or from an independent code (i); its error is that of "
            "the farther end of the range. What is folded is not printed." }
    }
}

/// What a status means; neighbours with one meaning are explained together.
fn meaning(status: Status) -> &'static str {
    match status {
        Status::Verified => {
            "proved to a residual of 1e-8, with total weight, height and live power scaled to 1"
        }
        Status::Bracketed => "between the two values by the method's own evidence",
        Status::Estimate => "a number without a proof",
        Status::Stands | Status::Falls => {
            "no push is too large, for the friction law that the method assumes; does not stand \
             under its own weight"
        }
        Status::NotApplicable => "outside the method's limits of validity, which are named",
        Status::Undecided => "no honest answer, with the reason",
        Status::Failed => "broke, or was refuted by the judge",
    }
}

pub fn limitations() -> Markup {
    html! {
        ul {
            li { "The verified interval is what a search found: a lower collapse state without dilatancy may "
                "exist, unless the method bound proves that none does." }
            li { "With head joints in contact the pushover's answer is not unique. It is what the scene and its "
                "mirror image do, or undecided." }
            li { "The closed form's range is an assumption about the mechanism, not a bound." }
            li { "Blocks are rigid and infinitely strong, friction is Coulomb's, walls are loaded in their plane." }
            li { "A published value can be met for a wrong reason; the crack's slope beside it is quantised by "
                "half units, so that c and e say more." }
        }
    }
}

/// Packages that numbers depend on.
const PACKAGES: [&str; 3] = ["clarabel", "rapier2d-f64", "nalgebra"];

/// Versions, machine, settings.
pub fn made_with(settings: &Settings) -> Markup {
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    let written = |setting: &Setting| format!("{} = {}", setting.name, setting.of(settings));
    let settings: Vec<String> = Setting::all().iter().map(written).collect();
    html! {
        dl.facts {
            dt { "trilith" } dd { (env!("CARGO_PKG_VERSION")) }
            @for package in PACKAGES { dt { (package) } dd { (version(package)) } }
            dt { "machine" }
            dd { (std::env::consts::ARCH) ", " (std::env::consts::OS) ", " (cores) " cores" }
            dt { "settings" }
            dd { (settings.join(", ")) }
            dt { "times" }
            dd { "CPU seconds of one thread on this machine; everything else is the same on every run" }
        }
    }
}

/// The version that the program was locked to.
fn version(package: &str) -> &'static str {
    let lock = include_str!("../../../Cargo.lock");
    let named = format!("name = \"{package}\"\nversion = \"");
    let after = lock.split_once(named.as_str()).map(|(_, after)| after);
    after
        .and_then(|after| after.split('"').next())
        .unwrap_or("unknown")
}

#[cfg(test)]
mod tests {
    #[test]
    fn every_package_has_its_version() {
        for package in super::PACKAGES {
            assert!(super::version(package).contains('.'), "{package}");
        }
    }
}
