//! Grids over blocks of unequal weight and size, where measures over the whole scene do not see the
//! light ones, and over heavy tops.

use super::grid::{Grid, GridPoint, Known, chosen, crossed};
use super::towers::{self, Stone, Tower};
use super::walls::of_library;
use crate::scene::HeadJoints;

fn ratios(large: bool) -> &'static [f64] {
    chosen(large, &[1.0, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12], &[1e2, 1e6])
}

/// A column whose blocks differ in weight.
pub fn weights(large: bool) -> Grid {
    const COURSES: usize = 5;
    // Exponents of the ratio, from bottom to top.
    let share = |course: usize| course as f64 / (COURSES - 1) as f64;
    type Order<'a> = (&'a str, &'a dyn Fn(usize) -> f64);
    let orders: [Order; 3] = [
        ("lighter upwards", &|course| -share(course)),
        ("heavier upwards", &share),
        ("in turn", &|course| -((course % 2) as f64)),
    ];
    let friction = 1.5;
    let cells = crossed(ratios(large), &orders, |ratio: f64, (order, exponent)| {
        let stone = |course: usize| Stone {
            width: 1.0 - 0.1 * course as f64,
            height: 0.5,
            weight: ratio.powf(exponent(course)),
        };
        let tower = Tower {
            axis: 0.0,
            stones: (0..COURSES).map(stone).collect(),
            load: 0.0,
        };
        let known = Known::exact(tower.multiplier(friction));
        let scene = towers::scene(&[tower], friction);
        let place = [format!("{ratio:e}"), order.to_owned()];
        GridPoint::of_scene(place, known, scene)
    });
    Grid {
        name: "weights",
        x: "heaviest over lightest block",
        y: "how the weights follow each other from the bottom",
        kinds: &[],
        causes: "A column of five blocks that narrow upwards from 1 to 0.6, each 0.5 high, \
                 friction 1.5; exact. Lighter upwards, the top block rocks, else the column. \
                 Programs give each block units of its own, and the judge measures it by its own \
                 forces. pushover: refuses weights that differ by more than 1e4 within one \
                 connected part, and is right below. sequential: in the large atlas, with weights \
                 that fall upwards by 1e8 and more, its estimate is 14 to 24 % off or it has \
                 none. macro-block: a column has no stagger, so that it declines.",
        cells,
    }
}

/// A light block that rocks beside a heavy one.
pub fn light_beside_heavy(large: bool) -> Grid {
    let sizes = chosen(large, &[1.0, 1e-2, 1e-4], &[1.0, 1e-2]);
    let friction = 0.65;
    let cells = crossed(ratios(large), sizes, |ratio, size| {
        let tower = |axis, width, height, weight| Tower {
            axis,
            stones: vec![Stone {
                width,
                height,
                weight,
            }],
            load: 0.0,
        };
        let towers = [
            tower(0.0, 2.0, 2.0, ratio),
            tower(10.0, size, 4.0 * size, 1.0),
        ];
        let known = Known::exact(towers::multiplier(&towers, friction));
        let scene = towers::scene(&towers, friction);
        let place = [format!("{ratio:e}"), format!("{size:e}")];
        GridPoint::of_scene(place, known, scene)
    });
    Grid {
        name: "light-beside-heavy",
        x: "weight of the heavy block over that of the light one",
        y: "width of the light block",
        kinds: &[],
        causes: "A heavy block 2 x 2 and, apart from it, a light one four times as high as wide, \
                 friction 0.65; exact: the light one rocks at 0.25. What is measured over the \
                 whole scene alone does not see it. pushover: what is not connected is run by \
                 itself. sequential: in the large atlas it loses the light block from 1e8 on. \
                 macro-block: a block has no stagger, so that it declines.",
        cells,
    }
}

/// A slab on two columns, and a wall under overburden.
pub fn load_on_top(large: bool) -> Grid {
    let all = [0.25, 0.5, 1.0, 2.0, 4.0, 10.0, 1e2, 1e4];
    let ratios = chosen(large, &all, &[4.0, 10.0]);
    let friction = 0.6;
    let capped = |cap: f64| {
        let (multiplier, scene) = towers::capped(cap, friction);
        let place = [cap.to_string(), "cap".to_owned()];
        GridPoint::of_scene(place, Known::exact(multiplier), scene)
    };
    let loaded = |ratio: f64| {
        let (scene, known) = of_library(&format!("overburden-{ratio}"), HeadJoints::Open)?;
        let place = [ratio.to_string(), "overburden".to_owned()];
        Some(GridPoint::of_scene(place, known, scene))
    };
    let caps = ratios.iter().map(|&cap| capped(cap));
    let walls = ratios.iter().filter_map(|&ratio| loaded(ratio));
    let cells = caps.chain(walls).collect();
    Grid {
        name: "load-on-top",
        x: "load on top over the weight below",
        y: "what carries it",
        kinds: &[],
        causes: "cap: a slab on two columns of four blocks 1 x 0.5, friction 0.6; exact: 0.5 \
                 whatever it weighs. overburden: paper-1 with open head joints, HiGHS. pushover: \
                 in the large atlas it refuses the cap that is more than 1e4 times as heavy as a \
                 block. macro-block: of the wall a range that rests on an assumed mechanism, far \
                 wider than 1 %; columns have no stagger.",
        cells,
    }
}
