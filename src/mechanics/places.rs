//! Where blocks of a wall are, as people say it: in which pier, above or below which opening; of a wall
//! without openings, in which corner.

use super::openings::{Opening, openings, place_words, storey_words};
use crate::scene::{Point, Scene};
use crate::text::{counted, enumerated};

const NAMED: usize = 3;

/// Blocks that are called by their own names.
const BY_NAME: usize = 2;

/// What is left out is named where it is less than one in so many.
const MOST: usize = 4;

/// Part of a wall's or a region's size by which the middle of what moves must lie off that of the rest.
const ASIDE: f64 = 0.15;

/// The regions of a wall, and the one of every block; without openings there are none.
pub struct Places<'a> {
    scene: &'a Scene,
    regions: Vec<Region>,
    of_block: Vec<usize>,
}

#[derive(Clone, Debug, PartialEq)]
struct Region {
    /// By itself: "the right pier", "the masonry above the door".
    name: String,
    /// After a number of blocks: "of the right pier", "above the door".
    blocks_of: String,
}

impl<'a> Places<'a> {
    pub fn new(scene: &'a Scene) -> Self {
        let rows = openings(scene);
        let mut regions: Vec<Region> = Vec::new();
        let mut of_block = Vec::new();
        if !rows.is_empty() {
            for block in scene.blocks() {
                let region = region(&rows, block.shape.centroid());
                let known = regions.iter().position(|known| *known == region);
                of_block.push(known.unwrap_or(regions.len()));
                if known.is_none() {
                    regions.push(region);
                }
            }
        }
        Self {
            scene,
            regions,
            of_block,
        }
    }

    /// Where these blocks are, and whether those are several things.
    pub fn of(&self, blocks: &[usize]) -> (String, bool) {
        if self.scene.wall().is_none() && blocks.len() <= BY_NAME {
            let names = blocks.iter().map(|&block| self.scene.block_name(block));
            return (enumerated(&names.collect::<Vec<_>>()), blocks.len() > 1);
        }
        let all: Vec<usize> = (0..self.scene.blocks().len())
            .filter(|&block| !self.scene.is_moving_support(block))
            .collect();
        if self.regions.is_empty() {
            let rest = without(&all, blocks);
            if MOST * rest.len() < all.len() {
                let but = self.of(&rest).0;
                return (format!("all but {but}"), true);
            }
            let part = self.part(blocks, &all);
            return (format!("the {part}part"), false);
        }
        let mut names: Vec<String> = Vec::new();
        let regions = self.by_size(blocks);
        for &(region, _) in regions.iter().take(NAMED) {
            let within = |of: &[usize]| -> Vec<usize> {
                let of = of.iter().copied();
                of.filter(|&block| self.of_block[block] == region).collect()
            };
            let (some, whole) = (within(blocks), within(&all));
            let Region { name, blocks_of } = &self.regions[region];
            names.push(match (some.len(), whole.len()) {
                (1, 1) if blocks_of.starts_with("above") => {
                    name.replace("masonry above", "lintel over")
                }
                (some, whole) if some == whole => name.clone(),
                (1, _) => format!("a block {blocks_of}"),
                (count @ 2..=3, _) => format!("{count} blocks {blocks_of}"),
                _ => format!("the {}part of {name}", self.part(&some, &whole)),
            });
        }
        let others: usize = regions.iter().skip(NAMED).map(|(_, count)| count).sum();
        match others {
            0 => {}
            1 => names.push("one more block".to_owned()),
            _ => names.push(format!("{others} blocks elsewhere")),
        }
        let several = names.len() > 1 || names[0].starts_with(|c: char| c.is_ascii_digit());
        (enumerated(&names), several)
    }

    /// So many blocks, and of which region most of them are.
    pub fn counted(&self, blocks: &[usize]) -> String {
        let count = counted(blocks.len(), "block");
        match self.by_size(blocks)[..] {
            [(region, _)] => format!("{count} {}", self.regions[region].blocks_of),
            _ => count,
        }
    }

