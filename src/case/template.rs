//! The case that `trilith new NAME` writes.

/// A small wall that runs as it is, with every key explained.
pub fn template(name: &str) -> String {
    // What would end the string or is not to be seen has no place in a title.
    let title: String = name
        .chars()
        .filter(|c| !c.is_control() && !"\"\\".contains(*c))
        .collect();
    TEMPLATE.replace("NAME", &title)
}

const TEMPLATE: &str = r#"# A case for trilith: one dry-joint wall, pushed sideways until it collapses.
# It runs as it stands: `trilith run NAME.toml`. Everything behind a # is a remark.

title = "NAME"
# Where the wall comes from.
source = "the template"

# One full unit, and the weight of one; any one consistent system of lengths and forces.
# `thickness = 1.0` may be added; results do not depend on it, nor on the weight.
unit = { length = 4.0, height = 1.75, weight = 1.0 }

# Courses from bottom to top. In a course `1` is a unit, `h` half a unit, `g` a gap one unit wide;
# `1*24` is 24 units, and spaces are allowed between pieces.
courses = ["h11h", "111"]
# The list of courses is laid this many times (1 if left out).
repeat = 2

# A regular bond needs no strings. These lines, instead of the two above, give the same wall:
# bond = "running"      # or "stack": units directly above each other
# courses = 4
# units = 3             # width in full units
# first = "half"        # or "whole": which course is at the bottom

# Coefficient of friction (tan φ) of every joint.
friction = 0.65

# Overburden p on top of the wall, as the ratio p / (γ H) to the wall's own weight (0 if left out).
overburden = 0.0

# What the vertical joints carry: "contact" (friction, if left out), "open" (nothing), or "both",
# which runs every method on both.
head_joints = "contact"

# Which way the wall is pushed: "right" (if left out), "left", or "both", which reports the weaker
# side.
push = "right"

# Values to compare with, as many as there are; remove the # to use one. A result further away
# than the tolerance, which is absolute, is reported, and the exit status is 1.
# [[references]]
# method = "associative"      # macro-block, associative, sequential, interval, pushover, auto
# head_joints = "contact"     # only for this setting (for every one if left out)
# quantity = "lambda"         # lambda, lower, upper, tan_beta, c, e
# value = 0.6667
# tolerance = 0.00005
# source = "Table 1 of ..."
# kind = "published"          # or "analytic" (exact), "independent" (another code)
# note = "a remark"           # may be left out
# deviation = "the reason"    # only if the value is known not to be met
"#;

#[cfg(test)]
mod tests {
    use super::template;
    use crate::case::Case;
    use crate::scene::{HeadJoints, Push};

    fn read(text: &str) -> Case {
        Case::read("new.toml", text.as_bytes()).unwrap_or_else(|complaint| panic!("{complaint}"))
    }

    #[test]
    fn the_template_runs_as_it_stands() {
        let case = read(&template("garden"));
        assert_eq!(case.title, "garden");
        assert_eq!(case.head_joints, [HeadJoints::Contact]);
        assert_eq!(case.pushes, [Push::Right]);
        assert_eq!(case.scene(HeadJoints::Contact).blocks.len(), 14);
        assert!(case.scene(HeadJoints::Contact).regular.is_ok());
    }

    #[test]
    fn its_remarks_are_true() {
        let text = template("garden");
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
            .replace(strings, "")
            .replace("repeat = 2", "");
        assert_eq!(read(&bond).geometry, read(&text).geometry);
    }

    #[test]
    fn no_name_breaks_it() {
        assert_eq!(read(&template("a\"b\\c\nd")).title, "abcd");
    }
}
