//! The picture: a plot a scene, time and error on logarithmic axes, with the Pareto front of both.

use indexmap::{IndexMap, IndexSet};

use super::measurement::Measurement;
use super::reference::DIGITS;
use crate::answer::Bracket;
use crate::method::{Look, METHODS, method_look};
use crate::number::{ends_of, short};
use crate::picture::palette::{FRONT, INK, NO_ANSWER};
use crate::picture::{
    Filling, Line, Plot, PlotAxis, PlotPoint, Sample, Ticks, dashed_line, plots, solid_line,
};
use crate::run::{Partial, titled};

/// The plane of all plots, in decades of seconds and of per cent.
#[derive(Clone, Copy)]
struct Plane {
    seconds: [f64; 2],
    errors: [f64; 2],
}

const PERCENT: f64 = 2.0;

impl Plane {
    fn of(entries: &[Measurement]) -> Self {
        let logs = entries.iter().map(|e| e.row.seconds.max(1e-9).log10());
        let errors = entries.iter().filter_map(Measurement::error);
        let largest = errors.fold(1e-2, f64::max).log10().ceil();
        let [first, last] = ends_of(logs);
        Self {
            seconds: [first.floor(), last.ceil().max(-8.0)],
            errors: [FLOOR.log10() + PERCENT - 0.5, largest + PERCENT + 0.9],
        }
    }

    /// Lower end of the band of failures.
    fn limit(&self) -> f64 {
        self.errors[1] - 0.7
    }

    fn place(&self, entry: &Measurement) -> [f64; 2] {
        let failures = self.errors[1] - 0.35;
        let y = entry.error().map_or(failures, of_error);
        [entry.row.seconds.max(1e-9).log10(), y]
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
        let own = entries.iter().filter(|e| e.row.scene_name() == *case);
        panel(&own.collect::<Vec<_>>(), &looks, plane)
    };
    let panels: Vec<Plot> = cases.iter().map(of_case).collect();
    let title = titled("Speed against accuracy", partial);
    plots(&title, &panels, &legend(&looks))
}

/// Every mark, line and shade of the plots.
fn legend<'a>(looks: &IndexMap<&'a str, Look>) -> Vec<(Sample, &'a str)> {
    let methods = looks.iter();
    let mut entries: Vec<(Sample, &str)> = methods
        .map(|(name, look)| (Sample::Point(*look, Filling::Full), *name))
        .collect();
    entries.extend([
        (
            Sample::disc(Filling::Full),
            "not above the lowest state: safe",
        ),
        (Sample::disc(Filling::Open), "above it"),
        (Sample::disc(Filling::Hollow), "loose setting"),
        (Sample::Bar(INK), "from the better to the worse end"),
        (
            Sample::Line(solid_line(FRONT)),
            "best of what is proved or seen",
        ),
        (
            Sample::Line(dashed_line(INK)),
            "floor: the references' digits",
        ),
        (Sample::Shade(NO_ANSWER, 0.12), "no answer"),
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
            // Down to the better end; nothing for what is one number.
            below: (entry.distances()).map_or(0.0, |[near, far]| of_error(far) - of_error(near)),
            filling: filling(entry),
            name: on_front(entry).then(|| entry.name()),
            tooltip: tooltip(entry),
        });
        (look, points.collect())
    });
    let [from, to] = plane.seconds;
    let row = own.first().map(|entry| &entry.row);
    let title = row.map_or(String::new(), |row| {
        format!("{}, {} head joints", row.case, row.head_joints.name())
    });
    let floor = of_error(0.0);
    Plot {
        title,
        about: about(own),
        x: PlotAxis {
            label: "CPU time, seconds".to_owned(),
            ticks: Ticks::Decades(plane.seconds, to as i32),
        },
        y: PlotAxis {
            label: "error, %".to_owned(),
            ticks: Ticks::Decades(plane.errors, plane.limit().floor() as i32),
        },
        band: Some(([plane.limit(), plane.errors[1]], NO_ANSWER)),
        lines: vec![
            Line {
                points: vec![[from, floor], [to, floor]],
                colour: INK,
                dashed: true,
                ..Line::default()
            },
            Line {
                points: steps(&front, plane),
                colour: FRONT,
                ..Line::default()
            },
        ],
        marks: marks.collect(),
        ..Plot::default()
    }
}

/// Errors below this count as it: the references have six digits.
const FLOOR: f64 = DIGITS;

/// How much smaller an error must be to be worth more time: the rest is noise of the clock.
const BETTER: f64 = 0.9;

/// Members of the front: of the entries that vouch for themselves, those that no other one beats in both
/// time and error, fastest first.
pub fn front<'a>(entries: &[&'a Measurement]) -> Vec<&'a Measurement> {
    let mut answered: Vec<(&'a Measurement, f64)> = (entries.iter())
        .filter(|entry| entry.vouches())
        .filter_map(|entry| Some((*entry, entry.error()?)))
        .collect();
    answered.sort_by(|(a, x), (b, y)| a.row.seconds.total_cmp(&b.row.seconds).then(x.total_cmp(y)));
    let mut best = f64::INFINITY;
    answered.retain(|(_, error)| {
        // What is exact to the references' digits cannot be beaten by more digits.
        let better = *error < BETTER * best && best > FLOOR;
        if better {
            best = *error;
        }
        better
    });
    answered.into_iter().map(|(entry, _)| entry).collect()
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
