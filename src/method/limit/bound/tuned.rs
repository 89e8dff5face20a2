//! What the tuned numbers are worth: each is halved and doubled. They may cost a bound some of its
//! height, but what is proved must stay proved, and below the lowest state.

use super::parameters::Parameters;
use super::solve_with;
use crate::certificate::prove;
use crate::method::Settings;
use crate::method::limit::walls::{LOWEST_OF_SMALL_WALL as LOWEST, small_wall};
use crate::scene::HeadJoints;

#[test]
fn proofs_do_not_hang_on_tuned_numbers() {
    let mut wrong = Vec::new();
    for head_joints in [HeadJoints::Contact, HeadJoints::Open] {
        let scene = small_wall(head_joints);
        for by in [0.5, 2.0] {
            for (name, parameters) in Parameters::TUNED.each_times(by) {
                let outcome = solve_with(&scene, &Settings::default(), parameters, &());
                let bracket = outcome.bracket().expect("there is a bound and a state");
                let certificate = outcome.evidence.certificate().expect("it is certified");
                let proved = prove(&scene, certificate);
                println!("{name} × {by}: {bracket:?}");
                let is_proved = proved.is_ok_and(|proved| proved.lower >= bracket.lower);
                if !is_proved || bracket.lower > LOWEST || bracket.lower < 0.99 * LOWEST {
                    wrong.push(format!("{name} × {by}: {bracket:?}, {proved:?}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
