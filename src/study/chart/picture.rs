//! The picture: a panel a scene, time and error on log axes.
//!
//! Logarithms are plotted on linear axes whose ticks say what they stand for, so that bars and the
//! band of failures are placed in decades.

use indexmap::{IndexMap, IndexSet};

use super::front::{FLOOR, front};
use super::table::Measurement;
use crate::method::{Look, METHODS, method_look};
use crate::number::short;
use crate::picture::palette::{FRONT, NO_ANSWER};
use crate::picture::{Band, Line, Marks, Note, Plot, PlotAxis, PlotPoint, Ticks, panels};
use crate::run::{Partial, titled};

/// The plane of all panels, in decades.
#[derive(Clone, Copy)]
struct Plane {
    seconds: [f64; 2],
    errors: [f64; 2],
}

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
            errors: [FLOOR.log10() - 0.5, largest + 1.0],
        }
    }

    /// Lower end of the band of failures.
    fn limit(&self) -> f64 {
        self.errors[1] - 1.0
    }

    /// Where failures are marked.
    fn failures(&self) -> f64 {
        self.errors[1] - 0.5
    }

    fn place(&self, entry: &Measurement) -> [f64; 2] {
        let y = match entry.error() {
            Some(error) => error.max(FLOOR).log10(),
            None => self.failures(),
        };
        [entry.row.seconds.max(1e-9).log10(), y]
    }

    /// Time, with a tick a decade.
    fn time(&self) -> PlotAxis {
        let [from, to] = self.seconds.map(|end| end as i32);
        let ticks = (from..=to).map(|decade| (f64::from(decade), duration(decade)));
        PlotAxis {
            label: "CPU time, median".to_owned(),
            ticks: Ticks::Words(self.seconds, ticks.collect()),
        }
    }

    /// Error, with a tick a decade up to the band of failures.
    fn error(&self) -> PlotAxis {
        let [from, to] = [FLOOR.log10().round(), self.limit()].map(|end| end as i32);
        let ticks = (from..=to).map(|decade| (f64::from(decade), share(decade)));
        PlotAxis {
            label: "error, relative".to_owned(),
            ticks: Ticks::Words(self.errors, ticks.collect()),
        }
    }
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
    let plots: Vec<Plot> = cases.iter().map(of_case).collect();
    let title = "Speed against accuracy: CPU time, and error of the farther end of the bracket";
    panels(&titled(title, partial), &plots, &looks)
}

/// Names and looks of the methods, those of the table first and in its order.
fn looks(entries: &[Measurement]) -> IndexMap<&str, Look> {
    let ours = METHODS.iter().map(|entry| (entry.name(), entry.look));
    let mut looks: IndexMap<&str, Look> = ours.collect();
    for entry in entries {
        let outside = looks.len() - METHODS.len();
        let look = || method_look(&entry.row.method, outside);
        looks.entry(&entry.row.method).or_insert_with(look);
    }
    looks
}

/// One scene: points with bars, the front with names, the band of failures.
fn panel(own: &[&Measurement], looks: &IndexMap<&str, Look>, plane: Plane) -> Plot {
    let front = front(own);
    let on_front = |entry: &Measurement| front.iter().any(|member| std::ptr::eq(*member, entry));
    let marks = looks.iter().map(|(&name, &look)| {
        let of_method = own.iter().filter(|entry| entry.row.method == name);
        let points = of_method.map(|entry| PlotPoint {
            at: plane.place(entry),
            below: below(entry),
            name: on_front(entry).then(|| entry.name()),
        });
        Marks {
            look,
            points: points.collect(),
        }
    });
    Plot {
        title: title(own),
        x: plane.time(),
        y: plane.error(),
        bands: vec![Band {
            ends: [plane.limit(), plane.errors[1]],
            colour: NO_ANSWER,
        }],
        lines: vec![Line {
            points: steps(&front, plane),
            colour: FRONT,
            name: None,
            dashed: false,
        }],
        marks: marks.collect(),
        notes: vec![Note {
            at: [plane.seconds[0] + 0.45, plane.failures()],
            words: "no answer",
        }],
    }
}

/// The scene, and what its errors are measured against.
fn title(own: &[&Measurement]) -> String {
    let known = own.first().and_then(|entry| entry.reference.as_ref());
    let against = known.map_or(String::new(), |known| {
        let source = format!("{} {}", known.kind.name(), known.method);
        format!(" against {} ({source})", short(known.value, 6))
    });
    let case = own.first().map(|entry| entry.row.scene_name());
    format!("{}{against}", case.unwrap_or_default())
}

/// From the error down to the nearer end of the bracket, in decades; nothing for what is one number.
fn below(entry: &Measurement) -> f64 {
    match (entry.error(), entry.nearest()) {
        (Some(error), Some(nearest)) => error.max(FLOOR).log10() - nearest.max(FLOOR).log10(),
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

/// A power of ten in seconds, in words.
fn duration(decade: i32) -> String {
    let digits = |power: i32| 10i64.pow(power.clamp(0, 18) as u32);
    match decade {
        ..-6 => format!("{} ns", digits(decade + 9)),
        -6..-3 => format!("{} µs", digits(decade + 6)),
        -3..0 => format!("{} ms", digits(decade + 3)),
        _ => format!("{} s", digits(decade)),
    }
}

/// A power of ten as a relative error, in words.
fn share(decade: i32) -> String {
    let error = 10f64.powi(decade);
    if error <= 1.01 * FLOOR {
        "≤ 1e-6".to_owned()
    } else if error < 0.99e-3 {
        format!("1e{decade}")
    } else {
        format!("{} %", short(100.0 * error, 1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_say_what_the_decades_are() {
        let words = [-7, -6, -4, -3, -1, 0, 2].map(duration);
        assert_eq!(
            words,
            ["100 ns", "1 µs", "100 µs", "1 ms", "100 ms", "1 s", "100 s"]
        );
        assert_eq!(
            [-6, -4, -3, -1].map(share),
            ["≤ 1e-6", "1e-4", "0.1 %", "10 %"]
        );
    }
}
