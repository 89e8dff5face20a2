//! What a user may change about the methods.
//!
//! A new setting is one entry in the table below, and the line of the method that reads its field.
//! From the entry follow its flag, `[settings]` and `settings.NAME` in sweeps, the help, the refusals
//! with what is allowed, and what a report prints.

mod choice;
mod error;
#[macro_use]
mod settings_macro;
mod value;

use std::sync::LazyLock;

pub use choice::{Accuracy, Collapse, Engine};
pub use error::SettingError;
pub use value::Allowed;
use value::SettingValue;

/// Relative tolerance of all linear programs, unless a user asks for another. 1e-8 leaves 9e-8 of λ
/// on a wall of 915 blocks, 1e-10 less than 1e-9, for a fifth more iterations.
pub(crate) const LP_TOLERANCE: f64 = 1e-10;

settings! {
    /// Settings of the interval.
    interval: IntervalSettings {
        /// How many starts the search of `interval` and `auto` makes; more may find lower states. With 0 it
        /// makes as many as a number of linear programs allows, which depends on the scene.
        starts: usize = 0, Allowed::Whole(0..=10_000), "";
    }

    /// Settings of the pushover.
    pushover: PushoverSettings {
        /// How accurate λ of the pushover is meant to be; the error that it states is measured on the scene.
        accuracy: Accuracy = Accuracy::Normal, Allowed::Words(Accuracy::WORDS), "";
        /// Repeat each pushover with half the substep, mirrored and without damping; all must agree.
        verify: bool = false, Allowed::Switch, "";
        /// What the pushover takes for the collapse.
        collapse: Collapse = Collapse::Runaway, Allowed::Words(Collapse::WORDS), "";
        /// Run the pushovers of a range, which walls with head joints in contact need, also where they take
        /// long.
        long_ranges: bool = false, Allowed::Switch, "";
        /// Keep in the JSON how the blocks move after the collapse of each pushover, until one is a course
        /// height away.
        recording: bool = false, Allowed::Switch, "";
        /// Factor on the pushover's substep; above 1 its answer is an estimate.
        substep: f64 = 1.0, Allowed::Number(1.0 / 64.0..=64.0), "times what the accuracy needs";
        /// Factor on the pushover's contact stiffness; below 1 its answer is an estimate, above 1
        /// the substep does not resolve the contacts.
        stiffness: f64 = 1.0, Allowed::Number(1e-6..=64.0), "times what the substep allows";
    }

    /// Settings of the linear programs.
    programs: ProgramSettings {
        /// Relative tolerance of the linear programs of `associative` and `sequential`.
        lp_tolerance: f64 = LP_TOLERANCE, Allowed::Number(1e-14..=0.1), "of λ";
        /// Whether the limit analyses first try the part of a wall that the crack can reach.
        reduction: bool = true, Allowed::Switch, "";
        /// Which solver solves the linear programs of the limit analyses.
        engine: Engine = Engine::Structured, Allowed::Words(Engine::WORDS), "";
    }

    /// Settings of the sequential method; those who use it differ in them.
    sequential: SequentialSettings {
        /// α of the sequential method's first step: how contractant the substitute law is.
        alpha: f64 = 0.3, Allowed::Number(1e-4..=1.0), "of the friction coefficient";
        /// β of the sequential method: the share of the new normal forces in each step.
        beta: f64 = 0.6, Allowed::Number(0.01..=1.0), "";
        // 1e-5, as published, lifts λ on a wall of 48 courses 0.04 % above λ_A; the bias is in
        // proportion, and down to 1e-7 no more sub-programs become infeasible (measured).
        /// c0 of the sequential method: the shear that every joint carries without any pressure.
        c0: f64 = 1e-6, Allowed::Number(0.0..=0.1), "of the largest normal force";
    }

    /// Settings of the lower bound.
    bound: BoundSettings {
        /// Relative distance between the lower bound and the lowest state at which the proof may end.
        bound_gap: f64 = 1e-4, Allowed::Number(0.0..=1.0), "of λ";
        /// How many lifted programs a lower bound may take.
        lifts: usize = 64, Allowed::Whole(1..=10_000), "";
        /// How many interior-point steps all these programs may take.
        lift_steps: usize = 1_000, Allowed::Whole(1..=1_000_000), "";
        /// How much arithmetic all these programs may take, beyond that of 120 steps.
        lift_work: f64 = 600.0, Allowed::Number(0.0..=1e9), "1e9 products of numbers";
        /// How many unknowns a lifted program may have; its time and memory grow with their square.
        lift_unknowns: usize = 16_000, Allowed::Whole(1..=100_000), "";
        /// Where rounding limits the motions that a lower bound is about: how large the sum of their openings
        /// and slips may be, over the displacement of the push.
        lift_cap: f64 = 1e4, Allowed::Number(1.0..=1e12), "";
    }

    /// Settings of the method that picks among the others.
    auto: AutoSettings {
        /// Width of the range, relative to λ, up to which `auto` calls the multiplier unique.
        tolerance: f64 = 0.01, Allowed::Number(1e-6..=1.0), "of λ";
    }
}

