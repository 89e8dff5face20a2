//! A sweep that is given on the command line: a case, and what varies in it.

use std::fmt::Write;

use super::plan::{Sweep, stem};
use crate::case::{Complaint, plain, quoted};

/// How values are given, for help lines.
const FORMS: &str = "write `KEY=FROM:TO:COUNT`, as in `friction=0.4:0.8:5`, or `KEY=VALUE,VALUE`, as in \
                     `friction=0.4,0.65`";

impl Sweep {
    /// The sweep of a case in which keys run through values: `KEY=FROM:TO:COUNT` or `KEY=VALUE,VALUE`.
    /// Several keys make a grid. `head_joints=open` says which head joints run, for all points. Without
    /// `methods` all run.
    ///
    /// # Errors
    /// What is wrong with the case, a key or its values.
    pub fn of_case(case: &str, vary: &[String], methods: &[String]) -> Result<Self, Complaint> {
        let mut text = format!("case = {}\n", quoted(case));
        if !methods.is_empty() {
            let names: Vec<String> = methods.iter().map(|name| quoted(name)).collect();
            let _ = writeln!(text, "methods = [{}]", names.join(", "));
        }
        let case = if case == "-" { "stdin" } else { stem(case) };
        let mut name = plain(case);
        for one in vary {
            let refused = || Complaint::new(format!("--vary {one}")).help(FORMS);
            let (key, values) = one.split_once('=').ok_or_else(refused)?;
            let key = key.trim();
            if key == "head_joints" {
                text.insert_str(0, &format!("head_joints = {}\n", quoted(values.trim())));
                continue;
            }
            let values = range_or_list(values).ok_or_else(refused)?;
            let _ = writeln!(text, "[[vary]]\n{} = {values}", quoted(key));
            let _ = write!(name, "-{}", plain(key));
        }
        Self::named(name, "--vary", text.as_bytes())
    }
}

/// Values in the form of a sweep file; `None` where they are in none.
fn range_or_list(values: &str) -> Option<String> {
    let number = |text: &str| {
        let text = text.trim();
        text.parse()
            .ok()
            .filter(|of: &f64| of.is_finite())
            .map(|of| {
                // A whole number stays one, as for a number of courses.
                text.parse()
                    .map_or(format!("{of:?}"), |whole: i64| whole.to_string())
            })
    };
    if let [from, to, count] = values.split(':').collect::<Vec<_>>()[..] {
        let [from, to, count] = [number(from)?, number(to)?, number(count)?];
        return Some(format!("{{ from = {from}, to = {to}, count = {count} }}"));
    }
    let words = |word: &str| number(word).unwrap_or_else(|| quoted(word.trim()));
    let list: Vec<String> = values.split(',').map(words).collect();
    let is_sound = !values.contains(':') && values.split(',').all(|word| !word.trim().is_empty());
    is_sound.then(|| format!("[{}]", list.join(", ")))
}
