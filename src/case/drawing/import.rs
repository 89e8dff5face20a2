//! From a drawing to a case of explicit blocks.

use super::entities::file;
use super::groups::document;
use super::heal::{Gap, gaps, heal};
use super::options::DrawingOptions;
use super::outlines::outlines;
use super::paths::{Path, Paths, same};
use crate::case::complaint::{Complaint, Document};
use crate::case::geometry::Geometry;
use crate::case::model::Case;
use crate::case::printable::printable;
use crate::scene::{
    Assembly, Forces, NamedBlock, Polygon, PolygonError, Side, Support, TOUCHING, Unsound, extent,
};

/// A case from a drawing, and what was done to get it.
#[derive(Clone, Debug)]
pub struct Imported {
    /// The case.
    pub case: Case,
    /// What was taken for what, and what was moved: a line each.
    pub remarks: Vec<String>,
}

/// Most blocks of a drawing.
const MOST_BLOCKS: usize = 100_000;

/// Gaps wider than this part of a block's extent are meant.
const WIDEST_GAP: f64 = 0.015;

/// Layers whose outlines never move, where nobody names one.
const SUPPORT_LAYERS: [&str; 4] = ["support", "supports", "ground", "fixed"];

/// An outline with its name, and where it was drawn.
struct Drawn {
    name: String,
    path: Path,
    shape: Polygon,
}

impl Case {
    /// Reads a drawing: every closed outline is a block, or a support.
    ///
    /// # Errors
    /// What cannot be a wall, with the entity's name, handle and layer.
    pub fn from_drawing(
        path: &str,
        bytes: &[u8],
        options: &DrawingOptions,
    ) -> Result<Imported, Complaint> {
        let name = plain_name(path);
        let document = document(path, bytes)?;
        let mut remarks = Vec::new();
        let mut drawn = drawn(&document, options, &mut remarks)?;
        let fixed = supports(&document, &drawn, options, &mut remarks)?;
        if options.tolerance > 0.0 {
            healed(&document, &mut drawn, options, &mut remarks)?;
        }
        let assembly = assembly(&drawn, &fixed, options);
        sound(&document, &drawn, &fixed, &assembly, options)?;
        remarks.insert(
            0,
            format!(
                "{} blocks and {} supports from closed outlines",
                assembly.blocks.len(),
                assembly.supports.len()
            ),
        );
        Ok(Imported {
            case: Case {
                title: name.clone(),
                name,
                source: format!(
                    "the drawing {}",
                    printable(path.rsplit('/').next().unwrap_or(path))
                ),
                geometry: Geometry::Blocks(assembly),
                pushes: options.pushes.clone(),
                head_joints: options.head_joints.clone(),
                references: Vec::new(),
                warnings: Vec::new(),
            },
            remarks,
        })
    }
}

/// The file's name as a case's: drawings are called with spaces and all.
fn plain_name(path: &str) -> String {
    let stem = std::path::Path::new(path).file_stem().unwrap_or_default();
    let plain = |c: char| match c {
        c if c.is_alphanumeric() || "-_.".contains(c) => c,
        _ => '-',
    };
    let name: String = stem.to_string_lossy().chars().map(plain).collect();
    if name.is_empty() {
        "drawing".to_owned()
    } else {
        name
    }
}

/// Every closed outline of the drawing, in metres where the unit is known.
fn drawn(
    document: &Document,
    options: &DrawingOptions,
    remarks: &mut Vec<String>,
) -> Result<Vec<Drawn>, Complaint> {
    let file = file(document)?;
    let mut paths = Paths {
        document,
        file: &file,
        chord: options.chord,
        without: &options.without,
        found: Vec::new(),
        left_aside: Vec::new(),
    };
    paths.read()?;
    if !paths.left_aside.is_empty() {
        remarks.push(format!("left aside: {}", paths.left_aside.join(", ")));
    }
    let metres = options.metres.or(file.metres);
    match metres {
        Some(metres) => remarks.push(format!("a drawing unit is {metres} m; lengths are in metres")),
        None => remarks.push(
            "the drawing does not say its unit of length, and is taken as it is; `--units mm` says it"
                .to_owned(),
        ),
    }
    let scale = metres.unwrap_or(1.0);
    let per_metre = whole_if_near(1.0 / scale);
    let closed = outlines(document, paths.found, options.tolerance.max(TOUCHING))?;
    if let Some(path) = closed.get(MOST_BLOCKS) {
        let title = format!("more than {MOST_BLOCKS} outlines");
        return Err(complain(document, path, &title).help("leave out layers: `--without LAYER`"));
    }
    let mut names = std::collections::HashSet::new();
    let mut drawn = Vec::new();
    for (index, mut path) in closed.into_iter().enumerate() {
        for point in &mut path.points {
            // Division by a thousand keeps the digits of millimetres, and times a thousandth does not.
            *point = if scale < 1.0 {
                *point / per_metre
            } else {
                *point * scale
            };
        }
        let shape = shape(document, &path)?;
        let mut name = match path.handle.as_str() {
            "" => (index + 1).to_string(),
            handle => printable(handle),
        };
        while !names.insert(name.clone()) {
            name.push('\'');
        }
        drawn.push(Drawn { name, path, shape });
    }
    Ok(drawn)
}

