//! Texts of a case, made fit for a terminal.

/// A text on one line, in which what would steer a terminal is shown instead of sent: control
/// characters as Rust writes them, `\u{1b}`, and so what turns the direction of writing. Ends of
/// lines and tabs become spaces.
pub(crate) fn printable(text: &str) -> String {
    let steers =
        |c: char| c.is_control() || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let mut shown = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\n' | '\r' | '\t' => shown.push(' '),
            c if steers(c) => shown.extend(c.escape_unicode()),
            c => shown.push(c),
        }
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::printable;

    #[test]
    fn what_steers_a_terminal_is_shown() {
        assert_eq!(printable("a\u{1b}[31mb\u{9b}"), "a\\u{1b}[31mb\\u{9b}");
        assert_eq!(printable("\u{202e}lla"), "\\u{202e}lla");
        assert_eq!(printable("two\nlines λ"), "two lines λ");
    }
}
