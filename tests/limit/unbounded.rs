//! Scenes that no push collapses by associative friction, and what that says without dilatancy.
//!
//! Two seeded classes: few voussoirs of rough joints, with loads that press as they push; and small walls whose
//! weights push downwards as they push sideways. A ray of forces within friction leaves λ_A without limit; joints
//! that would wedge with dilatancy slip without it, so that many of these scenes collapse all the same.

use crate::share::share;
use trilith::answer::{Certificate, Evidence, Outcome, Status};
use trilith::inside::{Standing, prove};
use trilith::judge::judge;
use trilith::method::limit::{Associative, Interval, Sequential};
use trilith::method::{Auto, Method, Settings, methods};
use trilith::scene::{
    Arch, Assembly, Force, Forces, HeadJoints, Own, Piece, Push, Scene, Vector, Wall,
};

/// Deterministic noise (xorshift).
struct Noise(u64);

impl Noise {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        low + (high - low) * ((self.0 >> 11) as f64 / (1u64 << 53) as f64)
    }

    fn whole(&mut self, low: u32, high: u32) -> u32 {
        self.between(f64::from(low), f64::from(high) + 1.0) as u32
    }
}

/// An arch of 2 to 5 voussoirs with one to three loads on them, dead and live.
fn scene(noise: &mut Noise) -> Scene {
    let arch = Arch {
        mean_radius: 1.0,
        thickness: noise.between(0.1, 0.5),
        embrace: noise.between(40.0, 180.0),
        voussoirs: noise.whole(2, 5),
        specific_weight: 1.0,
        friction: noise.between(0.5, 2.0).into(),
        forces: Forces::default(),
    };
    let assembly = arch.assembly().expect("a proper arch");
    let weight = assembly.blocks[0].weight;
    let extra = (0..noise.whole(1, 3)).map(|_| {
        let block = noise.whole(0, arch.voussoirs - 1) as usize;
        let mut force = |low: f64, high: f64| weight * noise.between(low, high);
        let (dead, live) = (
            Vector::new(0.0, force(-5.0, 0.0)),
            Vector::new(force(0.0, 2.0), force(-3.0, 3.0)),
        );
        Force {
            block,
            point: assembly.blocks[block].centre,
            dead,
            live,
        }
    });
    let extra = extra.collect();
    let loaded = Assembly {
        forces: Forces {
            extra,
            ..Forces::default()
        },
        ..assembly.clone()
    };
    let scene = loaded.scene(HeadJoints::Contact, Push::Right);
    scene.expect("the numbers are proper")
}

/// A running bond of three or four courses of two or three units, of which up to 3.3 of every weight push
/// downwards as the whole weight pushes sideways.
fn pressed_wall(noise: &mut Noise) -> Scene {
    let units = noise.whole(2, 3) as usize;
    let course = |course: u32| {
        let ends = [Piece::Half].repeat((course % 2) as usize);
        let within = vec![Piece::Unit; units - ends.len()];
        [ends.clone(), within, ends].concat()
    };
    let of_weight = Vector::new(1.0, -noise.between(0.3, 3.3));
    let wall = Wall {
        unit_length: 4.0,
        unit_height: noise.between(1.0, 5.0),
        thickness: 1.0,
        unit_weight: 1.0,
        courses: (0..noise.whole(3, 4)).map(course).collect(),
        friction: noise.between(0.3, 1.5).into(),
        overburden: 0.0,
        push: Push::Right,
        own: Own {
            forces: Forces {
                of_weight,
                ..Forces::default()
            },
            ..Own::default()
        },
    };
    let head_joints = [HeadJoints::Open, HeadJoints::Contact][noise.whole(0, 1) as usize];
    wall.scene(head_joints).expect("it can be laid")
}

/// Arches that stand for associative friction, out of `tried`.
fn unbounded(seed: u64, tried: usize) -> Vec<Scene> {
    unbounded_of(scene, seed, tried)
}

/// Scenes of a class that do, out of `tried`.
fn unbounded_of(scene: fn(&mut Noise) -> Scene, seed: u64, tried: usize) -> Vec<Scene> {
    let mut noise = Noise(seed);
    let scenes = (0..tried).map(|_| scene(&mut noise));
    let stands = |scene: &Scene| judged(&Associative, scene).status == Status::Stands;
    scenes.filter(stands).collect()
}