/// One setting: everything that stands about it in the table.
#[derive(Debug)]
pub struct Setting {
    /// Its name on the command line, in sweeps and in what is printed.
    pub name: &'static str,
    /// What it means, as a sentence without its full stop.
    pub meaning: &'static str,
    /// What a number of it is a part or a multiple of; empty for words and counts.
    pub unit: &'static str,
    /// What it may be.
    pub allowed: Allowed,
    written: fn(&Settings) -> String,
    read: fn(&mut Settings, &str) -> Option<()>,
}

impl Setting {
    /// Every setting, in the order of the table.
    pub fn all() -> &'static [Setting] {
        &ALL
    }

    /// The value that it has in some settings, as it is written to set it.
    pub fn of(&self, settings: &Settings) -> String {
        (self.written)(settings)
    }

    fn named(name: &str) -> Result<&'static Setting, SettingError> {
        let found = Setting::all().iter().find(|setting| setting.name == name);
        found.ok_or_else(|| {
            let known: Vec<&str> = Setting::all().iter().map(|setting| setting.name).collect();
            let misspelt = known
                .iter()
                .map(|&near| (strsim::osa_distance(name, near), near))
                .filter(|&(letters, near)| letters <= near.len() / 3)
                .min();
            SettingError::Unknown {
                name: name.to_owned(),
                nearest: misspelt.map(|(_, near)| near),
                known,
            }
        })
    }
}

impl Settings {
    /// Sets one by its name. A refused value changes nothing.
    ///
    /// # Errors
    /// The name is none, or the value is not allowed.
    pub fn set(&mut self, name: &str, value: &str) -> Result<(), SettingError> {
        let setting = Setting::named(name)?;
        let allowed = setting.allowed.holds(value);
        let done = allowed.then(|| (setting.read)(self, value)).flatten();
        done.ok_or_else(|| SettingError::Value {
            name: setting.name,
            value: value.to_owned(),
            allowed: setting.allowed.clone(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_setting_can_be_written_and_read_back() {
        let defaults = Settings::default();
        for setting in Setting::all() {
            let mut settings = defaults;
            let text = setting.of(&defaults);
            assert_eq!(settings.set(setting.name, &text), Ok(()), "{text}");
            assert_eq!(settings, defaults, "{}", setting.name);
            assert!(setting.meaning.len() > 10 && !setting.name.contains('_'));
        }
    }

    #[test]
    fn settings_can_be_set_by_name() {
        let mut settings = Settings::default();
        let values = [
            "starts=7",
            "accuracy=fine",
            "verify=true",
            "lp-tolerance=1e-6",
            "c0=0",
        ];
        for (name, value) in values.iter().filter_map(|set| set.split_once('=')) {
            settings.set(name, value).unwrap();
        }
        let mut expected = Settings::default();
        expected.interval.starts = 7;
        expected.pushover.accuracy = Accuracy::Fine;
        expected.pushover.verify = true;
        expected.programs.lp_tolerance = 1e-6;
        expected.sequential.c0 = 0.0;
        assert_eq!(settings, expected);
    }

    #[test]
    fn what_is_refused_says_what_to_write_and_changes_nothing() {
        let mut settings = Settings::default();
        let cases = "
            starts=10001       | `starts` is `10001`       | write a whole number from 0 to 10000
            starts=x           | `starts` is `x`           | write a whole number from 0 to 10000
            accuracy=exact     | `accuracy` is `exact`     | write one of coarse, normal, fine
            verify=yes         | `verify` is `yes`         | write one of false, true
            lp-tolerance=nan   | `lp-tolerance` is `nan`   | write a number from 1e-14 to 0.1
            tolerance=-1       | `tolerance` is `-1`       | write a number from 0.000001 to 1
            speed=1            | there is no setting `speed` | settings are starts,
            lp_tolerance=1     | no setting `lp_tolerance` | did you mean `lp-tolerance`?
            strats=1           | no setting `strats`       | did you mean `starts`? settings are ";
        for case in cases.trim().lines() {
            let parts: Vec<&str> = case.split('|').map(str::trim).collect();
            let (name, value) = parts[0].split_once('=').unwrap();
            let error = settings.set(name, value).unwrap_err();
            assert!(error.to_string().contains(parts[1]), "{error}");
            assert!(error.advice().starts_with(parts[2]), "{}", error.advice());
        }
        assert_eq!(settings, Settings::default());
    }
}
