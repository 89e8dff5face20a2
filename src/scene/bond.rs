//! Bonds in elevation: the regular patterns that courses are laid in, defined once each.

use super::wall::{Course, Piece};
use Piece::{Half, Quarter, Unit};

/// A regular pattern of two courses that take turns: one with whole ends, one with cut ends (half
/// units, headers or closers). A unit is a stretcher; in elevation a header is half as long, and a
/// closer half as long as a header.
#[derive(Debug)]
pub(crate) struct Bond {
    /// The word in case files.
    pub name: &'static str,
    /// What the lowest course can be; `None` where all courses are alike.
    pub lowest: Option<LowestCourse>,
    /// How the courses are made.
    pattern: Pattern,
}

/// The words for the lowest course of a bond.
#[derive(Debug)]
pub(crate) struct LowestCourse {
    /// It has the cut ends.
    pub cut: &'static str,
    /// It has the whole ends.
    pub whole: &'static str,
    /// Whether it has the cut ends where nobody says.
    pub cut_unless_said: bool,
}

/// The two courses of a bond, each as wide as this number of units: whole ends, then cut ends.
#[derive(Debug)]
enum Pattern {
    /// Always the same, or the nearest width that closes where this one does not.
    Fixed(fn(usize) -> Result<[Course; 2], usize>),
    /// With a free overlap: the shorter lap of units in adjacent courses, a fraction of the unit's
    /// length up to 1/2.
    Lapped(fn(usize, f64) -> [Course; 2]),
}

/// Every bond. A new one is an entry here and its pattern below; case files, complaints and the
/// template follow.
pub(crate) const BONDS: &[Bond] = &[
    Bond {
        name: "running",
        lowest: Some(LowestCourse {
            cut: "half",
            whole: "whole",
            cut_unless_said: true,
        }),
        pattern: Pattern::Lapped(running),
    },
    Bond {
        name: "stack",
        lowest: None,
        pattern: Pattern::Fixed(stack),
    },
    Bond {
        name: "english",
        lowest: Some(LowestCourse {
            cut: "header",
            whole: "stretcher",
            cut_unless_said: false,
        }),
        pattern: Pattern::Fixed(english),
    },
    Bond {
        name: "flemish",
        lowest: Some(LowestCourse {
            cut: "closer",
            whole: "whole",
            cut_unless_said: false,
        }),
        pattern: Pattern::Fixed(flemish),
    },
    Bond {
        name: "header",
        lowest: Some(LowestCourse {
            cut: "closer",
            whole: "whole",
            cut_unless_said: false,
        }),
        pattern: Pattern::Fixed(header),
    },
];

/// Stretchers; every second course is out of step with the one below by `overlap`, and begins with
/// a piece of that length.
fn running(units: usize, overlap: f64) -> [Course; 2] {
    let [first, last] = [overlap, 1.0 - overlap].map(|part| match part {
        0.5 => Half,
        0.25 => Quarter,
        part => Piece::Part(part),
    });
    let between = vec![Unit; units.saturating_sub(1)];
    let cut = [vec![first], between, vec![last]].concat();
    [vec![Unit; units], cut]
}

/// Units directly above each other.
fn stack(units: usize) -> Result<[Course; 2], usize> {
    Ok([vec![Unit; units], vec![Unit; units]])
}

/// A course of stretchers, then a course of headers with a closer beside each outer header.
fn english(units: usize) -> Result<[Course; 2], usize> {
    if units < 2 {
        return Err(2);
    }
    let headers = ends(&[Half, Quarter], vec![Half; 2 * units - 3]);
    Ok([vec![Unit; units], headers])
}

/// Stretcher and header in turn in every course, a header over the middle of each stretcher; every
/// second course begins and ends with a header and a closer. It closes at 4, 7, 10, … units.
fn flemish(units: usize) -> Result<[Course; 2], usize> {
    const STEP: usize = 3;
    let steps = units.saturating_sub(1) / STEP;
    if steps == 0 || units % STEP != 1 {
        return Err((units / STEP).max(1) * STEP + 1);
    }
    // Stretchers with a header between each two.
    let turns = |stretchers: usize| {
        let mut course = [Unit, Half].repeat(stretchers);
        course.pop();
        course
    };
    let cut = ends(&[Half, Quarter], turns(2 * steps));
    Ok([turns(2 * steps + 1), cut])
}

