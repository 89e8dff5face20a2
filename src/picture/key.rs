//! The legend of drawings: what occurs in them, and nothing else.

use super::axes::round_below;
use super::legend::{LegendEntry, Sample};
use super::mechanism::Occurring;
use super::palette::{
    BEFORE, CRACK, FORCE, FRICTION, INK, MACRO_CRACK, SCALE, SLIDING, STILL, SUPPORT, THRUST,
};
use super::svg::style;
use crate::number::short;

/// What drawings hold, which their legend explains.
#[derive(Clone, Debug, Default)]
pub struct Holds {
    /// Marks of a mechanism.
    pub mechanism: Occurring,
    /// Whether there is a mechanism at all.
    pub moved: bool,
    /// Supports.
    pub supports: bool,
    /// Coefficients of friction that joints have of their own.
    pub frictions: Vec<f64>,
    /// The lines of c and e.
    pub crack: bool,
    /// The crack of the macro-block model.
    pub macro_crack: bool,
    /// A round force, and the pixels of its arrow.
    pub force: Option<(f64, f64)>,
}

impl Holds {
    /// What either holds.
    pub fn and(mut self, other: Holds) -> Self {
        let Occurring {
            still,
            tints,
            scale,
            slides,
            opens,
        } = other.mechanism;
        let own = &mut self.mechanism;
        own.still |= still;
        own.scale |= scale;
        own.slides |= slides;
        own.opens |= opens;
        for friction in other.frictions {
            if !self.frictions.contains(&friction) {
                self.frictions.push(friction);
            }
        }
        for tint in tints {
            if !own.tints.contains(&tint) {
                own.tints.push(tint);
            }
        }
        Holds {
            moved: self.moved || other.moved,
            supports: self.supports || other.supports,
            frictions: self.frictions,
            crack: self.crack || other.crack,
            macro_crack: self.macro_crack || other.macro_crack,
            force: self.force.or(other.force),
            mechanism: self.mechanism,
        }
    }
}

/// The entries that explain what is there, with the length that is drawn so many pixels long.
pub fn entries(holds: &Holds, scale: f64) -> Vec<LegendEntry> {
    let line = |colour: &str, width: f64| style().hollow().stroke(colour).stroke_width(width);
    let mut entries = Vec::new();
    let mut add = |sample, words: &str| entries.push(LegendEntry::new(sample, words));
    let occurs = &holds.mechanism;
    if holds.supports {
        add(Sample::Shade(SUPPORT, 1.0), "support");
    }
    if occurs.still {
        add(Sample::Tints(vec![STILL]), "stands still");
    }
    match occurs.tints.as_slice() {
        [] => {}
        [one] => add(Sample::Tints(vec![one]), "moves as one body"),
        several => {
            add(Sample::Tints(several.to_vec()), "a tint moves as one body");
        }
    }
    if occurs.scale {
        let ends = ["0".to_owned(), "100 %".to_owned()];
        add(Sample::Scale(&SCALE, ends), "of the largest displacement");
    }
    if occurs.slides {
        add(Sample::Haloed(line(SLIDING, 2.4)), "joint slides");
    }
    if occurs.opens {
        add(Sample::Gap, "joint opens");
    }
    if !holds.frictions.is_empty() {
        let all = holds.frictions.iter().map(f64::to_string);
        let words = format!("joint with friction {}", all.collect::<Vec<_>>().join(", "));
        add(Sample::Line(line(FRICTION, 2.0).dashes("5 3")), &words);
    }
    if holds.moved {
        add(Sample::Line(line(BEFORE, 1.2)), "before");
    }
    if holds.crack {
        add(Sample::Line(line(CRACK, 1.4)), "crack of c and e");
    }
    if holds.macro_crack {
        let dashes = line(MACRO_CRACK, 1.5).dashes("7 4");
        add(Sample::Line(dashes), "macro-block crack");
    }
    if let Some((force, pixels)) = holds.force {
        let words = format!(
            "contact force of {}, on the block that it points into",
            short(force, 9)
        );
        add(Sample::Arrow(FORCE, pixels), &words);
        let words = "line of thrust, or resultants on the courses";
        add(Sample::Line(line(THRUST, 1.2)), words);
    }
    let length = round_below(LENGTH / scale);
    let words = format!("{} units of length", short(length, 9));
    add(Sample::Length(INK, length * scale), &words);
    entries
}

/// Pixels that the length of the legend is long, at most.
const LENGTH: f64 = 60.0;
