//! Supports that move: the `[[move]]` tables of a file.

use toml::Spanned;

use super::checks::{Written, choose, coordinates, not_negative, positive_or_one, unknown};
use super::file::{CaseFile, MoveTable};
use super::leaves::leaves_the_wall;
use super::missing::missing_key;
use super::values::Pair;
use crate::case::complaint::Complaint;
use crate::case::geometry::Geometry;
use crate::scene::{
    Assembly, HeadJoints, MovingSupport, Point, Polygon, Push, Sense, SupportMotion, Vector, Wall,
};

pub(super) fn motion(
    file: &CaseFile,
    geometry: &Geometry,
) -> Result<Option<SupportMotion>, Complaint> {
    let Some(first) = file.moves.first() else {
        return Ok(None);
    };
    if let Some(word) = file.push.as_ref().filter(|word| word.get_ref() == "both") {
        let complaint = word.wrong(
            "a push to both sides beside `[[move]]`",
            "which of the two?",
        );
        return Err(complaint.help("write `push = \"right\"` or `push = \"left\"`"));
    }
    let assembly = geometry.assembly();
    let mut motion = SupportMotion {
        supports: Vec::new(),
        about: about(first.get_ref())?,
        sense: sense(first.get_ref())?,
        pushed: match &first.get_ref().pushed {
            Some(lambda) => not_negative("pushed", lambda)?,
            None => 0.0,
        },
    };
    for table in &file.moves {
        let mut support = support(table, geometry, &assembly, motion.about, first)?;
        if motion.about.is_some() && !motion.supports.is_empty() {
            // It turns with the first.
            let direction = support.away;
            support.away = motion.first_at(support.shape.centroid());
            if support.away.dot(&direction) < 0.0 {
                let complaint = (table.get_ref().direction).wrong(
                    "a direction that turns the other way",
                    "against the first `[[move]]`",
                );
                return Err(complaint.help("write how its middle moves as it turns with the first"));
            }
        }
        let is_known = |known: &MovingSupport| {
            known.support == support.support && (known.blocks == support.blocks)
        };
        if motion.supports.iter().any(is_known) {
            let complaint = table.wrong(format!("`{}` moves twice", support.name), "here again");
            return Err(complaint.help("name each support once"));
        }
        motion.supports.push(support);
        one_motion(table, &motion)?;
    }
    let scene = geometry.scene(HeadJoints::Contact, Push::Right);
    leaves_the_wall(&file.moves, &motion, &scene)?;
    Ok(Some(motion))
}

/// A table's support, which moves along the table's direction.
fn support(
    spanned: &Spanned<MoveTable>,
    geometry: &Geometry,
    assembly: &Assembly,
    about: Option<Point>,
    first: &Spanned<MoveTable>,
) -> Result<MovingSupport, Complaint> {
    let table = spanned.get_ref();
    let (name, support, blocks, shape) = match (&table.support, &table.units, geometry) {
        (None, Some(units), Geometry::Wall(wall)) => {
            let (blocks, shape) = under(units, wall, assembly)?;
            let written = units.get_ref().trim();
            let unit = match written.parse::<usize>() {
                Ok(_) => "unit",
                Err(_) => "units",
            };
            (format!("{unit} {written}"), 0, Some(blocks), shape)
        }
        (_, _, Geometry::Wall(_)) => return Err(missing_key(spanned.span(), "units")),
        (Some(word), None, _) => {
            let names = || {
                assembly
                    .supports
                    .iter()
                    .map(|support| support.name.as_str())
            };
            let found = names().position(|name| name == word.get_ref());
            let index = found.ok_or_else(|| unknown("support", word, names()))?;
            let shape = assembly.supports[index].shape.clone();
            (word.get_ref().clone(), index, None, shape)
        }
        (None, None, _) => return Err(missing_key(spanned.span(), "support")),
        (_, Some(units), _) => {
            let complaint = units.wrong(
                "`units` of a scene without courses",
                "goes with a coursed wall",
            );
            return Err(complaint.help("write `support` with a support's name"));
        }
    };
    let direction = unit_vector(&table.direction)?;
    let away = match about {
        None => direction,
        Some(about) => turning(&table.direction, direction, shape.centroid() - about)?,
    };
    let own = positive_or_one("rate", table.rate.as_ref())?;
    let of_first = positive_or_one("rate", first.get_ref().rate.as_ref())?;
    Ok(MovingSupport {
        name,
        shape,
        support,
        blocks,
        away: away * (own / of_first),
    })
}