    /// The regions of these blocks with their number in each, the most first.
    fn by_size(&self, blocks: &[usize]) -> Vec<(usize, usize)> {
        let mut counts = vec![0; self.regions.len()];
        for &block in blocks.iter().filter(|_| !self.regions.is_empty()) {
            counts[self.of_block[block]] += 1;
        }
        let mut counts: Vec<_> = counts.into_iter().enumerate().collect();
        counts.retain(|&(_, count)| count > 0);
        counts.sort_by_key(|&(_, count)| std::cmp::Reverse(count));
        counts
    }

    /// Which part of all blocks these are, before the noun: "upper right ".
    fn part(&self, blocks: &[usize], all: &[usize]) -> String {
        let shape = |block: usize| &self.scene.blocks()[block].shape;
        let middle = |of: &[usize]| {
            let area: f64 = of.iter().map(|&block| shape(block).area()).sum();
            let sum = of
                .iter()
                .map(|&block| shape(block).centroid().coords * shape(block).area());
            sum.sum::<nalgebra::Vector2<f64>>() / area
        };
        let rest = without(all, blocks);
        let boxes = all.iter().map(|&block| shape(block).bounds());
        let ends = boxes.reduce(|(low, high), (l, h)| (low.inf(&l), high.sup(&h)));
        let (Some((low, high)), false) = (ends, rest.is_empty()) else {
            return String::new();
        };
        let (aside, size) = (middle(blocks) - middle(&rest), high - low);
        let word = |aside: f64, size: f64, words: [&'static str; 2]| match aside / size {
            at if at > ASIDE => words[0],
            at if at < -ASIDE => words[1],
            _ => "",
        };
        let up = word(aside.y, size.y, ["upper ", "lower "]);
        format!("{up}{}", word(aside.x, size.x, ["right ", "left "]))
    }
}

fn without(all: &[usize], blocks: &[usize]) -> Vec<usize> {
    let all = all.iter().copied();
    all.filter(|block| !blocks.contains(block)).collect()
}

