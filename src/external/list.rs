//! Where external methods are named: a TOML file, or `NAME=COMMAND` on the command line.
//!
//! ```toml
//! [[method]]
//! name = "highs"
//! command = ["python3", "highs.py"] # runs in the folder of this file
//! time_limit = 60                   # seconds, optional
//! ```

use std::io;
use std::path::Path;
use std::time::Duration;

use serde::Deserialize;
use toml::Spanned;

use super::process::External;
use crate::case::{Complaint, Document, Written, explain, outside_name};
use crate::files::{Input, read_input};
use crate::method::METHODS;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ProgramList {
    method: Vec<ProgramEntry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, expecting = "a `[[method]]` table")]
struct ProgramEntry {
    name: Spanned<String>,
    command: Spanned<Vec<String>>,
    time_limit: Option<Spanned<f64>>,
}

/// Time limit of a program that states none.
const DEFAULT_LIMIT: Duration = Duration::from_secs(60);

/// Longest time limit, seconds.
const MAX_TIME_LIMIT: f64 = 86_400.0;

/// Reads the methods that a text stands for: a `.toml` file, or
/// `NAME=COMMAND` with the command's words divided as a shell would.
pub fn read(argument: &str) -> Result<Vec<External>, Complaint> {
    if let Some((name, command)) = argument.split_once('=') {
        let method = of_argument(name, command).map_err(|(title, help)| {
            Complaint::new(format!("external method {argument}: {title}")).help(help)
        })?;
        return Ok(vec![method]);
    }
    if !argument.ends_with(".toml") {
        let title = format!("external method {argument}: neither a .toml file nor NAME=COMMAND");
        return Err(Complaint::new(title).help("write `highs=\"python3 highs.py\"`"));
    }
    let bytes = read_input(Path::new(argument), Input::Toml);
    let text = bytes.and_then(|bytes| String::from_utf8(bytes).map_err(io::Error::other));
    let text = text.map_err(|error| {
        Complaint::new(format!("cannot read {argument}: {error}"))
            .help("check the path and that it is a text")
    })?;
    parse(argument, &text)
}

fn of_argument(name: &str, command: &str) -> Result<External, (String, String)> {
    check_name(name)?;
    let words = shlex::split(command).filter(|words| !words.is_empty());
    let command = words.ok_or_else(|| {
        let help = "write the program and its arguments, with every quote closed";
        (format!("`{command}` is no command"), help.to_owned())
    })?;
    Ok(External {
        name: name.to_owned(),
        command,
        folder: None,
        limit: DEFAULT_LIMIT,
    })
}

/// Reads the text of a file of methods, whose folder is where they run.
///
/// # Errors
/// The first mistake of the file.
pub fn parse(path: &str, text: &str) -> Result<Vec<External>, Complaint> {
    let document = Document {
        path: path.to_owned(),
        text: text.into(),
    };
    let list = toml::from_str(text).map_err(|error| explain(&document, &error))?;
    of_list(path, list).map_err(|complaint| complaint.in_document(&document))
}

fn of_list(path: &str, list: ProgramList) -> Result<Vec<External>, Complaint> {
    let mut methods: Vec<External> = Vec::new();
    for entry in list.method {
        let name = entry.name.get_ref();
        let wrong_name =
            |(title, help): (String, String)| entry.name.wrong(title, "this name").help(help);
        check_name(name).map_err(wrong_name)?;
        if methods.iter().any(|other| other.name == *name) {
            let title = format!("two methods are named `{name}`");
            return Err(wrong_name((title, "give each a name of its own".into())));
        }
        if entry.command.get_ref().is_empty() {
            let complaint = entry.command.wrong("no command", "empty");
            return Err(complaint.help("write `command = [\"python3\", \"highs.py\"]`"));
        }
        let limit = match &entry.time_limit {
            None => DEFAULT_LIMIT,
            Some(limit) if *limit.get_ref() > 0.0 && *limit.get_ref() <= MAX_TIME_LIMIT => {
                Duration::from_secs_f64(*limit.get_ref())
            }
            Some(limit) => {
                let title = "a time limit that no program can be held to";
                let complaint = limit.wrong(title, "seconds");
                return Err(complaint.help(format!("write seconds, up to {MAX_TIME_LIMIT}")));
            }
        };
        let folder = Path::new(path).parent().map(Path::to_owned);
        methods.push(External {
            name: name.clone(),
            command: entry.command.into_inner(),
            folder: folder.filter(|folder| !folder.as_os_str().is_empty()),
            limit,
        });
    }
    Ok(methods)
}

/// A plain word that names no other method, or what is wrong and what to write instead.
fn check_name(name: &str) -> Result<(), (String, String)> {
    outside_name(name).map_err(|help| (format!("`{name}` is no plain, short word"), help))?;
    if METHODS.iter().any(|method| method.name() == name) {
        let help = "choose another name".to_owned();
        return Err((format!("`{name}` is a method of trilith's own"), help));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_names_methods_that_run_in_its_folder() {
        let text = "[[method]]\nname = \"highs\"\ncommand = [\"python3\", \"highs.py\"]\n\
                    time_limit = 2.5\n";
        let methods = parse("methods/mine.toml", text).unwrap();
        assert_eq!(methods[0].folder.as_deref(), Some(Path::new("methods")));
        assert_eq!(methods[0].limit, Duration::from_millis(2500));
        let one = read("mine=sh -c 'exit 3'").unwrap();
        assert_eq!(one[0].command, ["sh", "-c", "exit 3"]);
    }

    #[test]
    fn mistakes_are_shown_with_what_to_write() {
        let right = "[[method]]\nname = \"highs\"\ncommand = [\"a\"]\n";
        let twice = right.repeat(2);
        for (text, expected) in [
            (right.replace("highs", "interval"), "trilith's own"),
            (right.replace("highs", "a b"), "plain, short word"),
            (
                right.replace("highs", "a-very-long-name"),
                "up to 12 letters",
            ),
            (right.replace("[\"a\"]", "[]"), "no command"),
            (right.replace("name", "nme"), "did you mean `name`?"),
            (format!("{right}time_limit = 0.0\n"), "write seconds"),
            (twice, "two methods"),
        ] {
            let shown = parse("a.toml", &text).unwrap_err().to_string();
            assert!(shown.contains(expected), "{shown}");
            assert!(shown.contains("a.toml:"), "{shown}");
        }
        for argument in ["mine", "mine=", "mine='", "=a", "pushover=a", "none.toml"] {
            assert!(read(argument).is_err(), "{argument}");
        }
    }
}