fn whole_if_near(number: f64) -> f64 {
    let whole = number.round();
    if (number - whole).abs() < 1e-9 * whole {
        whole
    } else {
        number
    }
}

/// An outline as a shape. A circle's last point may repeat its first.
fn shape(document: &Document, path: &Path) -> Result<Polygon, Complaint> {
    let mut points = path.points.clone();
    let (low, high) = points
        .iter()
        .fold((points[0], points[0]), |(low, high), p| {
            (low.inf(p), high.sup(p))
        });
    // Points that a program wrote twice, but for rounding.
    let near = 1e-7 * (high - low).norm();
    points.dedup_by(|a, b| (*a - *b).norm() <= near);
    while points.len() > 1 && (points[0] - points[points.len() - 1]).norm() <= near {
        points.pop();
    }
    Polygon::new(points.clone()).map_err(|error| {
        let (title, at) = match error {
            PolygonError::NotSimple(corner) => (
                "an outline that crosses or touches itself".to_owned(),
                points.get(corner),
            ),
            PolygonError::TooFewCorners(count) => {
                (format!("an outline of {count} corners"), points.first())
            }
            PolygonError::NotFinite(_) | PolygonError::Sliver { .. } => {
                ("an outline without area".to_owned(), points.first())
            }
        };
        let title = match at {
            Some(at) => format!("{title}, at ({}, {})", at.x, at.y),
            None => title,
        };
        complain(document, path, &title)
            .help("draw it again, or leave its layer out: `--without LAYER`")
    })
}

/// Which outlines never move: those of a layer, or else the lowest wide one.
fn supports(
    document: &Document,
    drawn: &[Drawn],
    options: &DrawingOptions,
    remarks: &mut Vec<String>,
) -> Result<Vec<bool>, Complaint> {
    let none = || {
        let end = document.text.len();
        document.complain(end..end, "no outline of a block", "nothing closed is drawn")
    };
    let Some(first) = drawn.first() else {
        return Err(none().help("draw each block as a closed polyline in model space"));
    };
    let on =
        |layer: &str| -> Vec<bool> { drawn.iter().map(|d| same(&d.path.layer, layer)).collect() };
    let is_some = |fixed: &[bool]| fixed.contains(&true);
    let layer = options.support.as_deref();
    let known = layer
        .into_iter()
        .chain(SUPPORT_LAYERS.into_iter().filter(|_| layer.is_none()));
    for layer in known {
        let fixed = on(layer);
        if is_some(&fixed) {
            if fixed.iter().all(|fixed| *fixed) {
                let title = format!("all outlines are on the layer `{layer}` of supports");
                return Err(complain(document, &first.path, &title)
                    .help("name the layer of what never moves with `--support LAYER`"));
            }
            remarks.push(format!("supports: what is on the layer `{layer}`"));
            return Ok(fixed);
        }
    }
    if let Some(layer) = layer {
        let title = format!("no closed outline on the layer `{layer}`");
        let mut layers: Vec<&str> = drawn.iter().map(|d| d.path.layer.as_str()).collect();
        layers.sort_unstable();
        layers.dedup();
        layers.truncate(20);
        return Err(complain(document, &first.path, &title).help(format!(
            "the layers with closed outlines are {}",
            crate::case::suggestion::listed(layers)
        )));
    }
    let bounds = |d: &Drawn| d.shape.bounds();
    let low = drawn
        .iter()
        .map(|d| bounds(d).0.y)
        .fold(f64::INFINITY, f64::min);
    let (left, right) = drawn
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, r), d| {
            (l.min(bounds(d).0.x), r.max(bounds(d).1.x))
        });
    let wide = |d: &Drawn| bounds(d).1.x - bounds(d).0.x >= 0.5 * (right - left);
    let lowest = drawn
        .iter()
        .position(|d| wide(d) && bounds(d).0.y <= low + 1e-6 * extent(&d.shape) && drawn.len() > 1);
    match lowest {
        Some(lowest) => {
            let name = &drawn[lowest].name;
            remarks.push(format!(
                "support: the lowest wide outline, `{name}`; `--support LAYER` names another"
            ));
            Ok((0..drawn.len()).map(|i| i == lowest).collect())
        }
        None => Err(complain(
            document,
            &first.path,
            "no support: which outlines never move?",
        )
        .help(
            "draw the ground as a closed outline on a layer `support`, or name its layer with \
             `--support LAYER`",
        )),
    }
}

