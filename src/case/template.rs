//! The cases that `trilith new NAME` writes.

use super::reference::{Quantity, known_method_names};
use crate::scene::{BONDS, Bond, LowestCourse};

/// The forms of a case that there is a template of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Template {
    Wall,
    Blocks,
    Arch,
}

impl Template {
    /// A small case of this form that runs as it is, with every key explained.
    pub fn text(self, name: &str) -> String {
        let form = match self {
            Template::Wall => include_str!("templates/wall.toml"),
            Template::Blocks => include_str!("templates/blocks.toml"),
            Template::Arch => include_str!("templates/arch.toml"),
        };
        // What would end the string or is not to be seen has no place in a title.
        let title: String = name
            .chars()
            .filter(|c| !c.is_control() && !"\"\\".contains(*c))
            .collect();
        let methods: Vec<&str> = known_method_names().collect();
        let quantities = Quantity::ALL.map(Quantity::name);
        let references = include_str!("templates/references.txt")
            .replace("METHODS", &methods.join(", "))
            .replace("QUANTITIES", &quantities.join(", "));
        let form = form
            .replace("OTHER_BONDS", &other_bonds())
            .replace("# LOWEST_COURSES\n", &lowest_courses());
        (form + &references).replace("NAME", &title)
    }
}

/// The bonds but the first, which the template itself lays.
fn other_bonds() -> String {
    let names = BONDS
        .iter()
        .skip(1)
        .map(|bond| format!("\"{}\"", bond.name));
    names.collect::<Vec<_>>().join(", ")
}

/// What the lowest course can be in those, a remark a bond.
fn lowest_courses() -> String {
    let remark = |bond: &Bond| {
        let LowestCourse { cut, whole, .. } = bond.lowest.as_ref()?;
        Some(format!(
            "#                       # {}: \"{cut}\" or \"{whole}\"\n",
            bond.name
        ))
    };
    BONDS.iter().skip(1).filter_map(remark).collect()
}

#[cfg(test)]
mod tests {
    use super::Template;
    use crate::case::model::Case;
    use crate::case::read::CASE_KEYS;
    use crate::scene::{HeadJoints, Push};

    fn read(text: &str) -> Case {
        Case::read("new.toml", text.as_bytes()).unwrap_or_else(|complaint| panic!("{complaint}"))
    }

    #[test]
    fn the_template_runs_as_it_stands() {
        let case = read(&Template::Wall.text("garden"));
        assert_eq!(case.title, "garden");
        assert_eq!(case.head_joints, [HeadJoints::Contact]);
        assert_eq!(case.pushes, [Push::Right]);
        assert_eq!(case.scene(HeadJoints::Contact).blocks().len(), 14);
        assert!(case.scene(HeadJoints::Contact).regular().is_ok());
    }

    #[test]
    fn its_remarks_are_true() {
        let text = Template::Wall.text("garden");
        let (head, reference) = text.split_once("# [[references]]\n").unwrap();
        let reference = reference.replace("\n# ", "\n");
        let case = read(&format!("{head}[[references]]\n{}", &reference[2..]));
        assert_eq!(case.references.len(), 1);
        let strings = "courses = [\"h11h\", \"111\"]";
        let bond = text
            .replace("# bond", "bond")
            .replace("# courses", "courses")
            .replace("# units", "units")
            .replace("# first", "first")
            .replace("# overlap", "overlap")
            .replace(strings, "")
            .replace("repeat = 2", "");
        assert_eq!(read(&bond).geometry, read(&text).geometry);
    }

    #[test]
    fn every_key_of_a_case_is_explained_in_some_template() {
        let texts = [Template::Wall, Template::Blocks, Template::Arch].map(|t| t.text("garden"));
        for key in CASE_KEYS {
            let (value, table) = (format!("{key} = "), format!("[{key}]"));
            let explains = |text: &String| text.contains(&value) || text.contains(&table);
            assert!(texts.iter().any(explains), "{key}");
        }
    }

    #[test]
    fn no_name_breaks_it() {
        assert_eq!(read(&Template::Wall.text("a\"b\\c\nd")).title, "abcd");
    }

    #[test]
    fn remarks_about_single_courses_joints_and_blocks_are_true() {
        let mut text = Template::Wall.text("garden");
        for key in [
            "heights",
            "open_head_joints",
            "joints",
            "          { between",
        ] {
            let remark = format!("# {key}");
            assert!(text.contains(&remark), "{key}");
            text = text.replace(&remark, key);
        }
        let scene = read(&text).scene(HeadJoints::Contact);
        let rough = |friction: f64| {
            let mut joints = scene.joints().iter();
            joints.any(|joint| joint.friction == friction)
        };
        assert!(rough(0.3) && rough(0.4));
        assert_eq!(scene.left_out(), 2);
        let text = Template::Blocks.text("garden");
        let (head, joint) = text.split_once("# [[joint]]\n").unwrap();
        let (joint, _) = joint.split_once("\n\n").unwrap();
        let joint = joint.replace("# ", "");
        let block = "specific_weight = 2.0\nfriction = 0.5\n";
        let head = head.replace("# specific_weight = 2.0", block);
        let scene = read(&format!("{head}[[joint]]\n{joint}")).scene(HeadJoints::Contact);
        assert_eq!(scene.left_out(), 1);
        assert_eq!(scene.joints()[2].friction, 0.5);
    }

    #[test]
    fn remarks_about_loads_are_true() {
        let text = Template::Arch.text("garden");
        let (head, load) = text.split_once("# [[load]]\n").unwrap();
        let (load, _) = load.split_once("\n\n").unwrap();
        let load = load.replace("\n# ", "\n");
        let case = read(&format!("{head}[[load]]\n{}", &load[2..]));
        let scene = case.scene(HeadJoints::Contact);
        let loads: usize = scene.blocks().iter().map(|block| block.loads.len()).sum();
        assert_eq!(loads, scene.blocks().len() + 1);
        let text = Template::Blocks.text("garden");
        let along = "along = [[0.0, 4.0], [4.0, 4.0]]";
        let line = text.replace("at = [2.0, 4.0] ", &format!("{along} #"));
        let force = |text: &str| read(text).scene(HeadJoints::Contact).total_live();
        assert_eq!(force(&line), force(&text) + 3.0);
    }
}
