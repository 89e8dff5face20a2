//! The scene as the protocol writes it: what of it a simulation needs.

use serde::Deserialize;

pub type Pair = [f64; 2];

#[derive(Deserialize)]
pub struct Scene {
    pub blocks: Vec<Block>,
    pub supports: Vec<Support>,
    pub joints: Vec<Joint>,
}

#[derive(Deserialize)]
pub struct Block {
    pub corners: Vec<Pair>,
    pub centroid: Pair,
    pub loads: Vec<Load>,
}

#[derive(Deserialize)]
pub struct Load {
    pub point: Pair,
    pub dead: Pair,
    pub live: Pair,
}

#[derive(Deserialize)]
pub struct Support {
    pub corners: Vec<Pair>,
}

#[derive(Deserialize)]
pub struct Joint {
    pub from_block: Option<usize>,
    pub from_support: Option<usize>,
    pub to: usize,
    pub ends: [Pair; 2],
    pub friction: f64,
    pub class: String,
}

/// Sum of the sizes of all dead loads, then of all live ones.
pub fn sizes(scene: &Scene) -> (f64, f64) {
    let all = || scene.blocks.iter().flat_map(|block| &block.loads);
    let size = |force: Pair| force[0].hypot(force[1]);
    (
        all().map(|load| size(load.dead)).sum(),
        all().map(|load| size(load.live)).sum(),
    )
}

/// The median over the blocks of the smaller side of the box around each.
pub fn median_size(scene: &Scene) -> f64 {
    let extent = |block: &Block, axis: usize| {
        let along = || block.corners.iter().map(|corner| corner[axis]);
        along().fold(f64::MIN, f64::max) - along().fold(f64::MAX, f64::min)
    };
    let mut sizes: Vec<f64> = (scene.blocks.iter())
        .map(|block| extent(block, 0).min(extent(block, 1)))
        .collect();
    sizes.sort_by(f64::total_cmp);
    sizes[sizes.len() / 2]
}
