//! Drawings of walls and their mechanisms as SVG: the same input gives the same bytes.
//!
//! ```text
//! figure ── panel (one method's view) ──▶ wall: supports, blocks in rigid parts, marks, forces
//!                                    └──▶ crack: c, e, the macro-block's crack, the push
//! ```
//!
//! Blocks are shown displaced along their velocities, amplified: distances between them mean what a
//! mechanism is, first order in its size, so that no block seems to enter another.

mod crack;
mod frame;
mod legend;
mod palette;
mod panel;
mod parts;
mod svg;
mod wall;

pub use frame::{Displaced, Frame};
pub use parts::{Part, parts, threshold};
pub use svg::{Path, Px, escape, px};
pub use wall::Shown;

use crate::run::Row;
use crate::scene::Scene;
use legend::Holds;
use panel::{HEADING, LINE, Panel};
use svg::Svg;

/// One method's answer for one scene.
#[derive(Clone, Copy)]
pub struct View<'a> {
    /// The scene that the answer is about.
    pub scene: &'a Scene,
    /// The answer.
    pub row: &'a Row,
    /// tan β of the macro-block model, where it has one for this scene.
    pub macro_slope: Option<f64>,
}

impl View<'_> {
    fn is_macro_block(&self) -> bool {
        self.row.method == "macro-block" && self.row.outcome.crack.is_some()
    }
}

/// What a drawing shows beside the mechanisms.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// Contact forces of each view that has them, in a picture of their own beside the mechanism:
    /// they balance in the wall as it stands.
    pub forces: bool,
    /// A heading over all, and a legend below.
    pub framed: bool,
    /// Pixels that a picture is wide.
    pub width: f64,
    /// Pixels for a unit of length, where several drawings share it; else as large as fits.
    pub scale: Option<f64>,
}

impl Options {
    /// For so many pictures side by side.
    pub fn for_pictures(count: usize) -> Self {
        Self {
            forces: false,
            framed: true,
            width: match count {
                0 | 1 => 640.0,
                2 => 480.0,
                _ => 400.0,
            },
            scale: None,
        }
    }
}

/// What one picture is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Contents {
    Mechanism,
    Forces,
}

/// Pixels around a figure.
const BORDER: f64 = 16.0;

/// Pixels between two pictures.
const GAP: f64 = 24.0;

/// Pixels that a picture may be high, as a part of its width.
const HIGHEST: f64 = 1.05;

/// Pictures side by side, all at one scale and on one base line, as a whole SVG file.
pub fn figure(title: &str, views: &[View], options: &Options) -> String {
    let width = options.width;
    let mut panels = Vec::new();
    for view in views {
        panels.push(Panel::new(view, Contents::Mechanism));
        if options.forces && view.row.outcome.forces.is_some() {
            panels.push(Panel::new(view, Contents::Forces));
        }
    }
    let scale = panels
        .iter()
        .map(|panel| panel.scale([width, HIGHEST * width]));
    let scale = scale.fold(f64::INFINITY, f64::min);
    let height = panels
        .iter()
        .map(|panel| panel.height(scale))
        .fold(0.0, f64::max);
    let captions: Vec<Vec<String>> = panels
        .iter()
        .map(|panel| panel.caption((width / 6.3) as usize, options.forces))
        .collect();
    let lines = captions.iter().map(Vec::len).max().unwrap_or(0);

    let count = panels.len() as f64;
    let across = count * width + (count - 1.0).max(0.0) * GAP;
    let mut svg = Svg::default();
    let mut y = BORDER;
    if options.framed {
        svg.text(
            [BORDER, y + 14.0],
            "start",
            "font-size=\"16\" font-weight=\"700\"",
            title,
        );
        y += 28.0;
    }
    for (index, (panel, caption)) in panels.iter().zip(&captions).enumerate() {
        let x = BORDER + index as f64 * (width + GAP);
        let top = y + HEADING;
        svg.open("class=\"picture\"");
        panel.draw(&mut svg, [x, top], [width, height], scale);
        panel.words(&mut svg, [x, y + 14.0], caption, top + height);
        svg.close();
    }
    y += HEADING + height + LINE * lines as f64 + 8.0;
    if options.framed {
        y += 6.0;
        let entries = legend::entries(holds(views, options));
        y += legend::draw(&mut svg, &entries, [BORDER, y], across);
    }
    let words: Vec<String> = captions.iter().map(|lines| lines.join(", ")).collect();
    let title = format!("{title}. {}", words.join(". "));
    svg.document([across + 2.0 * BORDER, y + BORDER], &title)
}

/// The largest scale at which each of these pictures fits into its width.
pub fn common_scale(views: &[View], width: f64) -> f64 {
    let panels: Vec<Panel> = views
        .iter()
        .map(|view| Panel::new(view, Contents::Mechanism))
        .collect();
    fitting(&panels, width)
}

fn fitting(panels: &[Panel], width: f64) -> f64 {
    let scales = panels
        .iter()
        .map(|panel| panel.scale([width, HIGHEST * width]));
    scales.fold(f64::INFINITY, f64::min)
}

/// The legend of every mark, as a drawing of its own.
pub fn legend(width: f64) -> String {
    let all = Holds {
        mechanism: true,
        crack: true,
        macro_crack: true,
        forces: true,
    };
    let mut svg = Svg::default();
    let height = legend::draw(&mut svg, &legend::entries(all), [2.0, 2.0], width);
    svg.document(
        [width + 4.0, height + 4.0],
        "What the marks of the drawings mean",
    )
}

fn holds(views: &[View], options: &Options) -> Holds {
    let any = |has: &dyn Fn(&View) -> bool| views.iter().any(has);
    Holds {
        mechanism: any(&|view| view.row.outcome.mechanism.is_some()),
        crack: any(&|view| {
            view.row
                .outcome
                .crack
                .is_some_and(|crack| crack.c.is_some())
        }),
        macro_crack: any(&|view| view.macro_slope.is_some()),
        forces: options.forces && any(&|view| view.row.outcome.forces.is_some()),
    }
}
