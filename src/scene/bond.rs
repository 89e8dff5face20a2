//! Bonds in elevation: the regular patterns that courses are laid in, defined once each.

use super::wall::{Course, Piece};

/// A regular pattern of courses. A unit is a stretcher; in elevation a header is half as long, and
/// a closer half as long as a header.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bond {
    /// Stretchers; every second course is out of step with the one below by `overlap`, a fraction
    /// of the unit up to 1/2, and begins with a piece of that length.
    Running {
        /// The shorter lap of units in adjacent courses, over the unit's length.
        overlap: f64,
    },
    /// Units directly above each other.
    Stack,
    /// A course of stretchers, then a course of headers with a closer beside each outer header.
    English,
    /// Stretcher and header in turn in every course, a header over the middle of each stretcher;
    /// every second course begins and ends with a header and a closer.
    Flemish,
    /// Headers; every second course is out of step by half a header and has closers at its ends.
    Header,
}

/// Widths of a wall in Flemish bond, in units: 4, 7, 10, …
const FLEMISH_STEP: usize = 3;

/// Why a bond cannot be laid.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum BondError {
    /// The pattern does not close at this width.
    #[error("{bond} bond does not close at a width of {units} units")]
    Width {
        /// The bond's name.
        bond: &'static str,
        /// The width asked for.
        units: usize,
        /// The nearest width that closes.
        nearest: usize,
    },
}

impl Bond {
    /// Half a unit out of step.
    pub const RUNNING: Self = Bond::Running { overlap: 0.5 };

    /// The word in case files.
    pub fn name(self) -> &'static str {
        match self {
            Bond::Running { .. } => "running",
            Bond::Stack => "stack",
            Bond::English => "english",
            Bond::Flemish => "flemish",
            Bond::Header => "header",
        }
    }

    /// `courses` courses from the bottom, each `units` units wide. The two courses of the pattern
    /// take turns; `cut_first` lays the one with the cut ends lowest: half units, headers or
    /// closers. A stack has no such course.
    ///
    /// # Errors
    /// [`BondError`] where the pattern does not close at this width.
    pub fn lay(
        self,
        courses: usize,
        units: usize,
        cut_first: bool,
    ) -> Result<Vec<Course>, BondError> {
        let [whole, cut] = self.pattern(units)?;
        let course = |i: usize| match i.is_multiple_of(2) == cut_first {
            true => cut.clone(),
            false => whole.clone(),
        };
        Ok((0..courses).map(course).collect())
    }

    /// The course with whole ends and the one with cut ends.
    fn pattern(self, units: usize) -> Result<[Course; 2], BondError> {
        use Piece::{Half, Quarter, Unit};
        let ends = |end: &[Piece], middle: Course| {
            let back = end.iter().rev().copied();
            [end.to_vec(), middle, back.collect()].concat()
        };
        let wrong = |nearest| BondError::Width {
            bond: self.name(),
            units,
            nearest,
        };
        Ok(match self {
            Bond::Stack => [vec![Unit; units], vec![Unit; units]],
            Bond::Running { overlap } => {
                let between = vec![Unit; units.saturating_sub(1)];
                let [first, last] = [overlap, 1.0 - overlap].map(|part| match part {
                    0.5 => Half,
                    0.25 => Quarter,
                    part => Piece::Part(part),
                });
                let cut = [vec![first], between, vec![last]].concat();
                [vec![Unit; units], cut]
            }
            Bond::English if units < 2 => return Err(wrong(2)),
            Bond::English => [
                vec![Unit; units],
                ends(&[Half, Quarter], vec![Half; 2 * units - 3]),
            ],
            Bond::Flemish => {
                let steps = units.saturating_sub(1) / FLEMISH_STEP;
                if steps == 0 || units % FLEMISH_STEP != 1 {
                    let nearest = (units / FLEMISH_STEP).max(1) * FLEMISH_STEP + 1;
                    return Err(wrong(nearest));
                }
                // Stretchers with a header between each two.
                let turns = |stretchers: usize| {
                    let mut course = [Unit, Half].repeat(stretchers);
                    course.pop();
                    course
                };
                let stretchers = 2 * steps + 1;
                [
                    turns(stretchers),
                    ends(&[Half, Quarter], turns(stretchers - 1)),
                ]
            }
            Bond::Header => [
                vec![Half; 2 * units],
                ends(&[Quarter], vec![Half; 2 * units - 1]),
            ],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Piece::{Half, Part, Quarter, Unit};

    #[test]
    fn patterns_are_the_textbooks() {
        let running = Bond::RUNNING.lay(3, 2, true).unwrap();
        assert_eq!(
            running,
            [
                vec![Half, Unit, Half],
                vec![Unit; 2],
                vec![Half, Unit, Half]
            ]
        );
        let third = Bond::Running { overlap: 0.2 }.lay(2, 2, false).unwrap();
        assert_eq!(third, [vec![Unit; 2], vec![Part(0.2), Unit, Part(0.8)]]);
        assert_eq!(Bond::Stack.lay(2, 1, true).unwrap(), [[Unit], [Unit]]);
        let english = Bond::English.lay(2, 3, false).unwrap();
        assert_eq!(english[1], [Half, Quarter, Half, Half, Half, Quarter, Half]);
        let flemish = Bond::Flemish.lay(2, 4, false).unwrap();
        assert_eq!(flemish[0], [Unit, Half, Unit, Half, Unit]);
        assert_eq!(flemish[1], [Half, Quarter, Unit, Half, Unit, Quarter, Half]);
        let header = Bond::Header.lay(2, 1, true).unwrap();
        assert_eq!(header, [vec![Quarter, Half, Quarter], vec![Half, Half]]);
    }

    /// Every course of a bond is as wide as asked for, and no perpend stands on another.
    #[test]
    fn courses_are_as_wide_as_asked_and_perpends_are_staggered() {
        let part = |piece: &Piece| match piece {
            Unit | Piece::Gap => 1.0,
            Half => 0.5,
            Quarter => 0.25,
            Part(part) => *part,
        };
        let bonds = [
            Bond::RUNNING,
            Bond::Running { overlap: 0.3 },
            Bond::English,
            Bond::Flemish,
            Bond::Header,
        ];
        for bond in bonds {
            let perpends = |course: &Course| -> Vec<f64> {
                let ends = course.iter().scan(0.0, |x, piece| {
                    *x += part(piece);
                    Some(*x)
                });
                ends.collect()
            };
            let [a, b] = bond.pattern(7).unwrap().map(|course| perpends(&course));
            for course in [&a, &b] {
                assert!((course.last().unwrap() - 7.0).abs() < 1e-12, "{bond:?}");
            }
            for x in &a[..a.len() - 1] {
                assert!(b.iter().all(|y| (x - y).abs() > 0.2), "{bond:?}: {x}");
            }
        }
    }

    #[test]
    fn a_width_that_does_not_close_is_refused_with_the_nearest() {
        for (units, nearest) in [(1, 4), (2, 4), (3, 4), (5, 4), (6, 7), (9, 10)] {
            let error = Bond::Flemish.lay(2, units, true).unwrap_err();
            let BondError::Width { nearest: found, .. } = error;
            assert_eq!(found, nearest, "{units}");
        }
        assert!(Bond::English.lay(2, 1, true).is_err());
    }
}
