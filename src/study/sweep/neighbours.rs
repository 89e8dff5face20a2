//! The interval's search, started from the states of neighbouring points too.
//!
//! A state of the next wall along an axis is often close to one that this wall's own starts miss.
//! The neighbours' states are searched again with every point, so that a point stays a function of
//! itself alone: shards and resumed sweeps give the same rows as one run.

use super::variants::Variant;
use crate::answer::{Outcome, Work};
use crate::method::limit::Interval;
use crate::method::{Method, Settings};
use crate::scene::{HeadJoints, Scene};

/// The interval on one wall, with the walls beside it on an axis.
pub(super) struct FromNeighbours<'a> {
    pub neighbours: Vec<&'a Variant>,
    pub head_joints: HeadJoints,
}

impl Method for FromNeighbours<'_> {
    fn name(&self) -> &str {
        Interval.name()
    }

    fn solve(&self, scene: &Scene, settings: &Settings) -> Outcome {
        let mut work = Work::default();
        let mut starts = Vec::new();
        for neighbour in &self.neighbours {
            let other = neighbour
                .case
                .geometry
                .scene(self.head_joints, scene.push());
            let outcome = Interval.solve(&other, settings);
            work = work + outcome.work;
            let weight = other.total_weight();
            let normals = outcome.evidence.forces().map(|(_, forces)| forces);
            let normals = normals.filter(|forces| forces.len() == scene.joints().len());
            starts.extend(normals.map(|forces| -> Vec<f64> {
                let total = |normal: [f64; 2]| (normal[0] + normal[1]).max(0.0) / weight;
                forces.iter().map(|force| total(force.normal)).collect()
            }));
        }
        let mut outcome = Interval.solve_from(scene, settings, &starts);
        let modelled = outcome.work.modelled;
        outcome.work = outcome.work + work;
        outcome.work.modelled = modelled;
        outcome
    }
}
