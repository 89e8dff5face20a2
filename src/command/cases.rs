//! `trilith list`, `trilith show`, `trilith new`.

use clap::ValueEnum;
use std::fmt::Write;
use std::path::Path;

use crate::case::{self, Case, Geometry, Template};
use crate::files::write_whole;
use crate::method::{METHODS, PushoverSettings, pushover};
use crate::number::short;
use crate::scene::{Forces, Friction, HeadJoints, Joint, JointClass, Push, Scene, Sense, Side};
use crate::study::sweep::{self, Sweep};
use crate::text::{GridColumn, grid, words};

use super::plan::warn;
use super::screen::{layout, print, print_lines};
use super::stop::Stop;

#[derive(Clone, Copy, ValueEnum)]
pub(super) enum KindArgument {
    /// A coursed wall.
    Wall,
    /// Blocks of any shape.
    Blocks,
    /// A circular voussoir arch.
    Arch,
}

impl From<KindArgument> for Template {
    fn from(argument: KindArgument) -> Self {
        match argument {
            KindArgument::Wall => Template::Wall,
            KindArgument::Blocks => Template::Blocks,
            KindArgument::Arch => Template::Arch,
        }
    }
}

/// Columns of the lists of cases and of sweeps: where there is no room, the files go.
const NAMED: [GridColumn; 3] = [words("name"), words("file").spare(1), words("title")];

pub(super) fn list() -> Result<u8, Stop> {
    let cases = case::embedded()
        .zip(case::library())
        .map(|((path, _), case)| [case.name, path.to_owned(), case.title].to_vec());
    let mut sweeps = Vec::new();
    for (path, _) in sweep::embedded() {
        let sweep = Sweep::find(path)?;
        sweeps.push(vec![sweep.name, path.to_owned(), sweep.title]);
    }
    let methods = METHODS.iter().map(|entry| {
        let by_default = if entry.by_default { "yes" } else { "" };
        [entry.name(), by_default, entry.summary]
            .map(str::to_owned)
            .to_vec()
    });
    let table = |columns: &[GridColumn], rows: &[Vec<String>]| grid(layout(), 2, columns, rows);
    print(&format!(
        "cases built in:\n{}\nsweeps built in:\n{}\nmethods:\n{}",
        table(&NAMED, &cases.collect::<Vec<_>>()),
        table(&NAMED, &sweeps),
        table(
            &[words("name"), words("by default"), words("what it is")],
            &methods.collect::<Vec<_>>()
        ),
    ))?;
    Ok(0)
}

pub(super) fn show(argument: &str, pushover: bool) -> Result<u8, Stop> {
    let cases = case::find(argument)?;
    warn(&cases);
    for case in &cases {
        print_lines(&description(case))?;
        for &head_joints in case.head_joints.iter().filter(|_| pushover) {
            let scene = case.scene(head_joints);
            let lines = pushover::parameters(&scene, &PushoverSettings::default())
                .unwrap_or_else(|reason| format!("It is not run: {reason}.\n"));
            print_lines(&format!(
                "pushover, {} head joints\n{lines}",
                head_joints.name()
            ))?;
        }
    }
    Ok(0)
}

fn description(case: &Case) -> String {
    let mut text = format!("{}: {}\nsource: {}\n", case.name, case.title, case.source);
    text.push_str(&geometry(&case.geometry));
    let _ = writeln!(text, "pushed {}", pushes(&case.pushes));
    for head_joints in &case.head_joints {
        let scene = case.scene(*head_joints);
        let _ = writeln!(text, "{}", crate::record::fingerprint(*head_joints, &scene));
    }
    if let Geometry::Blocks(_) = case.geometry {
        text.push_str(&steep_joints(&case.scene(HeadJoints::Contact)));
    }
    if let Some(motion) = &case.motion {
        for support in &motion.supports {
            let [x, y] = [support.away.x, support.away.y].map(|part| short(part, 4));
            let _ = writeln!(
                text,
                "{} moves {} the wall, which is {} [{x}, {y}]",
                support.name,
                match motion.sense {
                    Sense::Away => "away from",
                    Sense::Against => "against",
                },
                match motion.sense {
                    Sense::Away => "along",
                    Sense::Against => "against",
                },
            );
        }
    }
    for r in &case.references {
        let joints = r.head_joints.map_or("both", |h| h.name());
        let _ = writeln!(
            text,
            "{} {} {}: {} +- {} ({}, {})",
            r.method,
            joints,
            r.quantity.name(),
            r.value,
            r.tolerance,
            r.kind.name(),
            r.source
        );
    }
    text
}

