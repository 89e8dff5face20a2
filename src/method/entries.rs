//! The one table that says everything about every method but how it works. A new method is one file
//! and one entry here; whoever needs to know something of a method asks this table.

use super::Method;
use super::auto::Auto;
use super::limit::{Associative, Bound, Interval, Sequential};
use super::macro_block::MacroBlock;
use super::pushover::Pushover;
use crate::scene::HeadJoints;

/// What a method's answers are claims about. Relations between methods follow from it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The range of a closed form for an assumed mechanism. It does not see head joints.
    ClosedForm,
    /// Bounds of λ_A, the multiplier of associative friction: no collapse multiplier is above it.
    AssociativeBounds,
    /// One collapse state without dilatancy, that an iteration converged to.
    CollapseState,
    /// The lowest and the highest collapse state without dilatancy that were found.
    CollapseStates,
    /// What was seen in an experiment: the last load at rest and the first that collapsed.
    Observed,
    /// A proved lower bound of every collapse state, and the lowest one verified.
    LowerBound,
    /// The lowest collapse state found and λ_A, made of other methods' answers.
    Enclosure,
    /// The answer of an outside program; it says itself what it is.
    Outside,
}

/// A mark in plots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the names say it")]
pub enum Mark {
    Square,
    Circle,
    Triangle,
    Diamond,
    TriangleDown,
    Star,
    Plus,
    Cross,
}

/// How a method looks in every plot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Look {
    /// Colour, `#rrggbb` (Okabe and Ito, for all eyes).
    pub colour: &'static str,
    pub mark: Mark,
}

pub const fn look(colour: &'static str, mark: Mark) -> Look {
    Look { colour, mark }
}

/// Rough CPU time of a method with default settings, which grows with a power of the blocks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// CPU seconds on paper-1 with open head joints, 33 blocks.
    pub of_33_blocks: f64,
    /// Exponent of growth in the number of blocks.
    pub growth: f64,
    /// How many times as long it takes with head joints in contact.
    pub contact: f64,
    /// Blocks beyond which it declines head joints in contact, at once.
    pub most_in_contact: usize,
    /// Share of it with head joints in contact that only one core can do, where others help with the rest.
    pub alone_in_contact: f64,
}

impl Cost {
    /// CPU seconds on a scene of so many blocks, roughly.
    pub fn seconds(self, blocks: usize, head_joints: HeadJoints) -> f64 {
        let open = self.of_33_blocks * (blocks.max(1) as f64 / 33.0).powf(self.growth);
        match head_joints {
            HeadJoints::Open => open,
            HeadJoints::Contact if blocks > self.most_in_contact => 0.0,
            HeadJoints::Contact => self.contact * open,
        }
    }

    /// Of these, those that no second core can take off.
    pub fn seconds_alone(self, blocks: usize, head_joints: HeadJoints) -> f64 {
        let share = match head_joints {
            HeadJoints::Open => 1.0,
            HeadJoints::Contact => self.alone_in_contact,
        };
        share * self.seconds(blocks, head_joints)
    }
}

/// Settings that are not as by default: names and values.
pub type Changes = &'static [(&'static str, &'static str)];

/// A rung of a method's ladder: its settings, and the scenes that are worth it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rung {
    /// What is not as by default.
    pub changes: Changes,
    pub scenes: Scenes,
    /// Whether it asks for less than the default does: an answer sooner, not a better one.
    pub loose: bool,
}

/// Scenes by their number of blocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scenes {
    All,
    /// Those of fewer than 200 blocks: on others the rung takes minutes.
    Small,
    /// Those of 200 blocks and more: on others the rung changes nothing.
    Large,
}

/// Blocks from which a scene is large.
const LARGE: usize = 200;

impl Scenes {
    /// Whether a scene of so many blocks is one of them.
    pub fn hold(self, blocks: usize) -> bool {
        match self {
            Scenes::All => true,
            Scenes::Small => blocks < LARGE,
            Scenes::Large => blocks >= LARGE,
        }
    }
}

const fn all(changes: Changes) -> Rung {
    Rung {
        changes,
        scenes: Scenes::All,
        loose: false,
    }
}

const fn small(changes: Changes) -> Rung {
    Rung {
        scenes: Scenes::Small,
        ..all(changes)
    }
}

