//! Drawings as PNG and PDF, with the fonts of the machine. The SVG is the drawing; these are prints of it.

use std::sync::Arc;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb::Database};
use svg2pdf::{ConversionOptions, PageOptions};

/// Pixels of a PNG for one of the drawing: it is sharp in print at a drawing's own size.
const SHARPNESS: f32 = 3.0;

/// Pixels of a drawing to an inch, as in a browser.
const DPI: f32 = 96.0;

/// Fonts that have the letters and widths of drawings, the first that there is.
const FONTS: [&str; 4] = ["Helvetica", "Arial", "Liberation Sans", "DejaVu Sans"];

fn read(svg: &str) -> Result<Tree, String> {
    let mut fonts = Database::new();
    fonts.load_system_fonts();
    let has = |name: &&str| {
        let mut families = fonts.faces().flat_map(|face| &face.families);
        families.any(|(family, _)| family == name)
    };
    let family = FONTS.into_iter().find(has).ok_or_else(|| {
        let fonts = FONTS.join(", ");
        format!("no font is installed that drawings can be printed with: {fonts}")
    })?;
    let options = Options {
        font_family: family.to_owned(),
        fontdb: Arc::new(fonts),
        ..Options::default()
    };
    Tree::from_str(svg, &options).map_err(|error| format!("the drawing cannot be read: {error}"))
}

/// A drawing as PNG, three pixels for each of its own.
///
/// # Errors
/// Where no font is installed, or the drawing has no size.
pub fn png(svg: &str) -> Result<Vec<u8>, String> {
    let tree = read(svg)?;
    let size = tree.size().to_int_size().scale_by(SHARPNESS);
    let pixmap = size.and_then(|size| Pixmap::new(size.width(), size.height()));
    let mut pixmap = pixmap.ok_or("the drawing cannot be printed in its size")?;
    let scale = Transform::from_scale(SHARPNESS, SHARPNESS);
    resvg::render(&tree, scale, &mut pixmap.as_mut());
    let png = pixmap.encode_png();
    png.map_err(|error| format!("the PNG cannot be made: {error}"))
}

/// A drawing as PDF, one page of its own size, text as text.
///
/// # Errors
/// Where no font is installed.
pub fn pdf(svg: &str) -> Result<Vec<u8>, String> {
    let page = PageOptions { dpi: DPI };
    let done = svg2pdf::to_pdf(&read(svg)?, ConversionOptions::default(), page);
    done.map_err(|error| format!("the PDF cannot be made: {error}"))
}

#[cfg(test)]
mod tests {
    use super::super::svg::{Anchor, Path, Svg, style};
    use super::*;

    /// With text where the machine has a font, else a refusal that names those that would do.
    #[test]
    fn a_drawing_is_printed_or_says_which_font_is_missing() {
        let mut svg = Svg::default();
        svg.path(
            &Path::through(&[[2.0, 2.0], [38.0, 18.0]], false),
            style().stroke("#222"),
            "",
        );
        svg.text([5.0, 15.0], Anchor::Start, style(), "λ = 0.64");
        let svg = svg.document([40.0, 20.0], "a line");
        match (png(&svg), pdf(&svg)) {
            (Ok(png), Ok(pdf)) => {
                assert_eq!(&png[1..4], b"PNG");
                assert_eq!(&png[16..24], [0, 0, 0, 120, 0, 0, 0, 60]);
                assert!(pdf.starts_with(b"%PDF"));
                assert_eq!(png, super::png(&svg).unwrap(), "the same bytes");
            }
            (Err(png), Err(pdf)) => {
                assert!(png.contains("Liberation Sans"), "{png} {pdf}");
            }
            other => panic!("{other:?}"),
        }
    }
}
