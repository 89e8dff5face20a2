//! The picture: a plot a scene, time and error on logarithmic axes.

use indexmap::{IndexMap, IndexSet};

use super::front::{FLOOR, front};
use super::measurement::Measurement;
use crate::answer::Bracket;
use crate::method::{Look, METHODS, Mark, method_look};
use crate::number::short;
use crate::picture::palette::{FRONT, INK, NO_ANSWER};
use crate::picture::{
    Band, Filling, LegendEntry, Line, Marks, Plot, PlotAxis, PlotPoint, Sample, Ticks, dashed_line,
    plots, solid_line,
};
use crate::run::{Partial, titled};

/// The plane of all plots, in decades of seconds and of per cent.
#[derive(Clone, Copy)]
struct Plane {
    seconds: [f64; 2],
    errors: [f64; 2],
}

/// Per cent in one.
const PERCENT: f64 = 2.0;

impl Plane {
    fn of(entries: &[Measurement]) -> Self {
        let logs = || {
            entries
                .iter()
                .map(|entry| entry.row.seconds.max(1e-9).log10())
        };
        let errors = entries.iter().filter_map(Measurement::error);
        let largest = errors.fold(1e-2, f64::max).log10().ceil();
        Self {
            seconds: [
                logs().fold(f64::INFINITY, f64::min).floor(),
                logs().fold(-9.0, f64::max).ceil().max(-8.0),
            ],
            errors: [FLOOR.log10() + PERCENT - 0.5, largest + PERCENT + 0.9],
        }
    }

    /// Lower end of the band of failures.
    fn limit(&self) -> f64 {
        self.errors[1] - 0.7
    }

    /// Where failures are marked.
    fn failures(&self) -> f64 {
        self.errors[1] - 0.35
    }

    fn place(&self, entry: &Measurement) -> [f64; 2] {
        let y = entry.error().map_or(self.failures(), of_error);
        [entry.row.seconds.max(1e-9).log10(), y]
    }

    fn time(&self) -> PlotAxis {
        PlotAxis {
            label: "CPU time, seconds".to_owned(),
            ticks: Ticks::Decades(self.seconds, self.seconds[1] as i32),
        }
    }

    fn error(&self) -> PlotAxis {
        PlotAxis {
            label: "error, %".to_owned(),
            ticks: Ticks::Decades(self.errors, self.limit().floor() as i32),
        }
    }
}

/// An error as a height: none is below the floor.
fn of_error(error: f64) -> f64 {
    error.max(FLOOR).log10() + PERCENT
}

/// The chart as SVG: the same bytes for the same table. It says so where it is partial.
pub fn picture(entries: &[Measurement], partial: Option<&Partial>) -> String {
    let cases: IndexSet<String> = entries.iter().map(|e| e.row.scene_name()).collect();
    let looks = looks(entries);
    let plane = Plane::of(entries);
    let of_case = |case: &String| {
        let own: Vec<&Measurement> = entries
            .iter()
            .filter(|e| e.row.scene_name() == *case)
            .collect();
        panel(&own, &looks, plane)
    };
    let panels: Vec<Plot> = cases.iter().map(of_case).collect();
    plots(
        &titled("Speed against accuracy", partial),
        &panels,
        &legend(&looks),
    )
}

/// Every mark, line and shade of the plots.
fn legend(looks: &IndexMap<&str, Look>) -> Vec<LegendEntry> {
    let methods = looks.iter();
    let mut entries: Vec<LegendEntry> = methods
        .map(|(name, look)| LegendEntry::new(Sample::Point(*look, Filling::Full), *name))
        .collect();
    let disc = |filling, words: &str| {
        let look = Look {
            colour: INK,
            mark: Mark::Circle,
        };
        LegendEntry::new(Sample::Point(look, filling), words)
    };
    entries.extend([
        disc(Filling::Full, "not above the lowest state: safe"),
        disc(Filling::Open, "above it"),
        disc(Filling::Hollow, "loose setting"),
        LegendEntry::new(Sample::Bar(INK), "from the better to the worse end"),
        LegendEntry::new(
            Sample::Line(solid_line(FRONT)),
            "front of what vouches for itself",
        ),
        LegendEntry::new(
            Sample::Line(dashed_line(INK)),
            "floor: the references' digits",
        ),
        LegendEntry::new(Sample::Shade(NO_ANSWER, 0.12), "no answer"),
    ]);
    entries
}

