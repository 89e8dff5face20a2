//! The geometry of cases: arches of true annular sectors, explicit scenes that say the same as a
//! coursed wall, and both sides of a push.

use crate::scenes::{laid, mirrored, small_walls};
use crate::seeded::seeded;
use proptest::prelude::*;
use trilith::answer::Status;
use trilith::case::{Case, find};
use trilith::method::limit::{Associative, Interval};
use trilith::method::{Method, Settings};
use trilith::run::{Row, answer};
use trilith::scene::{Arch, Forces, HeadJoints, JointClass, Push, Scene};

const BOTH: [HeadJoints; 2] = [HeadJoints::Contact, HeadJoints::Open];

fn case(name: &str) -> Case {
    find(name)
        .unwrap_or_else(|complaint| panic!("{complaint}"))
        .remove(0)
}

/// λ_A's verified bracket.
fn multiplier(scene: &Scene) -> [f64; 2] {
    let outcome = Associative.solve(scene, &Settings::default());
    assert_eq!(outcome.status, Status::Verified, "{}", outcome.reason());
    let bracket = outcome.bracket().expect("verified with a bracket");
    [bracket.lower, bracket.upper]
}

/// Area and centroid of an annular sector of half-angle `half`, centred on the vertical, by adding
/// up thin rings: no formula in common with the generator.
fn summed_sector(inner: f64, outer: f64, half: f64) -> (f64, f64) {
    const RINGS: u32 = 20_000;
    let step = (outer - inner) / f64::from(RINGS);
    let (mut area, mut moment) = (0.0, 0.0);
    for ring in 0..RINGS {
        let radius = inner + step * (f64::from(ring) + 0.5);
        area += 2.0 * half * radius * step;
        // The mean of cos over the ring's angle is sin(half)/half.
        moment += 2.0 * half.sin() * radius * radius * step;
    }
    (area, moment / area)
}

proptest! {
    #![proptest_config(seeded(2026, 32))]

    /// Every arch weighs what its sectors do, at their centroids, and its joints are radial.
    #[test]
    fn arches_are_made_of_annular_sectors(
        mean_radius in 0.5..20.0f64,
        ratio in 0.02..1.5f64,
        embrace in 20.0..260.0f64,
        voussoirs in 4u32..60,
        specific_weight in 0.1..30.0f64,
    ) {
        let thickness = ratio * mean_radius;
        let arch = Arch {
            mean_radius,
            thickness,
            embrace,
            voussoirs,
            specific_weight,
            friction: 0.6.into(),
            forces: Forces::default(),
        };
        let assembly = arch.assembly().unwrap();
        prop_assert!(assembly.check().is_ok(), "{:?}", assembly.check());
        let half = embrace.to_radians() / f64::from(voussoirs) / 2.0;
        let (inner, outer) = (mean_radius - thickness / 2.0, mean_radius + thickness / 2.0);
        let (area, centre) = summed_sector(inner, outer, half);
        for (k, block) in assembly.blocks.iter().enumerate() {
            prop_assert!((block.weight / (area * specific_weight) - 1.0).abs() < 1e-8);
            prop_assert!((block.centre.coords.norm() / centre - 1.0).abs() < 1e-8);
            let angle = embrace.to_radians() / 2.0 - half * (2.0 * k as f64 + 1.0);
            let from_crown = (-block.centre.x).atan2(block.centre.y);
            prop_assert!((from_crown - angle).abs() < 1e-9);
        }
        let scene = assembly.scene(HeadJoints::Contact, Push::Right).expect("the numbers are proper");
        prop_assert_eq!(scene.joints().len(), voussoirs as usize + 1);
        for joint in scene.joints() {
            prop_assert!(joint.class != JointClass::Head);
            prop_assert!((joint.length() / thickness - 1.0).abs() < 1e-6);
            let radial = joint.ends[0].coords.normalize();
            prop_assert!(radial.dot(&joint.normal).abs() < 1e-6);
        }
    }
}

/// Block by block, paper-1 has the joints of the coursed wall, and its multiplier.
#[test]
fn an_explicit_copy_of_a_wall_gives_the_walls_multiplier() {
    let (wall, blocks) = (case("paper-1"), case("paper-1-blocks"));
    for head_joints in BOTH {
        let (wall, blocks) = (wall.scene(head_joints), blocks.scene(head_joints));
        let count =
            |scene: &Scene, class| scene.joints().iter().filter(|j| j.class == class).count();
        for class in [JointClass::Base, JointClass::Bed, JointClass::Head] {
            assert_eq!(count(&wall, class), count(&blocks, class), "{class:?}");
        }
        assert!((wall.total_weight() - blocks.total_weight()).abs() < 1e-9);
        for (a, b) in multiplier(&wall).into_iter().zip(multiplier(&blocks)) {
            assert!((a / b - 1.0).abs() < 1e-8, "{a} {b}");
        }
    }
}

