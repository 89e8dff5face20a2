//! Light and small blocks beside, on and under heavy ones: closed forms, which measures over the
//! whole scene would miss.

use crate::scenes::{ground, rectangle, scene, weighted};
use trilith::answer::{Bracket, Fact, Outcome, Status};
use trilith::inside::PushoverFact;
use trilith::method::pushover::Pushover;
use trilith::method::{Method, Settings};
use trilith::scene::{Block, Scene};

/// A block `[x0, x1] × [y0, y1]` with a weight.
fn block([x0, x1, y0, y1]: [f64; 4], weight: f64) -> Block {
    let shape = rectangle(x0, x1, y0, y1);
    let centre = shape.centroid();
    weighted(shape, weight, centre)
}

fn laid(blocks: Vec<Block>) -> Scene {
    scene(blocks, vec![ground()], 0.65)
}

fn pushed(scene: &Scene) -> Outcome {
    Pushover.solve(scene, &Settings::default())
}

/// Within the error that the answer itself states.
fn assert_right(what: &str, scene: &Scene, exact: f64) {
    let outcome = pushed(scene);
    let (Some(Bracket { lower, upper }), Some(error)) =
        (outcome.bracket(), outcome.evidence.stated_error())
    else {
        panic!("{what}: {:?} {}", outcome.status, outcome.reason());
    };
    let off = (lower - exact).max(exact - upper) / exact;
    assert!(
        off <= error,
        "{what}: {lower}-{upper} ± {error} for {exact}"
    );
    assert!(error <= 2e-3, "{what}: {error}");
}

/// A heavy flat block slides at μ = 0.65; whatever is slender rocks at b/h = 0.25 long before.
#[test]
fn a_light_block_rocks_beside_and_on_a_heavy_one() {
    let heavy = [0.0, 4.0, 0.0, 2.0];
    for ratio in [1.0, 0.1, 1e-2, 1e-3, 1e-4] {
        for width in [0.3, 0.5, 1.0] {
            let rocks = |x: f64, y: f64| [x, x + width, y, y + 4.0 * width];
            let beside = laid(vec![block(heavy, 1.0), block(rocks(10.0, 0.0), ratio)]);
            assert_right(&format!("beside, {ratio} {width}"), &beside, 0.25);
            let on = laid(vec![block(heavy, 1.0), block(rocks(1.0, 2.0), ratio)]);
            assert_right(&format!("on top, {ratio} {width}"), &on, 0.25);
            let halves = [
                [1.0, 1.0 + width, 2.0, 2.0 + 2.0 * width],
                [1.0, 1.0 + width, 2.0 + 2.0 * width, 2.0 + 4.0 * width],
            ];
            let two = [
                vec![block(heavy, 1.0)],
                halves.map(|of| block(of, ratio)).into(),
            ];
            assert_right(
                &format!("two on top, {ratio} {width}"),
                &laid(two.concat()),
                0.25,
            );
        }
    }
}

/// Two blocks of one width b, of which the lower is lighter: they rock together about the toe, at
/// b/2 over the height of their centre of mass.
#[test]
fn a_light_block_carries_a_heavy_one() {
    for ratio in [1.0, 0.1, 1e-2, 1e-3, 1e-4] {
        let stack = laid(vec![
            block([0.0, 1.0, 0.0, 1.0], ratio),
            block([0.0, 1.0, 1.0, 2.0], 1.0),
        ]);
        let centre = (0.5 * ratio + 1.5) / (ratio + 1.0);
        assert_right(&format!("under, {ratio}"), &stack, 0.5 / centre);
    }
}

/// Pinnacles of specific weight 1: down to a hundredth of the size, and a ten-thousandth of the
/// weight, of what they stand on.
#[test]
fn a_small_block_rocks_on_a_large_one() {
    for size in [1.0, 0.3, 0.1, 0.03, 0.01] {
        let small = [1.0, 1.0 + 0.5 * size, 2.0, 2.0 + 2.0 * size];
        let large = block([0.0, 4.0, 0.0, 2.0], 1.0);
        let scene = laid(vec![large, block(small, size * size)]);
        assert_right(&format!("size {size}"), &scene, 0.25);
    }
}

/// Beyond a ratio of 1e4 within one part there is no number but a refusal that names the blocks.
/// Parts that do not touch are judged one by one, whatever their ratio.
#[test]
fn beyond_the_ratio_the_blocks_are_named() {
    let heavy = block([0.0, 4.0, 0.0, 2.0], 1e6);
    let on = laid(vec![heavy.clone(), block([1.0, 1.5, 2.0, 4.0], 1.0)]);
    let outcome = pushed(&on);
    assert_eq!(outcome.status, Status::Undecided);
    let [
        Fact::Pushover(PushoverFact::UnequalWeights {
            light,
            heavy: named,
            ..
        }),
    ] = &outcome.facts[..]
    else {
        panic!("{:?}", outcome.facts);
    };
    assert_eq!((light.as_str(), named.as_str()), ("block 2", "block 1"));
    let beside = laid(vec![heavy.clone(), block([9.0, 9.5, 0.0, 2.0], 1.0)]);
    assert_right("beside", &beside, 0.25);
    let small = laid(vec![heavy.clone(), block([9.0, 9.0001, 0.0, 0.001], 1.0)]);
    assert_right("small and beside", &small, 0.1);
    let leaning = [
        block([9.0, 10.0, 0.0, 1.0], 1.0),
        block([9.8, 11.8, 1.0, 2.0], 1.0),
    ];
    let falls = pushed(&laid([vec![heavy], leaning.into()].concat()));
    assert_eq!(falls.status, Status::Falls, "{}", falls.reason());
}
