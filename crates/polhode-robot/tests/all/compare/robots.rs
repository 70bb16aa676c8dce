//! A robot as numbers, with other frames, joint zeros, merged links and
//! planted slips.
//!
//! The formulas here are independent of the library's: rotations are matrices.

use crate::common::{Matrix, matrix_about, matrix_about_axis, times};

/// Pose of an inner frame in an outer one: x_outer = R x + p.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub(crate) r: Matrix,
    pub(crate) p: [f64; 3],
}

const ONE: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl Frame {
    pub(crate) const IDENTITY: Self = Self { r: ONE, p: [0.0; 3] };

    pub(crate) fn new(p: [f64; 3], [roll, pitch, yaw]: [f64; 3]) -> Self {
        let r = times(matrix_about(2, yaw), times(matrix_about(1, pitch), matrix_about(0, roll)));
        Self { r, p }
    }

    pub(crate) fn then(&self, inner: &Self) -> Self {
        Self { r: times(self.r, inner.r), p: self.point(inner.p) }
    }

    pub(crate) fn inverse(&self) -> Self {
        let r = transposed(self.r);
        let back = Self { r, p: [0.0; 3] }.point(self.p);
        Self { r, p: back.map(|c| -c) }
    }

    fn turned(&self, v: [f64; 3]) -> [f64; 3] {
        self.r.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
    }

    pub(crate) fn point(&self, v: [f64; 3]) -> [f64; 3] {
        let turned = self.turned(v);
        [0, 1, 2].map(|k| turned[k] + self.p[k])
    }

    /// Returns roll, pitch and yaw.
    pub(crate) fn angles(&self) -> [f64; 3] {
        let r = self.r;
        [r[2][1].atan2(r[2][2]), (-r[2][0]).atan2(r[2][1].hypot(r[2][2])), r[1][0].atan2(r[0][0])]
    }

    /// Returns the quaternion (w, x, y, z), as the product of half the angles.
    pub(crate) fn quaternion(&self) -> [f64; 4] {
        let [(sr, cr), (sp, cp), (sy, cy)] = self.angles().map(|angle| (0.5 * angle).sin_cos());
        [
            cr * cp * cy + sr * sp * sy,
            sr * cp * cy - cr * sp * sy,
            cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy,
        ]
    }
}

pub(crate) fn transposed(r: Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| r[j][i]))
}

/// Returns R I Rᵀ.
pub(crate) fn turned_tensor(r: Matrix, tensor: Matrix) -> Matrix {
    times(times(r, tensor), transposed(r))
}

/// Joint above a link; axis and anchor in the link's frame.
#[derive(Clone, Debug)]
pub(crate) struct Hinge {
    pub(crate) name: String,
    pub(crate) kind: &'static str,
    pub(crate) axis: [f64; 3],
    pub(crate) anchor: [f64; 3],
}

/// Mass, centre and tensor about it, axes of the link.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Solid {
    pub(crate) mass: f64,
    pub(crate) center: [f64; 3],
    pub(crate) tensor: Matrix,
}

/// Returns the sum of bodies: I = Σ (I_k + m_k (d_k² 1 − d_k d_kᵀ)) about the common centre.
pub(crate) fn sum(solids: &[Solid]) -> Solid {
    let mass: f64 = solids.iter().map(|solid| solid.mass).sum();
    let center =
        [0, 1, 2].map(|k| solids.iter().map(|solid| solid.mass * solid.center[k]).sum::<f64>() / mass);
    let mut tensor = [[0.0; 3]; 3];
    for solid in solids {
        let d = [0, 1, 2].map(|k| solid.center[k] - center[k]);
        let square: f64 = d.iter().map(|c| c * c).sum();
        for (i, row) in tensor.iter_mut().enumerate() {
            for (j, element) in row.iter_mut().enumerate() {
                *element += solid.tensor[i][j] + solid.mass * (square * ONE[i][j] - d[i] * d[j]);
            }
        }
    }
    Solid { mass, center, tensor }
}

#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub(crate) name: String,
    pub(crate) parent: Option<usize>,
    /// Pose of the link in its parent; of the root in the model.
    pub(crate) pose: Frame,
    pub(crate) joint: Option<Hinge>,
    pub(crate) solid: Option<Solid>,
}

#[derive(Clone, Debug)]
pub(crate) struct Robot(pub(crate) Vec<Part>);

pub(crate) const LANGUAGES: [&str; 4] = ["urdf", "sdf", "xml", "usda"];

