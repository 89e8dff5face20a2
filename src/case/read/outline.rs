//! The outline of a block or support as written, and its shape.

use crate::case::complaint::{Complaint, Place};
use crate::scene::{Point, Polygon, PolygonError, signed_area};
use crate::text::counted;

/// The name of a block or support and its corners, with the places they were read from.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    pub name: String,
    pub place: Place,
    pub corners: Vec<Point>,
    pub places: Vec<Place>,
}

/// Most corners of an outline: what is found by comparing all edges with all takes no time.
const MOST_CORNERS: usize = 1000;

/// Blocks longer than this times their thickness are slivers.
const MOST_SLENDER: f64 = 1000.0;

impl Outline {
    /// Line of the first row and of the last: `a.csv:3 to 6`, or `a.toml:3`.
    pub fn rows(&self) -> String {
        let first = self.place.path_and_line();
        let last = self.places.last().unwrap_or(&self.place).path_and_line();
        match last.rsplit_once(':') {
            Some((_, line)) if last != first => format!("{first} to {line}"),
            _ => first,
        }
    }

    /// The shape; `moves` says that it is a block, which must not be a sliver.
    pub fn shape(&self, moves: bool) -> Result<Polygon, Complaint> {
        self.no_repeated_corner()?;
        if let Some(place) = self.places.get(MOST_CORNERS) {
            let title = format!("`{}` has more than {MOST_CORNERS} corners", self.name);
            return Err(place
                .complain(title, "the first too many")
                .help("leave out corners, or write longer chords for a curve"));
        }
        let shape = Polygon::new(self.corners.clone()).map_err(|error| self.unusable(&error))?;
        let edges = shape.edges().map(|(a, b)| (b - a).norm());
        let longest = edges.fold(0.0, f64::max);
        if moves && shape.area() < longest * longest / MOST_SLENDER {
            return Err(self.sliver());
        }
        Ok(shape)
    }

    /// Refuses a corner that is the same point as the next one, all the way round.
    fn no_repeated_corner(&self) -> Result<(), Complaint> {
        let count = self.corners.len();
        let next = |i: usize| (i + 1) % count;
        let same = (0..count).find(|&i| count > 2 && self.corners[i] == self.corners[next(i)]);
        let Some(same) = same else {
            return Ok(());
        };
        let (place, title, help) = match next(same) {
            0 => (
                same,
                format!("the last corner of `{}` repeats the first", self.name),
                "leave it out: the outline closes by itself",
            ),
            again => (
                again,
                format!("a corner of `{}` repeats the one before", self.name),
                "write each corner once",
            ),
        };
        Err(self.places[place].complain(title, "here").help(help))
    }

    fn unusable(&self, error: &PolygonError) -> Complaint {
        let name = &self.name;
        let (title, help) = match *error {
            PolygonError::NotSimple(corner) => {
                let title = format!("the outline of `{name}` crosses or touches itself");
                return self.places[self.as_written(corner)]
                    .complain(title, "in the edge at this corner")
                    .help(
                        "write the corners in order round the outline, each once; a block with a hole is \
                         cut into two through it",
                    );
            }
            PolygonError::TooFewCorners(count) => {
                let title = format!("`{name}` has {}", counted(count, "corner"));
                (
                    title,
                    "write at least three corners, in order round the outline",
                )
            }
            PolygonError::NotFinite(_) => (
                format!("`{name}` has no finite corners"),
                "write finite numbers",
            ),
            PolygonError::Sliver { area, .. } if area <= 0.0 => (
                format!("`{name}` has no area"),
                "write its corners in order round the outline",
            ),
            PolygonError::Sliver { .. } => return self.sliver(),
        };
        self.place.complain(title, "here").help(help)
    }

    fn sliver(&self) -> Complaint {
        let name = &self.name;
        let title =
            format!("`{name}` is a sliver, more than {MOST_SLENDER} times longer than thick");
        let complaint = self.place.complain(title, "here");
        complaint.help("check its coordinates, or join it to the block beside it")
    }

    /// The place of a polygon's corner in the list as written: the polygon turns it round where it
    /// runs clockwise.
    fn as_written(&self, corner: usize) -> usize {
        match signed_area(&self.corners) < 0.0 {
            true => self.corners.len() - 1 - corner,
            false => corner,
        }
    }
}
