//! The price of each assumption: how far it moves the multiplier from the lowest collapse state with
//! head joints in contact and Coulomb friction.

use indexmap::IndexMap;

use crate::answer::{Status, magnitude};
use crate::method::{Kind, Look, Mark};
use crate::number::percent;
use crate::picture::palette::INK;
use crate::picture::{Filling, Line, Marks, Note, Plot, PlotAxis, PlotPoint, Ticks, plots};
use crate::run::Row;
use crate::scene::HeadJoints;

/// What is assumed instead.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Assumption {
    /// Associative friction: λ_A.
    Associative,
    /// The closed form's lower value.
    ClosedFormLower,
    /// The closed form's upper value.
    ClosedFormUpper,
    /// Head joints that carry nothing.
    OpenHeadJoints,
}

impl Assumption {
    const ALL: [Assumption; 4] = [
        Assumption::Associative,
        Assumption::ClosedFormLower,
        Assumption::ClosedFormUpper,
        Assumption::OpenHeadJoints,
    ];

    fn name(self) -> &'static str {
        match self {
            Assumption::Associative => "associative",
            Assumption::ClosedFormLower => "closed form, lower",
            Assumption::ClosedFormUpper => "closed form, upper",
            Assumption::OpenHeadJoints => "open head joints",
        }
    }
}

/// What one assumption costs on one scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Price {
    /// The assumption.
    pub assumption: Assumption,
    /// Name of the scene.
    pub scene: String,
    /// (λ with it − λ without) / λ without.
    pub relative: f64,
}

/// The prices of all assumptions on all scenes whose lowest collapse state is verified. Rows with
/// settings of their own are left out.
pub fn prices<'a>(rows: impl IntoIterator<Item = &'a Row>) -> Vec<Price> {
    let mut scenes: IndexMap<(&str, bool), Vec<&Row>> = IndexMap::new();
    for row in rows {
        scenes
            .entry((&row.case, is_open(row)))
            .or_default()
            .push(row);
    }
    let lowest = |case, open| {
        let rows = scenes.get(&(case, open))?;
        let states =
            |row: &&&Row| row.kind() == Kind::CollapseStates && row.status() == Status::Verified;
        let row = rows.iter().find(states)?;
        Some((row.bracket()?.lower, row.multiplier_unit))
    };
    let mut prices = Vec::new();
    for (&(case, open), rows) in &scenes {
        let Some((lambda, unit)) = lowest(case, open) else {
            continue;
        };
        let mut add = |assumption, with: f64, without: f64| {
            prices.push(Price {
                assumption,
                scene: rows[0].scene_name(),
                relative: (with - without) / magnitude(without, unit),
            });
        };
        for row in rows {
            let Some(bracket) = row.bracket() else {
                continue;
            };
            match row.kind() {
                Kind::AssociativeBounds if row.status() == Status::Verified => {
                    add(Assumption::Associative, bracket.upper, lambda);
                }
                Kind::ClosedForm => {
                    add(Assumption::ClosedFormLower, bracket.lower, lambda);
                    add(Assumption::ClosedFormUpper, bracket.upper, lambda);
                }
                _ => {}
            }
        }
        if open && let Some((contact, _)) = lowest(case, false) {
            add(Assumption::OpenHeadJoints, lambda, contact);
        }
    }
    prices
}

fn is_open(row: &Row) -> bool {
    row.head_joints == HeadJoints::Open
}

/// Mark of a price.
const LOOK: Look = Look {
    colour: "#0072B2",
    mark: Mark::Circle,
};

/// The prices as SVG, a line an assumption; `None` where nothing has a price.
pub fn price_picture(prices: &[Price]) -> Option<String> {
    let shown: Vec<Assumption> = Assumption::ALL
        .into_iter()
        .filter(|assumption| prices.iter().any(|price| price.assumption == *assumption))
        .collect();
    let count = shown.len();
    let mut plot = Plot {
        about:
            "(λ with the assumption − lowest verified state) / lowest verified state, a circle a \
                scene"
                .to_owned(),
        x: PlotAxis {
            label: "price, %".to_owned(),
            ticks: Ticks::Fitting,
        },
        y: PlotAxis {
            label: String::new(),
            ticks: Ticks::Words(
                [0.0, count as f64],
                shown
                    .iter()
                    .enumerate()
                    .map(|(line, assumption)| (height(count, line), assumption.name().to_owned()))
                    .collect(),
            ),
        },
        ..Plot::default()
    };
    for (line, assumption) in shown.iter().enumerate() {
        let mut own: Vec<&Price> = prices
            .iter()
            .filter(|price| price.assumption == *assumption)
            .collect();
        own.sort_by(|a, b| a.relative.total_cmp(&b.relative));
        let middle = height(count, line);
        let points = own.iter().enumerate().map(|(index, price)| PlotPoint {
            // Spread evenly, so that equal prices are seen to be many.
            at: [
                100.0 * price.relative,
                middle - 0.28 * (0.618 * index as f64).fract(),
            ],
            below: 0.0,
            filling: Filling::Open,
            name: None,
            tooltip: format!("{}: {}", price.scene, percent(price.relative)),
        });
        plot.marks.push(Marks {
            look: LOOK,
            points: points.collect(),
        });
        plot.notes.push(Note {
            at: [f64::NEG_INFINITY, middle + 0.3],
            words: in_words(&own),
        });
    }
    plot.lines.push(Line {
        points: vec![[0.0, 0.0], [0.0, count as f64]],
        colour: INK,
        name: None,
        dashed: true,
    });
    (count > 0).then(|| plots("The price of each assumption", &[plot], &[]))
}

/// Height of a line of the picture.
fn height(count: usize, line: usize) -> f64 {
    (count - line) as f64 - 0.55
}

/// Median and farthest price, from the smallest to the largest.
fn in_words(sorted: &[&Price]) -> String {
    let median = sorted[sorted.len() / 2].relative;
    let far = |a: &&&Price, b: &&&Price| a.relative.abs().total_cmp(&b.relative.abs());
    let farthest = sorted.iter().max_by(far).unwrap_or(&sorted[0]);
    format!(
        "{} scenes: median {}, farthest {} ({})",
        sorted.len(),
        percent(median),
        percent(farthest.relative),
        farthest.scene
    )
}