/// A further table speaks of the same motion as the first.
fn one_motion(table: &Spanned<MoveTable>, motion: &SupportMotion) -> Result<(), Complaint> {
    let own = table.get_ref();
    if sense(own)? != motion.sense || about(own)? != motion.about {
        let title = "supports that do not move as one";
        let complaint = table.wrong(
            title,
            "`moves` and `about` are those of the first `[[move]]`",
        );
        return Err(complaint.help("write the same for all of them, or a case each"));
    }
    if let Some(rate) = own.rate.as_ref().filter(|_| motion.about.is_some()) {
        let complaint = rate.wrong(
            "`rate` beside `about`",
            "the centre says how fast each moves",
        );
        return Err(complaint.help("remove `rate`"));
    }
    if motion.is_one() {
        return Ok(());
    }
    let title = "supports that move along one line, but not as one";
    let complaint = table.wrong(title, "one of them at another rate or the other way");
    Err(complaint.help(
        "write `about` with a centre of rotation, or let one of them move by what they move against \
         each other",
    ))
}

fn sense(table: &MoveTable) -> Result<Sense, Complaint> {
    let words = [Sense::Away, Sense::Against].map(|sense| (sense.name(), sense));
    choose("moves", words, &table.moves)
}

fn about(table: &MoveTable) -> Result<Option<Point>, Complaint> {
    let centre = |pair| coordinates(pair, "a centre of rotation");
    table.about.as_ref().map(centre).transpose()
}

fn unit_vector(pair: &Spanned<Pair>) -> Result<Vector, Complaint> {
    let vector = coordinates(pair, "a direction")?.coords;
    vector.try_normalize(0.0).ok_or_else(|| {
        let complaint = pair.wrong("a direction without length", "here");
        complaint.help("write the way that leads away from the wall, such as `[0.0, -1.0]`")
    })
}

/// Velocity of a centroid that turns, away from the wall, where a direction says which way that is.
fn turning(written: &Spanned<Pair>, direction: Vector, arm: Vector) -> Result<Vector, Complaint> {
    let across = Vector::new(-arm.y, arm.x).try_normalize(0.0);
    let along = across.map(|across| (across, across.dot(&direction)));
    match along {
        Some((across, part)) if part.abs() > 1e-3 => Ok(across * part.signum()),
        _ => Err(written
            .wrong(
                "a direction that no turning has",
                "the support's middle does not move this way",
            )
            .help("write roughly how its middle moves as it leaves the wall, or another `about`")),
    }
}

/// Blocks of the lowest course from one piece to another, and the ground below them as deep as a
/// course is high.
fn under(
    units: &Spanned<String>,
    wall: &Wall,
    assembly: &Assembly,
) -> Result<(Vec<usize>, Polygon), Complaint> {
    let wrong = |title: String, help: &str| Err(units.wrong(title, "here").help(help));
    let text = units.get_ref().trim();
    let (from, to) = text.split_once('-').unwrap_or((text, text));
    let most = wall.courses[0].len();
    let place = |word: &str| word.trim().parse::<usize>().ok();
    let Some((from, to)) = place(from).zip(place(to)) else {
        let help = "write the pieces of the lowest course from the left, as in `units = \"5-8\"`";
        return wrong(format!("`{text}` names no units"), help);
    };
    if !(1 <= from && from <= to && to <= most) {
        let help = format!("write pieces from 1 to {most}, the smaller first");
        return wrong(format!("the lowest course has no pieces {text}"), &help);
    }
    let places = wall.block_places().enumerate();
    let is_above = |&(_, (course, piece)): &(usize, (usize, usize))| {
        course == 1 && (from..=to).contains(&piece)
    };
    let blocks: Vec<usize> = places.filter(is_above).map(|(block, _)| block).collect();
    let bounds = blocks
        .iter()
        .map(|&block| assembly.blocks[block].shape.bounds());
    let ends = bounds.map(|(low, high)| (low.x, high.x));
    let ends = ends.reduce(|(low, high), (l, h)| (low.min(l), high.max(h)));
    let shape = ends.map(|(low, high)| Polygon::rectangle(low, high, -wall.unit_height, 0.0));
    match shape {
        Some(Ok(shape)) => Ok((blocks, shape)),
        _ => wrong(
            format!("the pieces {text} are gaps"),
            "name units that stand on the ground",
        ),
    }
}