/// Names and looks of the methods, those of the table first and in its order.
fn looks(entries: &[Measurement]) -> IndexMap<&str, Look> {
    let used = |name: &str| entries.iter().any(|entry| entry.row.method == name);
    let ours = METHODS.iter().filter(|entry| used(entry.name()));
    let mut looks: IndexMap<&str, Look> = ours.map(|entry| (entry.name(), entry.look)).collect();
    let own = looks.len();
    for entry in entries {
        let outside = looks.len() - own;
        let look = || method_look(&entry.row.method, outside);
        looks.entry(&entry.row.method).or_insert_with(look);
    }
    looks
}

/// One scene: points with bars, the front with names, the floor, the band of failures.
fn panel(own: &[&Measurement], looks: &IndexMap<&str, Look>, plane: Plane) -> Plot {
    let front = front(own);
    let on_front = |entry: &Measurement| front.iter().any(|member| std::ptr::eq(*member, entry));
    let marks = looks.iter().map(|(&name, &look)| {
        let of_method = own.iter().filter(|entry| entry.row.method == name);
        let points = of_method.map(|entry| PlotPoint {
            at: plane.place(entry),
            below: below(entry),
            filling: filling(entry),
            name: on_front(entry).then(|| entry.name()),
            tooltip: tooltip(entry),
        });
        Marks {
            look,
            points: points.collect(),
        }
    });
    let [from, to] = plane.seconds;
    let floor = of_error(0.0);
    let line = |points, colour, dashed| Line {
        points,
        colour,
        name: None,
        dashed,
    };
    Plot {
        title: title(own),
        about: about(own),
        x: plane.time(),
        y: plane.error(),
        bands: vec![Band {
            ends: [plane.limit(), plane.errors[1]],
            colour: NO_ANSWER,
        }],
        lines: vec![
            line(vec![[from, floor], [to, floor]], INK, true),
            line(steps(&front, plane), FRONT, false),
        ],
        marks: marks.collect(),
        ..Plot::default()
    }
}

fn filling(entry: &Measurement) -> Filling {
    match (entry.loose, entry.error().is_none() || entry.is_safe()) {
        (true, _) => Filling::Hollow,
        (false, true) => Filling::Full,
        (false, false) => Filling::Open,
    }
}

fn tooltip(entry: &Measurement) -> String {
    let percent = |error: f64| format!("{:.1e} %", 100.0 * error);
    let error = entry.error().map_or("no answer".to_owned(), percent);
    let seconds = entry.row.seconds;
    format!("{}: {error}, {seconds:.1e} s", entry.name())
}

fn title(own: &[&Measurement]) -> String {
    let row = own.first().map(|entry| &entry.row);
    row.map_or(String::new(), |row| {
        format!("{}, {} head joints", row.case, row.head_joints.name())
    })
}

/// What the errors are measured against.
fn about(own: &[&Measurement]) -> String {
    let Some(known) = own.first().and_then(|entry| entry.reference.as_ref()) else {
        return String::new();
    };
    let Bracket { lower, upper } = known.range;
    let kind = known.lowest.kind.name();
    if upper > lower {
        let [lower, upper] = [lower, upper].map(|end| short(end, 6));
        format!("error against the states {lower} to {upper} ({kind})")
    } else if known.is_associative() {
        let value = short(lower, 6);
        format!("error against associative {value} ({kind}): no lowest state is known")
    } else {
        format!("error against {} ({kind})", short(lower, 6))
    }
}

/// From the error down to that of the better end, in decades; nothing for what is one number.
fn below(entry: &Measurement) -> f64 {
    match (entry.error(), entry.nearest()) {
        (Some(error), Some(nearest)) => of_error(error) - of_error(nearest),
        _ => 0.0,
    }
}

/// The front as a staircase.
fn steps(front: &[&Measurement], plane: Plane) -> Vec<[f64; 2]> {
    let mut steps: Vec<[f64; 2]> = Vec::new();
    for entry in front {
        let [x, y] = plane.place(entry);
        if let Some(&[_, before]) = steps.last() {
            steps.push([x, before]);
        }
        steps.push([x, y]);
    }
    if let Some(&[_, last]) = steps.last() {
        steps.push([plane.seconds[1], last]);
    }
    steps
}