/// Returns a base with two branches: shoulder (revolute), elbow (revolute), hand (fixed); and rail
/// (prismatic), finger (revolute).
pub(crate) fn robot() -> Robot {
    let part =
        |name: &str, parent: Option<usize>, joint: Option<(&str, &'static str, [f64; 3])>, pose, k: usize| {
            let scale = [3.2, 1.7, 0.9, 0.31, 0.53, 0.24][k];
            let angles = [0.4 + 0.3 * f64::from(u8::try_from(k).unwrap()), -0.7, 1.1];
            let moments = [0.011, 0.017, 0.023].map(|i: f64| i * scale);
            let diagonal = [[moments[0], 0.0, 0.0], [0.0, moments[1], 0.0], [0.0, 0.0, moments[2]]];
            let tensor = turned_tensor(Frame::new([0.0; 3], angles).r, diagonal);
            let center = [
                [0.03, -0.02, 0.05],
                [0.11, 0.04, -0.06],
                [0.08, -0.05, 0.03],
                [0.02, 0.03, -0.04],
                [-0.05, 0.07, 0.02],
                [0.01, -0.06, 0.04],
            ][k];
            let joint =
                joint.map(|(name, kind, axis)| Hinge { name: name.to_owned(), kind, axis, anchor: [0.0; 3] });
            Part {
                name: name.to_owned(),
                parent,
                pose,
                joint,
                solid: Some(Solid { mass: scale, center, tensor }),
            }
        };
    let pose = Frame::new;
    Robot(vec![
        part("base", None, None, Frame::IDENTITY, 0),
        part(
            "upper",
            Some(0),
            Some(("shoulder", "revolute", [0.36, -0.48, 0.8])),
            pose([0.1, 0.2, 0.3], [0.3, -0.2, 0.9]),
            1,
        ),
        part(
            "fore",
            Some(1),
            Some(("elbow", "revolute", [0.6, 0.64, -0.48])),
            pose([0.35, -0.1, 0.05], [-0.5, 0.4, 0.2]),
            2,
        ),
        part(
            "hand",
            Some(2),
            Some(("wrist", "fixed", [1.0, 0.0, 0.0])),
            pose([0.2, 0.05, -0.07], [0.1, 0.8, -0.6]),
            3,
        ),
        part(
            "rail",
            Some(0),
            Some(("slide", "prismatic", [-0.48, 0.6, 0.64])),
            pose([-0.2, 0.15, 0.1], [0.7, 0.1, -0.3]),
            4,
        ),
        part(
            "finger",
            Some(4),
            Some(("knuckle", "revolute", [0.0, 0.8, 0.6])),
            pose([0.12, 0.22, -0.15], [0.2, 0.5, 0.3]),
            5,
        ),
    ])
}

impl Robot {
    pub(crate) fn part(&mut self, name: &str) -> &mut Part {
        self.0.iter_mut().find(|part| part.name == name).unwrap()
    }

    pub(crate) fn solid(&mut self, name: &str) -> &mut Solid {
        self.part(name).solid.as_mut().unwrap()
    }

    /// Returns the robot with other link frames. In URDF a frame stays on the axis of its joint.
    pub(crate) fn reframed(&self, language: &str) -> Self {
        let frames: Vec<Frame> = (self.0.iter().enumerate())
            .map(|(k, part)| {
                let k = f64::from(u8::try_from(k).unwrap());
                let shift = [0.07 + 0.01 * k, -0.05, 0.03 * k];
                let turn = [0.5 - 0.2 * k, 0.3 * k, -0.4 + 0.1 * k];
                match &part.joint {
                    None if language == "urdf" => Frame::IDENTITY,
                    Some(joint) if language == "urdf" && joint.kind == "revolute" => {
                        Frame::new(joint.axis.map(|c| (0.04 + 0.02 * k) * c), turn)
                    }
                    _ => Frame::new(shift, turn),
                }
            })
            .collect();
        let mut robot = self.clone();
        for (part, frame) in robot.0.iter_mut().zip(&frames) {
            let above = part.parent.map_or(Frame::IDENTITY, |k| frames[k]);
            part.pose = above.inverse().then(&part.pose).then(frame);
            let back = frame.inverse();
            if let Some(joint) = &mut part.joint {
                joint.axis = back.turned(joint.axis);
                joint.anchor = back.point(joint.anchor);
                if language == "urdf" {
                    joint.anchor = [0.0; 3];
                }
            }
            if let Some(solid) = &mut part.solid {
                solid.center = back.point(solid.center);
                solid.tensor = turned_tensor(back.r, solid.tensor);
            }
        }
        robot
    }

    /// Returns the robot with the zero of a joint moved by q.
    pub(crate) fn rezeroed(&self, link: &str, q: f64) -> Self {
        let mut robot = self.clone();
        let part = robot.part(link);
        let joint = part.joint.as_ref().unwrap();
        let moved = if joint.kind == "prismatic" {
            Frame { r: ONE, p: joint.axis.map(|c| q * c) }
        } else {
            Frame { r: matrix_about_axis(joint.axis, q), p: [0.0; 3] }
        };
        part.pose = part.pose.then(&moved);
        robot
    }

    /// Returns the robot with the hand's mass in the forearm, and without the hand.
    pub(crate) fn merged(&self) -> Self {
        let mut robot = self.clone();
        let hand = robot.0.remove(3);
        for part in &mut robot.0 {
            part.parent = part.parent.map(|k| if k > 3 { k - 1 } else { k });
        }
        let of_hand = hand.solid.unwrap();
        let center = hand.pose.point(of_hand.center);
        let tensor = turned_tensor(hand.pose.r, of_hand.tensor);
        let fore = robot.solid("fore");
        *fore = sum(&[*fore, Solid { mass: of_hand.mass, center, tensor }]);
        robot
    }

    /// Returns the robot with this many digits in axes, anchors, masses, centres and tensors, and in the
    /// angles of poses.
    pub(crate) fn rounded(&self, digits: usize) -> Self {
        let round = |x: f64| format!("{x:.*e}", digits - 1).parse::<f64>().unwrap();
        let mut robot = self.clone();
        for part in &mut robot.0 {
            part.pose = Frame::new(part.pose.p.map(round), part.pose.angles().map(round));
            if let Some(joint) = &mut part.joint {
                (joint.axis, joint.anchor) = (joint.axis.map(round), joint.anchor.map(round));
            }
            if let Some(solid) = &mut part.solid {
                let Solid { mass, center, tensor } = solid;
                (*mass, *center) = (round(*mass), center.map(round));
                *tensor = tensor.map(|row| row.map(round));
            }
        }
        robot
    }
}
