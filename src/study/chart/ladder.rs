//! Every method over its ladder of settings, from cheap to dear, as the table of methods has it.

use crate::method::{Changes, Kind, METHODS, Method, Settings};

#[derive(Clone)]
pub struct Step<'a> {
    pub method: &'a dyn Method,
    pub settings: Settings,
    /// What is not as by default, as `name=value`; `default` where nothing is.
    pub label: String,
    /// Whether it is quick rather than right.
    pub loose: bool,
}

/// The steps for a scene of that many blocks, method by method: the default first, then its ladder;
/// then the external methods as they are. Proofs of a lower bound are left out: they take minutes on
/// walls of twenty blocks.
pub fn ladder<'a>(blocks: usize, externals: &[&'a dyn Method]) -> Vec<Step<'a>> {
    let mut steps = Vec::new();
    for entry in METHODS.iter().filter(|e| e.kind != Kind::LowerBound) {
        steps.push(step(entry.method, &[], false));
        let rungs = entry.ladder.iter();
        let rungs = rungs.filter(|rung| rung.scenes.hold(blocks));
        steps.extend(rungs.map(|rung| step(entry.method, rung.changes, rung.loose)));
    }
    steps.extend(externals.iter().map(|&method| step(method, &[], false)));
    steps
}

fn step<'a>(method: &'a dyn Method, changes: Changes, loose: bool) -> Step<'a> {
    let mut settings = Settings::default();
    for (name, value) in changes {
        let set = settings.set(name, value);
        set.expect("a test sets every rung of the table");
    }
    let words = changes
        .iter()
        .map(|(name, value)| format!("{name}={value}"));
    let label = match changes {
        [] => "default".to_owned(),
        _ => words.collect::<Vec<_>>().join(" "),
    };
    Step {
        method,
        settings,
        label,
        loose,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_scenes_have_more_steps_than_large_ones() {
        assert!(ladder(10, &[]).len() > ladder(1000, &[]).len());
        assert!(ladder(10, &[]).len() > METHODS.len());
    }
}
