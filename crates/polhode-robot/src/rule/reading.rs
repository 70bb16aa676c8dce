//! What a reader left out or had to decide.

use super::{Example, Rule};
use crate::finding::Severity::{Note, Suspect};

const NOT_CHECKED: &str = "What is not read is not checked.";

pub(super) const RULES: [Rule; 17] = [
    Rule {
        code: "read.inertials",
        severity: Suspect,
        title: "a link has one inertial",
        why: "Programs read the first, and the file says something else besides.",
        mend: "Leave the other one out.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <inertial>\n    <mass value=\"1.7\"/>\n    \
                    <inertia ixx=\"0.031\" iyy=\"0.042\" izz=\"0.053\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n  </inertial>\n  \
                    <inertial><mass value=\"2.3\"/></inertial>\n</link>",
            old: "\n  <inertial><mass value=\"2.3\"/></inertial>",
            new: "",
        }),
    },
    Rule {
        code: "read.twice",
        severity: Suspect,
        title: "an element stands once",
        why: "Programs read the first, and the file says something else besides.",
        mend: "Leave the other one out.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <inertial>\n    <mass value=\"1.7\"/>\n    <mass value=\"2.3\"/>\n    \
                    <inertia ixx=\"0.031\" iyy=\"0.042\" izz=\"0.053\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n  </inertial>\n</link>",
            old: "\n    <mass value=\"2.3\"/>",
            new: "",
        }),
    },
    Rule {
        code: "pose.degrees",
        severity: Suspect,
        title: "roll, pitch and yaw of URDF and SDF are radians",
        why: "90 rad are fourteen turns and a third: the link stands askew, and its tensor with it. Whole parts of a turn in degrees are \
              hardly meant so.",
        mend: "Write radians; a pose of SDF with degrees=\"true\" has degrees.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <inertial>\n    <origin xyz=\"0.1 0 0.2\" rpy=\"0 0 90\"/>\n    <mass value=\"1.7\"/>\n    \
                    <inertia ixx=\"0.031\" iyy=\"0.042\" izz=\"0.053\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n  </inertial>\n</link>",
            old: "0 0 90",
            new: "0 0 1.5707963267948966",
        }),
    },
    Rule {
        code: "read.unknown",
        severity: Suspect,
        title: "attributes and elements are those of the language",
        why: "Programs do not read others. One that says something of mass is probably meant to be read; of anything else it is a note.",
        mend: "Write what the language has: the mass in kg, the place in <origin>.",
        example: Some(Example {
            model: "<link name=\"arm\">\n  <inertial>\n    <mass value=\"1700\" unit=\"g\"/>\n    \
                    <inertia ixx=\"0.031\" iyy=\"0.042\" izz=\"0.053\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>\n  </inertial>\n</link>",
            old: "value=\"1700\" unit=\"g\"",
            new: "value=\"1.7\"",
        }),
    },
    Rule {
        code: "read.world",
        severity: Note,
        title: "a joint to the world names a link of that name",
        why: "Drake takes the parent \"world\" for the world; other programs look for a link, and refuse the joint.",
        mend: "Add <link name=\"world\"/>.",
        example: Some(Example {
            model: "<link name=\"arm\"/>\n<joint name=\"j\" type=\"fixed\"><parent link=\"world\"/><child link=\"arm\"/></joint>",
            old: "<link name=\"arm\"/>\n",
            new: "<link name=\"world\"/>\n<link name=\"arm\"/>\n",
        }),
    },
    Rule {
        code: "read.include",
        severity: Note,
        title: "every file that a model includes is found",
        why: NOT_CHECKED,
        mend: "Put it where the model names it, or name its folder with --root.",
        example: Some(Example {
            model: "<sdf version=\"1.9\">\n  <world name=\"w\">\n    <include><uri>model://arm</uri></include>\n  </world>\n</sdf>",
            old: "\n    <include><uri>model://arm</uri></include>",
            new: "",
        }),
    },
    Rule {
        code: "read.package",
        severity: Note,
        title: "the package of a URI is one of the roots, or lies in one",
        why: "The package was found elsewhere: an ancestor folder of the model has its name, or exactly one folder of that name below the checked \
              folder holds the file. ROS and Gazebo look in their own paths only, and may find another package.",
        mend: "Name the package, or the folder around it, with --root.",
        example: None,
    },
    Rule {
        code: "read.left_out",
        severity: Note,
        title: "bodies are written one by one",
        why: NOT_CHECKED,
        mend: "Save the model as its program has it (MuJoCo: mj_saveLastXML; USD: usdcat --flatten), and check that.",
        example: Some(Example {
            model: "<mujoco>\n  <worldbody>\n    <body name=\"arm\">\n      <composite type=\"cable\" count=\"9 1 1\"/>\n    </body>\n  \
                    </worldbody>\n</mujoco>",
            old: "\n      <composite type=\"cable\" count=\"9 1 1\"/>\n    ",
            new: "",
        }),
    },
    Rule {
        code: "read.unit",
        severity: Note,
        title: "a layer of USD says its unit of length",
        why: "By USD's rule a unit is 0.01 m where metersPerUnit is not given, which few mean.",
        mend: "Write metersPerUnit in the layer's metadata.",
        example: Some(Example {
            model: "#usda 1.0\n\ndef Xform \"arm\"\n{\n}\n",
            old: "#usda 1.0\n",
            new: "#usda 1.0\n(\n    metersPerUnit = 1\n)\n",
        }),
    },
    Rule {
        code: "read.compiler",
        severity: Suspect,
        title: "the settings of the compiler are those that MuJoCo takes, and leave the model as it is written",
        why: "With a setting that MuJoCo refuses no mass is known. Others have it join bodies, or read places otherwise: a note, as here each body \
              stands alone, as it is written.",
        mend: "Write one of the words or numbers that it takes; save the model as MuJoCo has compiled it (mj_saveLastXML), and check that.",
        example: Some(Example {
            model: "<mujoco>\n  <compiler balanceinertia=\"yes\"/>\n  <worldbody/>\n</mujoco>",
            old: "yes",
            new: "true",
        }),
    },
    Rule {
        code: "read.animated",
        severity: Suspect,
        title: "the mass of a body is one constant of the layer",
        why: "timeSamples, connections and splines are not read, and an inertia that changes over time is not one body. Of the sizes and places of \
              shapes it is a note.",
        mend: "Write one value, or flatten the stage at one time.",
        example: Some(Example {
            model: "#usda 1.0\n(\n    metersPerUnit = 1\n)\ndef Xform \"arm\" (\n    prepend apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\"]\n)\n{\n    \
                    float physics:mass.timeSamples = { 0: 1.7 }\n    point3f physics:centerOfMass = (0, 0, 0)\n    \
                    float3 physics:diagonalInertia = (0.031, 0.042, 0.053)\n}\n",
            old: "physics:mass.timeSamples = { 0: 1.7 }",
            new: "physics:mass = 1.7",
        }),
    },
    Rule {
        code: "inertia.computed",
        severity: Note,
        title: "the inertia of an SDF link with auto=\"true\" follows from its collisions",
        why: "It is computed as SDFormat does, from shapes and densities, and a stated mass scales it. Without collisions, or with a density or mass \
              that is not positive, SDFormat refuses the link; a pose or tensor in the inertial is overwritten.",
        mend: "Nothing, if the numbers are those of the link; else give each collision its <density>.",
        example: None,
    },
    Rule {
        code: "joint.armature",
        severity: Suspect,
        title: "the inertia of a rotor is a number of at least 0",
        why: "polhode inertia --subtree adds it to what the joint's motor has to move.",
        mend: "Write kg·m², or kg for a joint that slides.",
        example: Some(Example {
            model: "<mujoco>\n  <worldbody>\n    <body name=\"arm\">\n      <joint type=\"hinge\" armature=\"-0.05\"/>\n      \
                    <geom size=\"0.1\"/>\n    </body>\n  </worldbody>\n</mujoco>",
            old: "-0.05",
            new: "0.05",
        }),
    },
    Rule {
        code: "read.numbers",
        severity: Suspect,
        title: "an attribute or element has as many numbers as its meaning",
        why: "MuJoCo refuses more, and OpenSim reads the first ones; these are checked.",
        mend: "Leave the others out.",
        example: Some(Example {
            model: "<mujoco>\n  <worldbody>\n    <body name=\"arm\">\n      \
                    <inertial pos=\"0 0 0\" mass=\"1.7\" diaginertia=\"0.031 0.042 0.053 0\"/>\n    </body>\n  </worldbody>\n</mujoco>",
            old: "0.053 0\"",
            new: "0.053\"",
        }),
    },
    Rule {
        code: "read.pose",
        severity: Note,
        title: "frames are at places that a double holds",
        why: "Composed down the tree, the place is beyond the largest double; it is taken at the origin.",
        mend: "Look for a place with a wrong power of ten.",
        example: Some(Example {
            model: "<mujoco>\n  <worldbody>\n    <body name=\"arm\" pos=\"1e308 0 0\">\n      <body name=\"hand\" pos=\"1e308 0 0\"/>\n    \
                    </body>\n  </worldbody>\n</mujoco>",
            old: "\"arm\" pos=\"1e308 0 0\"",
            new: "\"arm\" pos=\"1 0 0\"",
        }),
    },
    Rule {
        code: "read.frame",
        severity: Note,
        title: "a pose is relative to a frame of the model",
        why: "Without that frame the pose is taken in the frame around it.",
        mend: "Write the frame's name as it stands in its <frame>, <link> or <joint>.",
        example: Some(Example {
            model: "<sdf version=\"1.9\">\n  <model name=\"m\">\n    <link name=\"arm\">\n      \
                    <pose relative_to=\"elbow\">0 0 1 0 0 0</pose>\n    </link>\n  </model>\n</sdf>",
            old: " relative_to=\"elbow\"",
            new: "",
        }),
    },
    Rule {
        code: "read.frame_circle",
        severity: Note,
        title: "frames do not name each other in a circle",
        why: "Such frames have no place; they are taken in the root's.",
        mend: "Let one of them be relative to a link.",
        example: Some(Example {
            model: "<sdf version=\"1.9\">\n  <model name=\"m\">\n    <link name=\"arm\"/>\n    \
                    <frame name=\"a\"><pose relative_to=\"b\">1 0 0 0 0 0</pose></frame>\n    \
                    <frame name=\"b\"><pose relative_to=\"a\">1 0 0 0 0 0</pose></frame>\n  </model>\n</sdf>",
            old: "relative_to=\"a\"",
            new: "relative_to=\"arm\"",
        }),
    },
];