/// Lays edges that nearly touch on common lines, and says what was moved.
fn healed(
    document: &Document,
    drawn: &mut [Drawn],
    options: &DrawingOptions,
    remarks: &mut Vec<String>,
) -> Result<(), Complaint> {
    let shapes: Vec<Polygon> = drawn.iter().map(|d| d.shape.clone()).collect();
    let (corners, moved) = heal(&shapes, options.tolerance);
    for m in &moved {
        let part = (m.to - m.from).norm() / extent(&shapes[m.body]);
        if part > 2.0 * options.tolerance {
            let path = &drawn[m.body].path;
            let title = format!(
                "a corner at ({}, {}) would have to move by {:.2} % of its block to touch its neighbours",
                m.from.x,
                m.from.y,
                100.0 * part
            );
            return Err(complain(document, path, &title).help(beyond(options)));
        }
    }
    for (body, corners) in corners.into_iter().enumerate() {
        if shapes[body].corners() != corners {
            let mut path = drawn[body].path.clone();
            path.points = corners;
            drawn[body].shape = shape(document, &path)?;
        }
    }
    if !moved.is_empty() {
        let mut bodies: Vec<usize> = moved.iter().map(|m| m.body).collect();
        bodies.dedup();
        remarks.push(format!(
            "moved {} corners of {} outlines, so that edges within {} of a block's extent touch:",
            moved.len(),
            bodies.len(),
            options.tolerance
        ));
        remarks.extend(moved.iter().map(|m| {
            let way = m.to - m.from;
            format!(
                "  `{}` at ({}, {}) by ({:.3e}, {:.3e})",
                drawn[m.body].name, m.from.x, m.from.y, way.x, way.y
            )
        }));
    }
    Ok(())
}

fn beyond(options: &DrawingOptions) -> String {
    if options.tolerance < 0.01 {
        format!(
            "correct the drawing, or heal more with `--tolerance 0.01` (a part of the smaller block's \
             extent; now {})",
            options.tolerance
        )
    } else {
        "correct the drawing: more than 1 % of a block is not healed".to_owned()
    }
}

fn assembly(drawn: &[Drawn], fixed: &[bool], options: &DrawingOptions) -> Assembly {
    let (mut blocks, mut supports) = (Vec::new(), Vec::new());
    for (body, fixed) in drawn.iter().zip(fixed) {
        let (name, shape) = (body.name.clone(), body.shape.clone());
        if *fixed {
            supports.push(Support { name, shape });
        } else {
            blocks.push(NamedBlock {
                name,
                weight: options.specific_weight * shape.area(),
                centre: shape.centroid(),
                shape,
            });
        }
    }
    Assembly {
        blocks,
        supports,
        friction: options.friction.unwrap_or(0.0).into(),
        forces: Forces::default(),
        tolerance: TOUCHING,
        radial: false,
    }
}

/// Refuses what overlaps, gapes or floats, with layers, handles and coordinates.
fn sound(
    document: &Document,
    drawn: &[Drawn],
    fixed: &[bool],
    assembly: &Assembly,
    options: &DrawingOptions,
) -> Result<(), Complaint> {
    let shapes: Vec<Polygon> = drawn.iter().map(|d| d.shape.clone()).collect();
    let of = |side: Side| {
        let (wanted, place) = match side {
            Side::Support(place) => (true, place),
            Side::Block(place) => (false, place),
        };
        let mut same = drawn
            .iter()
            .zip(fixed)
            .filter(|(_, fixed)| **fixed == wanted);
        same.nth(place).expect("every body was drawn").0
    };
    let near = |d: &Drawn| {
        let at = d.shape.centroid();
        format!(
            "`{}` (layer `{}`, at {:.4}, {:.4})",
            d.name, d.path.layer, at.x, at.y
        )
    };
    let unsound = assembly.check().err();
    if let Some(Unsound::Overlap { one, other, depth }) = unsound {
        let (one, other) = (of(one), of(Side::Block(other)));
        let title = format!(
            "{} and {} overlap, {depth:.3e} deep",
            near(one),
            near(other)
        );
        return Err(complain(document, &other.path, &title).help(beyond(options)));
    }
    let mut wide = gaps(&shapes, TOUCHING, WIDEST_GAP).into_iter();
    let between = |gap: &Gap| gap.bodies.iter().any(|&body| !fixed[body]);
    if let Some(gap) = wide.find(between) {
        let [one, other] = gap.bodies.map(|body| &drawn[body]);
        let title = format!(
            "a gap of {:.3e} ({:.2} % of the smaller one) at ({:.4}, {:.4}) between {} and {}",
            gap.width,
            100.0 * gap.part,
            gap.at.x,
            gap.at.y,
            near(one),
            near(other)
        );
        return Err(complain(document, &other.path, &title).help(beyond(options)));
    }
    match unsound {
        Some(Unsound::Floating { block, .. }) => {
            let block = of(Side::Block(block));
            let title = format!(
                "{} floats: no joints lead from it to a support",
                near(block)
            );
            Err(complain(document, &block.path, &title).help(
                "let an edge of it lie on an edge of a block that is held, or leave its layer out with \
                 `--without LAYER`",
            ))
        }
        _ => Ok(()),
    }
}

fn complain(document: &Document, path: &Path, title: &str) -> Complaint {
    let handle = match path.handle.as_str() {
        "" => String::new(),
        handle => format!("handle {handle}, "),
    };
    let label = format!("{}: {handle}layer `{}`", path.kind, path.layer);
    document.complain(path.place.clone(), title, label)
}
