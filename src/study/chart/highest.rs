//! The highest collapse states without dilatancy that another code found, which no case cites.

use crate::scene::HeadJoints;

/// Case, setting and λ of the highest state: `states` of `tests/reference/limit.py` (HiGHS, SciPy
/// 1.17.1, 40 starts in contact and 20 open, seed 14), whose lowest are those that the cases cite. Six
/// digits, as the cases have.
const HIGHEST: [(&str, HeadJoints, f64); 5] = [
    ("paper-1", HeadJoints::Contact, 0.642859),
    ("paper-2", HeadJoints::Contact, 0.579317),
    ("paper-2", HeadJoints::Open, 0.562907),
    ("openings-3", HeadJoints::Contact, 0.402648),
    ("openings-4", HeadJoints::Contact, 0.322823),
];

/// The highest state of a scene, where it is not the lowest.
pub fn highest(case: &str, head_joints: HeadJoints) -> Option<f64> {
    let known = HIGHEST
        .iter()
        .find(|(name, setting, _)| *name == case && *setting == head_joints);
    known.map(|(_, _, lambda)| *lambda)
}