#[cfg(test)]
mod tests {
    use crate::case::model::Case;

    const WALL: &str = "unit = { length = 1, height = 1, weight = 1 }\ncourses = [\"11g1\", \"h11h\"]\n\
                        friction = 0.5\n[[move]]\nunits = \"1-2\"\ndirection = [0, -1]\nmoves = \"away\"\n";
    const BLOCKS: &str = "friction = 0.5\n[blocks]\n[[block]]\nname = \"a\"\nweight = 1\n\
                          corners = [[0, 0], [4, 0], [4, 1], [0, 1]]\n[[support]]\nname = \"left\"\n\
                          corners = [[0, -1], [1, -1], [1, 0], [0, 0]]\n[[support]]\nname = \"right\"\n\
                          corners = [[3, -1], [4, -1], [4, 0], [3, 0]]\n[[move]]\nsupport = \"right\"\n\
                          direction = [0, -1]\nmoves = \"away\"\n";

    fn refused(text: &str, from: &str, to: &str, expected: &str) {
        assert!(text.contains(from), "{from}");
        let complaint = Case::read("a.toml", text.replace(from, to).as_bytes()).unwrap_err();
        let shown = complaint.to_string();
        assert!(shown.contains(expected), "{to} gives\n{shown}");
        assert!(shown.contains("help: "), "{shown}");
    }

    #[test]
    fn what_cannot_move_is_refused() {
        for (from, to, expected) in [
            (
                "units = \"1-2\"",
                "units = \"5\"",
                "the lowest course has no pieces 5",
            ),
            ("units = \"1-2\"", "units = \"3\"", "the pieces 3 are gaps"),
            ("units = \"1-2\"", "units = \"left\"", "names no units"),
            (
                "units = \"1-2\"",
                "support = \"ground\"",
                "missing key `units`",
            ),
            ("[0, -1]", "[0, 0]", "a direction without length"),
            ("\"away\"", "\"awy\"", "did you mean `moves = \"away\"`?"),
            (
                "friction",
                "push = \"both\"\nfriction",
                "a push to both sides",
            ),
            ("moves =", "pushed = -1\nmoves =", "`pushed` is negative"),
            (
                "[[move]]",
                "settlement = 0.01\n[[move]]",
                "write a `[[move]]`",
            ),
        ] {
            refused(WALL, from, to, expected);
        }
        for (from, to, expected) in [
            (
                "support = \"right\"",
                "support = \"rigth\"",
                "unknown support `rigth`",
            ),
            (
                "direction = [0, -1]",
                "direction = [0, 1]",
                "presses `right` into the wall",
            ),
            (
                "[4, 0], [3, 0]]",
                "[4, -0.5], [3, -0.5]]",
                "no block touches `right`",
            ),
            (
                "support = \"right\"",
                "units = \"1\"",
                "`units` of a scene without courses",
            ),
            (
                "moves =",
                "about = [3.5, 4]\nmoves =",
                "a direction that no turning has",
            ),
        ] {
            refused(BLOCKS, from, to, expected);
        }
    }

    #[test]
    fn several_supports_that_do_not_move_as_one_are_refused() {
        let second = "[[move]]\nsupport = \"left\"\ndirection = [0, -1]\nmoves = \"away\"\n";
        let both = format!("{BLOCKS}{second}");
        assert!(Case::read("a.toml", both.as_bytes()).is_ok());
        for (from, to, expected) in [
            (
                "support = \"left\"",
                "support = \"right\"",
                "`right` moves twice",
            ),
            (
                "moves = \"away\"\n[[move]]",
                "moves = \"against\"\n[[move]]",
                "do not move as one",
            ),
            (
                "support = \"left\"",
                "rate = 2.0\nsupport = \"left\"",
                "but not as one",
            ),
        ] {
            refused(&both, from, to, expected);
        }
    }
}
