//! Seeded scenes that fall under their own weight, or nearly do.

use trilith::scene::{
    Block, Course, HeadJoints, Load, Own, Piece, Point, Polygon, Push, Scene, SceneParts, Vector,
    Wall,
};

/// Deterministic noise (xorshift).
pub struct Noise(pub u64);

impl Noise {
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        low + (high - low) * ((self.0 >> 11) as f64 / (1u64 << 53) as f64)
    }

    pub fn whole(&mut self, low: u32, high: u32) -> u32 {
        self.between(f64::from(low), f64::from(high) + 1.0) as u32
    }

    fn chance(&mut self, of: f64) -> bool {
        self.between(0.0, 1.0) < of
    }
}

fn heavy(shape: Polygon, weight: f64) -> Block {
    let load = Load {
        point: shape.centroid(),
        dead: Vector::new(0.0, -weight),
        live: Vector::new(weight, 0.0),
    };
    let loads = vec![load];
    Block { shape, loads }
}

fn rectangle(x0: f64, x1: f64, y0: f64, y1: f64) -> Polygon {
    Polygon::rectangle(x0, x1, y0, y1).expect("a proper rectangle")
}

/// The two parts of a polygon on both sides of a line.
fn cut(shape: &Polygon, through: Point, along: Vector) -> Option<[Polygon; 2]> {
    let mut sides = [Vec::new(), Vec::new()];
    for (from, to) in shape.edges() {
        let height = |p: Point| along.perp(&(p - through));
        let (a, b) = (height(from), height(to));
        sides[usize::from(a < 0.0)].push(from);
        if (a < 0.0) != (b < 0.0) {
            let on_line = from + (to - from) * (a / (a - b));
            sides.iter_mut().for_each(|side| side.push(on_line));
        }
    }
    let [one, other] = sides.map(Polygon::new);
    Some([one.ok()?, other.ok()?])
}

/// A box cut at random into convex pieces, some of them taken away, on level ground and perhaps
/// between walls; the pieces' weights spread over as many decades as `spread` says.
pub fn pile(noise: &mut Noise, spread: f64) -> Scene {
    let (width, height) = (noise.between(2.0, 6.0), noise.between(1.5, 5.0));
    let mut pieces = vec![rectangle(0.0, width, 0.0, height)];
    for _ in 0..noise.whole(4, 11) {
        let largest = |a: &usize, b: &usize| pieces[*a].area().total_cmp(&pieces[*b].area());
        let index = (0..pieces.len()).max_by(largest).expect("pieces");
        let (low, high) = pieces[index].bounds();
        let through = Point::new(
            low.x + (high.x - low.x) * noise.between(0.3, 0.7),
            low.y + (high.y - low.y) * noise.between(0.3, 0.7),
        );
        let angle = match noise.whole(0, 9) {
            0..=3 => 0.0,
            4..=6 => std::f64::consts::FRAC_PI_2,
            _ => noise.between(0.0, std::f64::consts::PI),
        };
        let parts = cut(
            &pieces[index],
            through,
            Vector::new(angle.cos(), angle.sin()),
        );
        let Some(parts) = parts else { continue };
        if parts.iter().all(|part| part.area() > 0.01 * width * height) {
            pieces.swap_remove(index);
            pieces.extend(parts);
        }
    }
    pieces.retain(|_| noise.chance(0.88));
    let mut supports = vec![rectangle(-20.0, 30.0, -1.0, 0.0)];
    if noise.chance(0.5) {
        supports.push(rectangle(width, width + 1.0, 0.0, height));
    }
    if noise.chance(0.3) {
        supports.push(rectangle(-1.0, 0.0, 0.0, height));
    }
    let friction = noise.between(0.1, 1.2);
    let blocks = pieces.into_iter().map(|shape| {
        let weight = shape.area() * 10f64.powf(noise.between(-0.5, 0.5) * spread);
        heavy(shape, weight)
    });
    let parts = SceneParts::new(blocks.collect(), supports, friction);
    Scene::new(parts).expect("the numbers are proper")
}

/// A stack whose blocks lean out until a part of it is about to tip: its centre lies beyond its bed
/// by the part `beyond` of the block's width (before it, where that is negative).
pub fn stack(noise: &mut Noise, beyond: f64) -> Scene {
    let count = noise.whole(2, 7) as usize;
    let widths: Vec<f64> = (0..count).map(|_| noise.between(0.5, 2.0)).collect();
    let weights: Vec<f64> = (0..count)
        .map(|_| 10f64.powf(noise.between(-1.0, 1.0)))
        .collect();
    let steps: Vec<f64> = (0..count).map(|_| noise.between(-0.3, 1.0)).collect();
    let centres = |scale: f64| -> Vec<f64> {
        let sum = steps.iter().scan(0.0, |x, step| {
            *x += step * scale;
            Some(*x)
        });
        sum.collect()
    };
    // How far the worst part's centre of weight lies beyond the end of its bed.
    let excess = |scale: f64| {
        let x = centres(scale);
        let over = (1..count).map(|k| {
            let weight: f64 = weights[k..].iter().sum();
            let moment: f64 = (k..count).map(|i| weights[i] * x[i]).sum();
            let right = (x[k - 1] + widths[k - 1] / 2.0).min(x[k] + widths[k] / 2.0);
            let left = (x[k - 1] - widths[k - 1] / 2.0).max(x[k] - widths[k] / 2.0);
            let centre = moment / weight;
            (centre - right).max(left - centre) / widths[k]
        });
        over.fold(f64::NEG_INFINITY, f64::max) - beyond
    };
    let (mut low, mut high) = (0.0, 10.0);
    for _ in 0..80 {
        let middle = (low + high) / 2.0;
        if excess(middle) > 0.0 {
            high = middle
        } else {
            low = middle
        }
    }
    let blocks = centres((low + high) / 2.0)
        .into_iter()
        .enumerate()
        .map(|(k, x)| {
            let half = widths[k] / 2.0;
            heavy(
                rectangle(x - half, x + half, k as f64, k as f64 + 1.0),
                weights[k],
            )
        });
    let supports = vec![rectangle(-40.0, 40.0, -1.0, 0.0)];
    let parts = SceneParts::new(blocks.collect(), supports, noise.between(0.1, 1.0));
    Scene::new(parts).expect("the numbers are proper")
}

