//! A case once it is read.

use super::complaint::Complaint;
use super::geometry::Geometry;
use super::reference::Reference;
use crate::method::limit::moving;
use crate::scene::{HeadJoints, Labels, Push, Scene, SupportMotion};

/// A wall, how it runs, and what its results are compared with.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// The file's name without `.toml`; the name in tables, snapshots and on the command line.
    pub name: String,
    /// One line for people.
    pub title: String,
    /// Where the wall comes from; may be empty.
    pub source: String,
    /// What it is made of. It can be laid: reading the case has tried.
    pub geometry: Geometry,
    /// The directions it is pushed in, one or both; the weaker side is the answer.
    pub pushes: Vec<Push>,
    /// What the head joints carry, one after the other, in the order of its results; never empty.
    pub head_joints: Vec<HeadJoints>,
    /// How supports move, where they do: then their reaction is the live load.
    pub(crate) motion: Option<SupportMotion>,
    /// The λ that is demanded of it, positive: answers give λ over it.
    pub demand: Option<f64>,
    /// Whether its file says no weight: then forces are in weights of a unit, and λ depends on none.
    pub is_weight_unsaid: bool,
    /// Values to compare with.
    pub references: Vec<Reference>,
    /// What may be a slip in its file, and was taken as it is written.
    pub warnings: Vec<Complaint>,
}

impl Case {
    /// What every method gets, one scene a direction of the push.
    ///
    /// # Panics
    /// As [`Geometry::scene`].
    pub fn sides(&self, head_joints: HeadJoints) -> Vec<Scene> {
        let scene = |&push| self.pushed(head_joints, push);
        self.pushes.iter().map(scene).collect()
    }

    /// The first of [`sides`](Self::sides).
    ///
    /// # Panics
    /// As [`Geometry::scene`], and where `pushes` is empty.
    pub fn scene(&self, head_joints: HeadJoints) -> Scene {
        self.pushed(head_joints, self.pushes[0])
    }

    /// The scene for one setting and one direction, with the names of the case.
    ///
    /// # Panics
    /// As [`Geometry::scene`].
    pub fn pushed(&self, head_joints: HeadJoints, push: Push) -> Scene {
        let labels = Labels {
            case: self.name.clone(),
            blocks: self.geometry.block_names(),
        };
        let scene = self.geometry.scene(head_joints, push).with_labels(labels);
        match &self.motion {
            Some(motion) => moving(scene, motion),
            None => scene,
        }
    }
}
