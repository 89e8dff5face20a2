//! From the text of a file to a case and its scene.

mod arch;
mod blocks;
mod bodies;
mod bond;
mod case;
mod checks;
mod course_string;
mod courses;
mod csv;
mod doubts;
mod explain;
mod file;
mod forces;
mod form;
mod friction;
mod gaps;
mod leaves;
mod missing;
mod mistakes;
mod moves;
mod not_modelled;
mod outline;
mod own_blocks;
mod own_joints;
mod pieces;
mod references;
mod spreadsheet;
mod unknown_key;
mod values;
mod wall;

pub(crate) use checks::Written;
pub(crate) use explain::explain;
#[cfg(test)]
pub(super) use file::CASE_KEYS;
pub(crate) use values::read_by_visitor;
