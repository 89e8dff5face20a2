//! The library: every embedded case, read.

use std::path::Path;

use super::embedded::embedded;
use super::unread::UnreadCase;
use crate::case::model::Case;

/// The walls of the paper's Table 1.
const PAPER: [&str; 3] = ["paper-1", "paper-2", "paper-3"];

/// The three walls of the paper's Table 1.
pub fn paper() -> Vec<Case> {
    PAPER.map(named).into()
}

/// Every embedded case.
pub fn library() -> Vec<Case> {
    embedded().map(read).collect()
}

/// The embedded case of this name.
fn named(name: &str) -> Case {
    let is_named = |path: &str| Path::new(path).file_stem().is_some_and(|stem| stem == name);
    let case = embedded().find(|(path, _)| is_named(path));
    read(case.expect("a test looks for it"))
}

fn read(embedded: (&str, &str)) -> Case {
    let case = UnreadCase::embedded(embedded).read();
    // A test reads every one.
    case.unwrap_or_else(|complaint| panic!("{complaint}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::HeadJoints;

    #[test]
    fn every_case_says_where_it_and_its_references_come_from() {
        let cases = library();
        let references: Vec<_> = cases.iter().flat_map(|case| &case.references).collect();
        assert!(references.len() >= cases.len(), "{}", references.len());
        assert!(cases.iter().all(|case| !case.source.trim().is_empty()));
        assert!(references.iter().all(|r| !r.source.trim().is_empty()));
        // What this project computes is never a reference.
        assert!(references.iter().all(|r| !r.source.contains("trilith")));
    }

    #[test]
    fn the_papers_walls_have_the_papers_sizes() {
        let cases = paper();
        let names: Vec<&str> = cases.iter().map(|case| case.name.as_str()).collect();
        assert_eq!(names, ["paper-1", "paper-2", "paper-3"]);
        let sizes: Vec<(usize, usize)> = cases
            .iter()
            .map(|case| case.scene(HeadJoints::Contact))
            .map(|scene| (scene.blocks().len(), scene.joints().len()))
            .collect();
        assert_eq!(sizes, [(33, 83), (55, 141), (1176, 3409)]);
        assert!(
            cases
                .iter()
                .all(|case| case.scene(case.head_joints[1]).regular().is_ok())
        );
    }

    #[test]
    fn openings_have_the_published_numbers_of_blocks_and_joints() {
        for (name, blocks, joints) in [("openings-3", 46, 102), ("openings-4", 55, 116)] {
            let scene = named(name).scene(HeadJoints::Contact);
            assert_eq!(
                (scene.blocks().len(), scene.joints().len()),
                (blocks, joints)
            );
        }
    }
}
