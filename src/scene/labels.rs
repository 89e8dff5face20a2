//! What people call a scene and its blocks.

/// Names for people and for outside programs; no method needs them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Labels {
    /// The case that the scene is of; empty where it is of none.
    pub case: String,
    /// One name a block, in their order, or none at all.
    pub blocks: Vec<String>,
}
