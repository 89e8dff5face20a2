//! Which settings each method climbs through, from cheap to dear.

use crate::method::{METHODS, Method, Settings};

/// One method with one setting.
#[derive(Clone)]
pub struct Rung<'a> {
    /// The method.
    pub method: &'a dyn Method,
    /// Its settings.
    pub settings: Settings,
    /// What is not as by default, as `name=value`; `default` where nothing is.
    pub label: String,
}

/// Settings that are not as by default: names and values.
type Changes = &'static [(&'static str, &'static str)];

/// What each method is run with, beside its defaults.
const LADDERS: [(&str, &[Changes]); 6] = [
    ("macro-block", &[]),
    (
        "associative",
        &[
            &[("lp-tolerance", "1e-2")],
            &[("lp-tolerance", "1e-4")],
            &[("lp-tolerance", "1e-6")],
            &[("lp-tolerance", "1e-8")],
            &[("reduction", "false")],
        ],
    ),
    (
        "sequential",
        &[
            &[("alpha", "0.1")],
            &[("beta", "0.3")],
            &[("c0", "1e-4")],
            &[("lp-tolerance", "1e-6")],
        ],
    ),
    (
        "interval",
        &[
            &[("starts", "1")],
            &[("starts", "4")],
            &[("starts", "8")],
            &[("starts", "16")],
            &[("reduction", "false")],
        ],
    ),
    (
        "pushover",
        &[
            &[("accuracy", "coarse")],
            &[("accuracy", "fine")],
            &[("substep", "4")],
            &[("substep", "2")],
            &[("stiffness", "0.25")],
        ],
    ),
    (
        "auto",
        &[&[("tolerance", "0.05")], &[("tolerance", "0.001")]],
    ),
];

/// Blocks from which rungs that take minutes are left out, and below which there is nothing to
/// reduce.
const LARGE: usize = 200;

/// Rungs that large scenes do without.
const LONG: [Changes; 7] = [
    &[("starts", "4")],
    &[("starts", "8")],
    &[("starts", "16")],
    &[("accuracy", "fine")],
    &[("c0", "1e-4")],
    &[("beta", "0.3")],
    &[("tolerance", "0.001")],
];

/// The rungs for a scene of that many blocks, method by method: the default first, then its ladder;
/// then the external methods as they are.
pub fn ladder<'a>(blocks: usize, externals: &[&'a dyn Method]) -> Vec<Rung<'a>> {
    let mut rungs = Vec::new();
    for (name, ladder) in LADDERS {
        let method = METHODS.into_iter().find(|method| method.name() == name);
        let method = method.expect("the ladders are of known methods");
        rungs.push(rung(method, &[]));
        for changes in ladder {
            let long = blocks >= LARGE && LONG.contains(changes);
            let idle = blocks < LARGE && changes.contains(&("reduction", "false"));
            if !long && !idle {
                rungs.push(rung(method, changes));
            }
        }
    }
    rungs.extend(externals.iter().map(|&method| rung(method, &[])));
    rungs
}

fn rung<'a>(method: &'a dyn Method, changes: &[(&str, &str)]) -> Rung<'a> {
    let mut settings = Settings::default();
    for (name, value) in changes {
        let set = settings.set(name, value);
        set.expect("the ladders hold settings and values that exist");
    }
    let words: Vec<String> = changes
        .iter()
        .map(|(name, value)| format!("{name}={value}"))
        .collect();
    Rung {
        method,
        settings,
        label: match words.is_empty() {
            true => "default".to_owned(),
            false => words.join(" "),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_method_has_a_ladder_and_every_rung_can_be_set() {
        let names: Vec<&str> = METHODS.iter().map(|method| method.name()).collect();
        assert_eq!(LADDERS.map(|(name, _)| name).to_vec(), names);
        assert!(ladder(10, &[]).len() > ladder(1000, &[]).len());
    }
}
