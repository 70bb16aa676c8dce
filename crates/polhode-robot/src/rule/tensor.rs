//! Tensors, by their own numbers.

use super::{Example, Rule};
use crate::finding::Severity::{Impossible, Note, Suspect};

pub(super) const RULES: [Rule; 7] = [
    Rule {
        code: "inertia.triangle",
        severity: Impossible,
        title: "two principal moments are together no less than the third",
        why: "i1 + i2 − i3 is twice the integral of a square over the body's mass, so it is not negative. No mass distribution has such a tensor; \
              programs refuse it (Drake, Gazebo, MuJoCo) or gain energy from it. What rounding of the printed digits explains is no finding.",
        mend: "Look for a wrong power of ten in one element, a wrong order of the six, or another unit; a fix is written where the link's geometry confirms it.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <inertial>\n    <mass value=\"1.7\"/>\n    \
                    <inertia ixx=\"0.031\" iyy=\"0.042\" izz=\"0.53\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n  </inertial>\n</link>",
            old: "0.53",
            new: "0.053",
        }),
    },
    Rule {
        code: "inertia.negative",
        severity: Impossible,
        title: "no principal moment is negative",
        why: "A moment of inertia is the integral of a square distance. With a negative one a torque turns a body the wrong way.",
        mend: "Look at the products: those of another link, or of another unit, beside right moments do this.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <inertial>\n    <mass value=\"1.7\"/>\n    \
                    <inertia ixx=\"0.031\" iyy=\"0.042\" izz=\"0.053\" ixy=\"0.91\" ixz=\"0\" iyz=\"0\"/>\n  </inertial>\n</link>",
            old: "0.91",
            new: "0.0091",
        }),
    },
    Rule {
        code: "inertia.zero",
        severity: Impossible,
        title: "what has mass and a size has moments of inertia",
        why: "Only a point has none. A joint that turns such a link divides by zero; fixed to another link it may be meant, so it is suspect there.",
        mend: "Write the moments with more digits: 0.000000 is what a small part prints as.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <inertial>\n    <mass value=\"1.7\"/>\n    \
                    <inertia ixx=\"0\" iyy=\"0\" izz=\"0\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n  </inertial>\n</link>",
            old: "ixx=\"0\" iyy=\"0\" izz=\"0\"",
            new: "ixx=\"0.031\" iyy=\"0.042\" izz=\"0.053\"",
        }),
    },
    Rule {
        code: "inertia.rounding",
        severity: Note,
        title: "a tensor has the digits that show it to be possible",
        why: "As printed it breaks the triangle inequality, and a tensor that rounds to it does not: a thin plate with few digits. A program that \
              tests strictly refuses it.",
        mend: "Export with more digits.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <inertial>\n    <mass value=\"1.7\"/>\n    \
                    <inertia ixx=\"0.0012\" iyy=\"0.0011\" izz=\"0.0024\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n  </inertial>\n</link>",
            old: "ixx=\"0.0012\" iyy=\"0.0011\" izz=\"0.0024\"",
            new: "ixx=\"0.001243\" iyy=\"0.001132\" izz=\"0.002371\"",
        }),
    },
    Rule {
        code: "inertia.asymmetric",
        severity: Suspect,
        title: "a tensor is symmetric",
        why: "Programs read the elements above the diagonal alone, so those below it say something that nobody reads.",
        mend: "Leave iyx, izx and izy out.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <inertial>\n    <mass value=\"1.7\"/>\n    \
                    <inertia ixx=\"0.031\" iyy=\"0.042\" izz=\"0.053\" ixy=\"0.001\" iyx=\"0.002\" ixz=\"0\" iyz=\"0\"/>\n  \
                    </inertial>\n</link>",
            old: "iyx=\"0.002\" ",
            new: "",
        }),
    },
    Rule {
        code: "inertia.two_forms",
        severity: Suspect,
        title: "a tensor is given in one form",
        why: "MuJoCo refuses fullinertia beside diaginertia or an attitude of the inertial.",
        mend: "Keep fullinertia, or diaginertia with an attitude.",
        example: Some(Example {
            model: "<mujoco>\n  <worldbody>\n    <body name=\"arm\">\n      \
                    <inertial pos=\"0 0 0\" mass=\"1.7\" fullinertia=\"0.031 0.042 0.053 0.001 0 0\" quat=\"0.8 0.6 0 0\"/>\n    \
                    </body>\n  </worldbody>\n</mujoco>",
            old: " quat=\"0.8 0.6 0 0\"",
            new: "",
        }),
    },
    Rule {
        code: "inertia.mirrored_pair",
        severity: Suspect,
        title: "mirror images have mirrored products of inertia",
        why: "Of a body mirrored along x, ixy and ixz change their signs; along y, ixy and iyz; along z, ixz and iyz. A left link that was copied \
              to the right keeps them.",
        mend: "Change the signs of the products that hold the mirrored axis.",
        example: Some(Example {
            model: "<link name=\"left_hip\">\n  <inertial>\n    <origin xyz=\"0.04 0.05 -0.02\"/>\n    <mass value=\"1.7\"/>\n    \
                    <inertia ixx=\"0.031\" iyy=\"0.042\" izz=\"0.053\" ixy=\"0.004\" ixz=\"0.003\" iyz=\"0.002\"/>\n  </inertial>\n</link>\n\
                    <link name=\"right_hip\">\n  <inertial>\n    <origin xyz=\"0.04 -0.05 -0.02\"/>\n    <mass value=\"1.7\"/>\n    \
                    <inertia ixx=\"0.031\" iyy=\"0.042\" izz=\"0.053\" ixy=\"+0.004\" ixz=\"0.003\" iyz=\"+0.002\"/>\n  </inertial>\n</link>\n\
                    <joint name=\"hips\" type=\"fixed\"><parent link=\"left_hip\"/><child link=\"right_hip\"/></joint>",
            old: "ixy=\"+0.004\" ixz=\"0.003\" iyz=\"+0.002\"",
            new: "ixy=\"-0.004\" ixz=\"0.003\" iyz=\"-0.002\"",
        }),
    },
];
