//! SVG text: fixed decimals, escaped text, compact paths.

use std::fmt::{Display, Write};

use super::palette::FAINT;

/// A point of the drawing in pixels, y down.
pub type Px = [f64; 2];

/// Pixels with two decimals, without trailing zeros and never a negative zero.
pub fn px(value: f64) -> String {
    crate::number::short(value, 2)
}

/// Text as it may stand between tags and in attributes.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            _ => out.push(c),
        }
    }
    out
}

/// Path of several outlines, each closed or not. Points are rounded to hundredths first, and then
/// written relative to each other, so that no rounding adds up.
#[derive(Clone, Debug, Default)]
pub struct Path {
    text: String,
}

impl Path {
    /// Adds the outline through these points.
    pub fn add(&mut self, points: &[Px], closed: bool) {
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

    /// Whether nothing was added.
    pub fn is_empty(&self) -> bool {
        self.text.is_empty()
    }

    /// The value of the attribute `d`.
    pub fn d(&self) -> &str {
        &self.text
    }
}

/// The inside of a drawing, written element by element.
#[derive(Clone, Debug, Default)]
pub struct Svg {
    text: String,
}

impl Svg {
    /// A path with its attributes and, where it is not empty, a tooltip. An empty path is left out.
    pub fn path(&mut self, path: &Path, attributes: impl Display, tooltip: &str) {
        if path.is_empty() {
            return;
        }
        let d = path.d();
        let _ = match tooltip {
            "" => writeln!(self.text, "<path {attributes} d=\"{d}\"/>"),
            _ => writeln!(
                self.text,
                "<path {attributes} d=\"{d}\"><title>{}</title></path>",
                escape(tooltip)
            ),
        };
    }

    /// Text at a point; `anchor` is `start`, `middle` or `end`.
    pub fn text(&mut self, at: Px, anchor: &str, attributes: impl Display, text: &str) {
        let [x, y] = at.map(px);
        let _ = writeln!(
            self.text,
            "<text x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\" {attributes}>{}</text>",
            escape(text)
        );
    }

    /// A heading in bold, and what follows it in small print.
    pub fn heading(&mut self, at: Px, bold: &str, small: &str) {
        let [x, y] = at.map(px);
        let (bold, small) = (escape(bold), escape(small));
        let _ = writeln!(
            self.text,
            "<text x=\"{x}\" y=\"{y}\"><tspan font-size=\"14.5\" font-weight=\"600\">{bold}</tspan>\
             <tspan dx=\"8\" font-size=\"12\" fill=\"{FAINT}\">{small}</tspan></text>"
        );
    }

    /// Opens a group.
    pub fn open(&mut self, attributes: impl Display) {
        let _ = writeln!(self.text, "<g {attributes}>");
    }

    /// Closes the innermost group.
    pub fn close(&mut self) {
        self.text.push_str("</g>\n");
    }

    /// The whole file, white behind the drawing. `title` is its name for those who cannot see it.
    pub fn document(&self, size: Px, title: &str) -> String {
        let [width, height] = size.map(px);
        let title = escape(title);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
             width=\"{width}\" height=\"{height}\" role=\"img\" aria-label=\"{title}\" \
             font-family=\"{FONT}\" font-size=\"13\" fill=\"{INK}\" stroke-linejoin=\"round\">\n\
             <title>{title}</title>\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{}</svg>\n",
            self.text
        )
    }
}

/// Fonts that look alike everywhere.
const FONT: &str = "'Helvetica Neue',Helvetica,Arial,'Liberation Sans','DejaVu Sans',sans-serif";

/// Text and the strongest lines.
pub const INK: &str = "#222";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_relative_and_without_negative_zeros() {
        let mut path = Path::default();
        path.add(
            &[[0.0, -0.001], [10.0, 0.0], [10.0, 5.126], [8.5, 4.0]],
            true,
        );
        assert_eq!(path.d(), "M0 0h10v5.13l-1.5-1.13z");
        path.add(&[[1.0, 1.0], [1.0, 1.004]], false);
        assert_eq!(path.d(), "M0 0h10v5.13l-1.5-1.13zM1 1");
    }

    #[test]
    fn text_is_escaped() {
        assert_eq!(escape("a<b & \"c\">"), "a&lt;b &amp; &quot;c&quot;&gt;");
    }
}
