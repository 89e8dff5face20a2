//! Tables that fit a screen: columns that do not fit are left out, the least wanted ones first.

use anstyle::Style;

use super::layout::{Layout, bold, lines};

#[derive(Clone, Copy)]
pub struct GridColumn {
    pub heading: &'static str,
    /// 0: it is always there; else it is left out the sooner the larger this is.
    pub spare: usize,
    /// Whether its cells end where it ends, as numbers do.
    pub right: bool,
    /// What a cell looks like.
    pub style: fn(&str) -> Style,
}

fn plain(_: &str) -> Style {
    Style::new()
}

pub const fn words(heading: &'static str) -> GridColumn {
    GridColumn {
        heading,
        spare: 0,
        right: false,
        style: plain,
    }
}

/// A column of numbers that is always there.
pub const fn numbers(heading: &'static str) -> GridColumn {
    GridColumn {
        right: true,
        ..words(heading)
    }
}

impl GridColumn {
    /// The same, to be left out where there is no room.
    pub const fn spare(self, spare: usize) -> Self {
        Self { spare, ..self }
    }

    /// The same below other words.
    pub const fn headed(self, heading: &'static str) -> Self {
        Self { heading, ..self }
    }

    /// The same with coloured cells.
    pub const fn styled(self, style: fn(&str) -> Style) -> Self {
        Self { style, ..self }
    }
}

const GAP: usize = 2;

fn length(text: &str) -> usize {
    text.chars().count()
}

/// A line of headings and one a row, each ended. What is too long for the width even so is wrapped in the
/// last column, and cut, with an ellipsis, in any other.
pub fn grid(layout: Layout, indent: usize, columns: &[GridColumn], rows: &[Vec<String>]) -> String {
    let widths = columns.iter().enumerate().map(|(at, column)| {
        let cells = rows.iter().map(|row| length(&row[at]));
        cells.max().unwrap_or(0).max(length(column.heading))
    });
    let mut widths: Vec<usize> = widths.collect();
    let shown = fitting(layout, indent, columns, &mut widths);
    let last = shown.last().copied().unwrap_or(0);
    let line = |cells: &dyn Fn(usize) -> (String, Style)| {
        let mut text = " ".repeat(indent);
        // Columns in front of the cell: what is painted is longer than it looks.
        let mut column = indent;
        for &at in &shown {
            let (cell, style) = cells(at);
            let parts = if at == last && !columns[at].right {
                lines(&cell, widths[at])
            } else {
                vec![cut(&cell, widths[at])]
            };
            let mut parts = parts.into_iter();
            let first = parts.next().unwrap_or_default();
            let blanks = " ".repeat(widths[at].saturating_sub(length(&first)));
            if columns[at].right {
                text.push_str(&blanks);
            }
            text.push_str(&layout.painted(&first, style));
            if at != last {
                text.push_str(&" ".repeat(GAP));
                if !columns[at].right {
                    text.push_str(&blanks);
                }
            }
            for part in parts {
                text = format!("{}\n{}{part}", text.trim_end(), " ".repeat(column));
            }
            column += widths[at] + GAP;
        }
        text.trim_end().to_owned() + "\n"
    };
    let mut text = line(&|at| (columns[at].heading.to_owned(), bold()));
    for row in rows {
        text.push_str(&line(&|at| {
            (row[at].clone(), (columns[at].style)(&row[at]))
        }));
    }
    text
}

/// The columns that are shown; the widest is narrowed where those that must be there do not fit.
fn fitting(
    layout: Layout,
    indent: usize,
    columns: &[GridColumn],
    widths: &mut [usize],
) -> Vec<usize> {
    let Some(width) = layout.columns() else {
        return (0..columns.len()).collect();
    };
    let total = |shown: &[usize], widths: &[usize]| {
        let cells: usize = shown.iter().map(|&at| widths[at]).sum();
        indent + cells + GAP * shown.len().saturating_sub(1)
    };
    let needed = (0..columns.len()).filter(|&at| columns[at].spare == 0);
    let mut shown: Vec<usize> = needed.collect();
    let mut spare: Vec<usize> = (0..columns.len())
        .filter(|&at| columns[at].spare > 0)
        .collect();
    spare.sort_by_key(|&at| columns[at].spare);
    for at in spare {
        let with = [shown.as_slice(), &[at]].concat();
        if total(&with, widths) > width {
            break;
        }
        shown = with;
    }
    shown.sort_unstable();
    let over = total(&shown, widths).saturating_sub(width);
    if let Some(&widest) = shown
        .iter()
        .max_by_key(|&&at| widths[at])
        .filter(|_| over > 0)
    {
        widths[widest] = widths[widest].saturating_sub(over).max(1);
    }
    shown
}

/// The first letters of a text, and an ellipsis where some are left out.
fn cut(text: &str, width: usize) -> String {
    if length(text) <= width {
        return text.to_owned();
    }
    let kept: String = text.chars().take(width.saturating_sub(1)).collect();
    format!("{kept}…")
}

#[cfg(test)]
mod tests {
    use super::*;

    const COLUMNS: [GridColumn; 3] = [words("name"), words("note").spare(1), numbers("count")];

    fn row(name: &str, note: &str, count: &str) -> Vec<String> {
        [name, note, count].map(str::to_owned).to_vec()
    }

    fn shown(width: Option<usize>, rows: &[Vec<String>]) -> String {
        let layout = Layout {
            width,
            colours: false,
        };
        grid(layout, 2, &COLUMNS, rows)
    }

    #[test]
    fn columns_are_left_out_where_there_is_no_room() {
        let rows = [row("a", &"long ".repeat(15), "1"), row("bc", "", "12")];
        let narrow = shown(Some(80), &rows);
        assert_eq!(narrow, "  name  count\n  a         1\n  bc       12\n");
        let wide = shown(Some(120), &rows);
        assert!(wide.contains("long long") && wide.lines().all(|line| length(line) <= 120));
        assert_eq!(shown(None, &rows), wide);
    }

    #[test]
    fn the_last_column_is_wrapped() {
        let columns = [words("name"), words("title")];
        let rows = [vec!["a".to_owned(), "many words ".repeat(10)]];
        let layout = Layout {
            width: Some(80),
            colours: false,
        };
        let text = grid(layout, 2, &columns, &rows);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 3, "{text}");
        assert!(lines[2].starts_with("        many") || lines[2].starts_with("        words"));
        assert!(lines.iter().all(|line| length(line) <= 80));
    }

    #[test]
    fn what_is_too_long_is_cut() {
        let rows = [row(&"x".repeat(200), "", "7")];
        let text = shown(Some(80), &rows);
        assert!(
            text.contains("x…  ") && text.ends_with("      7\n"),
            "{text}"
        );
        assert!(text.lines().all(|line| length(line) <= 80));
    }
}
