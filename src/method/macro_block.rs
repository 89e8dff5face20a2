//! The macro-block model: one crack, two macro-blocks, closed form (paper, section 2).

use super::{Method, Settings};
use crate::answer::{Bracket, Evidence, InapplicableForm, Invalid, Outcome, Status};
use crate::mechanics::Crack;
use crate::scene::{RegularWall, Scene};

/// The closed-form method. `lower` and `upper` are λ_low and λ_upp of Eq. (5): a range that
/// rests on an assumed mechanism, therefore an estimate and no bound.
pub struct MacroBlock;

impl Method for MacroBlock {
    fn name(&self) -> &str {
        "macro-block"
    }

    fn solve(&self, scene: &Scene, _settings: &Settings) -> Outcome {
        match of_scene(scene) {
            Err(reason) => Outcome::without_number(Status::NotApplicable, reason),
            Ok(range) => {
                let evidence = Evidence::ClosedForm {
                    bracket: Bracket {
                        lower: range.lower,
                        upper: range.upper,
                    },
                    crack: Crack {
                        c: None,
                        e: None,
                        tan_beta: range.tan_beta,
                        sharp: true,
                    },
                };
                Outcome::with(Status::Estimate, evidence)
            }
        }
    }
}

fn of_scene(scene: &Scene) -> Result<MultiplierRange, InapplicableForm> {
    Ok(collapse_range(scene.regular()?)?)
}

/// λ_low, λ_upp and the crack slope they share.
#[derive(Clone, Copy, Debug, PartialEq)]
struct MultiplierRange {
    /// Eq. (5) without friction along the crack.
    lower: f64,
    /// Eq. (5) with all friction along the crack.
    upper: f64,
    /// Crack slope tan β of Eq. (6).
    tan_beta: f64,
}

/// Walls may lie exactly on a limit of validity, as the paper's examples 2 and 3 do.
const EQUAL: f64 = 1.0 + 1e-9;

/// Section 2.1.2: the slope of the smallest multiplier with full friction, then both multipliers.
///
/// # Errors
/// [`Invalid`] names the condition α_c ≤ α_b ≤ α_p or tan β ≥ 0 that fails.
fn collapse_range(wall: &RegularWall) -> Result<MultiplierRange, Invalid> {
    let stagger = wall.overlap / wall.unit_height;
    let aspect = wall.length / wall.height;
    if stagger > aspect * EQUAL {
        return Err(Invalid::ShortWall { stagger, aspect });
    }
    let friction = friction_force(wall);
    let tan_beta = crack_slope(wall, friction);
    if tan_beta < 0.0 {
        return Err(Invalid::NegativeSlope { tan_beta });
    }
    let crack = crack_inclination(wall, tan_beta);
    if crack > stagger * EQUAL {
        return Err(Invalid::FlatCrack { crack, stagger });
    }
    Ok(MultiplierRange {
        lower: multiplier(wall, tan_beta, 0.0),
        upper: multiplier(wall, tan_beta, friction),
        tan_beta,
    })
}

/// Eq. (1): F = [p H tan α_b + (H tan α_b + s) H γ / 2] b f, all friction along the crack.
fn friction_force(wall: &RegularWall) -> f64 {
    let reach = wall.height * wall.overlap / wall.unit_height;
    let weight =
        wall.overburden * reach + (reach + wall.overlap) * wall.height / 2.0 * wall.specific_weight;
    weight * wall.thickness * wall.friction
}

/// Eq. (2): tan α_c = (H tan β + s) / H.
fn crack_inclination(wall: &RegularWall, tan_beta: f64) -> f64 {
    (wall.height * tan_beta + wall.overlap) / wall.height
}

/// Eq. (3): weights P of the overburden, P1 of the triangle, P2 of the strip on the macro-block.
fn weights(wall: &RegularWall, tan_beta: f64) -> (f64, f64, f64) {
    let (h, s, b) = (wall.height, wall.overlap, wall.thickness);
    let overburden = wall.overburden * b * (h * tan_beta + s);
    let triangle = h * h * tan_beta / 2.0 * b * wall.specific_weight;
    let strip = s * h * b * wall.specific_weight;
    (overburden, triangle, strip)
}

