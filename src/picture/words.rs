//! The one wrapper of words.

use textwrap::{Options, WordSplitter, WrapAlgorithm};

use super::metrics::text_width;

/// Text in lines of at most `width` characters, each as full as can be; only a longer word makes a
/// longer line.
pub(crate) fn lines(text: &str, width: usize) -> Vec<String> {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if text.is_empty() {
        return Vec::new();
    }
    let options = Options::new(width)
        .wrap_algorithm(WrapAlgorithm::FirstFit)
        .word_splitter(WordSplitter::NoHyphenation)
        .break_words(false);
    let lines = textwrap::wrap(&text, options);
    lines.into_iter().map(|line| line.into_owned()).collect()
}

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
        assert_eq!(
            lines(text, 13),
            ["one two-three", "incomprehensibly", "four"]
        );
        let pixels = text_width("one two-three", 12.0) + 0.1;
        assert_eq!(
            fitting(text, 12.0, pixels),
            ["one two-three", "incomprehensibly", "four"]
        );
        assert!(fitting("", 12.0, 13.0).is_empty());
    }
}
