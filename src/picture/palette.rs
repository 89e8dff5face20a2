//! Every colour of every picture. They are those of Okabe and Ito, and light tints of them, which
//! people with any kind of colour vision can tell apart; marks differ in shape or line style as well.

/// Text and the strongest lines.
pub const INK: &str = "#222";
pub const FAINT: &str = "#5f5b53";
/// Behind everything.
pub const WHITE: &str = "#fff";

/// What stands still.
pub const STILL: &str = "#eeece7";
/// The moving macro-block, and the largest part that moves.
pub const LARGEST: &str = PARTS[0];
/// Parts that move, the largest first.
pub const PARTS: [&str; 6] = [
    "#a9d4ee", "#f6cf86", "#93d1bb", "#e3b9d0", "#f4eea3", "#cfc4ea",
];
/// How far blocks move, from little to the most.
pub const SCALE: [&str; 8] = [
    "#f6f3d8", "#e9e6ae", "#d3dd9a", "#b3d194", "#8cc19a", "#66ada0", "#4a95a2", "#3b7c9c",
];
pub const BLOCK_LINE: &str = "#57534b";
/// Blocks where they were.
pub const BEFORE: &str = "#b9b4a8";
pub const SUPPORT: &str = "#cdc7bb";
pub const SUPPORT_LINE: &str = "#8b8475";
pub const SLIDING: &str = VERMILION;
pub const OPENING: &str = BLUE;
/// Joints with a friction of their own.
pub const FRICTION: &str = "#009e73";
/// Crack lines of c and e.
pub const CRACK: &str = "#7a3e9d";
pub const MACRO_CRACK: &str = "#000";
pub const FORCE: &str = "#b3006b";
pub const THRUST: &str = "#7a3e9d";
pub const SQUARE_LINE: &str = "#777";

/// Lines behind a plot.
pub const GRID: &str = "#dddddd";
/// The staircase of the fastest and most accurate settings.
pub const FRONT: &str = "#8a8a8a";
/// From a point to its name.
pub const LEADER: &str = "#888888";
/// Behind points without an answer.
pub const NO_ANSWER: &str = "#dd4444";

const BLUE: &str = "#0072b2";
const VERMILION: &str = "#d55e00";

/// A filled cell and the text on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tone {
    pub fill: &'static str,
    pub ink: &'static str,
}

const fn tone(fill: &'static str, ink: &'static str) -> Tone {
    Tone { fill, ink }
}

/// The tone of a share of the most, from 0 to 1; of nothing, that of no answer.
pub fn tone_of(share: Option<f64>) -> Tone {
    let Some(share) = share else {
        return REFUSED;
    };
    let step = (share * SCALE.len() as f64) as usize;
    let step = step.min(SCALE.len() - 1);
    // White on the two darkest.
    let ink = if step + 2 < SCALE.len() { INK } else { WHITE };
    tone(SCALE[step], ink)
}

/// What an answer turned out to be: right.
pub const RIGHT: Tone = tone("#9ed3b4", "#10331f");
/// Outside, without a claim.
pub const INACCURATE: Tone = tone("#f6d58a", "#4a3500");
pub const REFUSED: Tone = tone("#dcdcdc", "#444444");
pub const WRONG: Tone = tone("#c1121f", "#ffffff");
