//! What the limit analysis answers: the closed form, rigid blocks, the interval and its lower bound.

#[path = "../scenes/mod.rs"]
mod scenes;
#[path = "../seeded/mod.rs"]
mod seeded;
#[path = "../share/mod.rs"]
mod share;

mod arches;
mod auto;
mod bound;
mod branches;
mod endings;
mod engines;
mod geometry;
mod growth;
mod interval_descends;
mod invariance;
mod judge_edges;
mod lowest;
mod moves;
mod open_head_joints;
mod own;
mod paper_claims;
mod properties;
mod relations;
mod scales;
mod sequential_law;
mod shapes;
mod starts;
mod states;
mod unbounded;
