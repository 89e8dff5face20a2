//! What a certificate proves: what its slices prove one by one, and all of them together.

use super::conditions::{Chain, Conditions, chains};
use super::forces::{ForceBound, OUTWARD};
use super::rounding::{Rounding, deficits};
use super::tree::{SliceProof, together};
use super::types::{Certificate, Proved, Refusal, Slice};
use crate::fingerprint::Fingerprint;
use crate::scene::Scene;

/// What tells the conditions of a scene from those of every other, to nine digits.
pub(crate) fn scene_fingerprint(conditions: &Conditions) -> String {
    let mut fingerprint = Fingerprint::new();
    let mut add = |values: &mut dyn Iterator<Item = f64>| {
        let text: String = values.map(|value| format!("{value:.8e} ")).collect();
        fingerprint.add(text.as_bytes());
    };
    add(&mut conditions.dead.iter().copied());
    add(&mut conditions.live.iter().copied());
    for joint in &conditions.joints {
        add(&mut [joint.friction].into_iter());
        for row in &joint.rates {
            add(&mut row.iter().flat_map(|&(place, value)| [place as f64, value]));
        }
    }
    fingerprint.hex()
}

/// Proves a certificate for a scene.
///
/// # Errors
/// Why it proves nothing, or less than it claims.
pub fn prove(scene: &Scene, certificate: &Certificate) -> Result<Proved, Refusal> {
    let conditions = Conditions::of(scene);
    if certificate.scene != scene_fingerprint(&conditions) {
        return Err(Refusal::OtherScene);
    }
    let (lower, cap) = (certificate.lower, certificate.cap);
    if !cap.is_finite() || lower.is_nan() {
        return Err(Refusal::NotFinite);
    }
    if lower <= 0.0 {
        return Err(Refusal::Nothing { claimed: lower });
    }
    if cap < 1.0 {
        return Err(Refusal::Capped { cap });
    }
    let conditions = conditions.with_slip_bounds(scene, certificate.longest_way);
    let prover = Prover::new(scene, conditions, &certificate.opening)?;
    let slices = certificate.slices.iter().enumerate();
    let parts = slices.map(|(index, slice)| prover.slice(slice, certificate.cap, index));
    let parts = parts.collect::<Result<Vec<_>, _>>()?;
    let slices = certificate.slices.iter().zip(parts).collect::<Vec<_>>();
    let mut proved = together(&slices, certificate.cap)?;
    proved.lower *= prover.conditions.unit;
    // Written so that a NaN proves nothing.
    if certificate.lower <= proved.lower {
        proved.lower = certificate.lower;
        Ok(proved)
    } else {
        Err(Refusal::Less {
            claimed: certificate.lower,
            proved: proved.lower,
        })
    }
}

/// What every slice of a scene is proved with.
pub(crate) struct Prover {
    conditions: Conditions,
    forces: ForceBound,
    chains: Vec<Chain>,
}

impl Prover {
    /// For a scene and a motion that opens every joint by more than μ times its slip.
    ///
    /// # Errors
    /// The motion does not bound the forces, or a block hangs on nothing.
    pub(crate) fn new(
        scene: &Scene,
        conditions: Conditions,
        opening: &[f64],
    ) -> Result<Self, Refusal> {
        Ok(Self {
            forces: ForceBound::of(&conditions, opening)?,
            chains: chains(scene, &conditions).ok_or(Refusal::Unsupported)?,
            conditions,
        })
    }

    /// The scene's conditions.
    pub(crate) fn conditions(&self) -> &Conditions {
        &self.conditions
    }

    /// What a slice proves of motions whose rates add up to no more than `cap`.
    ///
    /// # Errors
    /// Its numbers are none of the scene.
    pub(crate) fn slice(
        &self,
        slice: &Slice,
        cap: f64,
        index: usize,
    ) -> Result<SliceProof, Refusal> {
        check(&self.conditions, slice, index)?;
        let rounding = Rounding::of(&self.conditions, slice);
        let [deficit, of_power] = deficits(
            &self.conditions,
            slice,
            &rounding,
            &self.forces,
            &self.chains,
        );
        let least = slice.sigma - (cap * deficit + of_power) * OUTWARD;
        let least = least - 1e-15 * (1.0 + least.abs());
        if !least.is_finite() {
            return Err(Refusal::NotFinite);
        }
        Ok(SliceProof {
            least: match slice.to.is_finite() {
                true => least,
                // Not for motions up to a cap alone.
                false if least > 0.0 && deficit == 0.0 => f64::INFINITY,
                false => slice.from,
            },
            deficit,
            rounding: rounding.largest(),
        })
    }
}

/// Sizes, signs and finite numbers.
fn check(conditions: &Conditions, slice: &Slice, index: usize) -> Result<(), Refusal> {
    let rates = conditions.rate_rows();
    let sizes = slice.multipliers.len() == conditions.force_rows() * rates
        && slice.balance.len() == conditions.velocities() * conditions.motions();
    if !sizes {
        return Err(Refusal::Size);
    }
    if slice.to.is_nan() {
        return Err(Refusal::NotFinite);
    }
    if slice.to.is_infinite() && slice.from != 0.0 {
        return Err(Refusal::Endless { slice: index });
    }
    let ends = [slice.from, slice.sigma];
    let numbers = ends.iter().chain(&slice.multipliers).chain(&slice.balance);
    if !numbers.copied().all(f64::is_finite) || slice.from < 0.0 {
        return Err(Refusal::NotFinite);
    }
    let of_joints = 4 * conditions.joints.len();
    let mut pairs: Vec<usize> = slice.assumed.iter().map(|assumed| assumed.pair).collect();
    pairs.sort_unstable();
    pairs.dedup();
    if pairs.len() < slice.assumed.len() || pairs.last().is_some_and(|&pair| pair >= of_joints) {
        return Err(Refusal::Size);
    }
    let zeros = slice.zeros(conditions.joints.len());
    let mut multipliers = slice.multipliers.iter().enumerate();
    if multipliers.any(|(at, &m)| m < 0.0 && !zeros.is_zero(at / rates, at % rates)) {
        return Err(Refusal::Negative { slice: index });
    }
    Ok(())
}
