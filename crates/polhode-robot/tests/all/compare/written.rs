//! Robots in URDF, SDF, MJCF and USD.

use polhode_robot::moments::Moments;

use super::robots::{Frame, Hinge, Robot, Solid, transposed, turned_tensor};
use crate::common::{Matrix, matrix_about, times};

impl Robot {
    pub(crate) fn written(&self, language: &str) -> String {
        match language {
            "urdf" => self.urdf(),
            "sdf" => self.sdf(),
            "xml" => self.mjcf(),
            _ => self.usd(),
        }
    }

    fn urdf(&self) -> String {
        let mut text = "<robot name=\"r\">\n".to_owned();
        for part in &self.0 {
            text += &format!("<link name=\"{}\">", part.name);
            if let Some(Solid { mass, center, tensor: t }) = &part.solid {
                text += &format!(
                    "\n<inertial><origin xyz=\"{}\"/>\n<mass value=\"{mass:e}\"/>\n<inertia ixx=\"{:e}\"\nixy=\"{:e}\"\nixz=\"{:e}\"\niyy=\"{:e}\"\niyz=\"{:e}\"\nizz=\"{:e}\"/></inertial>",
                    list(center),
                    t[0][0],
                    t[0][1],
                    t[0][2],
                    t[1][1],
                    t[1][2],
                    t[2][2]
                );
            }
            text += "</link>\n";
            let (Some(joint), Some(parent)) = (&part.joint, part.parent) else { continue };
            assert_eq!(joint.anchor, [0.0; 3]);
            text += &format!(
                "<joint name=\"{}\" type=\"{}\"><parent link=\"{}\"/><child link=\"{}\"/>\n<origin xyz=\"{}\" rpy=\"{}\"/><axis xyz=\"{}\"/>\
                 <limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint>\n",
                joint.name,
                joint.kind,
                self.0[parent].name,
                part.name,
                list(&part.pose.p),
                list(&part.pose.angles()),
                list(&joint.axis)
            );
        }
        text + "</robot>\n"
    }

    fn sdf(&self) -> String {
        let mut text = "<sdf version=\"1.9\"><model name=\"r\">\n".to_owned();
        for part in &self.0 {
            let relative =
                part.parent.map_or(String::new(), |k| format!(" relative_to=\"{}\"", self.0[k].name));
            text += &format!(
                "<link name=\"{}\"><pose{relative}>{} {}</pose>",
                part.name,
                list(&part.pose.p),
                list(&part.pose.angles())
            );
            if let Some(Solid { mass, center, tensor }) = &part.solid {
                // The inertial's frame is turned, and the tensor stated along its axes.
                let frame = Frame::new(*center, [0.6, -0.3, 0.8]);
                let t = turned_tensor(transposed(frame.r), *tensor);
                text += &format!(
                    "\n<inertial><pose>{} {}</pose>\n<mass>{mass:e}</mass>\n<inertia><ixx>{:e}</ixx>\n<ixy>{:e}</ixy>\n<ixz>{:e}</ixz>\n<iyy>{:e}</iyy>\n<iyz>{:e}</iyz>\n<izz>{:e}</izz></inertia></inertial>",
                    list(center),
                    list(&frame.angles()),
                    t[0][0],
                    t[0][1],
                    t[0][2],
                    t[1][1],
                    t[1][2],
                    t[2][2]
                );
            }
            text += "</link>\n";
            let (Some(joint), Some(parent)) = (&part.joint, part.parent) else { continue };
            text += &format!(
                "<joint name=\"{}\" type=\"{}\"><pose>{} 0 0 0</pose><parent>{}</parent><child>{}</child>\n",
                joint.name,
                joint.kind,
                list(&joint.anchor),
                self.0[parent].name,
                part.name
            );
            if joint.kind != "fixed" {
                text += &format!("<axis><xyz>{}</xyz></axis>", list(&joint.axis));
            }
            text += "</joint>\n";
        }
        text + "</model></sdf>\n"
    }

    fn mjcf(&self) -> String {
        "<mujoco><compiler angle=\"radian\"/><worldbody>\n".to_owned()
            + &self.body(0)
            + "</worldbody></mujoco>\n"
    }

