//! How wide text is, so that it finds room before anything draws it, and text in lines of a width.

use super::svg::{Anchor, Pixel, Svg, style};

/// Widths of the characters from space to `~` in Helvetica, thousandths of the font size (Adobe Font
/// Metrics; Arial and Liberation Sans have the same).
const WIDTHS: [u16; 95] = [
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278,
    278, // ' ' to /
    556, 556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, // 0 to ?
    1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778, // @ to O
    667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556, // P to _
    333, 556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556, // ` to o
    556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584, // p to ~
];

/// Width of what is not in the table: Greek letters, dashes and signs are narrower.
const OTHER: u16 = 620;

/// Pixels that a line of text is wide. Bold text is up to a tenth wider.
pub fn text_width(text: &str, font_size: f64) -> f64 {
    let width = |c: char| match (c as usize).checked_sub(' ' as usize) {
        Some(index) if index < WIDTHS.len() => WIDTHS[index],
        _ => OTHER,
    };
    let thousandths: u32 = text.chars().map(|c| u32::from(width(c))).sum();
    f64::from(thousandths) * font_size / 1000.0
}

/// Text in lines of at most so many pixels.
pub fn fitting(text: &str, font_size: f64, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line)
                if text_width(line, font_size)
                    + text_width(word, font_size)
                    + text_width(" ", font_size)
                    <= width =>
            {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// Writes text in lines of at most `width` pixels, `step` apart, the first on the base line at a point;
/// bold lines are up to a tenth wider. The pixels that they take downwards.
pub fn written(
    svg: &mut Svg,
    [x, y]: Pixel,
    text: &str,
    (size, bold): (f64, bool),
    width: f64,
    step: f64,
) -> f64 {
    let lines = fitting(text, if bold { 1.06 * size } else { size }, width);
    for (index, line) in lines.iter().enumerate() {
        let style = style().font_size(size);
        let style = if bold { style.bold() } else { style };
        svg.text([x, y + step * index as f64], Anchor::Start, style, line);
    }
    step * lines.len() as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_full_and_words_stay_whole() {
        assert_eq!(text_width("0.25", 10.0), 19.46);
        assert_eq!(text_width("λ", 10.0), 6.2);
        let text = "one  two-three\nincomprehensibly four";
        let pixels = text_width("one two-three", 12.0) + 0.1;
        assert_eq!(
            fitting(text, 12.0, pixels),
            ["one two-three", "incomprehensibly", "four"]
        );
        assert!(fitting("", 12.0, 13.0).is_empty());
    }
}
