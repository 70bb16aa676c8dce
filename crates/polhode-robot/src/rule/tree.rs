//! Links and joints.

use super::{Example, Rule};
use crate::finding::Severity::{Impossible, Note, Suspect};

const TREE: &str = "A robot is simulated from its root outwards: each link's motion is its parent's and its joint's. Where links do not make a \
                    tree, programs refuse the model. SDF may close loops, so it is a note there.";

pub(super) const RULES: [Rule; 10] = [
    Rule {
        code: "tree.cycle",
        severity: Impossible,
        title: "joints do not go round",
        why: TREE,
        mend: "Turn one of the joints round, or leave it out.",
        example: Some(Example {
            model: "<link name=\"base\"/>\n<link name=\"a\"/>\n<link name=\"b\"/>\n\
                    <joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>\n\
                    <joint name=\"k\" type=\"fixed\"><parent link=\"b\"/><child link=\"a\"/></joint>",
            old: "<parent link=\"b\"/>",
            new: "<parent link=\"base\"/>",
        }),
    },
    Rule {
        code: "tree.no_root",
        severity: Impossible,
        title: "one link, the root, hangs on no other",
        why: TREE,
        mend: "Leave out the joint that holds the root.",
        example: Some(Example {
            model: "<link name=\"a\"/>\n<link name=\"b\"/>\n\
                    <joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>\n\
                    <joint name=\"k\" type=\"fixed\"><parent link=\"b\"/><child link=\"a\"/></joint>",
            old: "\n<joint name=\"k\" type=\"fixed\"><parent link=\"b\"/><child link=\"a\"/></joint>",
            new: "",
        }),
    },
    Rule {
        code: "tree.two_roots",
        severity: Impossible,
        title: "one link alone hangs on no other",
        why: TREE,
        mend: "Join the parts, by a fixed joint where nothing moves.",
        example: Some(Example {
            model: "<link name=\"a\"/>\n<link name=\"b\"/>",
            old: "<link name=\"b\"/>",
            new: "<link name=\"b\"/>\n<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>",
        }),
    },
    Rule {
        code: "tree.two_parents",
        severity: Impossible,
        title: "a link hangs on one other",
        why: TREE,
        mend: "Leave one of the joints out; loops are closed in SDF, or by constraints of MJCF.",
        example: Some(Example {
            model: "<link name=\"a\"/>\n<link name=\"b\"/>\n<link name=\"c\"/>\n\
                    <joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>\n\
                    <joint name=\"k\" type=\"fixed\"><parent link=\"a\"/><child link=\"c\"/></joint>\n\
                    <joint name=\"m\" type=\"fixed\"><parent link=\"b\"/><child link=\"c\"/></joint>",
            old: "\n<joint name=\"m\" type=\"fixed\"><parent link=\"b\"/><child link=\"c\"/></joint>",
            new: "",
        }),
    },
    Rule {
        code: "tree.unknown_link",
        severity: Impossible,
        title: "a joint joins two links of the model",
        why: "A joint to nothing is refused. In SDF it may be a frame, or a link of a model that is included, so it is a note there.",
        mend: "Write the link's name as it stands in its <link>.",
        example: Some(Example {
            model: "<link name=\"a\"/>\n<link name=\"b\"/>\n\
                    <joint name=\"j\" type=\"fixed\"><parent link=\"A\"/><child link=\"b\"/></joint>",
            old: "link=\"A\"",
            new: "link=\"a\"",
        }),
    },
    Rule {
        code: "tree.duplicate_link",
        severity: Impossible,
        title: "links have names of their own",
        why: "Joints name links: of two with one name they mean the first, or the model is refused.",
        mend: "Rename one of them, and the joints that mean it.",
        example: Some(Example {
            model: "<link name=\"a\"/>\n<link name=\"a\"/>",
            old: "\n<link name=\"a\"/>",
            new: "",
        }),
    },
    Rule {
        code: "tree.duplicate_joint",
        severity: Impossible,
        title: "joints have names of their own",
        why: "Controllers name joints: of two with one name one cannot be driven, or the model is refused.",
        mend: "Rename one of them.",
        example: Some(Example {
            model: "<link name=\"a\"/>\n<link name=\"b\"/>\n<link name=\"c\"/>\n\
                    <joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>\n\
                    <joint name=\"j\" type=\"fixed\"><parent link=\"b\"/><child link=\"c\"/></joint>",
            old: "<joint name=\"j\" type=\"fixed\"><parent link=\"b\"/>",
            new: "<joint name=\"k\" type=\"fixed\"><parent link=\"b\"/>",
        }),
    },
    Rule {
        code: "tree.shared_name",
        severity: Note,
        title: "a link and a joint have two names",
        why: "libsdformat refuses one name for both since SDF 1.7, so it is suspect in SDF; a URDF with one name for both cannot become an SDF.",
        mend: "Rename the joint: elbow_joint.",
        example: Some(Example {
            model: "<link name=\"a\"/>\n<link name=\"b\"/>\n\
                    <joint name=\"b\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>",
            old: "<joint name=\"b\"",
            new: "<joint name=\"b_joint\"",
        }),
    },
    Rule {
        code: "tree.empty",
        severity: Impossible,
        title: "a robot has a link",
        why: "There is nothing to simulate, and programs refuse it.",
        mend: "Look whether xacro was expanded with the right arguments.",
        example: Some(Example {
            model: "<robot name=\"r\"></robot>",
            old: "></",
            new: "><link name=\"a\"/></",
        }),
    },
    Rule {
        code: "joint.axis",
        severity: Suspect,
        title: "what a joint turns about or slides along has a direction",
        why: "An axis of three zeros, or of numbers that are none, cannot be normalised: programs refuse it or divide by zero.",
        mend: "Write three finite numbers, not all zero.",
        example: Some(Example {
            model: "<link name=\"a\"/>\n<link name=\"b\"/>\n\
                    <joint name=\"j\" type=\"continuous\">\n  <parent link=\"a\"/><child link=\"b\"/>\n  <axis xyz=\"0 0 0\"/>\n</joint>",
            old: "0 0 0",
            new: "0 0 1",
        }),
    },
];
