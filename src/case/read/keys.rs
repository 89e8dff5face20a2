//! The keys of a case file.

/// The keys at the top of a case file, to tell a key in the wrong table from one that does not exist.
pub(super) const CASE_KEYS: [&str; 21] = [
    "title",
    "source",
    "unit",
    "courses",
    "repeat",
    "pieces",
    "bond",
    "units",
    "first",
    "overlap",
    "overburden",
    "arch",
    "blocks",
    "block",
    "support",
    "live",
    "load",
    "friction",
    "head_joints",
    "push",
    "references",
];
