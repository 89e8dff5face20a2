//! The grids of the atlas.

use super::factors::{friction, live_load};
use super::grid::{Grid, GridPoint, Known, chosen, crossed};
use super::openings::{openings, openings_in_contact};
use super::towers::Columns;
use super::unequal::{light_beside_heavy, load_on_top, weights};
use super::walls::{RUNNING, moved, running_bond, running_bond_in};
use crate::method::Kind;

/// All grids; the small ones are subsets of the large ones.
pub fn grids(large: bool) -> Vec<Grid> {
    vec![
        courses_and_friction(large),
        slenderness_and_mass(large),
        courses_and_overburden(large),
        courses_and_gap(large),
        unit_and_distance(large),
        tolerance_of_programs(large),
        substep_and_stiffness(large),
        weights(large),
        light_beside_heavy(large),
        live_load(large),
        friction(large),
        load_on_top(large),
        openings(large),
        openings_in_contact(large),
    ]
}

fn on_columns(place: [String; 2], columns: Columns) -> GridPoint {
    GridPoint::of_scene(place, Known::exact(columns.multiplier()), columns.scene())
}

fn courses_and_friction(large: bool) -> Grid {
    let courses = chosen(large, &[1, 2, 4, 8, 16, 32], &[1, 8]);
    let frictions = chosen(large, &[0.05, 0.2, 0.4, 0.9, 2.0], &[0.05, 0.4, 0.9]);
    let cells = crossed(courses, frictions, |courses, friction: f64| {
        let columns = Columns {
            courses,
            friction,
            ..Columns::default()
        };
        on_columns([courses.to_string(), friction.to_string()], columns)
    });
    Grid {
        name: "courses-friction",
        x: "courses",
        y: "friction coefficient",
        kinds: &[],
        causes: "A column of blocks 1 x 0.5 on level ground; exact: min(friction, width / \
                 height). sequential: right, but where the column slides as a whole only an \
                 estimate, as c0 lifts its multiplier by c0 over the friction. macro-block: a \
                 column has no stagger, so that it declines.",
        cells,
    }
}

fn slenderness_and_mass(large: bool) -> Grid {
    let slender = chosen(large, &[0.5, 1.0, 2.0, 5.0, 10.0, 40.0], &[0.5, 2.0, 10.0]);
    let ratios = chosen(large, &[1e-6, 1e-3, 0.1, 1.0, 1e3, 1e6], &[1e-3, 1.0, 1e3]);
    let cells = crossed(slender, ratios, |slenderness: f64, ratio| {
        let columns = Columns {
            height: slenderness / 3.0,
            mass_ratio: ratio,
            friction: 0.8,
            ..Columns::default()
        };
        on_columns([slenderness.to_string(), format!("{ratio:e}")], columns)
    });
    Grid {
        name: "slenderness-mass",
        x: "height over width",
        y: "weight of the top block over that of the others",
        kinds: &[],
        causes: "A column of three blocks, friction 0.8; exact. pushover: right up to weights of \
                 1 to 1e3; in the large atlas it refuses those of 1 to 1e6, as its solver passes \
                 a heavy block's load through light ones only slowly. macro-block: a column has \
                 no stagger, so that it declines.",
        cells,
    }
}

fn courses_and_overburden(large: bool) -> Grid {
    let courses = chosen(large, &[1, 3, 6, 12], &[1, 3]);
    let ratios = chosen(large, &[0.0, 0.1, 1.0, 10.0, 100.0], &[1.0, 10.0]);
    let cells = crossed(courses, ratios, |courses, overburden: f64| {
        let columns = Columns {
            courses,
            overburden,
            ..Columns::default()
        };
        on_columns([courses.to_string(), overburden.to_string()], columns)
    });
    Grid {
        name: "courses-overburden",
        x: "courses",
        y: "overburden over the column's weight",
        kinds: &[],
        causes: "A column of blocks 1 x 0.5, friction 0.6, loaded on its top both downwards and \
                 sideways; exact. pushover: the load on the top block is a force and no mass of \
                 it, so that no weights differ. macro-block: a column has no stagger, so that it \
                 declines.",
        cells,
    }
}

