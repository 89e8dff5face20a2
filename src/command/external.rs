//! `trilith export`, `trilith schema`.

use crate::case;
use crate::external;
use crate::scene::Push;
use clap::ValueEnum;

use super::head_joints::HeadJointsArgument;
use super::plan::warn;
use super::screen::{print, tell};
use super::stop::Stop;

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum SchemaOf {
    /// The scene, on standard input.
    Scene,
    /// The answer, on standard output.
    Result,
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum PushArgument {
    Right,
    Left,
}

impl From<PushArgument> for Push {
    fn from(argument: PushArgument) -> Self {
        match argument {
            PushArgument::Right => Push::Right,
            PushArgument::Left => Push::Left,
        }
    }
}

pub(super) fn export(
    argument: &str,
    head_joints: Option<HeadJointsArgument>,
    push: Option<Push>,
) -> Result<u8, Stop> {
    let cases = case::find(argument)?;
    let [case] = cases.as_slice() else {
        let names: Vec<&str> = cases.iter().map(|case| case.name.as_str()).collect();
        let text = format!(
            "error: {argument} holds several cases\nhelp: export one of {}",
            names.join(", ")
        );
        return Err(Stop::bad_input(text));
    };
    warn(&cases);
    let head_joints = match head_joints.map(HeadJointsArgument::one) {
        None => case.head_joints[0],
        Some(Some(one)) => one,
        Some(None) => {
            let text = "error: a scene has one setting of its head joints\nhelp: write \
                        `--head-joints contact` or `--head-joints open`";
            return Err(Stop::bad_input(text));
        }
    };
    if let ([first, _], None) = (case.pushes.as_slice(), push) {
        let way = first.name();
        tell!(
            "{} is pushed both ways; this is its push to the {way}",
            case.name
        );
    }
    let push = push.unwrap_or(case.pushes[0]);
    let text = external::export(&case.pushed(head_joints, push));
    let text = text.map_err(|e| Stop::not_written("JSON", e))?;
    print(&format!("{text}\n"))?;
    Ok(0)
}

pub(super) fn schema(of: SchemaOf) -> Result<u8, Stop> {
    let schema = match of {
        SchemaOf::Scene => external::scene_schema(),
        SchemaOf::Result => external::answer_schema(),
    };
    let text = serde_json::to_string_pretty(&schema);
    let text = text.map_err(|e| Stop::not_written("JSON", e))?;
    print(&format!("{text}\n"))?;
    Ok(0)
}
