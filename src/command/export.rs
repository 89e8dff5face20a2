//! `trilith export --dxf` and `--compas`.

use std::path::PathBuf;

use crate::external;
use crate::files::write_whole;
use crate::mechanics::thrust;
use crate::method::{Settings, methods};
use crate::picture::dxf;
use crate::run::{Plan, run};
use crate::scene::Push;

use super::convert::one_case;
use super::head_joints::HeadJointsArgument;
use super::screen::print_lines;
use super::stop::Stop;

/// The file that is written, of which there is one.
pub(super) struct Target {
    pub(super) dxf: Option<PathBuf>,
    pub(super) compas: Option<PathBuf>,
}

/// Writes a case as a drawing or a model, with the mechanism and the thrust or forces of a method's answer.
pub(super) fn export(
    argument: &str,
    head_joints: Option<HeadJointsArgument>,
    push: Option<Push>,
    target: &Target,
    method: &str,
) -> Result<u8, Stop> {
    let mut case = one_case(argument)?;
    case.head_joints.truncate(1);
    if let Some(one) = head_joints.and_then(HeadJointsArgument::one) {
        case.head_joints = vec![one];
    }
    if let Some(push) = push {
        case.pushes = vec![push];
    }
    let methods: Vec<_> = methods()
        .into_iter()
        .filter(|known| known.name() == method)
        .collect();
    if methods.is_empty() {
        let text =
            format!("error: there is no method named `{method}`\nhelp: `trilith list` names them");
        return Err(Stop::bad_input(text));
    }
    let plan = Plan {
        methods,
        settings: Settings::default(),
        head_joints: None,
    };
    let results = run(std::slice::from_ref(&case), &plan, &());
    let row = results
        .first()
        .and_then(|result| Some((result, result.rows.first()?)));
    let Some((result, row)) = row else {
        return Err(Stop::bad_input("error: there is nothing to draw"));
    };
    let scene = result.scene(row);
    let forces = row.outcome.evidence.forces();
    let mechanism = row.outcome.evidence.mechanism();
    let (path, text) = match (&target.dxf, &target.compas) {
        (Some(path), _) => {
            let thrust = forces.map(|(_, forces)| thrust(scene, forces));
            (path, dxf(scene, mechanism, thrust.as_ref()))
        }
        (None, Some(path)) => {
            let forces = forces.map(|(_, forces)| forces);
            let assembly = case.geometry.assembly();
            (path, external::compas(scene, &assembly, mechanism, forces))
        }
        (None, None) => return Err(Stop::bad_input("error: no file is named")),
    };
    write_whole(path, &text).map_err(|e| Stop::not_written(path.display(), e))?;
    print_lines(&format!("wrote {}\n", path.display()))?;
    Ok(0)
}
