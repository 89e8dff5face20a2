//! Settings of the methods as arguments, made from their table: every setting is a flag, and
//! `--set NAME=VALUE` is the same.

use crate::method::{Allowed, Setting, Settings};
use clap::builder::{PossibleValue, TypedValueParser};
use clap::error::ErrorKind;
use clap::{Arg, ArgAction, ArgMatches, Args, Command, Error, FromArgMatches};

use super::stop::Stop;

const HEADING: &str = "Settings of the methods, each also as --set NAME=VALUE";

/// The settings that the short help has.
const COMMON: [&str; 2] = ["accuracy", "starts"];

/// The settings that the arguments give. Given twice with two values is a mistake, in whichever
/// form.
pub(super) struct SettingArguments {
    given: Vec<Given>,
}

/// One setting as it was given.
struct Given {
    /// What was written, such as `--set starts=4`.
    written: String,
    /// Name and value; `None` without `=`.
    parts: Option<(String, String)>,
}

impl SettingArguments {
    pub(super) fn read(&self) -> Result<Settings, Stop> {
        let mut settings = Settings::default();
        let mut known: Vec<(&str, &str)> = Vec::new();
        for Given { written, parts } in &self.given {
            let refused = |why: String| Stop::bad_input(format!("error: {written}: {why}"));
            let Some((name, value)) = parts else {
                return Err(refused("write NAME=VALUE".to_owned()));
            };
            let before = settings;
            let set = settings.set(name, value);
            set.map_err(|error| refused(format!("{error}; {}", error.advice())))?;
            if let Some((_, other)) = known.iter().find(|(known, _)| known == name)
                && settings != before
            {
                return Err(refused(format!(
                    "{other} says otherwise; write one of the two"
                )));
            }
            known.push((name, written));
        }
        Ok(settings)
    }
}

impl Args for SettingArguments {
    fn augment_args(command: Command) -> Command {
        let set = Arg::new("set")
            .long("set")
            .value_name("NAME=VALUE")
            .action(ArgAction::Append)
            .help("Change a setting by its name")
            .help_heading(HEADING);
        command.args(Setting::all().iter().map(flag)).arg(set)
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for SettingArguments {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let mut given = Vec::new();
        for setting in Setting::all() {
            if let Some(value) = matches.get_one::<String>(setting.name) {
                given.push(Given {
                    written: format!("--{} {value}", setting.name),
                    parts: Some((setting.name.to_owned(), value.clone())),
                });
            }
        }
        for text in matches.get_many::<String>("set").into_iter().flatten() {
            let parts = text.split_once('=');
            given.push(Given {
                written: format!("--set {text}"),
                parts: parts.map(|(name, value)| (name.trim().into(), value.trim().into())),
            });
        }
        Ok(Self { given })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

fn flag(setting: &'static Setting) -> Arg {
    let default = setting.of(&Settings::default());
    let about = setting.meaning;
    let details = match &setting.allowed {
        Allowed::Switch | Allowed::Words(_) => default.clone(),
        allowed @ (Allowed::Whole(_) | Allowed::Number(_)) => match setting.unit {
            "" => format!("{default}; {allowed}"),
            unit => format!("{default} {unit}; {allowed}"),
        },
    };
    let flag = Arg::new(setting.name)
        .long(setting.name)
        .value_parser(WordsParser(&setting.allowed))
        .help(format!("{about} [default: {default}]"))
        .long_help(format!("{about} [default: {details}]"))
        .hide_short_help(!COMMON.contains(&setting.name))
        .help_heading(HEADING);
    match &setting.allowed {
        Allowed::Switch => flag
            .value_name("BOOL")
            .num_args(0..=1)
            .require_equals(true)
            .default_missing_value("true"),
        Allowed::Words(_) => flag.value_name("WORD"),
        Allowed::Whole(_) | Allowed::Number(_) => flag.value_name("NUMBER"),
    }
}

/// Shows the words of a choice in the help. It takes any text: the setting itself says what is
/// wrong with one, in the same words for a flag and for `--set`.
#[derive(Clone)]
struct WordsParser(&'static Allowed);

impl TypedValueParser for WordsParser {
    type Value = String;

    fn parse_ref(
        &self,
        command: &Command,
        _: Option<&Arg>,
        value: &std::ffi::OsStr,
    ) -> Result<String, Error> {
        let text = value.to_str().map(str::to_owned);
        text.ok_or_else(|| Error::new(ErrorKind::InvalidUtf8).with_cmd(command))
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        match self.0 {
            Allowed::Words(words) => Some(Box::new(words.iter().map(|(word, meaning)| {
                PossibleValue::new(*word).help(meaning.trim().trim_end_matches('.'))
            }))),
            Allowed::Switch | Allowed::Whole(_) | Allowed::Number(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(arguments: &[&str]) -> Result<Settings, String> {
        let command = SettingArguments::augment_args(Command::new("trilith"));
        command.clone().debug_assert();
        let matches = command.try_get_matches_from([&["trilith"], arguments].concat());
        let matches = matches.map_err(|error| error.to_string())?;
        let arguments = SettingArguments::from_arg_matches(&matches);
        arguments
            .map_err(|error| error.to_string())?
            .read()
            .map_err(|stop| stop.text)
    }

    #[test]
    fn a_flag_and_set_are_one() {
        for setting in Setting::all() {
            let default = setting.of(&Settings::default());
            let (flag, set) = (
                format!("--{}={default}", setting.name),
                format!("--set={}={default}", setting.name),
            );
            assert_eq!(read(&[&flag]), Ok(Settings::default()));
            assert_eq!(read(&[&flag, &set]), Ok(Settings::default()));
        }
        let flag = read(&["--accuracy", "fine", "--verify"]);
        assert_eq!(
            flag,
            read(&["--set", "accuracy=fine", "--set", "verify = true"])
        );
        assert!(flag.unwrap().pushover.verify);
        assert!(!read(&["--reduction=false"]).unwrap().programs.reduction);
    }

    #[test]
    fn both_refuse_in_the_same_words() {
        let range = "`starts` is `10001`; write a whole number from 0 to 10000";
        for arguments in [["--starts", "10001"], ["--set", "starts=10001"]] {
            let text = read(&arguments).unwrap_err();
            assert_eq!(text, format!("error: {}: {range}", arguments.join(" ")));
        }
        let twice = read(&["--starts", "4", "--set", "starts=8"]).unwrap_err();
        assert!(
            twice.contains("--set starts=8: --starts 4 says otherwise"),
            "{twice}"
        );
        assert!(
            read(&["--set", "starts"])
                .unwrap_err()
                .contains("write NAME=VALUE")
        );
    }
}
