//! Masses.

use super::{Example, Rule};
use crate::finding::Severity::{Impossible, Note, Suspect};

pub(super) const RULES: [Rule; 6] = [
    Rule {
        code: "mass.not_positive",
        severity: Impossible,
        title: "a link that moves has a positive mass, or carries one; what has no mass has no inertia",
        why: "A negative mass accelerates against its force, and a joint that moves nothing divides by zero.",
        mend: "Give the link its mass; a frame that only marks a place is joined by a fixed joint and needs no inertial.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <inertial>\n    <mass value=\"-1.7\"/>\n    \
                    <inertia ixx=\"0.031\" iyy=\"0.042\" izz=\"0.053\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n  </inertial>\n</link>",
            old: "-1.7",
            new: "1.7",
        }),
    },
    Rule {
        code: "mass.missing",
        severity: Impossible,
        title: "a link that moves says its mass, or carries a link that does",
        why: "MuJoCo refuses a body with a joint and no mass; SDF takes 1 kg and 1 kg·m² about each axis, which is hardly meant.",
        mend: "Add an inertial, in MJCF also a geom that has mass.",
        example: Some(Example {
            model: "<mujoco>\n  <worldbody>\n    <body name=\"arm\">\n      <joint type=\"hinge\"/>\n    </body>\n  </worldbody>\n</mujoco>",
            old: "<joint type=\"hinge\"/>",
            new: "<joint type=\"hinge\"/><geom size=\"0.1\"/>",
        }),
    },
    Rule {
        code: "mass.massless_collision",
        severity: Suspect,
        title: "what can be touched has mass",
        why: "Engines drop such a link, refuse it or let it fly off at the first contact. Where it is fixed to a link with mass, programs lump both, \
              so that it is a note there, one for all such links of a file; so it is for a base that is fixed to its place.",
        mend: "Give the link the mass of what it is, or its collision geometry to the link that it is fixed to.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <collision><geometry><box size=\"0.1 0.2 0.3\"/></geometry></collision>\n</link>",
            old: "<collision>",
            new: "<inertial>\n    <mass value=\"1.2\"/>\n    \
                  <inertia ixx=\"0.013\" iyy=\"0.010\" izz=\"0.005\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n  </inertial>\n  <collision>",
        }),
    },
    Rule {
        code: "mass.refused",
        severity: Note,
        title: "a link that moves has mass and moments of inertia",
        why: "Languages allow a link without mass between two joints; programs do not. MuJoCo refuses a moving body unless its mass and moments, or \
              those of a body that is fixed to it, are at least 1e-15. Gazebo drops the link with all that hangs from it. Drake refuses a massless \
              link at the end of a chain. Isaac Sim takes the inertia of a small sphere. For the programs of --for it is an error.",
        mend: "Give the link its mass and tensor; a few grams with the moments of a small part will do between two axes of a joint.",
        example: Some(Example {
            model: "<link name=\"base\"/>\n<link name=\"cross\"/>\n<link name=\"arm\">\n  <inertial>\n    <mass value=\"1.7\"/>\n    \
                    <inertia ixx=\"0.031\" iyy=\"0.042\" izz=\"0.053\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n  </inertial>\n</link>\n\
                    <joint name=\"pitch\" type=\"continuous\">\n  <parent link=\"base\"/><child link=\"cross\"/><axis xyz=\"0 1 0\"/>\n</joint>\n\
                    <joint name=\"yaw\" type=\"continuous\">\n  <parent link=\"cross\"/><child link=\"arm\"/><axis xyz=\"0 0 1\"/>\n</joint>",
            old: "<link name=\"cross\"/>",
            new: "<link name=\"cross\">\n  <inertial>\n    <mass value=\"0.02\"/>\n    \
                  <inertia ixx=\"2e-6\" iyy=\"3e-6\" izz=\"4e-6\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n  </inertial>\n</link>",
        }),
    },
    Rule {
        code: "density.implausible",
        severity: Suspect,
        title: "solids have 10 to 25,000 kg/m³",
        why: "The mass does not belong to the geometry: a mesh in millimetres that is read in metres, or the mass in grams. Primitives stand for \
              more than themselves and are granted a factor of 5; dummies of some grams are a note.",
        mend: "Scale the mesh (scale=\"0.001 0.001 0.001\"), or write the mass in kg. A fix is written where one of these alone makes density and \
               tensor agree.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <inertial>\n    <mass value=\"1.2\"/>\n    \
                    <inertia ixx=\"0.013\" iyy=\"0.010\" izz=\"0.005\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n  </inertial>\n  \
                    <visual><geometry><box size=\"100 200 300\"/></geometry></visual>\n</link>",
            old: "100 200 300",
            new: "0.1 0.2 0.3",
        }),
    },
    Rule {
        code: "inertia.missing",
        severity: Impossible,
        title: "a link with mass has its tensor",
        why: "A mass without a tensor has none to turn about its centre: programs refuse it, or take the identity, 1 kg·m² about each axis.",
        mend: "Compute it: polhode inertia MESH --mass KG --write urdf.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <inertial>\n    <mass value=\"1.7\"/>\n  </inertial>\n</link>",
            old: "<mass value=\"1.7\"/>",
            new: "<mass value=\"1.7\"/>\n    \
                  <inertia ixx=\"0.031\" iyy=\"0.042\" izz=\"0.053\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>",
        }),
    },
];
