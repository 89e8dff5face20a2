//! What the pushover answers.

#[path = "../random/mod.rs"]
mod random;
#[path = "../scenes/mod.rs"]
mod scenes;
#[path = "../share/mod.rs"]
mod share;

mod accuracy;
mod arches;
mod builders;
mod checks;
mod cracks;
mod falling;
mod hardly_stands;
mod moves;
mod not_convex;
mod random_walls;
mod refusals;
mod small;
mod tall_walls;
mod unequal;
