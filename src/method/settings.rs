//! What a user may change about the methods.

/// What a user may change about the methods; the defaults are what tables show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Settings {
    /// Starts of the interval's search.
    pub starts: usize,
    /// Error that the pushover may state.
    pub accuracy: Accuracy,
    /// Whether the pushover repeats itself with half the substep, mirrored and without kinetic
    /// damping, and gives no number where that changes it.
    pub verify: bool,
    /// What the pushover calls collapse.
    pub collapse: Collapse,
    /// Whether the pushover keeps how the blocks moved in the collapse.
    pub recording: bool,
    /// Whether the pushover varies head joints in contact on walls of any number of blocks.
    pub long_ranges: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            starts: 2,
            accuracy: Accuracy::Normal,
            verify: false,
            collapse: Collapse::Runaway,
            recording: false,
            long_ranges: false,
        }
    }
}

impl Settings {
    /// Names of the settings, as on the command line and in sweeps.
    pub const NAMES: [&str; 5] = ["starts", "accuracy", "verify", "collapse", "long-ranges"];

    /// Sets one by its name.
    ///
    /// # Errors
    /// In words, what is wrong with the name or the value and what to write instead.
    pub fn set(&mut self, name: &str, value: &str) -> Result<(), String> {
        match name {
            "starts" => self.starts = whole(name, value)?,
            "accuracy" => self.accuracy = choose(name, value, &Accuracy::NAMES)?,
            "verify" => self.verify = choose(name, value, &SWITCH)?,
            "collapse" => self.collapse = choose(name, value, &Collapse::NAMES)?,
            "long-ranges" => self.long_ranges = choose(name, value, &SWITCH)?,
            _ => {
                let names = Self::NAMES.join(", ");
                return Err(format!(
                    "there is no setting `{name}`; settings are {names}"
                ));
            }
        }
        Ok(())
    }
}

const SWITCH: [(&str, bool); 2] = [("false", false), ("true", true)];

/// Most starts of one search.
const MOST_STARTS: usize = 10_000;

fn whole(name: &str, value: &str) -> Result<usize, String> {
    let number = value.parse().unwrap_or(0);
    match (1..=MOST_STARTS).contains(&number) {
        true => Ok(number),
        false => Err(format!(
            "`{name}` is `{value}`; write a whole number from 1 to {MOST_STARTS}"
        )),
    }
}

fn choose<T: Copy>(name: &str, value: &str, known: &[(&str, T)]) -> Result<T, String> {
    let found = known.iter().find(|(word, _)| *word == value);
    found.map(|(_, choice)| *choice).ok_or_else(|| {
        let words: Vec<&str> = known.iter().map(|(word, _)| *word).collect();
        format!("`{name}` is `{value}`; write one of {}", words.join(", "))
    })
}

/// How accurate the pushover has to be; everything else about it follows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Accuracy {
    /// 1 %; 2 % above 30 courses.
    Coarse,
    /// 0.2 %; 0.4 % above 30 courses.
    #[default]
    Normal,
    /// 0.05 %; 0.2 % above 30 courses.
    Fine,
}

impl Accuracy {
    /// Every level by its name.
    pub const NAMES: [(&str, Accuracy); 3] = [
        ("coarse", Accuracy::Coarse),
        ("normal", Accuracy::Normal),
        ("fine", Accuracy::Fine),
    ];

    /// The error that a bracket states, relative to λ: of either end against the limit.
    pub fn stated_error(self, courses: f64) -> f64 {
        let tall = courses > 30.0;
        match self {
            Accuracy::Coarse if tall => 2e-2,
            Accuracy::Coarse => 1e-2,
            Accuracy::Normal if tall => 4e-3,
            Accuracy::Normal => 2e-3,
            Accuracy::Fine if tall => 2e-3,
            Accuracy::Fine => 5e-4,
        }
    }
}

/// What a pushover calls collapse.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Collapse {
    /// Blocks run away and do not slow down.
    #[default]
    Runaway,
    /// A joint has slipped by a thousandth of the course height, though it may come to rest.
    FirstSlip,
}

impl Collapse {
    /// Every definition by its name.
    pub const NAMES: [(&str, Collapse); 2] = [
        ("runaway", Collapse::Runaway),
        ("first-slip", Collapse::FirstSlip),
    ];
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_can_be_set_by_name() {
        let mut settings = Settings::default();
        let given = [
            ("starts", "7"),
            ("accuracy", "fine"),
            ("verify", "true"),
            ("collapse", "first-slip"),
            ("long-ranges", "true"),
        ];
        assert_eq!(given.map(|(name, _)| name), Settings::NAMES);
        for (name, value) in given {
            settings.set(name, value).unwrap();
        }
        let expected = Settings {
            starts: 7,
            accuracy: Accuracy::Fine,
            verify: true,
            collapse: Collapse::FirstSlip,
            recording: false,
            long_ranges: true,
        };
        assert_eq!(settings, expected);
        for (name, value) in [("starts", "0"), ("accuracy", "exact"), ("speed", "1")] {
            let text = settings.set(name, value).unwrap_err();
            assert!(text.contains(name), "{text}");
        }
        assert_eq!(settings, expected, "a refused value changes nothing");
    }
}
