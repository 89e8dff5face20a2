//! The only writer of SVG: typed elements, fixed decimals, escaped text.

use std::fmt::{Display, Write};

use super::palette::{FAINT, INK, WHITE};
use crate::number::short;

/// A point of the drawing in pixels from its upper left corner, y down.
pub type Pixel = [f64; 2];

/// Pixels with two decimals, without trailing zeros and never a negative zero.
fn px(value: f64) -> String {
    short(value, 2)
}

/// Path of several outlines, each closed or not. Points are rounded to hundredths first, and then
/// written relative to each other, so that no rounding adds up.
#[derive(Clone, Debug, Default)]
pub struct Path {
    text: String,
}

impl Path {
    pub fn through(points: &[Pixel], closed: bool) -> Self {
        let mut path = Self::default();
        path.add(points, closed);
        path
    }

    pub fn add(&mut self, points: &[Pixel], closed: bool) {
        let hundredths = |v: f64| (v * 100.0).round() as i64;
        let mut points = points.iter().map(|[x, y]| [hundredths(*x), hundredths(*y)]);
        let Some(mut at) = points.next() else {
            return;
        };
        self.number('M', at[0]);
        self.following(at[1]);
        for to in points {
            let [dx, dy] = [to[0] - at[0], to[1] - at[1]];
            match (dx, dy) {
                (0, 0) => {}
                (_, 0) => self.number('h', dx),
                (0, _) => self.number('v', dy),
                _ => {
                    self.number('l', dx);
                    self.following(dy);
                }
            }
            at = to;
        }
        if closed {
            self.text.push('z');
        }
    }

    fn number(&mut self, command: char, hundredths: i64) {
        self.text.push(command);
        self.text.push_str(&px(hundredths as f64 / 100.0));
    }

    fn following(&mut self, hundredths: i64) {
        if hundredths >= 0 {
            self.text.push(' ');
        }
        self.text.push_str(&px(hundredths as f64 / 100.0));
    }

    fn is_empty(&self) -> bool {
        self.text.is_empty()
    }

    fn d(&self) -> &str {
        &self.text
    }
}

/// The inside of a drawing, written element by element.
#[derive(Clone, Debug, Default)]
pub struct Svg {
    text: String,
}

impl Svg {
    /// A path and, where it is not empty, a tooltip. An empty path is left out.
    pub fn path(&mut self, path: &Path, style: Style, tooltip: &str) {
        if path.is_empty() {
            return;
        }
        let d = path.d();
        let _ = if tooltip.is_empty() {
            writeln!(self.text, "<path{style} d=\"{d}\"/>")
        } else {
            let tooltip = escape(tooltip);
            writeln!(
                self.text,
                "<path{style} d=\"{d}\"><title>{tooltip}</title></path>"
            )
        };
    }

    /// A rectangle by its upper left corner, width and height.
    pub fn rect(&mut self, corner: Pixel, size: [f64; 2], style: Style) {
        let ([x, y], [width, height]) = (corner.map(px), size.map(px));
        let _ = writeln!(
            self.text,
            "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"{style}/>"
        );
    }

    pub fn circle(&mut self, centre: Pixel, radius: f64, style: Style) {
        let ([x, y], radius) = (centre.map(px), px(radius));
        let _ = writeln!(
            self.text,
            "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"{style}/>"
        );
    }

    /// Text at a point of its base line.
    pub fn text(&mut self, at: Pixel, anchor: Anchor, style: Style, text: &str) {
        let [x, y] = at.map(px);
        let (anchor, text) = (anchor.name(), escape(text));
        let _ = writeln!(
            self.text,
            "<text x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\"{style}>{text}</text>"
        );
    }

    /// A heading in bold, and what follows it in small print.
    pub fn heading(&mut self, at: Pixel, bold: &str, small: &str) {
        let [x, y] = at.map(px);
        let (bold, small) = (escape(bold), escape(small));
        let _ = writeln!(
            self.text,
            "<text x=\"{x}\" y=\"{y}\"><tspan font-size=\"14.5\" font-weight=\"600\">{bold}</tspan>\
             <tspan dx=\"8\" font-size=\"12\" fill=\"{FAINT}\">{small}</tspan></text>"
        );
    }

    /// Opens a group; without words it has no tooltip.
    pub fn open(&mut self, style: Style, tooltip: &str) {
        let _ = writeln!(self.text, "<g{style}>");
        if !tooltip.is_empty() {
            let _ = writeln!(self.text, "<title>{}</title>", escape(tooltip));
        }
    }

