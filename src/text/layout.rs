//! How text is laid out on a screen: its width, its colours, wrapped words.

use std::fmt::Display;

use anstyle::Style;
use textwrap::{Options, WordSplitter, WrapAlgorithm};

/// Least width that text is laid out for, columns.
pub const LEAST_WIDTH: usize = 80;

/// Where text for people goes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Layout {
    /// Columns of the screen; `None` where lines may be of any length, as in a pipe or a file.
    pub width: Option<usize>,
    /// Whether verdicts are coloured.
    pub colours: bool,
}

impl Layout {
    /// The width, where there is one: `LEAST_WIDTH` at least.
    pub fn columns(self) -> Option<usize> {
        self.width.map(|width| width.max(LEAST_WIDTH))
    }

    /// Text in this style, where there are colours.
    pub fn painted(self, text: impl Display, style: Style) -> String {
        if self.colours && style != Style::new() {
            format!("{style}{text}{style:#}")
        } else {
            text.to_string()
        }
    }

    /// Words behind a lead: wrapped, where there is a width, with every further line below the first
    /// word. The lead is painted.
    pub fn paragraph(self, lead: &str, style: Style, words: &str) -> String {
        let indent = lead.chars().count();
        let wrapped = match self.columns() {
            Some(width) => lines(words, width.saturating_sub(indent)),
            None => vec![words.to_owned()],
        };
        let joined = wrapped.join(&format!("\n{}", " ".repeat(indent)));
        let text = format!("{}{joined}", self.painted(lead, style));
        text.trim_end().to_owned() + "\n"
    }
}

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

pub fn bold() -> Style {
    Style::new().bold()
}

/// A clause with a full stop behind it.
pub fn ended(clause: &str) -> String {
    let clause = clause.trim();
    match clause.ends_with(['.', '?', '!']) || clause.is_empty() {
        true => clause.to_owned(),
        false => format!("{clause}."),
    }
}

/// A sentence: a clause that begins with a capital, where a word begins it, and ends with a full stop.
pub fn sentence(clause: &str) -> String {
    let clause = ended(clause);
    let word = clause.split([' ', ',']).next().unwrap_or_default();
    match word.chars().all(|c| c.is_ascii_lowercase()) && !clause.is_empty() {
        true => clause[..1].to_ascii_uppercase() + &clause[1..],
        false => clause,
    }
}

/// So many of a word that takes an s.
pub fn counted(count: usize, word: &str) -> String {
    match count {
        1 => format!("1 {word}"),
        _ => format!("{count} {word}s"),
    }
}

/// Names with commas, and with "and" before the last.
pub fn enumerated(names: &[String]) -> String {
    match names {
        [] => String::new(),
        [one] => one.clone(),
        [others @ .., last] => format!("{} and {last}", others.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_hang_behind_their_lead_and_fit() {
        let layout = Layout {
            width: Some(1),
            colours: false,
        };
        let words = "twelve letters ".repeat(10);
        let text = layout.paragraph("  contact  ", Style::new(), &words);
        let lines: Vec<&str> = text.lines().collect();
        assert!(lines.len() > 1 && lines.iter().all(|line| line.chars().count() <= LEAST_WIDTH));
        assert!(lines[1].starts_with("           letters"), "{text}");
        let wide = Layout::default().paragraph("  contact  ", bold(), &words);
        assert_eq!(wide.lines().count(), 1);
        assert!(!wide.contains('\u{1b}'));
    }

    #[test]
    fn clauses_become_sentences() {
        assert_eq!(sentence("the wall falls"), "The wall falls.");
        assert_eq!(sentence("λ = 0.5"), "λ = 0.5.");
        assert_eq!(sentence("a1 moves first"), "a1 moves first.");
        assert_eq!(sentence(""), "");
    }

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
