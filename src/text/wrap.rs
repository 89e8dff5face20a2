//! Words wrapped to a width in columns.

use textwrap::{Options, WordSplitter, WrapAlgorithm};

/// Text in lines of at most `width` characters, each as full as can be; only a longer word makes a
/// longer line.
pub fn lines(text: &str, width: usize) -> Vec<String> {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if text.is_empty() {
        return Vec::new();
    }
    let lines = textwrap::wrap(&text, options(width).break_words(false));
    lines.into_iter().map(|line| line.into_owned()).collect()
}

fn options<'a>(width: usize) -> Options<'a> {
    Options::new(width)
        .wrap_algorithm(WrapAlgorithm::FirstFit)
        .word_splitter(WordSplitter::NoHyphenation)
}

/// Text of several lines for a screen: each that is longer than `width` is wrapped, and its further
/// lines are indented by `indent` columns more than the first.
pub fn wrapped(text: &str, width: Option<usize>, indent: usize) -> String {
    let Some(width) = width else {
        return text.to_owned();
    };
    let fitted = text.split('\n').map(|line| {
        if line.chars().count() <= width {
            return line.to_owned();
        }
        let blanks = line.len() - line.trim_start().len();
        let below = " ".repeat(blanks + indent);
        textwrap::wrap(line, options(width).subsequent_indent(&below)).join("\n")
    });
    fitted.collect::<Vec<_>>().join("\n")
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
    }

    #[test]
    fn long_lines_alone_are_wrapped() {
        let text = "short  line\n  a long line of words\n";
        assert_eq!(
            wrapped(text, Some(14), 2),
            "short  line\n  a long line\n    of words\n"
        );
        assert_eq!(wrapped(text, None, 2), text);
    }
}