fn bound() -> &'static dyn Method {
    let methods = methods();
    let named = methods.into_iter().find(|method| method.name() == "bound");
    named.expect("it is one of the methods")
}

fn judged(method: &dyn Method, scene: &Scene) -> Outcome {
    let mut outcome = method.solve(scene, &Settings::default());
    judge(scene, &mut outcome);
    outcome
}

/// Counts of (stands, verified, undecided) by the interval. No answer contradicts another.
fn counts(seed: u64, tried: usize) -> [usize; 3] {
    let mut counts = [0; 3];
    for (index, scene) in unbounded(seed, tried).iter().enumerate() {
        let interval = judged(&Interval, scene);
        let sequential = judged(&Sequential, scene);
        let auto = judged(&Auto, scene);
        let what = format!(
            "seed {seed}, scene {index}: {}; {}; {}",
            interval.reason(),
            sequential.reason(),
            auto.reason()
        );
        let place = match interval.status {
            Status::Stands => 0,
            Status::Verified => 1,
            Status::Undecided => 2,
            status => panic!("{what}: {}", status.name()),
        };
        counts[place] += 1;
        let stands = interval.status == Status::Stands;
        assert!(!stands || !interval.evidence.stands_by_friction(), "{what}");
        // The sequential method is not made of lifted programs.
        let by_lift = interval.evidence.certificate().is_some();
        assert_eq!(
            stands && !by_lift,
            sequential.status == Status::Stands,
            "{what}"
        );
        assert_eq!(stands, auto.status == Status::Stands, "{what}");
        assert!(stands || auto.status == Status::Undecided, "{what}");
        // A converged state of the sequential method is proved, or near one that the interval has.
        if let (Some(found), Some(state)) = (interval.bracket(), sequential.bracket())
            && sequential.status == Status::Verified
        {
            assert!(state.lower >= found.lower * (1.0 - 1e-6), "{what}");
        }
    }
    counts
}

#[test]
fn what_stands_with_dilatancy_is_searched_without() {
    let [stands, verified, undecided] = counts(0x5EED, 400);
    println!("{stands} stand, {verified} have verified states, {undecided} undecided");
    assert!(stands + verified + undecided >= 20);
    assert!(verified >= 20, "{verified} of {undecided}");
}

#[test]
#[ignore = "hundreds of scenes of the class"]
fn hundreds_of_scenes_contradict_nothing() {
    for seed in 1..=share(10) as u64 {
        let [stands, verified, undecided] = counts(seed, 400);
        println!("seed {seed}: {stands} stand, {verified} verified, {undecided} undecided");
    }
}

/// Where a push can be carried without limit by friction with dilatancy, lower bounds without it are proved all the
/// same, if only the joints can all open at once; and where no state is found, that there is none.
#[test]
fn bounds_of_pressed_walls_are_proved() {
    let [enclosed, stands, never_open] = proved_counts(pressed_wall, 7, 60, 12);
    println!("{enclosed} are enclosed, {stands} stand, {never_open} do not open");
    assert!(
        enclosed >= 5 && stands >= 10 && never_open == 0,
        "{enclosed} {stands} {never_open}"
    );
}

/// No motion opens all joints of most arches between their springings; of most others it is proved that they stand.
#[test]
fn that_arches_stand_is_proved_where_they_open() {
    let [enclosed, stands, never_open] = proved_counts(scene, 1, 400, 12);
    println!("{enclosed} are enclosed, {stands} stand, {never_open} do not open");
    assert!(
        enclosed >= 1 && stands >= 20,
        "{enclosed} {stands} {never_open}"
    );
}

#[test]
#[ignore = "hundreds of scenes of both classes"]
fn hundreds_of_proofs_that_scenes_stand_contradict_nothing() {
    for seed in 1..=share(2) as u64 {
        for scene in [pressed_wall, scene] {
            let [enclosed, stands, never_open] = proved_counts(scene, 100 + seed, 200, usize::MAX);
            println!(
                "seed {seed}: {enclosed} are enclosed, {stands} stand, {never_open} do not open"
            );
        }
    }
}