/// The region of a point: by the row of openings that is nearest.
fn region(rows: &[Vec<Opening>], at: Point) -> Region {
    let away = |row: &Vec<Opening>| {
        let low = row.iter().map(|of| of.low.y).fold(f64::INFINITY, f64::min);
        let high = row
            .iter()
            .map(|of| of.high.y)
            .fold(f64::NEG_INFINITY, f64::max);
        (low - at.y).max(at.y - high).max(0.0)
    };
    let nearest = (0..rows.len()).min_by(|&a, &b| away(&rows[a]).total_cmp(&away(&rows[b])));
    let storey = nearest.expect("there are openings");
    let row = &rows[storey];
    if let Some(of) = row.iter().find(|of| (of.low.x..of.high.x).contains(&at.x)) {
        let side = if at.y > of.low.y { "above" } else { "below" };
        let blocks_of = format!("{side} {}", of.name);
        return Region {
            name: format!("the masonry {blocks_of}"),
            blocks_of,
        };
    }
    let place = row.iter().filter(|of| of.low.x <= at.x).count();
    let name = match row.get(place.wrapping_sub(1)).zip(row.get(place)) {
        Some((left, right)) if row.len() > 2 => {
            format!("the pier between {} and {}", left.name, right.name)
        }
        _ => {
            let storey = storey_words(storey, rows.len());
            format!("the {storey}{}pier", place_words(place, row.len() + 1))
        }
    };
    Region {
        blocks_of: format!("of {name}"),
        name,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{Case, find};
    use crate::scene::HeadJoints;

    /// Walls of one to four windows in each of one to three storeys, with and without a door, whose gaps are as
    /// wide as a unit: every block is called by what lies beside, below or above it.
    #[test]
    fn blocks_are_named_by_the_openings_beside_them() {
        for (windows, storeys, door) in
            (1..=4).flat_map(|n| (1..=3).flat_map(move |s| [true, false].map(|d| (n, s, d))))
        {
            let scene = wall(windows, storeys, door);
            let rows = openings(&scene);
            let counts: Vec<usize> = rows.iter().map(Vec::len).collect();
            let mut wanted = vec![windows; storeys];
            wanted[0] += usize::from(door);
            assert_eq!(counts, wanted, "{windows} {storeys} {door}");
            let mut names: Vec<&str> = rows.iter().flatten().map(|of| of.name.as_str()).collect();
            assert_eq!(names.contains(&"the door"), door, "{names:?}");
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), counts.iter().sum::<usize>(), "{names:?}");
            let places = Places::new(&scene);
            // Piers, what is above each opening, and what is below each but the door.
            let regions = counts.iter().map(|count| 3 * count + 1).sum::<usize>();
            assert_eq!(places.regions.len(), regions - usize::from(door));
            for (block, &region) in scene.blocks().iter().zip(&places.of_block) {
                let (at, name) = (block.shape.centroid(), &places.regions[region].name);
                let over = rows
                    .iter()
                    .flatten()
                    .find(|of| name.ends_with(&format!(" {}", of.name)));
                if let Some(of) = over.filter(|_| name.starts_with("the masonry")) {
                    assert!(of.low.x < at.x && at.x < of.high.x, "{name} at {at}");
                    assert_eq!(name.contains("above"), at.y > of.high.y, "{name} at {at}");
                } else {
                    let mut all = rows.iter().flatten();
                    assert!(name.contains("pier"), "{name} at {at}");
                    assert!(all.all(|of| at.y < of.low.y
                        || at.y > of.high.y
                        || at.x < of.low.x
                        || at.x > of.high.x));
                }
            }
        }
    }

    /// Two courses below the windows, two beside them and one above in each storey; a door beside the first
    /// windows reaches the ground.
    fn wall(windows: usize, storeys: usize, door: bool) -> Scene {
        let mut rows = Vec::new();
        for storey in 0..storeys {
            for course in 0..5 {
                let open = (2..4).contains(&course);
                let window = if open { "g1" } else { "11" }.repeat(windows);
                let first = match (door, storey == 0 && course < 4) {
                    (true, true) => "1g1",
                    (true, false) => "111",
                    (false, _) => "1",
                };
                rows.push(format!("\"{first}{window}\""));
            }
        }
        let text = format!(
            "unit = {{ length = 1.0, height = 0.4, weight = 1.0 }}\ncourses = [{}]\nfriction = 0.6\n",
            rows.join(", ")
        );
        let case = Case::read_with("a.toml", text.as_bytes(), &|_| Err(String::new()));
        case.expect("it is a case").scene(HeadJoints::Contact)
    }

    /// A plain wall has corners, and a pile of named stones its names.
    #[test]
    fn what_moves_of_a_wall_without_openings_is_a_corner() {
        let scene = find("paper-1").expect("it is built in")[0].scene(HeadJoints::Open);
        let (low, high) = scene.bounds();
        let corner = |x: fn(f64) -> bool, y: fn(f64) -> bool| -> Vec<usize> {
            let inside = |block: &usize| {
                let at = scene.blocks()[*block].shape.centroid() - low;
                x(at.x / (high.x - low.x)) && y(at.y / (high.y - low.y))
            };
            (0..scene.blocks().len()).filter(inside).collect()
        };
        let places = Places::new(&scene);
        let said = |blocks: Vec<usize>| places.of(&blocks).0;
        assert_eq!(
            said(corner(|x| x > 0.6, |y| y > 0.4)),
            "the upper right part"
        );
        assert_eq!(
            said(corner(|x| x < 0.5, |y| y < 0.5)),
            "the lower left part"
        );
        assert_eq!(said(corner(|_| true, |y| y > 0.5)), "the upper part");
        assert_eq!(
            said(corner(|x| x > 0.12, |_| true)),
            "all but the left part"
        );
        let posts = find("trilith").expect("it is built in")[0].scene(HeadJoints::Contact);
        assert_eq!(Places::new(&posts).of(&[2]).0, "lintel");
    }
}
