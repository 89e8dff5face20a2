//! The program as its user meets it: commands, screens, files, messages.

#[path = "../long/mod.rs"]
mod long;
#[path = "../scenes/mod.rs"]
mod scenes;
#[path = "../share/mod.rs"]
mod share;
#[path = "../skipped/mod.rs"]
mod skipped;
#[path = "../svg/mod.rs"]
mod svg;

mod atlas;
mod bad_input;
mod chart;
mod command_line;
mod compas;
mod draw;
mod drawings;
mod external;
mod first_try;
mod inputs;
mod library_check;
mod malformed;
mod mistakes;
mod outputs;
mod outside_compared;
mod pages;
mod panics;
mod pictures;
mod readme;
mod report;
mod screens;
mod signals;
mod surveyed;
mod sweep;
mod witnesses;
mod words;
