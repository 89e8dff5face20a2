//! What every method gets: convex blocks with forces, joints, friction, and nothing else.

mod arch;
mod assembly;
mod block;
mod bond;
mod connected;
mod derived;
mod friction;
mod joints;
mod labels;
mod model;
mod parts;
mod polygon;
mod push;
mod regular;
mod soundness;
mod wall;

pub use arch::Arch;
pub use assembly::{Assembly, Force, Forces, NamedBlock, Support};
pub use block::{Block, Load, Wrench};
pub(crate) use bond::{BONDS, Bond, LowestCourse};
pub(crate) use connected::connected;
pub use friction::Friction;
pub(crate) use joints::TOUCHING;
pub use joints::{Joint, JointClass, Side};
pub use labels::Labels;
pub use model::Scene;
pub(crate) use model::multiplier_unit;
pub use parts::{SceneError, SceneParts};
pub use polygon::{Point, Polygon, PolygonError, Vector};
pub use push::{HeadJoints, Push};
pub use regular::{Coursing, Irregularity, RegularWall, WallFacts};
pub use soundness::Unsound;
pub use wall::{Course, Piece, Wall, WallError};
