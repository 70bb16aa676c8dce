//! Numbers.

use super::{Example, Rule};
use crate::finding::Severity::{Impossible, Suspect};

pub(super) const RULES: [Rule; 4] = [
    Rule {
        code: "number.malformed",
        severity: Impossible,
        title: "numbers are finite decimals with a point, without units",
        why: "Parsers stop at the first character that is none of a number's: 0,5 becomes 0, and 1kg is refused by some programs and read as 1 by \
              others.",
        mend: "Write a point for a comma, leave units out (kg, m and kg·m² are meant), and expand xacro before checking.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <inertial>\n    <mass value=\"1,7\"/>\n    \
                    <inertia ixx=\"0.031\" iyy=\"0.042\" izz=\"0.053\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n  </inertial>\n</link>",
            old: "1,7",
            new: "1.7",
        }),
    },
    Rule {
        code: "number.not_finite",
        severity: Impossible,
        title: "no number is infinite or NaN",
        why: "One NaN in a tensor makes the whole state of a simulation NaN after a step.",
        mend: "Export the link again; a CAD program prints NaN where a body has no volume.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <inertial>\n    <mass value=\"1.7\"/>\n    \
                    <inertia ixx=\"0.031\" iyy=\"0.042\" izz=\"nan\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n  </inertial>\n</link>",
            old: "nan",
            new: "0.053",
        }),
    },
    Rule {
        code: "number.missing",
        severity: Impossible,
        title: "an inertial has all its numbers",
        why: "Programs fill in what is missing, each in its own way: zero, one, or an error. In SDF there are defaults, so it is suspect there.",
        mend: "Write all six elements and the mass.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <inertial>\n    <mass value=\"1.7\"/>\n    \
                    <inertia ixx=\"0.031\" iyy=\"0.042\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n  </inertial>\n</link>",
            old: "ixy=",
            new: "izz=\"0.053\" ixy=",
        }),
    },
    Rule {
        code: "geometry.size",
        severity: Suspect,
        title: "sizes of shapes are positive numbers, in metres",
        why: "A shape without a size cannot be drawn or touched, and the inertia cannot be compared with it.",
        mend: "Write as many positive numbers as the shape has sizes.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <visual><geometry><box size=\"0.1 -0.2 0.3\"/></geometry></visual>\n</link>",
            old: "-0.2",
            new: "0.2",
        }),
    },
];
