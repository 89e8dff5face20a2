//! Settings of head joints as an argument.

use crate::case::{Case, Geometry};
use crate::scene::HeadJoints;
use clap::ValueEnum;

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum HeadJointsArgument {
    /// They carry pressure and friction.
    Contact,
    /// They carry nothing.
    Open,
    /// Both, one after the other.
    Both,
}

impl HeadJointsArgument {
    /// The one setting; `None` for both.
    pub(super) fn one(self) -> Option<HeadJoints> {
        match self {
            HeadJointsArgument::Contact => Some(HeadJoints::Contact),
            HeadJointsArgument::Open => Some(HeadJoints::Open),
            HeadJointsArgument::Both => None,
        }
    }

    /// Lets cases run with both, where that is said. An arch has no head joints, and runs once.
    pub(super) fn set(self, cases: &mut [Case]) {
        let walls = cases
            .iter_mut()
            .filter(|case| !matches!(case.geometry, Geometry::Arch(_)));
        for case in walls.filter(|_| self.one().is_none()) {
            case.head_joints = vec![HeadJoints::Contact, HeadJoints::Open];
        }
    }
}
