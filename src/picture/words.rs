//! Words wrapped to a width in pixels.

use super::metrics::text_width;

/// Text in lines of at most so many pixels.
pub(super) fn fitting(text: &str, font_size: f64, width: f64) -> Vec<String> {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_full_and_words_stay_whole() {
        let text = "one  two-three\nincomprehensibly four";
        let pixels = text_width("one two-three", 12.0) + 0.1;
        assert_eq!(
            fitting(text, 12.0, pixels),
            ["one two-three", "incomprehensibly", "four"]
        );
        assert!(fitting("", 12.0, 13.0).is_empty());
    }
}
