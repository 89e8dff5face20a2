//! What a user may change about the methods.

/// What a user may change about the methods; the defaults are what tables show.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Starts of the interval's search, and of that of `auto`.
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
    /// Relative tolerance of the linear programs of `associative` and `sequential`.
    pub lp_tolerance: f64,
    /// Whether those programs are scaled: total weight and height to 1.
    pub scaling: bool,
    /// Whether the limit analyses first try the part of a wall that the crack can reach.
    pub reduction: bool,
    /// α of the sequential method's first step.
    pub alpha: f64,
    /// β of the sequential method: share of the new normal forces.
    pub beta: f64,
    /// c0 of the sequential method over the largest normal force.
    pub c0: f64,
    /// Factor on the pushover's substep. Above 1 its answer is an estimate.
    pub substep: f64,
    /// Factor on the pushover's contact stiffness. Below 1 its answer is an estimate; above 1 the
    /// substep does not resolve the contacts.
    pub stiffness: f64,
    /// Relative width up to which `auto` has an answer.
    pub tolerance: f64,
    /// Whether `auto` runs a pushover beside an answer that is not unique.
    pub beside: bool,
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
            lp_tolerance: super::limit::TOLERANCE,
            scaling: true,
            reduction: true,
            alpha: 0.3,
            beta: 0.6,
            c0: 1e-6,
            substep: 1.0,
            stiffness: 1.0,
            tolerance: 0.01,
            beside: false,
        }
    }
}

impl Settings {
    /// Names of the settings, as on the command line and in sweeps.
    pub const NAMES: [&str; 15] = [
        "starts",
        "accuracy",
        "verify",
        "collapse",
        "long-ranges",
        "lp-tolerance",
        "scaling",
        "reduction",
        "alpha",
        "beta",
        "c0",
        "substep",
        "stiffness",
        "tolerance",
        "beside",
    ];

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
            "lp-tolerance" => self.lp_tolerance = number(name, value, [1e-14, 0.1])?,
            "scaling" => self.scaling = choose(name, value, &SWITCH)?,
            "reduction" => self.reduction = choose(name, value, &SWITCH)?,
            "alpha" => self.alpha = number(name, value, [1e-4, 1.0])?,
            "beta" => self.beta = number(name, value, [0.01, 1.0])?,
            "c0" => self.c0 = number(name, value, [0.0, 0.1])?,
            "substep" => self.substep = number(name, value, [1.0 / 64.0, 64.0])?,
            "stiffness" => self.stiffness = number(name, value, [1e-6, 64.0])?,
            "tolerance" => self.tolerance = number(name, value, [1e-6, 1.0])?,
            "beside" => self.beside = choose(name, value, &SWITCH)?,
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

fn number(name: &str, value: &str, [least, most]: [f64; 2]) -> Result<f64, String> {
    let parsed = value.parse::<f64>();
    let number = parsed.ok().filter(|number| (least..=most).contains(number));
    number.ok_or_else(|| format!("`{name}` is `{value}`; write a number from {least} to {most}"))
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
            ("lp-tolerance", "1e-6"),
            ("scaling", "false"),
            ("reduction", "false"),
            ("alpha", "0.1"),
            ("beta", "0.5"),
            ("c0", "1e-5"),
            ("substep", "2"),
            ("stiffness", "0.5"),
            ("tolerance", "0.02"),
            ("beside", "true"),
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
            lp_tolerance: 1e-6,
            scaling: false,
            reduction: false,
            alpha: 0.1,
            beta: 0.5,
            c0: 1e-5,
            substep: 2.0,
            stiffness: 0.5,
            tolerance: 0.02,
            beside: true,
        };
        assert_eq!(settings, expected);
        let wrong = [
            ("starts", "0"),
            ("accuracy", "exact"),
            ("speed", "1"),
            ("lp-tolerance", "nan"),
            ("tolerance", "-1"),
        ];
        for (name, value) in wrong {
            let text = settings.set(name, value).unwrap_err();
            assert!(text.contains(name), "{text}");
        }
        assert_eq!(settings, expected, "a refused value changes nothing");
    }
}
