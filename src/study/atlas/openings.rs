//! Grids over walls with openings, whose lowest states searches have missed.

use super::grid::{Grid, GridPoint, Known};
use super::walls::{COMPUTED, laid, wall};
use crate::answer::Bracket;
use crate::method::Kind;
use crate::scene::{Course, HeadJoints, Piece};

/// Head joints open: every method.
pub fn openings(large: bool) -> Grid {
    Grid {
        name: "openings",
        x: "height of the openings in courses",
        y: "openings",
        kinds: &[],
        causes: "Walls of 4 x 1.75 units, friction 0.65, with openings one unit wide and open \
                 head joints; HiGHS: one collapse state each, up to 8 % below λ_A. auto: in the \
                 large atlas it answers not unique where two openings are three courses high or \
                 more, as λ_A lies above the one state that is known. macro-block: knows no \
                 openings, so that it declines.",
        cells: pierced(HeadJoints::Open, large),
    }
}

/// The kinds that compute and do not watch: a pushover of a wall in contact is six.
const LIMIT_ANALYSIS: &[Kind] = &[
    Kind::AssociativeBounds,
    Kind::CollapseState,
    Kind::CollapseStates,
    Kind::Enclosure,
    Kind::Outside,
];

/// Head joints in contact.
pub fn openings_in_contact(large: bool) -> Grid {
    Grid {
        name: "openings-contact",
        x: "height of the openings in courses",
        y: "openings",
        kinds: LIMIT_ANALYSIS,
        causes: "Walls of 4 x 1.75 units, friction 0.65, with openings one unit wide and head joints \
                 in contact; HiGHS: several collapse states each. interval: right where it finds the \
                 lowest. auto: λ_A and the lowest state are 9 to 21 % apart, so that it answers not \
                 unique. sequential: ends near one state of several, without a proof.",
        cells: pierced(HeadJoints::Contact, large),
    }
}

fn pierced(head_joints: HeadJoints, large: bool) -> Vec<GridPoint> {
    let mut cells = Vec::new();
    for (row, openings) in [1, 2].into_iter().enumerate() {
        for (column, height) in HEIGHTS.into_iter().enumerate() {
            if !large && (openings, height) != (1, 5) {
                continue;
            }
            let [associative, lower, upper] = match head_joints {
                HeadJoints::Contact => CONTACT[row][column],
                HeadJoints::Open => {
                    let [associative, state] = OPEN[row][column];
                    [associative, state, state]
                }
            };
            let known = Known {
                states: Bracket { lower, upper },
                associative,
                accuracy: COMPUTED,
            };
            let scene = laid(&wall(courses(openings, height)), head_joints);
            let place = [height.to_string(), openings.to_string()];
            cells.push(GridPoint::of_scene(place, known, scene));
        }
    }
    cells
}

/// Heights of the openings that another code was asked about, in courses.
const HEIGHTS: [usize; 4] = [1, 3, 5, 7];

/// λ_A, lowest and highest state known with head joints in contact, over [`HEIGHTS`], with one opening
/// and with two. Two of height 5 are Ferris & Tin-Loi's wall 4.
const CONTACT: [[[f64; 3]; 4]; 2] = [
    [
        [0.497459344, 0.451827243, 0.497459344],
        [0.389828260, 0.334065934, 0.369747899],
        [0.313520413, 0.263736264, 0.276497696],
        [0.255399419, 0.217237308, 0.239543198],
    ],
    [
        [0.497459344, 0.451827243, 0.497459344],
        [0.408442321, 0.334065934, 0.394694760],
        [0.331948395, 0.263736264, 0.306981045],
        [0.269376750, 0.217237308, 0.247030879],
    ],
];

/// λ_A and the one state with open head joints, in the same order.
const OPEN: [[[f64; 2]; 4]; 2] = [
    [
        [0.451827243, 0.451827243],
        [0.336658849, 0.334065934],
        [0.265530256, 0.263736264],
        [0.218069935, 0.217237308],
    ],
    [
        [0.451827243, 0.451827243],
        [0.350333684, 0.334065934],
        [0.285403238, 0.263736264],
        [0.232799905, 0.217237308],
    ],
];

/// A wall with so many openings one unit wide, each between piers of one unit, with straight jambs and
/// a perpend over the middle of each; so many courses high, an odd number, with three courses below and
/// three above.
fn courses(openings: usize, height: usize) -> Vec<Course> {
    use Piece::{Gap, Half, Unit};
    let row = |pier: &[Piece]| {
        let further = [&[Gap], pier].concat().repeat(openings);
        [pier, &further].concat()
    };
    let units = 2 * openings + 1;
    let cut = [vec![Half], vec![Unit; units - 1], vec![Half]].concat();
    let band = [cut.clone(), vec![Unit; units], cut];
    let jambs = (0..height).map(|course| match course % 2 {
        0 => row(&[Unit]),
        _ => row(&[Half, Half]),
    });
    let jambs: Vec<Course> = jambs.collect();
    [band.as_slice(), &jambs, &band].concat()
}
