//! Answers in the terms of those who judge a wall: how far it could be tilted, its base shear, what
//! moves first, and the mechanism in words.

use std::fmt;

use crate::judge::Conclusion;
use crate::mechanics::{Moved, MovingPart};
use crate::number::short;
use crate::run::CaseResult;
use crate::scene::{Block, Scene, Vector};
use crate::text::enumerated;

/// The best answer about a scene in these terms.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Terms {
    /// The ground may be tilted by arctan λ, in degrees, where the live load is every weight sideways.
    pub tilt: Option<f64>,
    /// What the supports carry along x, positive in the direction of the live load, in the case's unit of
    /// force: the dead loads' part and λ times the live load.
    pub base_shear: Option<f64>,
    /// The part of it that comes from the push.
    pub push_shear: Option<f64>,
    /// What these are in, where the case says no weight.
    pub unit_of_force: Option<&'static str>,
    /// The blocks that move fastest.
    pub first_blocks: Vec<String>,
    /// The joints that open or slip fastest.
    pub first_joints: Vec<String>,
    /// The parts that move, each as one body.
    pub moving: Vec<MovingPart>,
    /// How it moves.
    pub mechanism: Option<String>,
    /// Where a support moves, the joints that open most, each with its opening over the support's motion.
    pub cracks: Vec<(String, f64)>,
}

/// The conclusion about a head-joint setting in these terms; `None` where there is no answer behind it.
pub(crate) fn terms(result: &CaseResult, conclusion: &Conclusion) -> Option<Terms> {
    let rows = result.rows.iter();
    let mut rows = rows.filter(|row| row.head_joints == conclusion.head_joints);
    let first = conclusion.methods.first()?;
    let row = rows.find(|row| row.method == *first)?;
    let row = &*row.of_side(conclusion.push);
    let (scene, evidence) = (result.scene(row), &row.outcome.evidence);
    // The reaction of a support is no push.
    let lambda = conclusion.bracket.filter(|_| scene.reaction().is_none());
    let lambda = lambda.map(|bracket| bracket.lower);
    let along = |load: fn(&Block) -> [f64; 3]| -> f64 {
        let blocks = scene.blocks().iter();
        blocks.map(|block| load(block)[0]).sum()
    };
    // In the direction of the live load, whatever the case calls its push.
    let sign = if along(Block::live) < 0.0 { -1.0 } else { 1.0 };
    let push_shear = lambda.map(|lambda| sign * lambda * along(Block::live));
    // Of several states, the lowest: the multiplier that the answer gives.
    let moved = evidence.mechanism();
    let moved = moved.map(|mechanism| Moved::new(scene, mechanism, evidence.still()));
    let tilt = lambda.filter(|_| weights_push(scene));
    Some(Terms {
        cracks: match (scene.reaction(), &moved) {
            (Some(_), Some(moved)) => moved.cracks(),
            _ => Vec::new(),
        },
        tilt: tilt.map(|lambda| lambda.atan().to_degrees()),
        base_shear: push_shear.map(|push| sign * along(Block::dead) + push),
        push_shear,
        unit_of_force: result.case.is_weight_unsaid.then_some("weight of a unit"),
        first_blocks: moved.as_ref().map_or(Vec::new(), Moved::first_blocks),
        first_joints: moved.as_ref().map_or(Vec::new(), Moved::first_joints),
        moving: moved.as_ref().map_or(Vec::new(), Moved::moving_parts),
        mechanism: moved.as_ref().and_then(Moved::words),
    })
}

/// Whether every live force is its dead one turned sideways, and so the push a tilt of the ground.
fn weights_push(scene: &Scene) -> bool {
    let sign = scene.push().sign();
    let loads = scene.blocks().iter().flat_map(|block| &block.loads);
    let mut loads = loads.map(|load| {
        let turned = Vector::new(-sign * load.dead.y, 0.0);
        (load.live - turned).norm() <= 1e-9 * load.dead.norm() && load.dead.x == 0.0
    });
    loads.all(|alike| alike)
}

impl fmt::Display for Terms {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let shear = self.base_shear.zip(self.push_shear).map(|(all, push)| {
            let [all, push] = [all, push].map(|shear| short(shear, 4));
            let unit = self.unit_of_force;
            let unit = unit.map_or(String::new(), |unit| format!(" times the {unit}"));
            match all == push {
                true => format!("the base shear is {all}{unit}"),
                false => {
                    format!("the base shear is {all}{unit}, of which {push} comes from the push")
                }
            }
        });
        let first = match self.first_blocks.as_slice() {
            [] => None,
            [one] => Some(format!("{one} moves first")),
            several => Some(format!("{} move first", enumerated(several))),
        };
        let cracks = self.cracks.iter();
        let cracks: Vec<String> = cracks
            .map(|(joint, opening)| format!("{} at {joint}", short(10.0 * opening, 2)))
            .collect();
        let cracks = (!cracks.is_empty()).then(|| {
            let cracks = cracks.join(", ");
            format!("for the first 10 of the support's motion joints open by {cracks}")
        });
        let all = [shear, self.mechanism.clone(), first, cracks];
        let all: Vec<String> = all.into_iter().flatten().collect();
        f.write_str(&all.join("; "))
    }
}
