//! Words for what real walls have and no method here models. The keys are known, so that nobody takes
//! the answer for one that counts them in, and the message says what comes nearest.

pub(crate) struct NotModelled {
    /// The key that the list of the README names.
    pub key: &'static str,
    other_words: &'static [&'static str],
    /// What it is, to stand before "is not modelled".
    pub what: &'static str,
    /// What to write instead.
    pub nearest: &'static str,
}

/// All of them.
pub(crate) const NOT_MODELLED: &[NotModelled] = &[
    NotModelled {
        key: "cohesion",
        other_words: &["adhesion", "mortar", "bond_strength"],
        what: "cohesion of joints",
        nearest: "leave it out: joints are dry, and hold by friction alone",
    },
    NotModelled {
        key: "tension",
        other_words: &["tensile_strength", "ft", "f_t"],
        what: "tensile strength of joints",
        nearest: "leave it out: joints open without resistance",
    },
    NotModelled {
        key: "tie",
        other_words: &[
            "ties", "anchor", "anchors", "chain", "tie_rod", "rod", "cramp", "dowel",
        ],
        what: "a tie",
        nearest: "its force, where you know it, is a pair of dead `[[load]]`s on the blocks that it \
                  holds",
    },
    NotModelled {
        key: "settlement",
        other_words: &["settlements", "displacement", "displacements", "spreading"],
        what: "a support's motion by an amount",
        nearest: "write a `[[move]]` for the support: its reaction as it begins to move, and which joints \
                  open",
    },
    NotModelled {
        key: "holes",
        other_words: &["hole", "void", "voids", "cavity", "interiors"],
        what: "a hole in a block",
        nearest: "cut the block into two through the hole, each with an outline of its own",
    },
    NotModelled {
        key: "compressive_strength",
        other_words: &["strength", "crushing", "fc", "f_c", "fm", "f_m"],
        what: "crushing",
        nearest: "leave it out: blocks are rigid and do not break; a shorter block keeps the toe from \
                  the edge",
    },
    NotModelled {
        key: "stiffness",
        other_words: &[
            "young",
            "modulus",
            "elasticity",
            "youngs_modulus",
            "poisson",
            "kn",
            "ks",
        ],
        what: "elasticity of blocks and joints",
        nearest: "leave it out: blocks are rigid, and the collapse multiplier of rigid blocks needs no \
                  stiffness",
    },
    NotModelled {
        key: "dilatancy",
        other_words: &["dilatancy_angle", "psi"],
        what: "a dilatancy between none and the friction angle",
        nearest: "leave it out: `associative` has the friction angle, `sequential`, `interval` and \
                  `pushover` have none",
    },
    NotModelled {
        key: "acceleration",
        other_words: &[
            "accelerogram",
            "ground_motion",
            "spectrum",
            "earthquake",
            "time_history",
        ],
        what: "motion of the ground in time",
        nearest: "leave it out: the live load is static, every weight sideways times the multiplier, and \
                  with `live = { weight = [1, 0.3] }` 0.3 of it upwards too",
    },
];

/// What a key stands for that is not modelled.
pub(super) fn not_modelled(key: &str) -> Option<&'static NotModelled> {
    let key = key.to_lowercase();
    let is = |entry: &&NotModelled| entry.key == key || entry.other_words.contains(&key.as_str());
    NOT_MODELLED.iter().find(is)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_readme_lists_them_and_no_word_stands_for_two() {
        let readme = include_str!("../../../README.md");
        let mut words = std::collections::HashSet::new();
        for entry in NOT_MODELLED {
            let key = format!("`{}`", entry.key);
            assert!(readme.contains(&key), "{key}");
            assert!(words.insert(entry.key), "{key}");
            for word in entry.other_words {
                assert!(words.insert(word), "{word}");
            }
        }
    }
}