/// Of scenes of a class, of so many blocks at most, that stand with associative friction: how many have a lowest state
/// that a proved bound meets, of how many without a state it is proved that they stand, and of how many nothing is, as
/// no motion opens all their joints. None contradicts another answer.
fn proved_counts(
    scene: fn(&mut Noise) -> Scene,
    seed: u64,
    tried: usize,
    most_blocks: usize,
) -> [usize; 3] {
    let [mut enclosed, mut stands, mut never_open] = [0; 3];
    let scenes = unbounded_of(scene, seed, tried).into_iter();
    let scenes = scenes.filter(|scene| scene.blocks().len() <= most_blocks);
    for (index, scene) in scenes.enumerate() {
        let scene = &scene;
        let mut interval = Interval.solve(scene, &search_alone());
        judge(scene, &mut interval);
        let bound = judged(bound(), scene);
        let what = format!("{index}: {}; {}", interval.reason(), bound.reason());
        let has_state = interval.status == Status::Verified;
        if has_state && bound.evidence.certificate().is_some() {
            let bracket = bound.bracket().expect("there is a state");
            let width = bracket.upper - bracket.lower;
            assert!((0.0..1e-4 * bracket.upper).contains(&width), "{what}");
            enclosed += 1;
        } else if bound.evidence.certificate().is_some() {
            assert_eq!(bound.status, Status::Stands, "{what}");
            assert!(!has_state && !bound.evidence.stands_by_friction(), "{what}");
            assert_nothing_collapses(scene, &bound);
            stands += 1;
        } else if bound.reason().contains("opens every joint") {
            never_open += 1;
        } else {
            println!("{what}");
        }
    }
    [enclosed, stands, never_open]
}

/// Settings with which the interval searches and asks no lifted program.
fn search_alone() -> Settings {
    let mut settings = Settings::default();
    settings.bound.lift_unknowns = 1;
    settings
}

/// Neither a longer search nor the sequential method has a collapse state, and the certificate proves that there is
/// none; what is changed in it proves nothing.
fn assert_nothing_collapses(scene: &Scene, stands: &Outcome) {
    let mut longer = search_alone();
    longer.interval.starts = 50;
    assert_eq!(Interval.solve(scene, &longer).bracket(), None);
    assert_ne!(judged(&Sequential, scene).status, Status::Verified);
    let certificate = stands.evidence.certificate().expect("it is proved");
    let bytes = certificate.to_bytes();
    let read = Certificate::from_bytes(&bytes).expect("it is whole");
    assert_eq!(
        prove(scene, &read).map(|proved| (proved.lower, proved.cap)),
        Ok((f64::INFINITY, None))
    );
    let mut bare = stands.clone();
    if let Evidence::Stands { standing, .. } = &mut bare.evidence {
        *standing = Standing::Certified { certificate: None };
    }
    judge(scene, &mut bare);
    assert_eq!(bare.status, Status::Failed);
    let is_refused = |change: &dyn Fn(&mut Certificate)| {
        let mut changed = certificate.clone();
        change(&mut changed);
        prove(scene, &changed).is_err()
    };
    assert!(is_refused(&|c| c.slices[0].from = 0.1));
    assert!(is_refused(&|c| c.slices[0].to = 1e9));
    assert!(is_refused(&|c| c.slices[0].sigma = -c.slices[0].sigma));
    assert!(is_refused(&|c| c.slices[0].sigma *= 2.0));
    assert!(is_refused(&|c| c.slices[0].balance.fill(0.0)));
    assert!(is_refused(&|c| c.slices[0].multipliers.fill(0.0)));
    assert!(is_refused(&|c| c.slices[0].multipliers[1] = -1.0));
    assert!(is_refused(&|c| c.slices.clear()));
    assert!(is_refused(&|c| c.lower = f64::NAN));
}

/// A ray that needs friction proves that a scene stands for associative friction, and nothing
/// without dilatancy.
#[test]
fn a_ray_with_friction_is_no_proof_without_dilatancy() {
    let mut refuted = 0;
    for scene in unbounded(0x5EED, 400) {
        let mut outcome = Associative.solve(&scene, &Settings::default());
        if let Evidence::Stands { standing, .. } = &mut outcome.evidence {
            *standing = Standing::WithoutFriction;
        }
        judge(&scene, &mut outcome);
        let without = judged(&Interval, &scene).status == Status::Stands;
        assert!(outcome.status == Status::Stands || outcome.status == Status::Failed);
        refuted += usize::from(outcome.status == Status::Failed && !without);
    }
    assert!(refuted > 10, "{refuted}");
}
