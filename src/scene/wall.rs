//! Coursed walls: laying courses into blocks, the overburden, the closed-form description.

use std::collections::BTreeMap;

use super::assembly::{Assembly, Force, Forces, NamedBlock, Support};
use super::friction::Friction;
use super::joints::{JointClass, NamedJoint, Side, TOUCHING};
use super::model::Scene;
use super::own::Own;
use super::parts::{SceneError, SceneParts};
use super::polygon::{Point, Polygon, PolygonError};
use super::push::{HeadJoints, Push};
use super::regular::{Coursing, Irregularity, RegularWall, WallFacts};

/// One piece of a course.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece {
    /// A full unit.
    Unit,
    /// Half a unit long; a header.
    Half,
    /// A quarter of a unit long; a closer.
    Quarter,
    /// This part of a unit's length.
    Part(f64),
    /// Nothing, one unit wide.
    Gap,
    /// Nothing, as wide as this part of a unit's length.
    Opening(f64),
}

impl Piece {
    /// Whether there is nothing.
    pub(crate) fn is_gap(&self) -> bool {
        matches!(self, Piece::Gap | Piece::Opening(_))
    }

    /// Its length over that of a unit.
    pub(super) fn part(self) -> f64 {
        match self {
            Piece::Unit | Piece::Gap => 1.0,
            Piece::Half => 0.5,
            Piece::Quarter => 0.25,
            Piece::Part(part) | Piece::Opening(part) => part,
        }
    }

    /// Whether its length is a multiple of half a unit.
    fn is_of_halves(&self) -> bool {
        matches!(self, Piece::Unit | Piece::Half | Piece::Gap)
    }
}

/// Pieces from left to right.
pub type Course = Vec<Piece>;

/// A wall of equal units in courses, on level ground.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall {
    /// Length l of a full unit.
    pub unit_length: f64,
    /// Height h of a unit, and of every course that has none of its own.
    pub unit_height: f64,
    /// Thickness b of the wall.
    pub thickness: f64,
    /// Weight of one full unit; the specific weight γ is this over l·h·b.
    pub unit_weight: f64,
    /// Courses from bottom to top.
    pub courses: Vec<Course>,
    /// Coefficients of friction μ.
    pub friction: Friction,
    /// Overburden ratio r = p / (γ H).
    pub overburden: f64,
    /// Direction of the live load.
    pub push: Push,
    /// What single courses, joints and blocks have of their own.
    pub own: Own,
}

