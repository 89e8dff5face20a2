//! What a drawing does not say, as arguments, and reading one.

use std::path::Path;

use crate::case::{Case, DrawingOptions, Imported};
use crate::files::{Input, read_input};
use crate::scene::Push;
use clap::{Args, ValueEnum};

use super::screen::tell;
use super::stop::Stop;

/// Remarks that a run prints; `import` prints all of them.
const SHOWN: usize = 20;

/// How to give what a complaint about a drawing asks for.
const OPTIONS: &str = "help: options are `--support LAYER`, `--without LAYER`, `--units mm`, \
                       `--gap 12mm`, and for `trilith import` `--tolerance 0.01`";

#[derive(Args)]
#[command(next_help_heading = "Drawings (.dxf) and models of COMPAS (.json)")]
pub(super) struct DrawingArguments {
    /// Layer of the outlines that never move [default: `support` or `ground`, else the lowest wide
    /// outline].
    #[arg(long, value_name = "LAYER", hide_short_help = true)]
    support: Option<String>,
    /// Leave these layers out.
    #[arg(
        long,
        value_name = "LAYER",
        value_delimiter = ',',
        hide_short_help = true
    )]
    without: Vec<String>,
    /// Coefficient of friction of every joint of the drawing.
    #[arg(long, value_name = "NUMBER")]
    friction: Option<f64>,
    /// Which way the drawing is pushed.
    #[arg(long, value_name = "WAY")]
    push: Option<Ways>,
    /// Unit of length of the drawing, instead of the one that its header names.
    #[arg(long, value_name = "UNIT", hide_short_help = true)]
    units: Option<Unit>,
    /// Arcs become chords that are nearer to them than this part of the radius.
    #[arg(long, value_name = "PART", hide_short_help = true)]
    chord: Option<f64>,
    /// Close gaps between stones, as of mortar, up to this width: each to a line in its middle, but none
    /// wider than a tenth of the smaller stone.
    #[arg(long, value_name = "WIDTH", value_parser = width, hide_short_help = true)]
    gap: Option<f64>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Ways {
    Right,
    Left,
    Both,
}

/// A width with its unit, in metres.
pub(super) fn width(text: &str) -> Result<f64, String> {
    let number = text.trim_end_matches(|c: char| c.is_alphabetic());
    let unit = Unit::from_str(&text[number.len()..], true);
    match (number.trim().parse::<f64>(), unit) {
        (Ok(width), Ok(unit)) if width > 0.0 && width.is_finite() => Ok(width * unit.metres()),
        _ => Err("write a width and its unit, as 12mm, 1.2cm or 0.5in".to_owned()),
    }
}

#[derive(Clone, Copy, ValueEnum)]
enum Unit {
    Mm,
    Cm,
    M,
    In,
    Ft,
}

impl Unit {
    fn metres(self) -> f64 {
        match self {
            Unit::Mm => 1e-3,
            Unit::Cm => 1e-2,
            Unit::M => 1.0,
            Unit::In => 0.0254,
            Unit::Ft => 0.3048,
        }
    }
}

/// Whether an argument names a drawing, or a model.
pub(super) fn is_drawing(argument: &str) -> bool {
    is_of(argument, "dxf") || is_of(argument, "json")
}

/// Whether a file's name has this ending.
fn is_of(argument: &str, ending: &str) -> bool {
    let end = Path::new(argument).extension();
    end.is_some_and(|end| end.eq_ignore_ascii_case(ending))
}

impl DrawingArguments {
    /// Whether any of them is given.
    pub(super) fn is_given(&self) -> bool {
        self.support.is_some()
            || !self.without.is_empty()
            || self.friction.is_some()
            || self.push.is_some()
            || self.units.is_some()
            || self.chord.is_some()
            || self.gap.is_some()
    }

    /// The coefficient of friction, where it is given.
    pub(super) fn friction(&self) -> Option<f64> {
        self.friction
    }

    fn options(&self, tolerance: Option<f64>) -> Result<DrawingOptions, Stop> {
        let default = DrawingOptions::default();
        let within = |name: &str, value: Option<f64>, unsaid: f64, low: f64, high: f64| {
            let value = value.unwrap_or(unsaid);
            if (low..=high).contains(&value) {
                return Ok(value);
            }
            let text =
                format!("error: --{name} {value}\nhelp: write a number from {low} to {high}");
            Err(Stop::bad_input(text))
        };
        if let Some(friction) = self.friction {
            within("friction", Some(friction), 0.0, 0.0, 1e12)?;
            if (10.5..90.0).contains(&friction) {
                let tangent = friction.to_radians().tan();
                tell!(
                    "warning: --friction {friction}: is this an angle? It is taken as tan φ; write \
                     {tangent:.3} for {friction} degrees"
                );
            }
        }
        Ok(DrawingOptions {
            support: self.support.clone(),
            without: self.without.clone(),
            tolerance: within("tolerance", tolerance, default.tolerance, 0.0, 0.01)?,
            gap: self.gap,
            chord: within("chord", self.chord, default.chord, 1e-6, 0.1)?,
            metres: self.units.map(Unit::metres),
            friction: self.friction,
            pushes: match self.push {
                None | Some(Ways::Right) => vec![Push::Right],
                Some(Ways::Left) => vec![Push::Left],
                Some(Ways::Both) => vec![Push::Right, Push::Left],
            },
            ..default
        })
    }

    /// The case of a drawing whose edges are healed within `tolerance`; tells on standard error what was
    /// taken for what, `all` of it or the first lines.
    pub(super) fn read(
        &self,
        argument: &str,
        tolerance: Option<f64>,
        all: bool,
    ) -> Result<Imported, Stop> {
        let bytes = read_input(Path::new(argument), Input::Table).map_err(|error| {
            let help = "check the path and its permissions";
            Stop::bad_input(format!(
                "error: cannot read {argument}: {error}\nhelp: {help}"
            ))
        })?;
        let imported = Case::from_drawing(argument, &bytes, &self.options(tolerance)?).map_err(
            |complaint| match is_of(argument, "dxf") {
                true => Stop::bad_input(format!("{complaint}\n{OPTIONS}")),
                false => Stop::bad_input(complaint.to_string()),
            },
        )?;
        let most = if all { usize::MAX } else { SHOWN };
        for remark in imported.remarks.iter().take(most) {
            tell!("{argument}: {remark}");
        }
        if let Some(more @ 1..) = imported.remarks.len().checked_sub(most) {
            tell!("{argument}: and {more} more; `trilith import {argument}` says all");
        }
        for warning in &imported.case.warnings {
            tell!("{warning}\n");
        }
        Ok(imported)
    }

    /// The case of a drawing that is to run, which needs a coefficient of friction.
    pub(super) fn case(&self, argument: &str) -> Result<Case, Stop> {
        if self.friction.is_none() {
            let text = format!(
                "error: {argument} says nothing about friction\nhelp: write `--friction 0.65`, \
                 or `trilith import {argument}` and fill it in"
            );
            return Err(Stop::bad_input(text));
        }
        Ok(self.read(argument, None, false)?.case)
    }
}
