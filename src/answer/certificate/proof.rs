//! What a certificate proves: sparse products and bounds on what rounding leaves.

use super::conditions::{Conditions, Entry, chains};
use super::sum::Sum;
use super::types::{Certificate, Proved, Refusal, Slice};
use crate::fingerprint::Fingerprint;
use crate::scene::Scene;

/// Outward rounding of the few sums that are not computed in twice the precision: their terms are
/// all positive, so that no sum is wrong by more than its number of terms times 1.2e-16.
const OUTWARD: f64 = 1.0 + 1e-9;

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
    if !(certificate.cap.is_finite() && certificate.lower.is_finite() && certificate.cap >= 0.0) {
        return Err(Refusal::NotFinite);
    }
    let prover = Prover::new(scene, conditions, &certificate.opening)?;
    let mut proved = Proved::default();
    for (index, slice) in certificate.slices.iter().enumerate() {
        let part = prover.slice(slice, certificate.cap, index)?;
        proved = proved.and(slice, part, certificate.cap, index)?;
    }
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

/// What one slice proves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SliceProof {
    /// No collapse state with λ* in the slice has it below this.
    pub(crate) least: f64,
    /// What rounding costs a unit of rates; 0 where the multipliers absorb it.
    pub(crate) deficit: f64,
    /// Largest entry of what rounding leaves of the identity.
    pub(crate) rounding: f64,
}

impl Proved {
    /// What is proved with one more slice, without dimension.
    ///
    /// # Errors
    /// The slice begins above what has been proved.
    pub(crate) fn and(
        self,
        slice: &Slice,
        part: SliceProof,
        cap: f64,
        index: usize,
    ) -> Result<Self, Refusal> {
        if slice.from > self.lower {
            return Err(Refusal::Apart { slice: index });
        }
        let reached = part.least.min(slice.to);
        let needs_cap = reached > self.lower && part.deficit > 0.0;
        Ok(Self {
            lower: self.lower.max(reached),
            cap: if needs_cap { Some(cap) } else { self.cap },
            slices: self.slices + 1,
            rounding: self.rounding.max(part.rounding),
        })
    }
}