const fn large(changes: Changes) -> Rung {
    Rung {
        scenes: Scenes::Large,
        ..all(changes)
    }
}

/// For all scenes, and looser than the default.
const fn loose(changes: Changes) -> Rung {
    Rung {
        loose: true,
        ..all(changes)
    }
}

/// One method with everything that others need to know of it.
pub struct MethodEntry {
    pub method: &'static dyn Method,
    /// What it is, in one line.
    pub summary: &'static str,
    /// What its answers claim.
    pub kind: Kind,
    /// Whether it runs where no method is named.
    pub by_default: bool,
    /// Whether its drawing is among those that are shown first (the paper's Figs. 4 and 5).
    pub drawn_first: bool,
    /// Its colour and mark.
    pub look: Look,
    /// Its CPU time, measured on the paper's walls of 33, 55 and 1176 blocks.
    pub cost: Cost,
    /// Settings that the chart runs it with beside the default, from cheap to dear.
    pub ladder: &'static [Rung],
}

impl MethodEntry {
    /// The method's name.
    pub fn name(&self) -> &'static str {
        self.method.name()
    }
}

const fn cost(of_33_blocks: f64, growth: f64, contact: f64) -> Cost {
    Cost {
        of_33_blocks,
        growth,
        contact,
        most_in_contact: usize::MAX,
        alone_in_contact: 1.0,
    }
}

/// Costs of the pushover: with head joints in contact it is a range of eight, which it does not begin
/// on its own where these would take long.
const PUSHOVER_COST: Cost = Cost {
    most_in_contact: 800,
    alone_in_contact: 0.6,
    ..cost(0.07, 1.7, 8.0)
};

/// Every method, in the order in which tables show them.
pub static METHODS: &[MethodEntry] = &[
    MethodEntry {
        method: &MacroBlock,
        summary: "closed form: one crack, two bodies; λ_low without and λ_upp with all friction \
                  along it",
        kind: Kind::ClosedForm,
        by_default: true,
        drawn_first: true,
        look: look("#999999", Mark::Square),
        cost: cost(1e-5, 0.0, 1.0),
        ladder: &[],
    },
    MethodEntry {
        method: &Associative,
        summary: "limit analysis with dilatant friction: an upper bound of every collapse multiplier",
        kind: Kind::AssociativeBounds,
        by_default: true,
        drawn_first: false,
        look: look("#0072B2", Mark::Circle),
        cost: cost(4e-4, 1.2, 2.0),
        ladder: &[
            loose(&[("lp-tolerance", "1e-2")]),
            loose(&[("lp-tolerance", "1e-4")]),
            loose(&[("lp-tolerance", "1e-6")]),
            loose(&[("lp-tolerance", "1e-8")]),
            all(&[("engine", "clarabel")]),
            large(&[("reduction", "false")]),
        ],
    },
    MethodEntry {
        method: &Sequential,
        summary: "the published sequence of linear programs for friction without dilatancy; no proof",
        kind: Kind::CollapseState,
        by_default: true,
        drawn_first: false,
        look: look("#E69F00", Mark::Triangle),
        cost: cost(3e-3, 1.6, 2.0),
        ladder: &[
            all(&[("alpha", "0.1")]),
            small(&[("beta", "0.3")]),
            small(&[("c0", "1e-4")]),
            loose(&[("lp-tolerance", "1e-6")]),
            all(&[("engine", "clarabel")]),
        ],
    },
    MethodEntry {
        method: &Interval,
        summary: "lowest and highest collapse state that a search finds; both are verified, and \
                  they are no bounds",
        kind: Kind::CollapseStates,
        by_default: true,
        drawn_first: true,
        look: look("#009E73", Mark::Diamond),
        cost: cost(0.4, 0.9, 2.0),
        ladder: &[
            loose(&[("starts", "1")]),
            small(&[("starts", "4")]),
            small(&[("starts", "8")]),
            small(&[("starts", "16")]),
            all(&[("engine", "clarabel")]),
            large(&[("reduction", "false")]),
        ],
    },
    MethodEntry {
        method: &Pushover,
        summary: "rigid bodies in contact, pushed harder until they collapse: the last load at rest \
                  and the first that collapses",
        kind: Kind::Observed,
        by_default: true,
        drawn_first: true,
        look: look("#D55E00", Mark::TriangleDown),
        cost: PUSHOVER_COST,
        ladder: &[
            loose(&[("accuracy", "coarse")]),
            small(&[("accuracy", "fine")]),
            loose(&[("substep", "4")]),
            loose(&[("substep", "2")]),
            all(&[("stiffness", "0.25")]),
        ],
    },
    MethodEntry {
        method: &Auto,
        summary: "cheap methods first, until the answer is certain: λ_A and the lowest collapse \
                  state found",
        kind: Kind::Enclosure,
        // It is made of the others and would only repeat them.
        by_default: false,
        drawn_first: false,
        look: look("#CC79A7", Mark::Star),
        cost: cost(0.15, 0.9, 2.0),
        ladder: &[
            loose(&[("tolerance", "0.05")]),
            small(&[("tolerance", "0.001")]),
        ],
    },
    MethodEntry {
        method: &Bound,
        summary: "a proved lower bound of every collapse state, beside the lowest one verified",
        kind: Kind::LowerBound,
        // A lift takes seconds to minutes, and only small scenes have one.
        by_default: false,
        drawn_first: false,
        look: look("#F0E442", Mark::Plus),
        cost: cost(60.0, 4.0, 1.0),
        ladder: &[],
    },
];

