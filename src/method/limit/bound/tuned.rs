//! What the tuned numbers are worth: each is halved and doubled. They may cost a bound some of its
//! height, but what is proved must stay proved, and below the lowest state.

use super::parameters::Parameters;
use super::solve_with;
use crate::certificate::prove;
use crate::method::Settings;
use crate::scene::{HeadJoints, OfBlocks, Piece, Push, Scene, Wall};

/// hh,1,hh of science's table, with its lowest state at 0.264706.
fn scene(head_joints: HeadJoints) -> Scene {
    use Piece::{Half, Unit};
    let wall = Wall {
        unit_length: 4.0,
        unit_height: 4.0,
        thickness: 1.0,
        unit_weight: 1.0,
        courses: vec![vec![Half, Half], vec![Unit], vec![Half, Half]],
        friction: 0.65.into(),
        overburden: 0.0,
        push: Push::Right,
        of_blocks: OfBlocks::default(),
    };
    wall.scene(head_joints).unwrap()
}

const LOWEST: f64 = 0.264_705_9;

#[test]
fn proofs_do_not_hang_on_tuned_numbers() {
    let mut wrong = Vec::new();
    for head_joints in [HeadJoints::Contact, HeadJoints::Open] {
        let scene = scene(head_joints);
        for by in [0.5, 2.0] {
            for (name, parameters) in Parameters::default().each_times(by) {
                let outcome = solve_with(&scene, &Settings::default(), parameters);
                let bracket = outcome.bracket.expect("there is a bound and a state");
                let certificate = outcome.certificate.expect("it is certified");
                let proved = prove(&scene, &certificate);
                println!("{name}: {bracket:?}");
                let is_proved = proved.is_ok_and(|proved| proved.lower >= bracket.lower);
                if !is_proved || bracket.lower > LOWEST || bracket.lower < 0.99 * LOWEST {
                    wrong.push(format!("{name}: {bracket:?}, {proved:?}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
