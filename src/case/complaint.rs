//! Complaints about input, in rustc's look: file, line, the offending text, what to write instead.

use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet, normalize_untrusted_str};

/// What is wrong with the input, where, and what to write instead.
#[derive(Clone, Debug, PartialEq)]
pub struct Complaint {
    title: String,
    /// The offending text, and the label below it.
    marked: Option<Box<(Mark, String)>>,
    help: Option<String>,
    /// What may stand where in the text so that the rest of it can be read.
    mend: Option<Box<(Range<usize>, String)>>,
    /// Further mistakes of the same file.
    others: Vec<Complaint>,
    /// Whether the input is taken all the same.
    warns: bool,
}

/// Which text is offending.
#[derive(Clone, Debug, PartialEq)]
enum Mark {
    /// That of a file.
    Place(Place),
    /// That of the file which is being read: [`Complaint::in_document`] says which it is.
    Span(Range<usize>),
}

/// A part of a file's text, within one line.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Place {
    document: Document,
    span: Range<usize>,
}

/// A file's path, as the user wrote it, and its text.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Document {
    pub path: String,
    pub text: Arc<str>,
}

/// Longest title and help line; a value of any length can stand in them.
const LONGEST: usize = 400;

/// Columns that a line of a file is cut to, with the offending part inside.
const SOURCE_WIDTH: usize = 80;

impl Complaint {
    /// A complaint that no text can be shown for.
    pub(crate) fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            marked: None,
            help: None,
            mend: None,
            others: Vec::new(),
            warns: false,
        }
    }

    /// A complaint about a text of the file that is being read, with a label below it.
    pub(crate) fn at(
        span: Range<usize>,
        title: impl Into<String>,
        label: impl Into<String>,
    ) -> Self {
        Self {
            marked: Some(Box::new((Mark::Span(span), label.into()))),
            ..Self::new(title)
        }
    }

    /// The same about the text of this file, where nobody has said of which.
    pub(crate) fn in_document(mut self, document: &Document) -> Self {
        if let Some(marked) = self.marked.as_deref_mut()
            && let (Mark::Span(span), _) = marked
        {
            marked.0 = Mark::Place(Place::new(document, span.clone()));
        }
        self
    }

    /// The same as a warning: the input is taken all the same.
    pub(crate) fn into_warning(mut self) -> Self {
        self.warns = true;
        self
    }

    /// Adds what to write instead.
    pub(crate) fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The same with what may be put into a place of the text so that the rest of it can be read; nothing
    /// where the key has to go.
    pub(crate) fn mended(mut self, place: Range<usize>, words: impl Into<String>) -> Self {
        self.mend = Some(Box::new((place, words.into())));
        self
    }

    /// The place and the words; `None` where the rest cannot be read, or makes no sense without this.
    pub(crate) fn mend(&self) -> Option<(&Range<usize>, &str)> {
        let mend = self.mend.as_deref();
        mend.map(|(place, words)| (place, words.as_str()))
    }

    /// The place in this document, where it is about a text of it.
    pub(crate) fn place_in(&self, document: &Document) -> Option<Range<usize>> {
        match self.marked.as_deref()? {
            (Mark::Place(place), _) => (place.document == *document).then(|| place.span.clone()),
            (Mark::Span(span), _) => Some(span.clone()),
        }
    }

    /// The same about a text that stands elsewhere, in this document.
    pub(crate) fn moved_to(mut self, document: &Document, place: Range<usize>) -> Self {
        let from = self.place_in_any();
        if let Some(mend) = self.mend.as_deref_mut() {
            let shift = |at: usize| (at + place.start).saturating_sub(from);
            mend.0 = shift(mend.0.start)..shift(mend.0.end);
        }
        if let Some(marked) = self.marked.as_deref_mut() {
            marked.0 = Mark::Place(Place::new(document, place));
        }
        self
    }

    fn place_in_any(&self) -> usize {
        match self.marked.as_deref() {
            Some((Mark::Place(Place { span, .. }) | Mark::Span(span), _)) => span.start,
            None => 0,
        }
    }

    /// The same with other mistakes of the file behind it.
    pub(crate) fn with_others(mut self, others: Vec<Complaint>) -> Self {
        self.others = others;
        self
    }

    /// What to write instead; empty where nobody knows.
    pub(crate) fn advice(&self) -> &str {
        self.help.as_deref().unwrap_or_default()
    }

    /// What is wrong, in one line.
    pub(crate) fn title(&self) -> &str {
        &self.title
    }

    /// The file and the line (from 1), where the complaint is about a text.
    pub fn line(&self) -> Option<(&str, usize)> {
        match self.marked.as_deref()? {
            (Mark::Place(place), _) => Some((&place.document.path, place.line())),
            (Mark::Span(_), _) => None,
        }
    }
}