    pub fn close(&mut self) {
        self.text.push_str("</g>\n");
    }

    /// The whole file, white behind the drawing. `title` is its name for those who cannot see it.
    pub fn document(&self, size: [f64; 2], title: &str) -> String {
        let [width, height] = size.map(px);
        let title = escape(title);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
             width=\"{width}\" height=\"{height}\" role=\"img\" aria-label=\"{title}\" \
             font-family=\"{FONT}\" font-size=\"13\" fill=\"{INK}\" stroke-linejoin=\"round\">\n\
             <title>{title}</title>\n\
             <rect width=\"100%\" height=\"100%\" fill=\"{WHITE}\"/>\n{}</svg>\n",
            self.text
        )
    }
}

/// Fonts that look alike everywhere.
const FONT: &str = "'Helvetica Neue',Helvetica,Arial,'Liberation Sans','DejaVu Sans',sans-serif";

#[derive(Clone, Copy, Debug)]
pub enum Anchor {
    Start,
    Middle,
    End,
}

impl Anchor {
    fn name(self) -> &'static str {
        match self {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        }
    }
}

/// How an element looks: attributes, in the order in which they are given.
#[derive(Clone, Debug, Default)]
pub struct Style {
    text: String,
}

pub fn style() -> Style {
    Style::default()
}

impl Style {
    fn with(mut self, name: &str, value: impl Display) -> Self {
        let value = escape(&value.to_string());
        let _ = write!(self.text, " {name}=\"{value}\"");
        self
    }

    pub fn class(self, name: &str) -> Self {
        self.with("class", name)
    }

    pub fn fill(self, colour: &str) -> Self {
        self.with("fill", colour)
    }

    pub fn fill_opacity(self, part: f64) -> Self {
        self.with("fill-opacity", px(part))
    }

    pub fn hollow(self) -> Self {
        self.with("fill", "none")
    }

    /// A line of this colour, so many pixels wide.
    pub fn line(self, colour: &str, pixels: f64) -> Self {
        self.hollow().stroke(colour).stroke_width(pixels)
    }

    pub fn stroke(self, colour: &str) -> Self {
        self.with("stroke", colour)
    }

    pub fn stroke_width(self, pixels: f64) -> Self {
        self.with("stroke-width", px(pixels))
    }

    /// Pixels of dashes and of the gaps between them, in turn.
    pub fn dashes(self, pattern: &str) -> Self {
        self.with("stroke-dasharray", pattern)
    }

    pub fn round_ends(self) -> Self {
        self.with("stroke-linecap", "round")
    }

    pub fn font_size(self, pixels: f64) -> Self {
        self.with("font-size", px(pixels))
    }

    pub fn bold(self) -> Self {
        self.with("font-weight", "700")
    }

    /// White around the letters of a text, so that it is read over lines.
    pub fn halo(self) -> Self {
        let white = self.stroke(WHITE).stroke_width(3.0);
        white.with("paint-order", "stroke")
    }

    pub fn italic(self) -> Self {
        self.with("font-style", "italic")
    }

    /// Turned about a point so that it is read from the right.
    pub fn upwards(self, about: Pixel) -> Self {
        let [x, y] = about.map(px);
        self.with("transform", format_args!("rotate(-90 {x} {y})"))
    }
}

impl Display for Style {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.text)
    }
}

/// Text as it may stand between tags and in attributes.
fn escape(text: &str) -> String {
    maud::html! { (text) }.into_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_and_attributes_are_escaped() {
        let mut svg = Svg::default();
        let style = style().fill("\"red\"").stroke_width(1.006);
        svg.text([1.0, -0.001], Anchor::Middle, style, "a<b & \"c\">");
        let expected = "<text x=\"1\" y=\"0\" text-anchor=\"middle\" fill=\"&quot;red&quot;\" \
                        stroke-width=\"1.01\">a&lt;b &amp; &quot;c&quot;&gt;</text>\n";
        assert_eq!(svg.text, expected);
    }

    #[test]
    fn paths_are_relative_and_without_negative_zeros() {
        let mut path = Path::through(
            &[[0.0, -0.001], [10.0, 0.0], [10.0, 5.126], [8.5, 4.0]],
            true,
        );
        assert_eq!(path.d(), "M0 0h10v5.13l-1.5-1.13z");
        path.add(&[[1.0, 1.0], [1.0, 1.004]], false);
        assert_eq!(path.d(), "M0 0h10v5.13l-1.5-1.13zM1 1");
    }
}
