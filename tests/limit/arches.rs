//! Voussoir arches, which have inclined joints and published answers.

use crate::scenes::arch;
use trilith::answer::{Outcome, Status};
use trilith::judge::judge;
use trilith::method::limit::{Associative, Interval};
use trilith::method::{Method, Settings};
use trilith::scene::Scene;

/// Friction that keeps every joint from sliding.
const ROUGH: f64 = 10.0;

fn judged(method: &dyn Method, scene: &Scene) -> Outcome {
    let mut outcome = method.solve(scene, &Settings::default());
    judge(scene, &mut outcome);
    outcome
}

/// λ_A, verified.
fn multiplier(scene: &Scene) -> f64 {
    let outcome = judged(&Associative, scene);
    assert_eq!(outcome.status, Status::Verified, "{}", outcome.reason());
    outcome.bracket().expect("verified with a bracket").upper
}

fn stands(scene: &Scene) -> bool {
    let outcome = judged(&Associative, scene);
    match outcome.status {
        Status::Verified => true,
        Status::Falls => false,
        status => panic!("{}: {}", status.name(), outcome.reason()),
    }
}

/// Seven voussoirs: Oppenheim, Earthquake Eng. Struct. Dyn. 21 (1992), prints 0.37. All digits: an
/// independent program with HiGHS; half a unit of the last one printed.
#[test]
fn arches_collapse_at_the_published_multipliers() {
    let known = [
        (157.5, 7, 0.37001, 5e-6),
        (157.5, 14, 0.3589, 5e-5),
        (157.5, 28, 0.3547, 5e-5),
        (157.5, 100, 0.3535, 5e-5),
        (180.0, 9, 0.14547, 5e-6),
        (180.0, 15, 0.14975, 5e-6),
        (180.0, 27, 0.14510, 5e-6),
        (180.0, 100, 0.14457, 5e-6),
    ];
    for (embrace, voussoirs, value, tolerance) in known {
        let lambda = multiplier(&arch(0.15, embrace, voussoirs, ROUGH));
        assert!((lambda - value).abs() <= tolerance, "{voussoirs}: {lambda}");
    }
}

/// The thinnest arch that stands: t/R by bisection to 1e-6.
fn thinnest(voussoirs: u32, friction: f64) -> f64 {
    let (mut falling, mut standing) = (0.05, 0.5);
    while standing - falling > 1e-6 {
        let ratio = (falling + standing) / 2.0;
        match stands(&arch(ratio, 180.0, voussoirs, friction)) {
            true => standing = ratio,
            false => falling = ratio,
        }
    }
    standing
}

/// Thinnest semicircles that stand: an independent program with HiGHS, towards Milankovitch's
/// 0.1075 for N → ∞; half a unit of the last digit, and what the search leaves.
#[test]
fn semicircles_stand_from_the_known_thickness_on() {
    for (voussoirs, ratio) in [(9, 0.10213), (15, 0.10627), (27, 0.10678), (100, 0.10746)] {
        let found = thinnest(voussoirs, ROUGH);
        assert!((found - ratio).abs() < 5e-6 + 1e-6, "{voussoirs}: {found}");
    }
}

/// A semicircle of 100 voussoirs slides nowhere for μ ≥ 0.3955, and none stands below 0.309 however
/// thick (computed by others for N → ∞).
#[test]
fn friction_decides_as_known() {
    let thinnest = 0.1076;
    assert!(stands(&arch(thinnest, 180.0, 100, 0.3960)));
    assert!(!stands(&arch(thinnest, 180.0, 100, 0.3945)));
    for ratio in [0.12, 0.2, 0.4, 0.8] {
        assert!(!stands(&arch(ratio, 180.0, 100, 0.3085)), "{ratio}");
    }
    assert!(stands(&arch(0.2, 180.0, 100, 0.3105)));
}

/// Collapse by hinges alone leaves nothing to dilatancy: the interval is λ_A (to 1e-6). With
/// sliding joints it ends verified or says why.
#[test]
fn intervals_of_arches_are_verified() {
    for voussoirs in [7, 28] {
        let scene = arch(0.15, 157.5, voussoirs, ROUGH);
        let (outcome, lambda) = (judged(&Interval, &scene), multiplier(&scene));
        assert_eq!(outcome.status, Status::Verified, "{}", outcome.reason());
        let bracket = outcome.bracket().expect("verified with a bracket");
        assert!(bracket.error(lambda, 1.0) < 1e-6, "{bracket:?} {lambda}");
    }
    for friction in [0.36, 0.4, 0.5] {
        let scene = arch(0.17, 180.0, 27, friction);
        let (outcome, lambda) = (judged(&Interval, &scene), multiplier(&scene));
        assert_eq!(outcome.status, Status::Verified, "{}", outcome.reason());
        let bracket = outcome.bracket().expect("verified with a bracket");
        assert!(bracket.upper <= lambda * (1.0 + 1e-6) && bracket.lower > 0.0);
    }
}
