//! Several collapse states: a range over what nobody knows of a real wall.
//!
//! What a perpend carries before the push depends on how tightly it was closed, so with head joints
//! in contact the collapse load is not unique: the scene and its mirror image, whose contacts are solved
//! in another order, may meet different states. Nor is it unique where levels of an open scene disagree.

mod head_joints;
mod states;

pub use head_joints::over_head_joints;
pub use states::over_states;