fn courses_and_gap(large: bool) -> Grid {
    let courses = chosen(large, &[2, 4, 8], &[2]);
    let gaps = chosen(large, &[1e-4, 1e-3, 1e-2, 0.1, 0.5], &[1e-4, 1e-2, 0.5]);
    let cells = crossed(courses, gaps, |courses, gap| {
        let columns = Columns {
            courses,
            gap,
            count: 2,
            ..Columns::default()
        };
        on_columns([courses.to_string(), format!("{gap:e}")], columns)
    });
    Grid {
        name: "courses-gap",
        x: "courses",
        y: "gap between two columns over their width",
        kinds: &[],
        causes: "Two equal columns with a gap between them, friction 0.6; exact: each for itself. \
                 The limit analysis sees no joint across a gap, however narrow. pushover: blocks \
                 without a joint must never touch in the engine, or the gap would close before the \
                 collapse and the columns would lean on each other.",
        cells,
    }
}

fn unit_and_distance(large: bool) -> Grid {
    let units = chosen(large, &[1e-6, 1e-3, 1.0, 1e3, 1e6], &[1e-3, 1.0, 1e3]);
    let distances = chosen(large, &[0.0, 1e3, 1e5, 1e7], &[0.0, 1e3]);
    let (courses, known) = RUNNING[0];
    let cells = crossed(units, distances, |unit, distance| {
        let wall = running_bond_in(courses, unit);
        let scene = moved(&wall, distance * wall.height());
        GridPoint::of_scene([format!("{unit:e}"), format!("{distance:e}")], known, scene)
    });
    Grid {
        name: "unit-distance",
        x: "unit of length",
        y: "distance from the origin over the wall's height",
        kinds: &[],
        causes: "paper-1 with open head joints in another unit and at another place; HiGHS: \
                 0.639969 wherever it stands. Every method scales to the wall's own size first; \
                 in the large atlas answers hold up to 1e7 heights from the origin. macro-block: \
                 its range holds the multiplier and is far wider than 1 %.",
        cells,
    }
}

fn tolerance_of_programs(large: bool) -> Grid {
    let tolerances = chosen(
        large,
        &[1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10],
        &[1e-2, 1e-4, 1e-6, 1e-10],
    );
    let cells = crossed(tolerances, &RUNNING, |tolerance, (courses, known)| {
        let place = [format!("{tolerance:e}"), format!("{courses} courses")];
        let mut point = GridPoint::of_scene(place, known, running_bond(courses));
        point.settings.programs.lp_tolerance = tolerance;
        point
    });
    Grid {
        name: "tolerance",
        x: "tolerance of the linear programs",
        y: "courses",
        kinds: &[Kind::AssociativeBounds, Kind::CollapseState],
        causes: "paper-1 and paper-2 with open head joints; HiGHS: 0.639969 and 0.562786. An \
                 interior-point solver stopped early reports success away from the optimum, the \
                 further the larger the wall. Its forces and velocities then prove nothing, and \
                 the answer is an estimate. sequential: its steps mend what a loose program \
                 leaves, and in the large atlas it is 2 % off at 1e-1 alone.",
        cells,
    }
}

fn substep_and_stiffness(large: bool) -> Grid {
    let substeps = chosen(large, &[0.5, 1.0, 2.0, 4.0, 16.0, 64.0], &[1.0, 4.0, 16.0]);
    let (all, small) = (
        [4.0, 1.0, 0.25, 1.0 / 16.0, 1.0 / 256.0],
        [4.0, 1.0, 1.0 / 16.0],
    );
    let stiffnesses = chosen(large, &all, &small);
    let (courses, known) = RUNNING[0];
    let cells = crossed(substeps, stiffnesses, |substep: f64, stiffness: f64| {
        let place = [substep.to_string(), stiffness.to_string()];
        let mut point = GridPoint::of_scene(place, known, running_bond(courses));
        point.settings.pushover.substep = substep;
        point.settings.pushover.stiffness = stiffness;
        point
    });
    Grid {
        name: "substep-stiffness",
        x: "substep over the default",
        y: "contact stiffness over the default",
        kinds: &[Kind::Observed],
        causes: "paper-1 with open head joints; HiGHS: 0.639969. Contacts are springs bound to the \
                 substep: longer substeps and softer springs let the wall settle and sway before it \
                 falls, which costs multiplier, and the self-check of the settlement refuses it; \
                 stiffer ones than the substep resolves jitter, and are refused at once. Off the \
                 default nothing is known about the error, so that answers are estimates.",
        cells,
    }
}