/// How outside programs look, in their order; the last look is for all further ones.
const OUTSIDE: [Look; 2] = [look("#000000", Mark::Plus), look("#56B4E9", Mark::Cross)];

/// A program of which nothing is known counts as long.
const OUTSIDE_COST: Cost = cost(0.5, 1.4, 1.0);

/// The entry of this name; `None` for an outside program.
pub fn entry(name: &str) -> Option<&'static MethodEntry> {
    METHODS.iter().find(|entry| entry.name() == name)
}

/// What the answers of the method of this name claim.
pub fn kind(name: &str) -> Kind {
    entry(name).map_or(Kind::Outside, |entry| entry.kind)
}

/// Rough CPU time of the method of this name.
pub fn expected_cost(name: &str) -> Cost {
    entry(name).map_or(OUTSIDE_COST, |entry| entry.cost)
}

/// Colour and mark of the method of this name; `outside` counts the outside programs of the plot
/// before it.
pub fn method_look(name: &str, outside: usize) -> Look {
    let other = OUTSIDE[outside.min(OUTSIDE.len() - 1)];
    entry(name).map_or(other, |entry| entry.look)
}

/// Every method, in the order of the table.
pub fn methods() -> Vec<&'static dyn Method> {
    METHODS.iter().map(|entry| entry.method).collect()
}

/// Every method but proofs of a lower bound, which take minutes on walls of twenty blocks.
pub fn without_lower_bounds() -> Vec<&'static dyn Method> {
    let wanted = METHODS
        .iter()
        .filter(|entry| entry.kind != Kind::LowerBound);
    wanted.map(|entry| entry.method).collect()
}

/// The methods of a run that names none.
pub fn defaults() -> Vec<&'static dyn Method> {
    let wanted = METHODS.iter().filter(|entry| entry.by_default);
    wanted.map(|entry| entry.method).collect()
}

#[cfg(test)]
mod tests {
    use super::super::Settings;
    use super::*;

    #[test]
    fn every_entry_is_complete_and_its_own() {
        for (index, one) in METHODS.iter().enumerate() {
            assert!(!one.summary.is_empty());
            assert_ne!(one.kind, Kind::Outside, "{}", one.name());
            for other in &METHODS[..index] {
                assert_ne!(one.name(), other.name());
                assert_ne!(one.look, other.look, "{} {}", one.name(), other.name());
            }
        }
        assert!(defaults().len() < METHODS.len());
        assert_eq!(kind("no-such"), Kind::Outside);
    }

    #[test]
    fn every_rung_can_be_set() {
        for entry in METHODS {
            for rung in entry.ladder {
                let mut settings = Settings::default();
                for (name, value) in rung.changes {
                    settings.set(name, value).unwrap();
                }
                assert_ne!(settings, Settings::default(), "{}", entry.name());
            }
        }
    }
}
