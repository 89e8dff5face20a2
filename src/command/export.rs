//! `trilith export`, `trilith schema`.

use std::path::PathBuf;

use crate::case::Case;
use crate::external;
use crate::files::write_whole;
use crate::mechanics::thrust;
use crate::method::methods;
use crate::picture::dxf;
use crate::run::{Plan, run};
use crate::scene::Push;
use clap::{Args, ValueEnum};

use super::convert::one_case;
use super::plan::HeadJointsArgument;
use super::screen::{print, print_lines, tell};
use super::stop::Stop;

#[derive(Args)]
pub(super) struct ExportArguments {
    /// A case file, the name of a built-in case, or `-` for a case in standard input.
    case: String,
    /// What head joints carry, instead of the first setting that the case runs with.
    #[arg(long)]
    head_joints: Option<HeadJointsArgument>,
    /// Direction of the push, instead of the first one of the case.
    #[arg(long)]
    push: Option<PushArgument>,
    /// Write a DXF drawing instead, with blocks, mechanism and thrust on layers.
    #[arg(long, value_name = "FILE.dxf", group = "file")]
    dxf: Option<PathBuf>,
    /// Write a BlockModel of COMPAS instead, with the mechanism and contact forces.
    #[arg(long, value_name = "FILE.json", group = "file")]
    compas: Option<PathBuf>,
    /// The method whose mechanism and forces are in the file.
    #[arg(
        long,
        value_name = "NAME",
        requires = "file",
        default_value = "associative"
    )]
    method: String,
}

#[derive(Clone, Copy, ValueEnum)]
enum PushArgument {
    Right,
    Left,
}

pub(super) fn export(arguments: &ExportArguments) -> Result<u8, Stop> {
    let mut case = one_case(&arguments.case)?;
    let push = arguments.push.map(|push| match push {
        PushArgument::Right => Push::Right,
        PushArgument::Left => Push::Left,
    });
    let head_joints = arguments.head_joints.map(HeadJointsArgument::one);
    let (path, is_dxf) = match (&arguments.dxf, &arguments.compas) {
        (Some(path), _) => (path, true),
        (None, Some(path)) => (path, false),
        (None, None) => {
            if head_joints == Some(None) {
                let text = "error: a scene has one setting of its head joints\nhelp: write \
                            `--head-joints contact` or `--head-joints open`";
                return Err(Stop::bad_input(text));
            }
            if let ([first, _], None) = (case.pushes.as_slice(), push) {
                let (name, way) = (&case.name, first.name());
                tell!("{name} is pushed both ways; this is its push to the {way}");
            }
            let head_joints = head_joints.flatten().unwrap_or(case.head_joints[0]);
            let scene = case.pushed(head_joints, push.unwrap_or(case.pushes[0]));
            print(&(external::export(&scene) + "\n"))?;
            return Ok(0);
        }
    };
    case.head_joints = vec![head_joints.flatten().unwrap_or(case.head_joints[0])];
    if let Some(push) = push {
        case.pushes = vec![push];
    }
    let text = with_answer(&case, &arguments.method, is_dxf)?;
    write_whole(path, &text).map_err(|e| Stop::not_written(path.display(), e))?;
    print_lines(&format!("wrote {}\n", path.display()))?;
    Ok(0)
}

/// A case as a drawing or a model, with the mechanism and the thrust or forces of a method's answer.
fn with_answer(case: &Case, method: &str, is_dxf: bool) -> Result<String, Stop> {
    let mut methods = methods();
    methods.retain(|known| known.name() == method);
    if methods.is_empty() {
        let text =
            format!("error: there is no method named `{method}`\nhelp: `trilith list` names them");
        return Err(Stop::bad_input(text));
    }
    let plan = Plan {
        methods,
        ..Plan::default()
    };
    let results = run(std::slice::from_ref(case), &plan, &|_| {});
    let result = results.first();
    let Some((result, row)) = result.and_then(|result| Some((result, result.rows.first()?))) else {
        return Err(Stop::bad_input("error: there is nothing to draw"));
    };
    let (scene, evidence) = (result.scene(row), &row.outcome.evidence);
    let forces = evidence.forces().map(|(_, forces)| forces);
    let mechanism = evidence.mechanism();
    let assembly = case.geometry.assembly();
    Ok(match is_dxf {
        true => dxf(
            scene,
            &assembly,
            mechanism,
            forces.map(|forces| thrust(scene, forces)).as_ref(),
        ),
        false => external::compas(scene, &assembly, mechanism, forces),
    })
}

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum SchemaOf {
    /// The scene, on standard input.
    Scene,
    /// The answer, on standard output.
    Result,
}

pub(super) fn schema(of: SchemaOf) -> Result<u8, Stop> {
    let schema = match of {
        SchemaOf::Scene => external::scene_schema(),
        SchemaOf::Result => external::answer_schema(),
    };
    let text = serde_json::to_string_pretty(&schema);
    print(&(text.expect("the keys of a schema are words") + "\n"))?;
    Ok(0)
}