/// Eq. (5): Eq. (4), the virtual work of a rotation about the toe, solved for λ.
fn multiplier(wall: &RegularWall, tan_beta: f64, friction: f64) -> f64 {
    let (h, s) = (wall.height, wall.overlap);
    let (p, p1, p2) = weights(wall, tan_beta);
    let resisting = p * (h * tan_beta + s) / 2.0
        + p1 * (h * tan_beta / 3.0 + s)
        + p2 * s / 2.0
        + friction * h / 3.0;
    let driving = p * h + p1 * 2.0 / 3.0 * h + p2 * h / 2.0;
    resisting / driving
}

/// Eq. (6): the tan β that makes Eq. (5) smallest.
fn crack_slope(wall: &RegularWall, friction: f64) -> f64 {
    let (r, t, v) = dimensionless(wall, friction);
    let root = (3.0 * t * t * (1.0 + 4.0 * r) + 8.0 * v * (1.0 + 3.0 * r)).sqrt();
    (root - 3.0 * t * (1.0 + 2.0 * r)) / (2.0 * (1.0 + 3.0 * r))
}

/// Eq. (7): r = p/(Hγ), t = s/H, v = F/(b H² γ).
fn dimensionless(wall: &RegularWall, friction: f64) -> (f64, f64, f64) {
    let (h, gamma) = (wall.height, wall.specific_weight);
    (
        wall.overburden / (h * gamma),
        wall.overlap / h,
        friction / (wall.thickness * h * h * gamma),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wall(l: f64, h: f64, mu: f64, courses: f64, units: f64) -> RegularWall {
        RegularWall {
            height: courses * h,
            length: units * l,
            overlap: l / 2.0,
            unit_height: h,
            thickness: 1.0,
            specific_weight: 1.0 / (l * h),
            overburden: 0.0,
            friction: mu,
        }
    }

    /// Table 1 of the paper, with the digits of the formulas beyond the printed ones.
    #[test]
    fn table_1_to_its_last_digit() {
        let cases = [
            (wall(4.0, 1.75, 0.65, 6.0, 5.0), 0.94545, 0.48712, 0.65974),
            (wall(4.0, 1.75, 0.65, 10.0, 5.0), 0.90936, 0.46007, 0.73793),
            (wall(3.0, 1.0, 0.75, 48.0, 24.0), 1.07199, 0.53634, 1.02512),
        ];
        for (wall, upper, lower, tan_beta) in cases {
            let range = collapse_range(&wall).unwrap();
            assert!((range.upper - upper).abs() < 6e-6, "{range:?}");
            assert!((range.lower - lower).abs() < 6e-6, "{range:?}");
            assert!((range.tan_beta - tan_beta).abs() < 6e-6, "{range:?}");
        }
    }

    /// Eq. (6) is the minimum of Eq. (5), with and without overburden.
    #[test]
    fn the_slope_minimises_the_multiplier() {
        for r in [0.0, 0.5, 3.0, 10.0] {
            let mut wall = wall(4.0, 1.75, 0.65, 6.0, 5.0);
            wall.overburden = r * wall.height * wall.specific_weight;
            let friction = friction_force(&wall);
            let best = crack_slope(&wall, friction);
            let at = |tan_beta| multiplier(&wall, tan_beta, friction);
            assert!(
                at(best) <= at(best + 1e-3) && at(best) <= at(best - 1e-3),
                "r = {r}"
            );
        }
    }

    #[test]
    fn limits_of_validity_are_named() {
        let short = wall(4.0, 1.75, 0.65, 6.0, 1.0);
        assert!(matches!(
            collapse_range(&short),
            Err(Invalid::ShortWall { .. })
        ));
        let rough = wall(4.0, 1.75, 3.0, 6.0, 5.0);
        assert!(matches!(
            collapse_range(&rough),
            Err(Invalid::FlatCrack { .. })
        ));
        let mut smooth = wall(4.0, 1.75, 0.0, 2.0, 5.0);
        assert!(matches!(
            collapse_range(&smooth),
            Err(Invalid::NegativeSlope { .. })
        ));
        smooth.friction = 0.65;
        assert!(collapse_range(&smooth).is_ok());
    }
}
