use super::Bound;
use crate::answer::Outcome;
use crate::method::{Method, Settings};
use crate::scene::{HeadJoints, Piece, Push, Scene, Wall};

fn wall(unit: [f64; 2], courses: &[&str], head: HeadJoints) -> Scene {
    let course = |text: &&str| {
        text.chars()
            .map(|c| match c {
                'h' => Piece::Half,
                'g' => Piece::Gap,
                _ => Piece::Unit,
            })
            .collect()
    };
    let wall = Wall {
        unit_length: unit[0],
        unit_height: unit[1],
        thickness: 1.0,
        unit_weight: 1.0,
        courses: courses.iter().map(course).collect(),
        friction: 0.65.into(),
        overburden: 0.0,
        push: Push::Right,
    };
    wall.scene(head).unwrap()
}

/// The walls of `science.md` section 7.
fn bound(scene: &Scene) -> Outcome {
    let mut outcome = Bound.solve(scene, &Settings::default());
    let clock = cpu_time::ThreadTime::now();
    let residual = crate::judge::judge(scene, &mut outcome);
    println!("{:?} {:?} {residual:?} judged {:?}: {}", outcome.status, outcome.bracket, clock.elapsed(), outcome.reason());
    outcome
}

#[test]
fn trial() {
    let courses = std::env::var("COURSES").unwrap_or("h1h,11,h1h".into());
    let unit = std::env::var("UNIT").unwrap_or("4x4".into());
    let unit: Vec<f64> = unit.split('x').map(|x| x.parse().unwrap()).collect();
    let number = |name: &str, or: f64| std::env::var(name).map_or(or, |v| v.parse().unwrap());
    let head = if std::env::var_os("OPEN").is_some() { HeadJoints::Open } else { HeadJoints::Contact };
    let names: Vec<&str> = courses.split(',').collect();
    let names = names.repeat(number("REPEAT", 1.0) as usize);
    let scene = wall([unit[0], unit[1]], &names, head);
    let clock = cpu_time::ThreadTime::now();
    bound(&scene);
    println!("{:?}", clock.elapsed());
}
