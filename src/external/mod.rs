//! External methods: any program that reads a scene as JSON on standard input and writes its answer
//! as JSON on standard output, in the same tables and charts as the methods here.
//!
//! A program that crashes, hangs, floods its output or answers nonsense is a row like any other,
//! `failed` with the reason. One that hands over forces and velocities is judged like any other:
//! it can earn `verified`, and can be refuted.

mod answer;
mod compas;
mod list;
mod outside;
mod process;
mod reading;
mod scene;
mod states;

pub use answer::{AnswerFile, answer_schema};
pub(crate) use compas::compas;
pub use list::parse;
pub(crate) use list::read;
pub use process::External;
pub(crate) use process::stop_all;
pub use scene::{SceneFile, export, scene_schema};
pub(crate) use states::answers;