/// Which joints between blocks are head joints, and which are bed joints although they are steep.
fn steep_joints(scene: &Scene) -> String {
    let named = |wanted: &dyn Fn(&Joint) -> bool| {
        let joints = scene.joints().iter().filter(|joint| wanted(joint));
        let names = joints.filter_map(|joint| match joint.from {
            Side::Block(from) => {
                let names = [from, joint.to].map(|block| scene.block_name(block));
                Some(names.join(" | "))
            }
            Side::Support(_) => None,
        });
        names.collect::<Vec<_>>()
    };
    let is_steep = |joint: &Joint| joint.normal.x.abs() > joint.normal.y.abs();
    let heads = named(&|joint| joint.class == JointClass::Head);
    let beds = named(&|joint| joint.class == JointClass::Bed && is_steep(joint));
    let mut text = String::new();
    for (what, names) in [("head joints", heads), ("steep bed joints", beds)] {
        if let Some((first, more)) = names.split_at_checked(MOST_NAMED) {
            let more = more.len();
            let _ = writeln!(text, "{what}: {} and {more} more", first.join(", "));
        } else if !names.is_empty() {
            let _ = writeln!(text, "{what}: {}", names.join(", "));
        }
    }
    text
}

/// Joints that are named at most.
const MOST_NAMED: usize = 40;

/// What the case is made of, in one paragraph.
fn geometry(geometry: &Geometry) -> String {
    match geometry {
        Geometry::Wall(wall) => format!(
            "{} courses of units {} x {} x {}, weight {} each; friction {}, overburden ratio {}\n",
            wall.courses.len(),
            wall.unit_length,
            wall.unit_height,
            wall.thickness,
            wall.unit_weight,
            friction(wall.friction),
            wall.overburden
        ),
        Geometry::Blocks(assembly) => {
            let supports = assembly.supports.iter().map(|s| s.name.as_str());
            format!(
                "{} blocks on {}; friction {}; {}\n\
                 edges touch within {:e} of the smaller block's extent\n",
                assembly.blocks.len(),
                supports.collect::<Vec<_>>().join(", "),
                friction(assembly.friction),
                forces(&assembly.forces),
                assembly.tolerance
            )
        }
        Geometry::Arch(arch) => format!(
            "an arch of mean radius {}, thickness {}, embrace {} degrees, {} voussoirs; \
             friction {}; {}\n",
            arch.mean_radius,
            arch.thickness,
            arch.embrace,
            arch.voussoirs,
            friction(arch.friction),
            forces(&arch.forces)
        ),
    }
}

fn forces(forces: &Forces) -> String {
    let weight = if forces.weight_is_live {
        "the live load is every weight sideways"
    } else {
        "the live load is the loads alone"
    };
    match forces.extra.len() {
        0 => weight.into(),
        1 => format!("{weight}, and 1 load"),
        count => format!("{weight}, and {count} loads"),
    }
}

fn pushes(pushes: &[Push]) -> &'static str {
    match pushes {
        [Push::Right] => "to the right",
        [Push::Left] => "to the left",
        _ => "to the right and to the left, and the weaker side counts",
    }
}

/// One number where all joints are alike.
fn friction(friction: Friction) -> String {
    let Friction { bed, head, base } = friction;
    if bed == head && bed == base {
        bed.to_string()
    } else {
        format!("{bed} bed, {head} head, {base} base")
    }
}

/// A file as a shell takes it for a command's argument, and the command for a file.
pub(super) fn quoted(file: &str) -> String {
    let file = match file.strip_prefix('-') {
        Some(_) => format!("./{file}"),
        None => file.to_owned(),
    };
    shlex::try_quote(&file).map_or(file.clone(), |quoted| quoted.into_owned())
}

pub(super) fn new(name: &str, template: Template) -> Result<u8, Stop> {
    let named = Path::new(name.strip_suffix(".toml").unwrap_or(name)).file_name();
    if named.is_none() || name.ends_with(['/', '\\']) {
        return Err(Stop::bad_input(format!(
            "error: `{name}` is no name for a case\nhelp: write `trilith new mywall`, or a path that ends in \
             `.toml`"
        )));
    }
    let file = if name.ends_with(".toml") {
        name.to_owned()
    } else {
        format!("{name}.toml")
    };
    let path = Path::new(&file);
    let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned());
    let Some(stem) = stem.filter(|s| !s.is_empty()) else {
        return Err(Stop::bad_input(format!(
            "error: `{name}` is no name for a case"
        )));
    };
    if path.exists() {
        let text =
            format!("error: {file} is there already\nhelp: choose another name, or remove it");
        return Err(Stop::bad_input(text));
    }
    let text = template.text(&stem);
    // A name that `run` would refuse is refused here.
    Case::read(&file, text.as_bytes())?;
    write_whole(path, &text).map_err(|e| Stop::not_written(&file, e))?;
    print_lines(&format!(
        "wrote {file}; next: trilith run {}\n",
        quoted(&file)
    ))?;
    Ok(0)
}
