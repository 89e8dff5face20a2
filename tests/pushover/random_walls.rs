//! Random walls as builders lay them, pushed and compared with verified states and bounds of the
//! limit analysis, which shares no code with the pushover.

use crate::random::Random;
use crate::scenes::{ground, homogeneous, rectangle, scene};
use crate::share::share;
use trilith::answer::{Bracket, Outcome, Status};
use trilith::inside::solve_with;
use trilith::judge::judge;
use trilith::method::limit::{Associative, Interval};
use trilith::method::pushover::Pushover;
use trilith::method::{Method, PushoverSettings, Settings};
use trilith::scene::{Block, HeadJoints, Load, Scene, Vector};

/// A wall in running bond: half-units are the grid. An opening has a lintel on it, and a cap lies on
/// all of the top course or on a part of it.
fn wall(seed: u64) -> Scene {
    let mut random = Random(seed.wrapping_mul(0x2545_F491_4F6C_DD1D));
    let columns = 4 + 2 * random.below(5);
    let courses = 3 + random.below(9);
    let half = random.between(0.3, 1.5);
    let opening = random.one_in(3) && columns >= 8 && courses >= 5;
    let (from, to) = (2 + random.below(2), columns - 2 - random.below(2));
    let (sill, head) = (1 + random.below(courses - 2), courses - 2);
    let open = |course: usize| opening && (sill..head).contains(&course);
    let cell = |a: usize, b: usize, course: usize| {
        rectangle(
            a as f64 * half,
            b as f64 * half,
            course as f64,
            course as f64 + 1.0,
        )
    };
    let mut blocks = Vec::new();
    for course in 0..courses {
        let mut cuts: Vec<usize> = (0..=columns)
            .filter(|at| (at + course) % 2 == 0 || [0, columns].contains(at))
            .collect();
        if open(course) {
            cuts.extend([from, to]);
        }
        let lintel = [from - 1, to + 1];
        if opening && course == head {
            cuts.retain(|at| *at <= lintel[0] || *at >= lintel[1]);
            cuts.extend(lintel);
        }
        cuts.sort_unstable();
        cuts.dedup();
        for pair in cuts.windows(2) {
            let inside = open(course) && pair[0] >= from && pair[1] <= to;
            if !inside {
                blocks.push(homogeneous(cell(pair[0], pair[1], course)));
            }
        }
    }
    let top = courses as f64;
    if random.one_in(3) {
        let (left, right) = match random.one_in(2) {
            true => (0.0, columns as f64 * half),
            false => (half, (columns - 2) as f64 * half),
        };
        let high = random.between(0.3, 2.0);
        blocks.push(homogeneous(rectangle(left, right, top, top + high)));
    }
    if random.one_in(3) {
        load(&mut blocks, random.between(0.1, 10.0), random.one_in(2));
    }
    let friction = random.between(0.2, 0.9);
    scene(blocks, vec![ground()], friction).with_head_joints(HeadJoints::Open)
}

/// A load on the highest blocks, as a multiple of their weight; `live`: it pushes too.
fn load(blocks: &mut [Block], factor: f64, live: bool) {
    let high = |block: &Block| block.shape.bounds().1.y;
    let top = blocks.iter().map(high).fold(0.0, f64::max);
    for block in blocks.iter_mut().filter(|block| high(block) == top) {
        let weight = factor * block.shape.area();
        let mut point = block.shape.centroid();
        point.y = top;
        let sideways = if live { weight } else { 0.0 };
        block.loads.push(Load {
            point,
            dead: Vector::new(0.0, -weight),
            live: Vector::new(sideways, 0.0),
        });
    }
}

/// Lowest verified multiplier and λ_A; `None` where the limit analysis has none.
pub fn truth(scene: &Scene) -> Option<Bracket> {
    truth_from(scene, 12)
}

/// The same from so many starts, or with 0 from those of the default search.
pub fn truth_from(scene: &Scene, starts: usize) -> Option<Bracket> {
    let mut settings = Settings::default();
    settings.interval.starts = starts;
    let judged = |method: &dyn Method| {
        let mut outcome = method.solve(scene, &settings);
        judge(scene, &mut outcome);
        (outcome.status == Status::Verified).then_some(outcome.bracket())?
    };
    Some(Bracket {
        lower: judged(&Interval)?.lower,
        upper: judged(&Associative)?.upper,
    })
}

/// Distance of a bracket from a range, relative to the range's upper end.
pub fn distance(seen: Bracket, truth: Bracket) -> f64 {
    let above = seen.lower - truth.upper;
    let below = truth.lower - seen.upper;
    above.max(below).max(0.0) / truth.upper
}

/// What many walls showed.
#[derive(Default)]
struct Score {
    walls: usize,
    undecided: usize,
    stated: Vec<f64>,
    /// Work beside that of a single level.
    work: Vec<f64>,
    wrong: Vec<String>,
}

impl Score {
    fn add(&mut self, seed: u64) {
        let scene = wall(seed);
        let Some(truth) = truth(&scene) else {
            println!("{seed}: the limit analysis has no range");
            return;
        };
        let seen = Pushover.solve(&scene, &Settings::default());
        let single = solve_with(&scene, &PushoverSettings::default(), |own| own);
        let steps = |outcome: &Outcome| outcome.work.block_steps as f64;
        self.walls += 1;
        self.work.push(steps(&seen) / steps(&single));
        let narrow = truth.upper - truth.lower <= 0.01 * truth.upper;
        let (Some(bracket), Some(error)) = (seen.bracket(), seen.evidence.stated_error()) else {
            println!("{seed}: {:?} {} for {truth:?}", seen.status, seen.reason());
            self.undecided += 1;
            return;
        };
        self.stated.push(error);
        let off = distance(bracket, truth);
        if off > error {
            let text = format!("{seed}: {bracket:?} {error} {off:.4} for {truth:?} {narrow}");
            println!("{text} {}; one level {:?}", seen.reason(), single.bracket());
            self.wrong.push(text);
        }
    }

    fn quantile(of: &mut [f64], part: f64) -> f64 {
        of.sort_by(f64::total_cmp);
        let last = of.len().saturating_sub(1);
        of.get((part * last as f64).round() as usize)
            .copied()
            .unwrap_or(0.0)
    }

    fn assert(mut self, undecided: usize) {
        let [median, most] = [0.5, 0.95].map(|part| Self::quantile(&mut self.stated, part));
        let work = [0.5, 0.95].map(|part| Self::quantile(&mut self.work, part));
        println!(
            "{} walls: {} wrong, {} undecided, stated {median} and {most}, work {work:?}",
            self.walls,
            self.wrong.len(),
            self.undecided
        );
        assert!(self.wrong.is_empty(), "{:#?}", self.wrong);
        assert!(self.undecided <= undecided, "{} undecided", self.undecided);
        assert!(median <= 2e-3 && most <= 1e-2, "{median} {most}");
        assert!(work[0] <= 3.0, "{work:?}");
    }
}

fn score(seeds: std::ops::Range<u64>) -> Score {
    let mut score = Score::default();
    seeds.for_each(|seed| score.add(seed));
    score
}

#[test]
fn random_walls_are_right_within_what_is_stated() {
    score(0..10).assert(0);
}

#[test]
#[ignore = "minutes"]
fn many_random_walls_are_right_within_what_is_stated() {
    score(100..100 + share(150) as u64).assert(share(4));
}