/// Why a wall cannot be laid. Courses and pieces count from 1.
#[allow(missing_docs, reason = "the sentence of each says it")]
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum WallError {
    #[error("the wall has no courses")]
    NoCourses,
    #[error("course {course} holds no block")]
    EmptyCourse { course: usize },
    #[error("there are {heights} heights for {courses} courses")]
    Heights { heights: usize, courses: usize },
    #[error("a block of this size cannot be laid: {0}")]
    Shape(#[from] PolygonError),
    #[error(transparent)]
    Scene(#[from] SceneError),
}

/// A laid block and its course.
struct Laid {
    shape: Polygon,
    course: usize,
}

impl Wall {
    /// A wall of unit thickness and weight from its courses, a letter a piece, for tests.
    #[cfg(test)]
    pub(crate) fn laid(unit: [f64; 2], friction: f64, courses: &[&str]) -> Self {
        let piece = |letter| match letter {
            'h' => Piece::Half,
            'g' => Piece::Gap,
            _ => Piece::Unit,
        };
        let course = |text: &&str| text.chars().map(piece).collect();
        Self {
            unit_length: unit[0],
            unit_height: unit[1],
            thickness: 1.0,
            unit_weight: 1.0,
            courses: courses.iter().map(course).collect(),
            friction: friction.into(),
            overburden: 0.0,
            push: Push::Right,
            own: Own::default(),
        }
    }

    /// Cubes of size and weight 1 beside each other, for tests: λ = 1 pushes with their weight.
    #[cfg(test)]
    pub(crate) fn of_cubes(count: usize, push: Push) -> Self {
        let wall = Self::laid([1.0, 1.0], 0.5, &[&"1".repeat(count)]);
        Self { push, ..wall }
    }

    /// Height H.
    pub fn height(&self) -> f64 {
        match self.own.heights.as_slice() {
            [] => self.courses.len() as f64 * self.unit_height,
            heights => heights.iter().sum(),
        }
    }

    /// Heights of the beds of the courses and of the top above the ground.
    fn levels(&self) -> Vec<f64> {
        if self.own.heights.is_empty() {
            let courses = 0..=self.courses.len();
            return courses.map(|n| n as f64 * self.unit_height).collect();
        }
        let mut levels = vec![0.0];
        for height in &self.own.heights {
            levels.push(levels[levels.len() - 1] + height);
        }
        levels
    }

    /// Where every block lies, in the order of the scene's blocks. Courses count from the bottom,
    /// pieces from the left with gaps. A block with a name of its own has that.
    pub fn block_names(&self) -> Vec<String> {
        let places = self.block_places().enumerate();
        let name = |(block, (course, piece))| match self.own.names.get(&block) {
            Some(name) => name.clone(),
            None => format!("course {course} piece {piece}"),
        };
        places.map(name).collect()
    }

    /// Course and piece of every block, both from 1, in the order of the scene's blocks.
    pub fn block_places(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let courses = self.courses.iter().enumerate();
        courses.flat_map(|(course, pieces)| {
            let blocks = pieces.iter().enumerate();
            let blocks = blocks.filter(|(_, piece)| !piece.is_gap());
            blocks.map(move |(piece, _)| (course + 1, piece + 1))
        })
    }

    /// The same wall as named blocks, their weights and the overburden as forces on them. What only a
    /// coursed wall has (the closed form, what its crack is measured with) is lost.
    ///
    /// # Errors
    /// [`WallError`] where the courses do not make a wall.
    pub fn assembly(&self) -> Result<Assembly, WallError> {
        let (mut blocks, mut extra) = (Vec::new(), Vec::new());
        let names = self.block_names().into_iter();
        for (index, (laid, name)) in self.lay()?.into_iter().zip(names).enumerate() {
            blocks.push(NamedBlock {
                name,
                weight: self.weight(index, &laid.shape),
                centre: laid.shape.centroid(),
                shape: laid.shape.clone(),
                friction: self.own.frictions.get(&index).copied(),
            });
            extra.extend(self.carried(index, &laid));
        }
        let own = &self.own.forces;
        extra.extend(&own.extra);
        let mut assembly = Assembly {
            blocks,
            supports: vec![Support {
                name: "ground".to_owned(),
                shape: self.ground()?,
            }],
            friction: self.friction,
            forces: Forces { extra, ..*own },
            overburden: 0.0,
            tolerance: TOUCHING,
            radial: false,
            named_joints: self.own.joints.clone(),
            layers: Default::default(),
        };
        if !(self.own.beds.is_empty() && self.own.open.is_empty()) {
            assembly.named_joints = self.named_joints(&assembly)?;
        }
        Ok(assembly)
    }

    /// The joints that have a friction of their own or are open, one by one.
    fn named_joints(&self, assembly: &Assembly) -> Result<Vec<NamedJoint>, SceneError> {
        let courses: Vec<usize> = self.block_places().map(|(course, _)| course).collect();
        let named = self.own.joints.iter();
        let mut named: BTreeMap<[Side; 2], NamedJoint> =
            named.map(|joint| (joint.bodies(), *joint)).collect();
        // Of the joints as they are without what is added here.
        for joint in Scene::new(assembly.parts(self.push))?.joints() {
            let course = courses[joint.to];
            let own = NamedJoint {
                between: joint.bodies(),
                class: None,
                friction: match joint.class {
                    JointClass::Base | JointClass::Bed => self.own.beds.get(&course).copied(),
                    JointClass::Head | JointClass::Guide => None,
                },
                open: joint.class == JointClass::Head && self.own.open.contains(&course),
            };
            if own.friction.is_some() || own.open {
                let known = named.entry(joint.bodies()).or_insert(own);
                known.friction = known.friction.or(own.friction);
                known.open |= own.open;
            }
        }
        Ok(named.into_values().collect())
    }

    /// Length of a course from the left end of the wall to its last piece or gap.
    pub fn course_width(&self, course: &Course) -> f64 {
        let widths = course.iter().map(|piece| self.unit_length * piece.part());
        widths.sum()
    }

    /// Blocks, ground, joints and forces of this wall.
    ///
    /// # Errors
    /// [`WallError`] where the courses do not make a wall.
    pub fn scene(&self, head_joints: HeadJoints) -> Result<Scene, WallError> {
        let scene = Scene::new(SceneParts {
            wall: Some(WallFacts {
                coursing: self.coursing(),
                regular: self.regular(),
            }),
            ..self.assembly()?.parts(self.push)
        })?;
        Ok(scene.with_head_joints(head_joints))
    }

    fn lay(&self) -> Result<Vec<Laid>, WallError> {
        if self.courses.is_empty() {
            return Err(WallError::NoCourses);
        }
        let levels = self.levels();
        if levels.len() != self.courses.len() + 1 {
            return Err(WallError::Heights {
                heights: levels.len() - 1,
                courses: self.courses.len(),
            });
        }
        let mut laid = Vec::new();
        for (course, pieces) in self.courses.iter().enumerate() {
            let before = laid.len();
            // Positions as counts of quarter units: no sum of rounded widths along a long course.
            let (mut quarters, mut parts) = (0.0, 0.0);
            for &piece in pieces {
                let at =
                    |quarters: f64, parts: f64| (quarters + 4.0 * parts) * (self.unit_length / 4.0);
                let x0 = at(quarters, parts);
                match piece {
                    Piece::Part(part) | Piece::Opening(part) => parts += part,
                    _ => quarters += 4.0 * piece.part(),
                }
                if piece.is_gap() {
                    continue;
                }
                let x1 = at(quarters, parts);
                let shape = Polygon::rectangle(x0, x1, levels[course], levels[course + 1])?;
                laid.push(Laid { shape, course });
            }
            if laid.len() == before {
                return Err(WallError::EmptyCourse { course: course + 1 });
            }
        }
        Ok(laid)
    }

    /// Level ground that reaches one wall height beyond the wall on both sides.
    fn ground(&self) -> Result<Polygon, PolygonError> {
        let widths = self.courses.iter().map(|course| self.course_width(course));
        let reach = self.height();
        let right = widths.fold(0.0, f64::max) + reach;
        Polygon::rectangle(-reach, right, -self.unit_height, 0.0)
    }

    /// Weight of a block: its own, or that of the units times its area.
    fn weight(&self, index: usize, shape: &Polygon) -> f64 {
        let own = self.own.weights.get(&index);
        own.copied()
            .unwrap_or_else(|| self.pressure() * shape.area())
    }

    /// Weight of the units over the area of the elevation.
    fn pressure(&self) -> f64 {
        self.unit_weight / (self.unit_length * self.unit_height)
    }

    /// The overburden on a block of the top course: p·b·width, dead downwards and live sideways (as
    /// λPH in Eq. 4), at the middle of its top face.
    fn carried(&self, block: usize, laid: &Laid) -> Option<Force> {
        let is_top = laid.course + 1 == self.courses.len();
        (self.overburden > 0.0 && is_top).then(|| {
            let (low, high) = laid.shape.bounds();
            let weight = self.overburden * self.height() * self.pressure() * (high.x - low.x);
            let middle = Point::new((low.x + high.x) / 2.0, high.y);
            self.own.forces.weight(block, middle, weight)
        })
    }

    /// `None` without stagger. In every bond the stagger line advances half a unit a course on
    /// average, or less.
    fn coursing(&self) -> Option<Coursing> {
        let staggered = self.courses.windows(2).any(|pair| pair[0] != pair[1]);
        staggered.then(|| Coursing {
            height: self.height(),
            levels: self.levels().split_off(1),
            overlap: self.unit_length / 2.0,
            halves: self.courses.iter().flatten().all(Piece::is_of_halves),
        })
    }

    /// The wall as the closed form sees it.
    fn regular(&self) -> Result<RegularWall, Irregularity> {
        if self.courses.len() < 2 {
            return Err(Irregularity::SingleCourse);
        }
        let length = self.course_width(&self.courses[0]);
        let starts_whole = self.courses[0].first() == Some(&Piece::Unit);
        for (i, course) in self.courses.iter().enumerate() {
            if (self.course_width(course) - length).abs() > 1e-9 * length {
                return Err(Irregularity::Width(i + 1));
            }
            if course.iter().any(|piece| !piece.is_of_halves()) {
                return Err(Irregularity::NotHalves(i + 1));
            }
            let whole = starts_whole == (i % 2 == 0);
            let last = course.len() - 1;
            let in_bond = course.iter().enumerate().all(|(k, &piece)| {
                let half = !whole && (k == 0 || k == last);
                piece == if half { Piece::Half } else { Piece::Unit }
            });
            if !in_bond {
                return Err(Irregularity::NotRunningBond(i + 1));
            }
        }
        self.plain()?;
        let specific_weight =
            self.unit_weight / (self.unit_length * self.unit_height * self.thickness);
        Ok(RegularWall {
            height: self.height(),
            length,
            overlap: self.unit_length / 2.0,
            unit_height: self.unit_height,
            thickness: self.thickness,
            specific_weight,
            overburden: self.overburden * specific_weight * self.height(),
            friction: self.friction.bed,
        })
    }
    /// Whether no course, joint or block has anything of its own that the closed form does not know.
    fn plain(&self) -> Result<(), Irregularity> {
        let own = &self.own;
        let heights = own.heights.iter();
        if let Some(course) = heights
            .map(|&h| h != self.unit_height)
            .position(|other| other)
        {
            return Err(Irregularity::Height(course + 1));
        }
        if own.forces.of_weight.y != 0.0 {
            return Err(Irregularity::PushedVertically);
        }
        let sideways = own.forces.of_weight.x == 1.0;
        if !(own.weights.is_empty() && own.forces.extra.is_empty() && sideways) {
            return Err(Irregularity::OwnLoads);
        }
        if self.friction.bed != self.friction.base {
            return Err(Irregularity::Friction);
        }
        let mut joints = own.joints.iter().filter_map(|joint| joint.friction);
        if !(own.beds.is_empty() && own.frictions.is_empty() && joints.next().is_none()) {
            return Err(Irregularity::OwnFriction);
        }
        Ok(())
    }
}
