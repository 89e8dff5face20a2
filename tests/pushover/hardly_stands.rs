//! Stacks that hardly stand: their multipliers are as small as the steps of the pushover's grid.

use crate::random::Random;
use crate::scenes::{homogeneous, rectangle, scene};
use trilith::answer::Status;
use trilith::method::pushover::Pushover;
use trilith::method::{Method, Settings};

/// A block as its width, its height and the middle of its base.
type Laid = [f64; 3];

/// A random stack, and its multiplier in closed form: the least of all edges, of each the distance across
/// to the centroid of what lies above it, over the height of that centroid. One part of the stack is laid
/// so far out that it rocks about the edge below it at λ.
fn stack(random: &mut Random, lambda: f64) -> (Vec<Laid>, f64) {
    let count = 2 + random.below(7);
    let mut at = 0.0;
    let mut blocks: Vec<Laid> = Vec::new();
    for _ in 0..count {
        blocks.push([random.between(0.6, 1.5), random.between(0.5, 1.5), at]);
        at += random.between(-0.1, 0.1);
    }
    let from = 1 + random.below(count - 1);
    let (arm, height) = above(&blocks, from);
    for block in &mut blocks[from..] {
        block[2] += arm - lambda * height;
    }
    let of_edge = |edge: usize| {
        let (arm, height) = above(&blocks, edge);
        arm / height
    };
    let least = (0..count).map(of_edge).fold(f64::INFINITY, f64::min);
    (blocks, least)
}

/// From the right edge of what carries the block `from` to the centroid of what lies on it: across, up.
fn above(blocks: &[Laid], from: usize) -> (f64, f64) {
    let base: f64 = blocks[..from].iter().map(|block| block[1]).sum();
    let (mut weight, mut x, mut y, mut low) = (0.0, 0.0, 0.0, base);
    for [width, height, middle] in &blocks[from..] {
        let own = width * height;
        weight += own;
        x += own * middle;
        y += own * (low + height / 2.0);
        low += height;
    }
    let right = |[width, _, middle]: &Laid| middle + width / 2.0;
    let own = right(&blocks[from]);
    let edge = from
        .checked_sub(1)
        .map_or(own, |below| own.min(right(&blocks[below])));
    (edge - x / weight, y / weight - base)
}

/// Two levels that see the same step of the grid suffice: no further one sees more. The closed form lies
/// within the stated error of every answer, and none is refused.
#[test]
fn what_hardly_stands_is_within_its_stated_error() {
    let mut random = Random(2026);
    let mut answered = 0;
    for _ in 0..60 {
        let lambda = random.between(0.0, 6e-3);
        let (laid, exact) = stack(&mut random, lambda);
        let mut low = 0.0;
        let blocks = laid.iter().map(|&[width, height, middle]| {
            low += height;
            let [left, right] = [middle - width / 2.0, middle + width / 2.0];
            homogeneous(rectangle(left, right, low - height, low))
        });
        let scene = scene(blocks.collect(), vec![rectangle(-9.0, 9.0, -1.0, 0.0)], 0.7);
        let outcome = Pushover.solve(&scene, &Settings::default());
        if exact < 0.0 {
            assert_eq!(
                outcome.status,
                Status::Falls,
                "{laid:?}: {}",
                outcome.reason()
            );
            continue;
        }
        answered += 1;
        let bracket = outcome
            .bracket()
            .unwrap_or_else(|| panic!("{laid:?}: {}", outcome.reason()));
        let stated = outcome
            .evidence
            .stated_error()
            .expect("a pushover states its error");
        let off = (bracket.lower - exact).max(exact - bracket.upper);
        assert!(
            off <= stated * exact.max(1e-3),
            "{laid:?}: {bracket:?} for {exact}"
        );
    }
    assert!(answered >= 50, "{answered} stand");
}