/// What every slice of a scene is proved with.
pub(crate) struct Prover {
    conditions: Conditions,
    forces: ForceBound,
    chains: Vec<Vec<(usize, usize, [f64; 3])>>,
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
            chains: chains(scene).ok_or(Refusal::Unsupported)?,
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
        let deficit = deficit(
            &self.conditions,
            slice,
            &rounding,
            &self.forces,
            &self.chains,
        );
        let least = slice.sigma - cap * deficit * OUTWARD;
        let least = least - 1e-15 * (1.0 + least.abs());
        if !least.is_finite() {
            return Err(Refusal::NotFinite);
        }
        Ok(SliceProof {
            least,
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
    let ends = [slice.from, slice.to, slice.sigma];
    let numbers = ends.iter().chain(&slice.multipliers).chain(&slice.balance);
    if !numbers.copied().all(f64::is_finite) || slice.from < 0.0 {
        return Err(Refusal::NotFinite);
    }
    let of_joints = 4 * conditions.joints.len();
    let negative = slice.multipliers.iter().enumerate().any(|(at, &m)| {
        let (force, rate) = (at / rates, at % rates);
        m < 0.0 && !(force == rate && force < of_joints)
    });
    if negative {
        return Err(Refusal::Negative { slice: index });
    }
    Ok(())
}

/// Σ ε N ≤ dead + λ · live over all joints, for every force state.
struct ForceBound {
    /// What each joint opens beyond μ|slip|, at least.
    margin: Vec<f64>,
    dead: f64,
    live: f64,
}

impl ForceBound {
    fn of(conditions: &Conditions, motion: &[f64]) -> Result<Self, Refusal> {
        if motion.len() != conditions.velocities() {
            return Err(Refusal::Size);
        }
        if !motion.iter().all(|v| v.is_finite()) {
            return Err(Refusal::NotFinite);
        }
        // A sum of at most a few hundred terms, and what it may be wrong by.
        let product = |row: &mut dyn Iterator<Item = Entry>| {
            let mut count = 0;
            let terms = row.map(|(k, value)| {
                count += 1;
                value * motion[k]
            });
            let (sum, magnitude) = terms.fold((0.0, 0.0), |(s, m), t: f64| (s + t, m + t.abs()));
            (sum, magnitude * f64::EPSILON * f64::from(count + 2))
        };
        let margin = |(index, joint): (usize, &super::conditions::JointRows)| {
            let [one, other, slip] = joint
                .rates
                .each_ref()
                .map(|row| product(&mut row.iter().copied()));
            let opening = (one.0 - one.1).min(other.0 - other.1);
            let slip = joint.friction * (slip.0.abs() + slip.1);
            let margin = opening - slip - f64::EPSILON * 4.0 * (opening.abs() + slip);
            if margin > 0.0 {
                Ok(margin)
            } else {
                Err(Refusal::Locks { joint: index })
            }
        };
        let margin = conditions.joints.iter().enumerate().map(margin);
        let margin = margin.collect::<Result<_, _>>()?;
        let power = |load: &[f64]| product(&mut load.iter().copied().enumerate());
        let (dead, live) = (power(&conditions.dead), power(&conditions.live));
        Ok(Self {
            margin,
            dead: -dead.0 + dead.1,
            live: live.0.abs() + live.1,
        })
    }

    /// Σ ε N at most, for λ* up to `to`.
    fn total(&self, to: f64) -> f64 {
        (self.dead + to.abs() * self.live).max(0.0) * OUTWARD
    }
}

/// What rounding leaves of the identity: one number at most a force and a kinematic unknown.
struct Rounding {
    /// By kinematic unknown, then by force: 1, λ, and three a joint.
    columns: Vec<Vec<f64>>,
}

impl Rounding {
    fn of(conditions: &Conditions, slice: &Slice) -> Self {
        let (forces, motions) = (conditions.forces(), conditions.motions());
        let velocities = conditions.velocities();
        let mut columns = vec![vec![Sum::default(); forces]; motions];
        for (c, &live) in conditions.live.iter().enumerate() {
            columns[c][1].add(live);
            columns[c][0].add_product(-slice.sigma, live);
        }
        for rate in 0..conditions.rate_rows() {
            let multiple = force_combination(conditions, slice, rate);
            for (c, value) in rate_entries(conditions, rate) {
                for (sum, part) in columns[c].iter_mut().zip(&multiple) {
                    sum.add_multiple(-value, *part);
                }
            }
        }
        for (c, column) in columns.iter_mut().enumerate() {
            let balance = |row: usize| -slice.balance[row * motions + c];
            for row in 0..velocities {
                column[0].add_product(balance(row), conditions.dead[row]);
                column[1].add_product(balance(row), conditions.live[row]);
            }
            for (j, joint) in conditions.joints.iter().enumerate() {
                for (kind, entries) in joint.rates.iter().enumerate() {
                    for &(row, value) in entries {
                        column[2 + 3 * j + kind].add_product(balance(row), value);
                    }
                }
            }
        }
        // No entry is a sum of more than this: the power's column of every joint and the loads.
        let steps = 64.0 * (conditions.rate_rows() + velocities) as f64;
        let largest = |column: Vec<Sum>| column.iter().map(|sum| sum.largest(steps)).collect();
        Self {
            columns: columns.into_iter().map(largest).collect(),
        }
    }

    fn largest(&self) -> f64 {
        self.columns.iter().flatten().copied().fold(0.0, f64::max)
    }

    /// The largest that one kinematic unknown's column can be, times any forces.
    fn over_forces(
        &self,
        motion: usize,
        conditions: &Conditions,
        slice: &Slice,
        forces: &ForceBound,
    ) -> f64 {
        let column = &self.columns[motion];
        let of_lambda = slice.from.abs().max(slice.to.abs());
        let joints = conditions.joints.iter().zip(&forces.margin).enumerate();
        let of_joint = joints.map(|(j, (joint, margin))| {
            let at = 2 + 3 * j;
            (column[at].max(column[at + 1]) + joint.friction * column[at + 2]) / margin
        });
        let of_joints = of_joint.fold(0.0, f64::max);
        (column[0] + of_lambda * column[1] + forces.total(slice.to) * of_joints) * OUTWARD
    }
}

/// Σ over the force conditions of multiplier · condition, for one rate: 1, λ and three a joint.
fn force_combination(conditions: &Conditions, slice: &Slice, rate: usize) -> Vec<Sum> {
    let rates = conditions.rate_rows();
    let multiplier = |force: usize| slice.multipliers[force * rates + rate];
    let mut parts = vec![Sum::default(); conditions.forces()];
    for (j, joint) in conditions.joints.iter().enumerate() {
        let [one, other, forward, backward] = [0, 1, 2, 3].map(|k| multiplier(4 * j + k));
        for (kind, own) in [one, other].into_iter().enumerate() {
            let part = &mut parts[2 + 3 * j + kind];
            part.add(own);
            part.add_product(joint.friction, forward);
            part.add_product(joint.friction, backward);
        }
        let part = &mut parts[2 + 3 * j + 2];
        part.add(forward);
        part.add(-backward);
    }
    let [one, above, below] = [0, 1, 2].map(|k| multiplier(4 * conditions.joints.len() + k));
    parts[0].add(one);
    parts[0].add_product(-slice.from, above);
    parts[0].add_product(slice.to, below);
    parts[1].add(above);
    parts[1].add(-below);
    parts
}

/// A rate as a combination of the kinematic unknowns.
fn rate_entries(conditions: &Conditions, rate: usize) -> Vec<Entry> {
    let (joint, kind) = (rate / 4, rate % 4);
    let Some(rows) = conditions.joints.get(joint) else {
        return conditions.live.iter().copied().enumerate().collect();
    };
    let forward = (conditions.velocities() + joint, 1.0);
    match kind {
        0 | 1 => rows.rates[kind].clone(),
        2 => vec![forward],
        _ => {
            let slip = rows.rates[2].iter().map(|&(k, value)| (k, -value));
            slip.chain([forward]).collect()
        }
    }
}

/// How much more a unit of some rate can cost by rounding than the multipliers of that rate absorb:
/// the bound is lower by this times the sum of all rates; 0 where they absorb all.
fn deficit(
    conditions: &Conditions,
    slice: &Slice,
    rounding: &Rounding,
    forces: &ForceBound,
    chains: &[Vec<(usize, usize, [f64; 3])>],
) -> f64 {
    let over = |motion| rounding.over_forces(motion, conditions, slice, forces);
    let velocities = conditions.velocities();
    let mut needed = vec![0.0; 4 * conditions.joints.len()];
    for (block, chain) in chains.iter().enumerate() {
        let of_block = [0, 1, 2].map(|k| over(3 * block + k));
        for &(joint, kind, share) in chain {
            let parts = share.iter().zip(&of_block);
            let cost: f64 = parts.map(|(share, of)| share.abs() * of).sum();
            needed[4 * joint + kind] += cost;
            if kind == 2 {
                needed[4 * joint + 3] += cost;
            }
        }
    }
    for joint in 0..conditions.joints.len() {
        needed[4 * joint + 2] += over(velocities + joint);
    }
    let rates = conditions.rate_rows();
    let of_joints = 4 * conditions.joints.len();
    let deficits = needed.iter().enumerate().map(|(rate, needed)| {
        let [one, above, below] =
            [0, 1, 2].map(|k| slice.multipliers[(of_joints + k) * rates + rate]);
        let absorbed = one + (slice.to - slice.from).max(0.0) * above.min(below);
        needed * OUTWARD - absorbed * (1.0 - 1e-9)
    });
    // A NaN must not be passed over.
    deficits.fold(0.0, |most: f64, deficit| {
        if deficit.is_nan() {
            f64::INFINITY
        } else {
            most.max(deficit)
        }
    })
}
