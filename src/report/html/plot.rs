//! Plots by kuva, made the same in every run and fit to stand beside others on a page.

use kuva::render::layout::Layout;
use kuva::render::plots::Plot;

use crate::method::METHODS;
use crate::picture::escape;

/// Colours in the order of the methods (Okabe and Ito, for all eyes), as in the chart; the last one
/// is for others.
const COLORS: [&str; 7] = [
    "#999999", "#0072b2", "#e69f00", "#009e73", "#d55e00", "#cc79a7", "#000000",
];

/// A colour for a method, the same in every plot.
pub fn color(method: &str) -> &'static str {
    let known = METHODS.iter().position(|known| known.name() == method);
    COLORS[known.unwrap_or(COLORS.len() - 1).min(COLORS.len() - 1)]
}

/// The plot as SVG. `name` is its name for those who cannot see it, `id` keeps its identifiers apart
/// from those of other plots on the page.
pub fn svg(plots: Vec<Plot>, layout: Layout, id: &str, name: &str) -> String {
    tidied(&kuva::render_to_svg(plots, layout), id, name)
}

/// Without the version comment, with identifiers that count from this plot's own beginning instead
/// of the process's, and scaling to the page.
fn tidied(svg: &str, id: &str, name: &str) -> String {
    let mut text = svg.to_owned();
    while let Some(start) = text.find("<!--") {
        let end = text[start..]
            .find("-->")
            .map_or(text.len(), |at| start + at + 3);
        text.replace_range(start..end, "");
    }
    let mut ids: Vec<String> = Vec::new();
    for (at, mark) in text.match_indices(" id=\"") {
        let rest = &text[at + mark.len()..];
        ids.push(rest[..rest.find('"').unwrap_or(0)].to_owned());
    }
    for (index, old) in ids.iter().enumerate() {
        let new = format!("{id}-{index}");
        for (before, after) in [(" id=\"", "\""), ("url(#", ")"), ("href=\"#", "\"")] {
            text = text.replace(
                &format!("{before}{old}{after}"),
                &format!("{before}{new}{after}"),
            );
        }
    }
    let label = format!(
        "<svg{} role=\"img\" aria-label=\"{}\"",
        view_box(&text),
        escape(name)
    );
    text.replacen("<svg", &label, 1)
}

/// The whole picture as the part that is shown, without which a narrow page would cut it off; empty
/// where it says so itself.
fn view_box(svg: &str) -> String {
    let root = &svg[..svg.find('>').unwrap_or(svg.len())];
    let size = |name: &str| {
        let (_, after) = root.split_once(&format!(" {name}=\""))?;
        after.split('"').next()
    };
    match (size("viewBox"), size("width"), size("height")) {
        (None, Some(width), Some(height)) => format!(" viewBox=\"0 0 {width} {height}\""),
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kuva::plot::LinePlot;

    #[test]
    fn a_plot_is_the_same_every_time() {
        let plot = || {
            let line = LinePlot::new().with_data(vec![(0.0, 1.0), (1.0, 3.0)]);
            let plots: Vec<Plot> = vec![line.into()];
            let layout = Layout::auto_from_plots(&plots)
                .with_x_axis_max(0.5)
                .with_clamp_axis();
            svg(plots, layout, "one", "a <line>")
        };
        let first = plot();
        assert_eq!(first, plot());
        assert!(first.contains(" viewBox=\"0 0 "));
        assert!(!first.contains("<!--") && first.contains("aria-label=\"a &lt;line&gt;\""));
    }
}
