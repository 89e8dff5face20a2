//! Pictures side by side, as one drawing.

use super::key;
use super::legend;
use super::panel::{HEADING, LINE, Panel};
use super::svg::{Svg, style};
use super::view::{Contents, Options, View};
use super::words::written;

/// Pixels around a figure.
const BORDER: f64 = 16.0;

/// Pixels between two pictures.
const GAP: f64 = 24.0;

/// Pixels that a picture may be high, as a part of its width.
const HIGHEST: f64 = 1.05;

/// Pictures side by side, all at one scale and on one base line, as a whole SVG file. A method without
/// anything to draw takes a line below them, and no picture.
pub fn figure(title: &str, views: &[View], options: &Options) -> String {
    let (panels, left_out) = panels(views, options);
    let scale = options
        .scale
        .unwrap_or_else(|| scale(&panels, options.width));
    let heights = panels.iter().map(|panel| panel.height(scale));
    let height = heights.fold(options.height, f64::max);
    let captions: Vec<Vec<String>> = panels
        .iter()
        .map(|panel| panel.caption(options.width, options.forces))
        .collect();
    let lines = captions.iter().map(Vec::len).max().unwrap_or(0);

    let count = panels.len() as f64;
    let across = count * options.width + (count - 1.0).max(0.0) * GAP;
    let mut svg = Svg::default();
    let mut y = BORDER;
    if options.framed {
        let at = [BORDER, y + 14.0];
        y += written(&mut svg, at, title, (16.0, true), across, 22.0) + 6.0;
    }
    let size = [options.width, height];
    for (index, (panel, caption)) in panels.iter().zip(&captions).enumerate() {
        let x = BORDER + index as f64 * (options.width + GAP);
        let top = y + HEADING;
        svg.open(style().class("picture"), "");
        panel.draw(&mut svg, [x, top], size, scale, options.labels);
        panel.words(&mut svg, [x, y + 14.0], caption, top + height);
        svg.close();
    }
    y += HEADING + height + LINE * lines as f64 + 8.0;
    for words in &left_out {
        let at = [BORDER, y + LINE - 4.0];
        y += written(&mut svg, at, words, (12.5, false), across, LINE);
    }
    y += 6.0;
    let held: Vec<_> = panels.iter().flat_map(|panel| panel.held(scale)).collect();
    let entries = key::entries(&held, scale);
    y += legend::draw(&mut svg, &entries, [BORDER, y], across);
    let words = captions.iter().map(|lines| lines.join(", "));
    let words: Vec<String> = words.chain(left_out).collect();
    let title = format!("{title}. {}", words.join(". "));
    svg.document([across + 2.0 * BORDER, y + BORDER], &title)
}

/// What is drawn of the views, and a line for each that has nothing. Where none has, the first shows the
/// wall as it stands.
fn panels<'a>(views: &'a [View], options: &Options) -> (Vec<Panel<'a>>, Vec<String>) {
    let (mut panels, mut left_out) = (Vec::new(), Vec::new());
    for view in views {
        let panel = Panel::new(view, Contents::Mechanism);
        if panel.shows_something() {
            panels.push(panel);
        } else {
            left_out.push(panel.in_a_line());
        }
        if options.forces && view.row.outcome.evidence.forces().is_some() {
            panels.push(Panel::new(view, Contents::Forces));
        }
    }
    if let ([], [first, ..]) = (panels.as_slice(), views) {
        panels.push(Panel::new(first, Contents::Mechanism));
        left_out.remove(0);
    }
    (panels, left_out)
}

/// The largest scale at which the mechanism of each of these views fits into a picture so many pixels
/// wide, and the pixels that the highest of them then takes.
pub fn common_size(views: &[View], width: f64) -> (f64, f64) {
    let panels = views
        .iter()
        .map(|view| Panel::new(view, Contents::Mechanism));
    let panels: Vec<Panel> = panels.collect();
    let scale = scale(&panels, width);
    let heights = panels.iter().map(|panel| panel.height(scale));
    (scale, heights.fold(0.0, f64::max))
}

fn scale(panels: &[Panel], width: f64) -> f64 {
    let scales = panels
        .iter()
        .map(|panel| panel.scale([width, HIGHEST * width]));
    scales.fold(f64::INFINITY, f64::min)
}
