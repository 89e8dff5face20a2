//! Completions and man pages: there for every command, made of the same definitions as `--help`.

use std::fs;
use std::process::Command;

fn trilith(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_trilith"))
        .args(arguments)
        .output()
        .expect("the program starts");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {errors}");
    String::from_utf8(output.stdout).expect("output is UTF-8")
}

/// The commands that `--help` lists, without `help` itself.
fn commands() -> Vec<String> {
    let help = trilith(&["--help"]);
    let listed = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    let listed = listed.take_while(|line| !line.is_empty());
    // What a description goes on with stands deeper than a name.
    let names = listed.filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    let names = names.filter_map(|line| line.split_whitespace().next());
    let names: Vec<String> = names.filter(|n| *n != "help").map(str::to_owned).collect();
    assert!(
        names.len() > 10 && names.contains(&"run".to_owned()),
        "{names:?}"
    );
    names
}

#[test]
fn completions_name_every_command() {
    for shell in ["bash", "zsh", "fish"] {
        let script = trilith(&["completions", shell]);
        for command in commands() {
            let word = |line: &str| {
                line.split(|c: char| !c.is_alphanumeric())
                    .any(|w| w == command)
            };
            assert!(
                script.lines().any(word),
                "{shell} does not complete {command}"
            );
        }
        assert!(script.contains("head-joints"), "{shell}: no option of run");
    }
}

#[test]
fn every_command_has_a_man_page() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    assert_eq!(trilith(&["man", "--out", out]), "");
    let whole = fs::read_to_string(folder.path().join("trilith.1")).unwrap();
    assert_eq!(whole, trilith(&["man"]));
    for command in commands() {
        let file = format!("trilith-{command}.1");
        let page = fs::read_to_string(folder.path().join(&file)).expect(&file);
        assert!(page.contains(".SH NAME"), "{page}");
        assert_eq!(page, trilith(&["man", &command]));
        let mentioned = whole.contains(&format!("trilith\\-{command}(1)"));
        assert!(mentioned, "trilith.1 does not name {file}");
    }
    assert_eq!(
        fs::read_dir(folder.path()).unwrap().count(),
        commands().len() + 1
    );
}

#[test]
fn the_version_is_told_everywhere() {
    let version = env!("CARGO_PKG_VERSION");
    for flag in ["--version", "-V", "-v"] {
        assert_eq!(trilith(&[flag]), format!("trilith {version}\n"));
        for command in commands() {
            let told = trilith(&[&command, flag]);
            assert_eq!(told, format!("trilith-{command} {version}\n"));
        }
    }
}