/// Headers; every second course is out of step by half a header and has closers at its ends.
fn header(units: usize) -> Result<[Course; 2], usize> {
    let cut = ends(&[Quarter], vec![Half; 2 * units - 1]);
    Ok([vec![Half; 2 * units], cut])
}

/// A course that begins with `end` and ends with its mirror image.
fn ends(end: &[Piece], middle: Course) -> Course {
    let back = end.iter().rev().copied();
    [end.to_vec(), middle, back.collect()].concat()
}

/// Half a unit out of step.
const HALF: f64 = 0.5;

impl Bond {
    /// Whether it can be laid with any overlap.
    pub fn has_overlap(&self) -> bool {
        matches!(self.pattern, Pattern::Lapped(_))
    }

    /// `courses` courses from the bottom, each `units` units wide. `cut_first` lays the one with the
    /// cut ends lowest. `overlap`, half a unit where there is none, is for bonds that
    /// [have one](Self::has_overlap).
    ///
    /// # Errors
    /// The nearest width that closes, where the pattern does not at this one.
    pub fn lay(
        &self,
        courses: usize,
        units: usize,
        cut_first: bool,
        overlap: Option<f64>,
    ) -> Result<Vec<Course>, usize> {
        let [whole, cut] = self.pair(units, overlap)?;
        let course = |i: usize| {
            if i.is_multiple_of(2) == cut_first {
                cut.clone()
            } else {
                whole.clone()
            }
        };
        Ok((0..courses).map(course).collect())
    }

    /// The course with whole ends and the one with cut ends.
    fn pair(&self, units: usize, overlap: Option<f64>) -> Result<[Course; 2], usize> {
        match self.pattern {
            Pattern::Lapped(pattern) => Ok(pattern(units, overlap.unwrap_or(HALF))),
            Pattern::Fixed(pattern) => pattern(units),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Piece::Part;

    fn bond(name: &str) -> &'static Bond {
        BONDS.iter().find(|bond| bond.name == name).unwrap()
    }

    #[test]
    fn patterns_are_the_textbooks() {
        let running = bond("running").lay(3, 2, true, None).unwrap();
        assert_eq!(
            running,
            [
                vec![Half, Unit, Half],
                vec![Unit; 2],
                vec![Half, Unit, Half]
            ]
        );
        let third = bond("running").lay(2, 2, false, Some(0.2)).unwrap();
        assert_eq!(third, [vec![Unit; 2], vec![Part(0.2), Unit, Part(0.8)]]);
        assert_eq!(
            bond("stack").lay(2, 1, true, None).unwrap(),
            [[Unit], [Unit]]
        );
        let english = bond("english").lay(2, 3, false, None).unwrap();
        assert_eq!(english[1], [Half, Quarter, Half, Half, Half, Quarter, Half]);
        let flemish = bond("flemish").lay(2, 4, false, None).unwrap();
        assert_eq!(flemish[0], [Unit, Half, Unit, Half, Unit]);
        assert_eq!(flemish[1], [Half, Quarter, Unit, Half, Unit, Quarter, Half]);
        let header = bond("header").lay(2, 1, true, None).unwrap();
        assert_eq!(header, [vec![Quarter, Half, Quarter], vec![Half, Half]]);
    }

    /// Every course of a bond is as wide as asked for, and no perpend stands on another.
    #[test]
    fn courses_are_as_wide_as_asked_and_perpends_are_staggered() {
        // All courses of a stack are alike.
        let staggered = BONDS.iter().filter(|bond| bond.lowest.is_some());
        let with = |bond: &'static Bond| {
            let other = bond.has_overlap().then_some((bond, Some(0.3)));
            [Some((bond, None)), other].into_iter().flatten()
        };
        for (bond, overlap) in staggered.flat_map(with) {
            let perpends = |course: &Course| -> Vec<f64> {
                let ends = course.iter().scan(0.0, |x, piece| {
                    *x += piece.part();
                    Some(*x)
                });
                ends.collect()
            };
            let [a, b] = bond
                .pair(7, overlap)
                .unwrap()
                .map(|course| perpends(&course));
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
            let laid = bond("flemish").lay(2, units, true, None);
            assert_eq!(laid, Err(nearest), "{units}");
        }
        assert!(bond("english").lay(2, 1, true, None).is_err());
    }
}
