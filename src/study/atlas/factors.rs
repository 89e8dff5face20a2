//! Grids over numbers that may have any size: live loads and friction.

use super::grid::{Grid, GridPoint, Known};
use super::towers::{self, Tower};
use super::walls::{COMPUTED, ROUGH, RUNNING, of_library, rough_bond, running_bond};
use crate::scene::{HeadJoints, Scene};

/// An arch that collapses by hinges alone.
const ARCH: &str = "oppenheim-7";

fn column() -> Tower {
    Tower::of_equal(0.0, 1.0, 0.5, 3)
}

pub fn live_load(large: bool) -> Grid {
    const FACTORS: [f64; 7] = [1e-6, 1e-4, 1e-2, 1.0, 1e2, 1e4, 1e6];
    let mut cells = Vec::new();
    // The scene under its own live load, and the factors in the small atlas.
    let mut row = |name: &str, known: Known, scene: Scene, small: &[f64]| {
        // The closed form knows no live load but the weight.
        let scene = scene.without_wall();
        for factor in FACTORS {
            if large || small.contains(&factor) {
                let pushed = scene.clone().with_loads(|load, _| load.live *= factor);
                let place = [format!("{factor:e}"), name.to_owned()];
                cells.push(GridPoint::of_scene(place, known.under_live(factor), pushed));
            }
        }
    };
    let known = Known::exact(column().multiplier(0.6));
    let scene = towers::scene(&[column()], 0.6);
    row("column", known, scene, &[1e-6, 1e6]);
    let (courses, known) = RUNNING[0];
    row("wall", known, running_bond(courses), &[1e-6]);
    if let Some((scene, known)) = of_library(ARCH, HeadJoints::Contact) {
        row("arch", known, scene, &[1e6]);
    }
    Grid {
        name: "live-load",
        x: "live load over the weight",
        y: "scene",
        kinds: &[],
        causes: "A column of three blocks, exact; paper-1 with open head joints and an arch of seven \
                 voussoirs, HiGHS. The multiplier is that of the weight over the factor, and nothing \
                 else may change: every method makes the live load dimensionless first. macro-block: \
                 knows no live load but the weight.",
        cells,
    }
}

/// Friction from little to what lets nothing slide.
pub fn friction(large: bool) -> Grid {
    let arch = of_library(ARCH, HeadJoints::Contact);
    let mut cells = Vec::new();
    for (friction, associative, lambda) in ROUGH {
        let mut point = |name: &str, known: Known, scene: Scene, small: &[f64]| {
            if large || small.contains(&friction) {
                let value = match friction {
                    1e4.. => format!("{friction:e}"),
                    _ => friction.to_string(),
                };
                let place = [value, name.to_owned()];
                cells.push(GridPoint::of_scene(place, known, scene));
            }
        };
        let known = Known::exact(column().multiplier(friction));
        let scene = towers::scene(&[column()], friction);
        point("column", known, scene, &[0.1, 1e6]);
        let known = Known {
            associative,
            ..Known::within(lambda, COMPUTED)
        };
        point("wall", known, rough_bond(friction), &[1.5]);
        // Hinges alone turn in it, so that more friction than the case has changes nothing.
        if let Some((scene, known)) = arch.clone().filter(|_| friction >= 10.0) {
            let scene = scene.with_friction(|_, _| friction);
            point("arch", known, scene, &[1e6]);
        }
    }
    Grid {
        name: "friction",
        x: "friction coefficient",
        y: "scene",
        kinds: &[],
        causes: "A column of three blocks, exact; paper-1 with open head joints and an arch of \
                 seven voussoirs, HiGHS. Beyond 1, joints that dilate lock, and λ_A leaves the \
                 one collapse state known of the wall behind, which rocks: auto answers not \
                 unique. pushover: between that state and λ_A, 2 % above it at 1.5, and in the \
                 large atlas up to 31 %. sequential: in the large atlas its programs \
                 for the wall fail from 1e2 on. macro-block: a range far wider than 1 %, and \
                 none beyond 1, where its crack would be flatter than the stagger.",
        cells,
    }
}