/// A wall in running bond with holes anywhere, so that units hang in the air beside them or above.
pub fn holed_wall(noise: &mut Noise) -> Wall {
    let (count, units) = (noise.whole(3, 8) as usize, noise.whole(3, 7) as usize);
    let holes = noise.between(0.0, 0.3);
    let course = |noise: &mut Noise, row: usize| -> Course {
        let whole = vec![Piece::Unit; units];
        let mut course = match row % 2 {
            0 => whole,
            _ => [&[Piece::Half][..], &whole[1..], &[Piece::Half]].concat(),
        };
        for piece in &mut course {
            if *piece == Piece::Unit && row + 1 < count && noise.chance(holes) {
                *piece = Piece::Gap;
            }
        }
        if course.iter().all(|piece| *piece == Piece::Gap) {
            course[0] = Piece::Unit;
        }
        course
    };
    Wall {
        unit_length: noise.between(1.5, 4.5),
        unit_height: noise.between(0.5, 2.5),
        thickness: 1.0,
        unit_weight: 1.0,
        courses: (0..count).map(|row| course(noise, row)).collect(),
        friction: noise.between(0.2, 1.2).into(),
        overburden: if noise.chance(0.3) {
            noise.between(0.0, 5.0)
        } else {
            0.0
        },
        push: Push::Right,
        own: Own::default(),
    }
}

/// Classes of scenes and the answer to each by `tests/reference/falls.py` (HiGHS through SciPy 1.17.1):
/// `s` stands, `f` falls, `?` too near to say.
pub const CLASSES: [(&str, &str); 6] = [
    (
        "pile",
        "sfssssfsssssfsffffsssssfffssfsssssffsssssssffsffsfssffssfsfssffsssfffssfssfsssss\
         sfffffsffssfssssssssssffssssfsffffffssfsfsssssssffsssfsssssfsfsfsssfssffsffssssf\
         ssssssssffffffssffsfffsfsfsfsfsssfsfffss",
    ),
    (
        "pile, weights over 4 decades",
        "fsffsfffsffsssfffffsffsssssssfffsssssfsfssfsffsffssssssfsssssssssfffssfsfssfsssf\
         sssffffsfffsssssfsfssssfssfffsffssssffsssssssffsssssffsfsfssssfsfffsssfsssfsssfs\
         ffssssfsssfsfsfsffffsssfssssfffsfsfsssss",
    ),
    // 186: HiGHS reports no forces. It stands: the force states of λ_A pushed right and left, both
    // proved block by block, have one at λ = 0 between them.
    (
        "pile, weights over 9 decades",
        "fssffsfsfsfssfssffsfsfsfsssfsssfsssfsfffsssssssssfsfsssffffsfsfsssssfsssffsffssf\
         ffsssfffffssfsssffsfsfssfsfssssssssfsssfsfssssfssffffsfssfssfssfsssssssfsssfssff\
         ffssssfsfsssffsssssffsfssssssssffsfsfssf",
    ),
    (
        "stack about to tip",
        "?ffsfssfsfsfs?ff?sfsssfssfffssssffffssssssfsffff?sffsffffssffssffssffssffsfsffff\
         sfffffffffsfssssssfsssf?fsfsssf?ssssfs?sss??s?sfsssssfffsffff?ssffs?ssf?sfsf?sff\
         sss??ffsss?ffffffssfsssfs?fffsfsfff??ffs",
    ),
    (
        "holed wall, contact",
        "sfsffsffffsfsfssffsssssssfffsssfsfsssfsffsffffssfssssfsfssfssfsssssssfssfffsfsff\
         sssfssssfsfsffffffsfffsssffsffffffffsfffsssfffsfffsffsssfssfsssffssfffffsfffssss\
         sssfssffsfsfffffffffsffsfffsfssfssfffsff",
    ),
    (
        "holed wall, open",
        "fssffffffsssfssfsfsfsssffffsfsffsffsfsfsfffssfffssffffsfsssffsfsffsfsfsfssfsfffs\
         sssfsffsssssfffffsss",
    ),
];

/// Scene `index` of a class, always the same.
pub fn of_class(class: usize, index: usize) -> Scene {
    let seed = 0x5EED + 1_000_003 * class as u64 + 7919 * index as u64;
    let mut noise = Noise(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
    for _ in 0..8 {
        noise.between(0.0, 1.0);
    }
    let noise = &mut noise;
    match class {
        0 => pile(noise, 0.0),
        1 => pile(noise, 4.0),
        2 => pile(noise, 9.0),
        3 => {
            let sign = if noise.chance(0.5) { 1.0 } else { -1.0 };
            let beyond = sign * 10f64.powf(noise.between(-7.0, -1.0));
            stack(noise, beyond)
        }
        4 => laid(&holed_wall(noise), HeadJoints::Contact),
        _ => laid(&holed_wall(noise), HeadJoints::Open),
    }
}

fn laid(wall: &Wall, head_joints: HeadJoints) -> Scene {
    wall.scene(head_joints).expect("the wall can be laid")
}
