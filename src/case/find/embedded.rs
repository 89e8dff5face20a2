//! The cases inside the binary, and the files beside them: all that lie below `cases/`.

use std::path::Path;

/// Path from the top of the repository, and text, in the order of tables: the paper's walls first.
const CASES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/embedded_cases.rs"));

/// The files beside them that cases may name, in the same form.
const FILES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/embedded_files.rs"));

/// The embedded cases as (path from the top of the repository, text).
pub fn embedded() -> impl Iterator<Item = (&'static str, &'static str)> {
    CASES.iter().copied()
}

/// The embedded file of this name beside an embedded case; in words why there is none.
pub(super) fn embedded_file(case: &str, name: &str) -> Result<Vec<u8>, String> {
    let wanted = Path::new(case).with_file_name(name);
    let found = FILES.iter().find(|(path, _)| Path::new(path) == wanted);
    let text = found.map(|(_, text)| text.as_bytes().to_vec());
    text.ok_or_else(|| "it is not built in".to_owned())
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    /// Every file below a folder of the repository, as `cases/...`; hidden ones left out.
    fn files_below(folder: &str) -> Vec<String> {
        let top = Path::new(env!("CARGO_MANIFEST_DIR"));
        let mut files = Vec::new();
        for entry in fs::read_dir(top.join(folder)).unwrap() {
            let entry = entry.unwrap();
            let name = entry.file_name().into_string().unwrap();
            let path = format!("{folder}/{name}");
            // Certificates are none, and are not embedded.
            if name.starts_with('.') || path == "cases/certificates" {
                continue;
            }
            if entry.path().is_dir() {
                files.extend(files_below(&path));
            } else {
                files.push(path);
            }
        }
        files
    }

    #[test]
    fn what_lies_below_cases_is_embedded() {
        let files = files_below("cases");
        let sorted = |texts: &mut dyn Iterator<Item = &str>| {
            let mut sorted: Vec<String> = texts.map(str::to_owned).collect();
            sorted.sort();
            sorted
        };
        let of_kind = |wanted: fn(&str) -> bool| {
            sorted(&mut files.iter().map(String::as_str).filter(|path| wanted(path)))
        };
        let cases = of_kind(|path| path.ends_with(".toml") && !path.ends_with(".sweep.toml"));
        assert!(!cases.is_empty());
        assert_eq!(cases, sorted(&mut embedded().map(|(path, _)| path)));
        let beside = of_kind(|path| !path.ends_with(".toml"));
        assert_eq!(beside, sorted(&mut FILES.iter().map(|(path, _)| *path)));
    }

    #[test]
    fn the_papers_walls_come_first_and_numbers_count_as_numbers() {
        let paths: Vec<&str> = embedded().map(|(path, _)| path).collect();
        for (place, wall) in [1, 2, 3].into_iter().enumerate() {
            assert_eq!(paths[place], format!("cases/walls/paper-{wall}.toml"));
        }
        let place = |path: &str| paths.iter().position(|known| *known == path).unwrap();
        for (first, second) in [
            ("columns/column-2", "columns/column-10"),
            ("walls/overburden-0.25", "walls/overburden-0.5"),
            ("walls/overburden-0.5", "walls/overburden-1"),
        ] {
            let [first, second] = [first, second].map(|name| format!("cases/{name}.toml"));
            assert!(place(&first) < place(&second), "{first}, {second}");
        }
    }
}
