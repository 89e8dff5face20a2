//! Where a search takes place: in a scene or in a part of it, whose states are completed.

use super::descent::{Approach, Branch, Descent, is_below};
use super::search::{Search, State};
use crate::answer::{SearchFailure, Work};
use crate::mechanics::{
    BlockResidual, CollapseResidual, CollapseState, JointForce, StaticResidual, VERIFIED_RESIDUAL,
};
use crate::method::limit::ending::totals;
use crate::method::limit::noise::Noise;
use crate::method::limit::reduction::ScenePart;
use crate::method::limit::scale::Scale;
use crate::scene::Scene;

/// Where a search takes place: a scene, or a part of it.
#[derive(Clone, Copy)]
pub(super) struct Place<'a> {
    whole: &'a Scene,
    part: Option<&'a ScenePart>,
}

impl<'a> Place<'a> {
    pub(super) fn whole(whole: &'a Scene) -> Self {
        Self { whole, part: None }
    }

    pub(super) fn part(whole: &'a Scene, part: &'a ScenePart) -> Self {
        let part = Some(part);
        Self { whole, part }
    }

    /// The scene that is searched.
    pub(super) fn searched(&self) -> &'a Scene {
        self.part.map_or(self.whole, |part| &part.scene)
    }

    /// Whether it is a part of the scene.
    pub(super) fn is_part(&self) -> bool {
        self.part.is_some()
    }

    /// N of the joints that are searched, over the weight of the scene that is searched, from forces
    /// of the whole scene.
    pub(super) fn normal(&self, forces: &[JointForce]) -> Vec<f64> {
        let unit = self.whole.total_weight();
        let normal = totals(forces).into_iter().map(|n| n / unit);
        self.normal_of(&normal.collect::<Vec<_>>())
    }

    /// The same from N over the whole scene's weight.
    pub(super) fn normal_of(&self, normal: &[f64]) -> Vec<f64> {
        let Some(part) = self.part else {
            return normal.to_vec();
        };
        let unit = self.whole.total_weight() / part.scene.total_weight();
        let joints = part.joints.iter();
        joints.map(|&joint| normal[joint] * unit).collect()
    }

    /// A state in the case's units, completed to one of the whole scene; `None` where its residuals
    /// prove nothing.
    pub(super) fn state(
        &self,
        scale: Scale,
        state: &State,
        work: &mut Work,
    ) -> Option<CollapseState> {
        let mut state = scale.state(state.lambda, &state.forces, &state.velocity);
        if let Some(part) = self.part {
            state.forces = part.complete(self.whole, state.lambda, &state.forces, work)?;
            state.mechanism = part.extend(self.whole, &state.mechanism);
        }
        is_proved(self.whole, &state).then_some(state)
    }

    /// States of the whole scene, by a descent from a state of the part alone, whose forces the rest cannot
    /// bear: the lowest one first, then one that is higher where there is one.
    pub(super) fn beyond_part(
        &self,
        search: &Search,
        state: &State,
        work: &mut Work,
    ) -> Result<Vec<CollapseState>, SearchFailure> {
        let part = self.part.ok_or(SearchFailure::PartOnly)?;
        let mut whole = Search::new(self.whole, search.numerics, search.tuned);
        let [of_part, of_whole] = [search, &whole].map(|search| search.program().scale());
        let mechanism = part.extend(self.whole, &of_part.mechanism(&state.velocity));
        let prices = whole.prices(&of_whole.velocity(self.whole, &mechanism));
        let nearest = whole.nearest(&prices, 1.0);
        let ends = nearest.and_then(|nearest| {
            let mut descent = Descent {
                search: &mut whole,
                approach: Approach::Quick,
                noise: Noise::new(0),
                known: &[],
            };
            let Branch { first, lowest } = descent.follow(totals(&nearest.forces))?;
            Ok([lowest, whole.highest_of(&first)])
        });
        *work = *work + whole.work;
        let [lowest, highest] = ends?.map(|state| {
            let place = Place::whole(self.whole);
            place.state(of_whole, &state, work)
        });
        let lowest = lowest.ok_or(SearchFailure::Unproved)?;
        Ok([lowest].into_iter().chain(highest).collect())
    }

    /// The block that keeps a state of the scene that is searched from being proved.
    pub(super) fn unresolved(&self, scale: Scale, state: &State) -> Option<BlockResidual> {
        let blocks = BlockResidual::of_state(
            self.searched(),
            &scale.state(state.lambda, &state.forces, &state.velocity),
        );
        (!blocks.is_small()).then_some(blocks)
    }

    /// Whether the branch's states are proved in the scene that is searched: what a program calls
    /// solved need not be. A state of a part that is lower than all others must be one of the whole
    /// scene too: else a descent in the whole scene is to begin from it.
    pub(super) fn prove(
        &self,
        scale: Scale,
        branch: &mut Branch,
        lowest: f64,
        work: &mut Work,
    ) -> Result<(), SearchFailure> {
        let searched = Place::whole(self.searched());
        let is_proved = |place: &Place, state: &State, work: &mut Work| {
            place.state(scale, state, work).is_some()
        };
        if !is_proved(&searched, &branch.lowest, work) {
            return Err(SearchFailure::Unproved);
        }
        let is_lower = self.is_part() && is_below(branch.lowest.lambda, lowest);
        if is_lower && !is_proved(self, &branch.lowest, work) {
            return Err(SearchFailure::PartOnly);
        }
        if !is_proved(&searched, &branch.first, work) {
            branch.first = branch.lowest.clone();
        }
        Ok(())
    }
}

fn is_proved(scene: &Scene, state: &CollapseState) -> bool {
    let statics = StaticResidual::of(scene, &state.forces, state.lambda);
    let collapse = CollapseResidual::of(scene, &state.forces, &state.mechanism);
    let of_scene = statics.largest().max(collapse.largest());
    of_scene <= VERIFIED_RESIDUAL && BlockResidual::of_state(scene, state).is_small()
}