    fn body(&self, k: usize) -> String {
        let part = &self.0[k];
        let mut text = format!(
            "<body name=\"{}\" pos=\"{}\" quat=\"{}\">\n",
            part.name,
            list(&part.pose.p),
            list(&part.pose.quaternion())
        );
        if let Some(Hinge { name, kind, axis, anchor }) = &part.joint {
            let kind = if *kind == "revolute" {
                "hinge"
            } else if *kind == "prismatic" {
                "slide"
            } else {
                ""
            };
            if !kind.is_empty() {
                text += &format!(
                    "<joint name=\"{name}\" type=\"{kind}\" axis=\"{}\" pos=\"{}\"/>\n",
                    list(axis),
                    list(anchor)
                );
            }
        }
        if let Some(Solid { mass, center, tensor: t }) = &part.solid {
            let full = [t[0][0], t[1][1], t[2][2], t[0][1], t[0][2], t[1][2]];
            text += &format!(
                "<inertial mass=\"{mass:e}\"\n pos=\"{}\"\n fullinertia=\"{}\"/>\n",
                list(center),
                list(&full)
            );
        }
        let below = (0..self.0.len()).filter(|j| self.0[*j].parent == Some(k));
        text += &below.map(|j| self.body(j)).collect::<String>();
        text + "</body>\n"
    }

    fn usd(&self) -> String {
        let mut text =
            "#usda 1.0\n(\n    metersPerUnit = 1\n    kilogramsPerUnit = 1\n)\ndef Xform \"robot\"\n{\n"
                .to_owned();
        for k in 0..self.0.len() {
            let part = &self.0[k];
            let frame = self.in_model(k);
            text += &format!(
                "def Xform \"{}\" (\n    prepend apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\"]\n)\n{{\n    double3 xformOp:translate = ({})\n    quatd xformOp:orient = ({})\n    uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"]\n",
                part.name,
                commas(&frame.p),
                commas(&frame.quaternion())
            );
            if let Some(Solid { mass, center, tensor: t }) = &part.solid {
                let Moments { values, axes } =
                    Moments::of(&[t[0][0], t[1][1], t[2][2], t[0][1], t[0][2], t[1][2]]);
                let principal = Frame { r: transposed(axes), p: [0.0; 3] };
                text += &format!(
                    "    float physics:mass = {mass:e}\n    point3f physics:centerOfMass = ({})\n    float3 physics:diagonalInertia = ({})\n    quatf physics:principalAxes = ({})\n",
                    commas(center),
                    commas(&values),
                    commas(&principal.quaternion())
                );
            }
            text += "}\n";
            let (Some(joint), Some(parent)) = (&part.joint, part.parent) else { continue };
            let kind = match joint.kind {
                "revolute" => "PhysicsRevoluteJoint",
                "prismatic" => "PhysicsPrismaticJoint",
                _ => "PhysicsFixedJoint",
            };
            // The frame of the joint: on the axis, z along it.
            let in_child = Frame { r: to_z(joint.axis), p: joint.anchor };
            let in_parent = part.pose.then(&in_child);
            text += &format!(
                "def {kind} \"{}\"\n{{\n    uniform token physics:axis = \"Z\"\n    rel physics:body0 = </robot/{}>\n    rel physics:body1 = </robot/{}>\n    point3f physics:localPos0 = ({})\n    point3f physics:localPos1 = ({})\n    quatf physics:localRot0 = ({})\n    quatf physics:localRot1 = ({})\n}}\n",
                joint.name,
                self.0[parent].name,
                part.name,
                commas(&in_parent.p),
                commas(&in_child.p),
                commas(&in_parent.quaternion()),
                commas(&in_child.quaternion())
            );
        }
        text + "}\n"
    }

    fn in_model(&self, k: usize) -> Frame {
        let part = &self.0[k];
        part.parent.map_or(part.pose, |parent| self.in_model(parent).then(&part.pose))
    }
}

/// Returns a rotation whose third column is a unit vector.
fn to_z([x, y, z]: [f64; 3]) -> Matrix {
    let (pitch, yaw) = (x.hypot(y).atan2(z), y.atan2(x));
    times(matrix_about(2, yaw), matrix_about(1, pitch))
}

fn list(numbers: &[f64]) -> String {
    numbers.iter().map(|x| format!("{x:e}")).collect::<Vec<_>>().join(" ")
}

fn commas(numbers: &[f64]) -> String {
    numbers.iter().map(|x| format!("{x:e}")).collect::<Vec<_>>().join(", ")
}
