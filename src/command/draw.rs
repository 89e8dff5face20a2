//! `trilith draw`.

use trilith::case;
use trilith::files::write_whole;
use trilith::method::{METHODS, Method};
use trilith::picture::{Options, View, figure};
use trilith::run::CaseResult;
use trilith::scene::HeadJoints;

use super::solve::solve;
use super::{DrawArguments, Stop, print};

/// The method that closes the gap between the closed form and the blocks is always run: its crack
/// is drawn over every mechanism.
const MACRO_BLOCK: &str = "macro-block";

/// What is drawn unless methods are named.
const ONE: [&str; 1] = ["interval"];

/// What `--side-by-side` draws unless methods are named: the paper's Figs. 4 and 5.
const SIDE_BY_SIDE: [&str; 3] = [MACRO_BLOCK, "interval", "pushover"];

pub(super) fn draw(arguments: &DrawArguments) -> Result<u8, Stop> {
    if arguments.output.extension().is_none_or(|end| end != "svg") {
        let path = arguments.output.display();
        let text = format!(
            "error: a drawing is SVG, and {path} does not end in `.svg`\nhelp: write `-o FILE.svg`"
        );
        return Err(Stop::bad_input(text));
    }
    let (mut cases, mut plan) = arguments
        .plan
        .read(std::slice::from_ref(&arguments.case), case::paper)?;
    if cases.len() != 1 {
        let text = format!(
            "error: `{}` stands for {} cases, and a drawing is of one\nhelp: name one case, and \
             methods after `--method`, separated by commas",
            arguments.case,
            cases.len()
        );
        return Err(Stop::bad_input(text));
    }
    let known = |name: &str| METHODS.iter().any(|method| method.name() == name);
    let named = plan.methods.iter().map(|method| method.name().to_owned());
    let drawn: Vec<String> = if arguments.plan.names_methods() {
        named.collect()
    } else {
        let own: &[&str] = if arguments.side_by_side {
            &SIDE_BY_SIDE
        } else {
            &ONE
        };
        let external = named.filter(|name| !known(name));
        own.iter()
            .map(|&name| name.to_owned())
            .chain(external)
            .collect()
    };
    let wanted = |method: &&dyn Method| {
        method.name() == MACRO_BLOCK || drawn.iter().any(|name| name == method.name())
    };
    let external = plan
        .methods
        .into_iter()
        .filter(|method| !known(method.name()));
    plan.methods = METHODS.into_iter().chain(external).filter(wanted).collect();
    let case = &mut cases[0];
    // One setting a drawing: open head joints where the case has them, which the published
    // mechanisms are of.
    let open = case.head_joints.contains(&HeadJoints::Open);
    let one = if open {
        HeadJoints::Open
    } else {
        case.head_joints[0]
    };
    plan.head_joints = plan.head_joints.or(Some(one));
    let results = solve(&cases, &plan, |_| Ok("not drawn".to_owned()));
    let [result] = results.as_slice() else {
        return Err(Stop::bad_input("error: there is nothing to draw"));
    };
    let views = views(result, &drawn);
    let pictures = views.len() * if arguments.forces { 2 } else { 1 };
    let options = Options {
        forces: arguments.forces,
        ..Options::for_pictures(pictures)
    };
    let title = format!("{}: {}", result.case.name, result.case.title);
    let svg = figure(&title, &views, &options);
    let path = &arguments.output;
    write_whole(path, &svg)
        .map_err(|e| Stop::bad_input(format!("error: cannot write {}: {e}", path.display())))?;
    print(&format!("wrote {}\n", path.display()))?;
    Ok(0)
}

/// The answers of these methods, in this order, with the macro-block's crack.
fn views<'a>(result: &'a CaseResult, methods: &[String]) -> Vec<View<'a>> {
    let row = |name: &str| result.rows.iter().find(|row| row.method == name);
    let slope = row(MACRO_BLOCK).and_then(|row| row.outcome.crack);
    let rows = methods.iter().filter_map(|name| row(name));
    rows.map(|row| View {
        scene: result.scene(row),
        row,
        macro_slope: slope.map(|crack| crack.tan_beta),
    })
    .collect()
}