/// Every wall of Ferris & Tin-Loi, written as explicit blocks in a case file, read back.
#[test]
fn walls_written_block_by_block_are_read_as_the_same_scene() {
    for (name, wall) in small_walls() {
        let scene = laid(&wall, HeadJoints::Contact);
        let shape = |corners: &[trilith::scene::Point]| {
            let corners = corners.iter().map(|p| format!("[{:?}, {:?}]", p.x, p.y));
            corners.collect::<Vec<_>>().join(", ")
        };
        let mut text = "friction = 0.65\n".to_owned();
        for support in scene.supports() {
            let corners = shape(support.corners());
            text += &format!("[[support]]\nname = \"ground\"\ncorners = [{corners}]\n");
        }
        for (k, block) in scene.blocks().iter().enumerate() {
            let corners = shape(block.shape.corners());
            let weight = -block.loads[0].dead.y;
            text +=
                &format!("[[block]]\nname = \"{k}\"\nweight = {weight:?}\ncorners = [{corners}]\n");
        }
        let read = Case::read("copy.toml", text.as_bytes());
        let read = read.unwrap_or_else(|complaint| panic!("{name}: {complaint}"));
        let copy = read.scene(HeadJoints::Contact);
        assert_eq!(copy.blocks(), scene.blocks(), "{name}");
        assert_eq!(copy.joints(), scene.joints(), "{name}");
    }
}

/// Explicit scenes and arches mirrored, with the push, give the multiplier of the original.
#[test]
fn mirrored_scenes_give_the_same_multiplier() {
    let names = [
        "trilith",
        "trapezoid-rocks",
        "triangle-both",
        "slope-slides",
        "eccentric-load",
        "oppenheim-14",
    ];
    for name in names {
        let scene = case(name).scene(HeadJoints::Contact);
        for (a, b) in multiplier(&scene)
            .into_iter()
            .zip(multiplier(&mirrored(&scene)))
        {
            assert!((a / b - 1.0).abs() < 1e-6, "{name}: {a} {b}");
        }
    }
}

#[test]
fn the_weaker_of_both_sides_is_the_answer() {
    the_weaker_side_answers(&["triangle-both", "slope-both", "eccentric-load-both"]);
}

#[test]
#[ignore = "long walls, pushed six times: in release"]
fn the_weaker_of_both_sides_is_the_answer_on_walls() {
    the_weaker_side_answers(&["running-third", "running-quarter"]);
}

/// Pushed both ways, the weaker side answers, with its own mechanism; pushed one way, that side.
fn the_weaker_side_answers(names: &[&str]) {
    let settings = Settings::default();
    for &name in names {
        let case = case(name);
        for method in [&Associative as &dyn Method, &Interval] {
            for &head_joints in &case.head_joints {
                let sides = case.sides(head_joints);
                assert_eq!(
                    [sides[0].push(), sides[1].push()],
                    [Push::Right, Push::Left]
                );
                let solved = |sides: &[Scene]| answer(sides, method, settings);
                let both = solved(&sides);
                let one = [solved(&sides[..1]), solved(&sides[1..])];
                let lower = |k: usize| one[k].outcome.bracket().unwrap().lower;
                let weaker = usize::from(lower(1) < lower(0));
                assert_eq!(both.push, one[weaker].push, "{name}");
                let least = |end: fn(&Row) -> f64| end(&one[0]).min(end(&one[1]));
                let bracket = both.bracket().unwrap();
                assert_eq!(
                    bracket.lower,
                    least(|row| row.bracket().unwrap().lower),
                    "{name}"
                );
                assert_eq!(
                    bracket.upper,
                    least(|row| row.bracket().unwrap().upper),
                    "{name}"
                );
                assert_eq!(
                    both.outcome.evidence.mechanism(),
                    one[weaker].outcome.evidence.mechanism(),
                    "{name}"
                );
                let reason = both.reason();
                let other = one[1 - weaker].bracket().unwrap();
                let says = match bracket.upper < other.lower {
                    true => "the wall is weaker when pushed to the ",
                    false => "the lowest collapse known is that of the push to the ",
                };
                assert!(reason.starts_with(says), "{name}: {reason}");
            }
        }
    }
}
