//! Which methods run, and with which settings: the arguments that several commands share.

use crate::case::{self, Case, Geometry};
use crate::external;
use crate::method::{self, Collapse, Kind, Method, kind};
use crate::run::Plan;
use crate::scene::HeadJoints;
use clap::{Args, ValueEnum};

use super::drawing::{DrawingArguments, is_drawing};
use super::screen::tell;
use super::settings::SettingArguments;
use super::stop::Stop;

#[derive(Args)]
#[command(next_help_heading = "What runs")]
pub(super) struct PlanArguments {
    /// Run only these methods; `trilith list` names all of them.
    #[arg(long, value_name = "NAME", num_args = 1.., value_delimiter = ',')]
    method: Vec<String>,
    /// What head joints carry, instead of what the case says.
    #[arg(long)]
    head_joints: Option<HeadJointsArgument>,
    #[command(flatten)]
    settings: SettingArguments,
    /// Also run programs of your own: a .toml file that names them, or NAME=COMMAND.
    #[arg(long, value_name = "FILE.toml|NAME=COMMAND")]
    external: Vec<String>,
    #[command(flatten)]
    drawing: DrawingArguments,
}

impl PlanArguments {
    /// The plan, and the cases that `cases` and the misplaced names of `--method` stand for; none
    /// named: those of `default`.
    pub fn read(
        &self,
        cases: &[String],
        default: fn() -> Vec<Case>,
    ) -> Result<(Vec<Case>, Plan<'static>), Stop> {
        let (methods, misplaced) = methods(&self.method, &externals(&self.external)?)?;
        let named = [cases, &misplaced].concat();
        let (drawings, named): (Vec<String>, Vec<String>) =
            named.into_iter().partition(|name| is_drawing(name));
        let mut cases = if !drawings.is_empty() && named.is_empty() {
            Vec::new()
        } else if named.is_empty() {
            default()
        } else {
            collect(&named)?
        };
        warn(&cases);
        if drawings.is_empty() && self.drawing.is_given() {
            let text = "error: --friction, --support and the like are for drawings, and none is \
                        named\nhelp: name a `.dxf`, or write them into the case";
            return Err(Stop::bad_input(text));
        }
        for drawing in &drawings {
            cases.push(self.drawing.case(drawing)?);
        }
        if let Some(head_joints) = self.head_joints {
            head_joints.set(&mut cases);
        }
        let settings = self.settings.read()?;
        if settings.pushover.collapse == Collapse::FirstSlip {
            // References of the pushover are of the collapse, which is not what it was asked for.
            for case in &mut cases {
                case.references
                    .retain(|reference| kind(&reference.method) != Kind::Observed);
            }
        }
        let plan = Plan {
            methods,
            settings,
            head_joints: self.head_joints.and_then(HeadJointsArgument::one),
        };
        Ok((cases, plan))
    }

    pub fn names_head_joints(&self) -> bool {
        self.head_joints.is_some()
    }

    pub fn names_methods(&self) -> bool {
        !self.method.is_empty()
    }
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum HeadJointsArgument {
    /// They carry pressure and friction.
    Contact,
    /// They carry nothing.
    Open,
    /// Both, one after the other.
    Both,
}

impl HeadJointsArgument {
    pub(super) fn all(self) -> Vec<HeadJoints> {
        match self {
            HeadJointsArgument::Contact => vec![HeadJoints::Contact],
            HeadJointsArgument::Open => vec![HeadJoints::Open],
            HeadJointsArgument::Both => vec![HeadJoints::Contact, HeadJoints::Open],
        }
    }

    /// The one setting; `None` for both.
    pub(super) fn one(self) -> Option<HeadJoints> {
        <[HeadJoints; 1]>::try_from(self.all())
            .ok()
            .map(|[one]| one)
    }

    /// Lets cases run with both, where that is said. An arch has no head joints, and runs once.
    pub(super) fn set(self, cases: &mut [Case]) {
        for case in cases {
            if self.one().is_none() && !matches!(case.geometry, Geometry::Arch(_)) {
                case.head_joints = self.all();
            }
        }
    }
}

/// The external methods that the arguments name.
pub(super) fn externals(arguments: &[String]) -> Result<Vec<&'static dyn Method>, Stop> {
    let mut all: Vec<&'static dyn Method> = Vec::new();
    for argument in arguments {
        for method in external::read(argument)? {
            let name = &method.name;
            if all.iter().any(|other| other.name() == name) {
                let text = format!(
                    "error: two external methods are named `{name}`\nhelp: give each a name of its own"
                );
                return Err(Stop::bad_input(text));
            }
            // Once a run of the program, which needs them to its end.
            all.push(Box::leak(Box::new(method)));
        }
    }
    Ok(all)
}

/// Tells on standard error what may be a slip in the files of cases.
pub(super) fn warn(cases: &[Case]) {
    for warning in cases.iter().flat_map(|case| &case.warnings) {
        tell!("{warning}\n");
    }
}

pub(super) fn collect(arguments: &[String]) -> Result<Vec<Case>, Stop> {
    case::collect(arguments).map_err(|complaints| {
        let texts: Vec<String> = complaints.iter().map(ToString::to_string).collect();
        Stop::bad_input(texts.join("\n\n"))
    })
}

/// The methods of these names in the list's own order, or the default ones without a name, each
/// once; then the external ones. What names no method but a case, as in
/// `--method associative paper-1`, is handed back.
fn methods(
    names: &[String],
    externals: &[&'static dyn Method],
) -> Result<(Vec<&'static dyn Method>, Vec<String>), Stop> {
    let all = [method::methods().as_slice(), externals].concat();
    let known = |name: &str| all.iter().any(|method| method.name() == name);
    let (names, others): (Vec<String>, Vec<String>) =
        names.iter().cloned().partition(|name| known(name));
    let is_case = |other: &&String| is_drawing(other) || case::find(other).is_ok();
    if let Some(other) = others.iter().find(|other| !is_case(other)) {
        let list: Vec<&str> = all.iter().map(|method| method.name()).collect();
        let list = list.join(", ");
        let text = format!("error: there is no method named `{other}`\nhelp: methods are {list}");
        return Err(Stop::bad_input(text));
    }
    if names.is_empty() {
        return Ok(([method::defaults().as_slice(), externals].concat(), others));
    }
    let wanted = |method: &&dyn Method| names.iter().any(|name| name == method.name());
    // Whoever names a program wants it to run, whichever of our own methods run beside it.
    let own = method::methods().into_iter().filter(wanted);
    Ok((own.chain(externals.iter().copied()).collect(), others))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn methods_keep_their_order_and_come_once() {
        let names = ["sequential", "paper-1", "macro-block", "sequential"].map(str::to_owned);
        let (found, cases) = methods(&names, &[]).unwrap_or_default();
        let found: Vec<&str> = found.iter().map(|m| m.name()).collect();
        assert_eq!(found, ["macro-block", "sequential"]);
        assert_eq!(cases, ["paper-1"]);
        assert!(methods(&["guess".to_owned()], &[]).is_err());
    }
}
