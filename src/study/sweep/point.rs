//! One point of a sweep: a method on a wall, named by everything that determines the answer.

use super::fingerprint::Fingerprint;
use crate::method::{Method, Settings};
use crate::scene::Scene;

/// Fingerprint of the sources that this program was compiled from.
const SOURCES: &str = env!("TRILITH_SOURCES");

/// What a method is asked about.
pub struct Subject<'a> {
    /// Name of the case, with `@open` where head joints are open: the first column of the rows.
    pub case: String,
    /// What varies in the sweep, by name, in the order of the columns.
    pub parameters: Vec<(String, String)>,
    /// Number of blocks: long points are begun first. It decides nothing else.
    pub blocks: usize,
    /// Builds the scenes, one a direction of the push, when the point's turn comes: a plan holds no
    /// scene.
    pub sides: Box<dyn Fn() -> Vec<Scene> + Send + Sync + 'a>,
    /// Texts that determine these scenes, and the method beyond its name and settings: the text of
    /// a case, a command with its version.
    pub determined_by: Vec<String>,
}

/// One point of a sweep.
pub struct Point<'a> {
    subject: Subject<'a>,
    method: Box<dyn Method + Send + 'a>,
    settings: Settings,
    id: String,
}

impl<'a> Point<'a> {
    /// A point. Its id is the fingerprint of everything in it, and of the program's sources.
    pub fn new(subject: Subject<'a>, method: impl Method + Send + 'a, settings: Settings) -> Self {
        let mut id = Fingerprint::new();
        let mut add = |text: &str| id.add(text.as_bytes());
        add(SOURCES);
        add(&subject.case);
        for (name, value) in &subject.parameters {
            add(name);
            add(value);
        }
        add(method.name());
        // Every field with its name; what it looks like can only change with the sources.
        add(&format!("{settings:?}"));
        subject.determined_by.iter().for_each(|text| add(text));
        Self {
            id: id.hex(),
            method: Box::new(method),
            subject,
            settings,
        }
    }

    /// 32 hexadecimal digits, the same on every machine.
    pub fn id(&self) -> &str {
        &self.id
    }

    /// First column of the row.
    pub fn case(&self) -> &str {
        &self.subject.case
    }

    /// What varies in the sweep, by name.
    pub fn parameters(&self) -> &[(String, String)] {
        &self.subject.parameters
    }

    /// The method.
    pub fn method(&self) -> &dyn Method {
        &*self.method
    }

    /// The method's settings.
    pub fn settings(&self) -> Settings {
        self.settings
    }

    /// The scenes, one a direction of the push.
    pub fn sides(&self) -> Vec<Scene> {
        (self.subject.sides)()
    }

    /// What the point is, for people: case, method and parameters.
    pub fn describe(&self) -> String {
        let mut text = format!("{} {}", self.subject.case, self.method.name());
        for (name, value) in &self.subject.parameters {
            text.push_str(&format!(" {name}={value}"));
        }
        text
    }

    /// CPU seconds that the point may take, roughly: long ones are begun first, and the time left
    /// is told by it. Measured on the paper's walls; a method unknown here counts as long.
    pub fn expected_seconds(&self) -> f64 {
        let (of_33_blocks, growth) = match self.method.name() {
            "macro-block" => (1e-5, 0.0),
            "associative" => (2e-3, 1.6),
            "sequential" => (4e-2, 1.6),
            "interval" | "auto" => (4e-2, 1.8),
            _ => (0.5, 1.4),
        };
        of_33_blocks * (self.subject.blocks.max(1) as f64 / 33.0).powf(growth)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::method::METHODS;

    fn point(case: &str, parameter: &str, method: usize, starts: usize, text: &str) -> String {
        let subject = Subject {
            case: case.into(),
            parameters: vec![("friction".into(), parameter.into())],
            blocks: 1,
            sides: Box::new(Vec::new),
            determined_by: vec![text.into()],
        };
        let mut settings = Settings::default();
        settings.interval.starts = starts;
        Point::new(subject, METHODS[method], settings).id().into()
    }

    #[test]
    fn the_id_tells_whatever_determines_the_answer() {
        let mut ids = vec![
            point("a", "0.5", 0, 2, "x"),
            point("b", "0.5", 0, 2, "x"),
            point("a", "0.6", 0, 2, "x"),
            point("a", "0.5", 1, 2, "x"),
            point("a", "0.5", 0, 3, "x"),
            point("a", "0.5", 0, 2, "y"),
        ];
        assert_eq!(ids[0], point("a", "0.5", 0, 2, "x"));
        ids.sort();
        ids.dedup();
        assert_eq!(ids.len(), 6);
    }
}