/// As the terminal shows it, without a final newline.
impl fmt::Display for Complaint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let printable = |text: &str| normalize_untrusted_str(&shorten(text, LONGEST));
        let level = if self.warns {
            Level::WARNING
        } else {
            Level::ERROR
        };
        let mut report = Group::with_title(level.primary_title(printable(&self.title)));
        if let Some((Mark::Place(place), label)) = self.marked.as_deref() {
            let mark = AnnotationKind::Primary
                .span(place.span.clone())
                .label(printable(label));
            report = report.element(
                Snippet::source(&*place.document.text)
                    .path(printable(&place.document.path))
                    .annotation(mark),
            );
        }
        if let Some(help) = &self.help {
            report = report.element(Level::HELP.message(printable(help)));
        }
        f.write_str(&Renderer::plain().term_width(SOURCE_WIDTH).render(&[report]))?;
        self.others
            .iter()
            .try_for_each(|other| write!(f, "\n\n{other}"))
    }
}

impl std::error::Error for Complaint {}

impl Document {
    /// The text of a file.
    ///
    /// # Errors
    /// Where it stops being UTF-8.
    pub fn read(path: &str, bytes: &[u8]) -> Result<Self, Complaint> {
        match std::str::from_utf8(bytes) {
            Ok(text) => Ok(Self {
                path: path.to_owned(),
                text: text.into(),
            }),
            Err(error) => Err(not_text(path, bytes, error)),
        }
    }

    /// A complaint about the text in `span`, of which at most the first line is marked.
    pub fn complain(
        &self,
        span: Range<usize>,
        title: impl Into<String>,
        label: impl Into<String>,
    ) -> Complaint {
        Place::new(self, span).complain(title, label)
    }

    /// The text in `span`; empty where the span is not one of this text.
    pub fn at(&self, span: Range<usize>) -> &str {
        self.text.get(span).unwrap_or_default()
    }
}

impl Place {
    /// The text in `span`, of which at most the first line counts.
    pub fn new(document: &Document, span: Range<usize>) -> Self {
        let text = &document.text;
        let start = floor_boundary(text, span.start);
        let end = floor_boundary(text, span.end).max(start);
        let line = text[start..end].split(['\n', '\r']).next();
        Self {
            document: document.clone(),
            span: start..start + line.map_or(0, str::len),
        }
    }

    /// A complaint about this text, with a label below it.
    pub fn complain(&self, title: impl Into<String>, label: impl Into<String>) -> Complaint {
        Complaint {
            marked: Some(Box::new((Mark::Place(self.clone()), label.into()))),
            ..Complaint::new(title)
        }
    }

    /// The line, from 1.
    pub fn line(&self) -> usize {
        let before = &self.document.text.as_bytes()[..self.span.start];
        1 + before.iter().filter(|&&byte| byte == b'\n').count()
    }

    /// File and line, to speak of this place in a complaint about another.
    pub fn path_and_line(&self) -> String {
        format!("{}:{}", self.document.path, self.line())
    }
}

/// Bytes that are no text: shows the line where it stops being UTF-8.
fn not_text(path: &str, bytes: &[u8], error: std::str::Utf8Error) -> Complaint {
    let good = error.valid_up_to();
    let before = &bytes[..good];
    let line = 1 + before.iter().filter(|&&byte| byte == b'\n').count();
    let column = before
        .iter()
        .rev()
        .take_while(|&&byte| byte != b'\n')
        .count();
    // All before the first bad byte is copied as it is, so its place stays the same.
    let document = Document {
        path: path.to_owned(),
        text: String::from_utf8_lossy(bytes).into(),
    };
    let byte = bytes.get(good).copied().unwrap_or_default();
    let column = column + 1;
    let title = format!("not UTF-8 text: line {line}, byte {column} is {byte:#04x}");
    document
        .complain(good..good + '\u{fffd}'.len_utf8(), title, "from here on")
        .help("save the file as UTF-8")
}

/// The last character boundary at or before `index`.
fn floor_boundary(text: &str, index: usize) -> usize {
    let index = index.min(text.len());
    (0..=index)
        .rev()
        .find(|&i| text.is_char_boundary(i))
        .unwrap_or(0)
}

/// The first `longest` characters of a text, with an ellipsis where some are left out.
pub(crate) fn shorten(text: &str, longest: usize) -> String {
    match text.char_indices().nth(longest) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_complaint_looks_like_the_compilers() {
        let document = Document {
            path: "walls/a.toml".into(),
            text: "title = \"a\"\nfrction = 0.65\n".into(),
        };
        let complaint = document
            .complain(12..19, "unknown key `frction`", "no such key")
            .help("write `friction`");
        let expected = "\
error: unknown key `frction`
 --> walls/a.toml:2:1
  |
2 | frction = 0.65
  | ^^^^^^^ no such key
  |
  = help: write `friction`";
        assert_eq!(complaint.to_string(), expected);
        assert_eq!(complaint.line(), Some(("walls/a.toml", 2)));
    }

    #[test]
    fn a_span_outside_the_text_or_inside_a_letter_is_harmless() {
        let document = Document {
            path: "a.toml".into(),
            text: "é\n".into(),
        };
        for span in [0..1, 1..2, 1..9, 7..9, 3..3, Range { start: 2, end: 1 }] {
            let shown = document.complain(span, "title", "label").to_string();
            assert!(shown.contains("a.toml:"), "{shown}");
        }
    }
}
