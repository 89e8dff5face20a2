//! Pictures side by side, as one drawing.

use super::legend::{self, Holds};
use super::panel::{HEADING, LINE, Panel};
use super::path::Pixel;
use super::svg::{Anchor, Svg, style};
use super::view::{Contents, Options, View};

/// Pixels around a figure.
const BORDER: f64 = 16.0;

/// Pixels between two pictures.
const GAP: f64 = 24.0;

/// Pixels that a picture may be high, as a part of its width.
const HIGHEST: f64 = 1.05;

/// Pictures side by side, all at one scale and on one base line, as a whole SVG file.
pub fn figure(title: &str, views: &[View], options: &Options) -> String {
    let panels = panels(views, options);
    let scale = options
        .scale
        .unwrap_or_else(|| fitting(&panels, options.width));
    let heights = panels.iter().map(|panel| panel.height(scale));
    let height = heights.fold(0.0, f64::max);
    let captions: Vec<Vec<String>> = panels
        .iter()
        .map(|panel| panel.caption((options.width / 6.3) as usize, options.forces))
        .collect();
    let lines = captions.iter().map(Vec::len).max().unwrap_or(0);

    let count = panels.len() as f64;
    let across = count * options.width + (count - 1.0).max(0.0) * GAP;
    let mut svg = Svg::default();
    let mut y = BORDER;
    if options.framed {
        let style = style().font_size(16.0).bold();
        svg.text([BORDER, y + 14.0], Anchor::Start, style, title);
        y += 28.0;
    }
    let size = [options.width, height];
    for (index, (panel, caption)) in panels.iter().zip(&captions).enumerate() {
        let x = BORDER + index as f64 * (options.width + GAP);
        picture(&mut svg, panel, caption, [x, y], size, scale);
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

/// One picture between its heading and its caption.
fn picture(
    svg: &mut Svg,
    panel: &Panel,
    caption: &[String],
    [x, y]: Pixel,
    size: [f64; 2],
    scale: f64,
) {
    let top = y + HEADING;
    svg.open(style().class("picture"), "");
    panel.draw(svg, [x, top], size, scale);
    panel.words(svg, [x, y + 14.0], caption, top + size[1]);
    svg.close();
}

fn panels<'a>(views: &'a [View], options: &Options) -> Vec<Panel<'a>> {
    let mut panels = Vec::new();
    for view in views {
        panels.push(Panel::new(view, Contents::Mechanism));
        if options.forces && view.row.outcome.forces.is_some() {
            panels.push(Panel::new(view, Contents::Forces));
        }
    }
    panels
}

/// The largest scale at which the mechanism of each of these views fits into a picture so many pixels
/// wide.
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
