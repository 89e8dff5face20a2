//! The one wrapper of words.

use textwrap::{Options, WordSplitter, WrapAlgorithm};

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

/// The same with at most so many lines, the last of which then ends in `…`.
pub(super) fn first_lines(text: &str, width: usize, most: usize) -> Vec<String> {
    let mut lines = lines(text, width);
    if lines.len() > most {
        lines.truncate(most);
        if let Some(last) = lines.last_mut() {
            last.push('…');
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
        assert_eq!(
            first_lines(text, 13, 2),
            ["one two-three", "incomprehensibly…"]
        );
        assert!(first_lines("", 13, 2).is_empty());
    }
}
