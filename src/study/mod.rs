//! Studies: many runs as one question. Sweeps over values, speed against accuracy, and the atlas of
//! where each method is right, refuses, or fails.

pub(crate) mod atlas;
pub(crate) mod chart;
pub(crate) mod sweep;
