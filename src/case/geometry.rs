//! What a case is made of.

use crate::scene::{Arch, Assembly, HeadJoints, Push, Scene, Wall};

/// The structure of a case.
#[derive(Clone, Debug, PartialEq)]
pub enum Geometry {
    /// A coursed wall.
    Wall(Wall),
    /// Explicit blocks.
    Blocks(Assembly),
    /// A voussoir arch.
    Arch(Arch),
}

impl Geometry {
    /// The scene for one setting and one direction of the push.
    ///
    /// # Panics
    /// Only where the geometry was changed by hand into one that cannot be laid: reading a case
    /// lays it for every setting.
    pub fn scene(&self, head_joints: HeadJoints, push: Push) -> Scene {
        match self {
            Geometry::Wall(wall) => {
                let wall = Wall {
                    push,
                    ..wall.clone()
                };
                let scene = wall.scene(head_joints);
                scene.expect("the wall was laid when the case was read")
            }
            Geometry::Blocks(_) | Geometry::Arch(_) => {
                let scene = self.assembly().scene(head_joints, push);
                scene.expect("the numbers were checked when the case was read")
            }
        }
    }

    /// Blocks, supports, friction and forces, whichever form they were written in.
    ///
    /// # Panics
    /// As [`scene`](Self::scene).
    pub fn assembly(&self) -> Assembly {
        match self {
            Geometry::Wall(wall) => {
                let assembly = wall.assembly();
                assembly.expect("the wall was laid when the case was read")
            }
            Geometry::Blocks(assembly) => assembly.clone(),
            Geometry::Arch(arch) => {
                let assembly = arch.assembly();
                assembly.expect("the arch was built when the case was read")
            }
        }
    }

    /// What the blocks are called, in the order of the scene's blocks: by the case, or by their
    /// place.
    pub fn block_names(&self) -> Vec<String> {
        match self {
            Geometry::Wall(wall) => wall.block_names(),
            Geometry::Blocks(assembly) => assembly.block_names(),
            Geometry::Arch(arch) => (1..=arch.voussoirs).map(|k| k.to_string()).collect(),
        }
    }
}
