//! Numeric data of the equations, along the three axes of the suspension.

use super::axis::{Axis, Hold};
use super::suspension::{Gimbal, Gimbals};
use crate::body::mass_properties::MassProperties;
use crate::math::frame::{Body, Part, Space};
use crate::math::rotation::Rotation;
use crate::math::vector::{Direction, Vector};

/// Threshold, relative to the trace of the tensor, below which an asymmetry is rounding.
const SYMMETRIC: f64 = 4.0 * f64::EPSILON;

/// Rotor, gimbals and base. Axis 1 is the outer one, 2 the inner one, and 3 = 1 × 2 the rotor's;
/// each turns with its own body.
#[derive(Clone, Debug)]
pub(super) struct Model {
    /// Angular velocity of the base, and gravity, along the axes of the base.
    pub(super) turning: [f64; 3],
    pub(super) gravity: [f64; 3],
    pub(super) outer: Form,
    pub(super) inner: Form,
    pub(super) rotor: Form,
    pub(super) axes: [Axis; 3],
    /// Rotations of the suspension in the base, and in the body.
    pub(super) in_base: Rotation<Space, Part>,
    pub(super) in_body: Rotation<Body, Part>,
}

/// Inertia tensor about the intersection of the axes, and m c.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Form {
    pub(super) inertia: [[f64; 3]; 3],
    pub(super) moment: [f64; 3],
}

impl Form {
    /// Converts the tensor and the moment to other axes.
    fn along(axes: [[f64; 3]; 3], inertia: [[f64; 3]; 3], moment: [f64; 3]) -> Self {
        let image = |v: [f64; 3]| inertia.map(|row| dot(row, v));
        let mut along = axes.map(|a| axes.map(|b| dot(a, image(b))));
        // Symmetric bit for bit.
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            let mean = 0.5 * (along[i][j] + along[j][i]);
            (along[i][j], along[j][i]) = (mean, mean);
        }
        Self { inertia: along, moment: axes.map(|a| dot(a, moment)) }
    }

    /// Makes a rotor exactly symmetric if it is symmetric to within rounding. Then nothing depends
    /// on its own angle.
    fn symmetrised(mut self) -> Self {
        let [[a, b, c], [_, d, e], [.., f]] = self.inertia;
        let small = SYMMETRIC * (a + d + f);
        if [a - d, b, c, e].iter().all(|x| x.abs() <= small) {
            let mean = 0.5 * (a + d);
            self.inertia = [[mean, 0.0, 0.0], [0.0, mean, 0.0], [0.0, 0.0, f]];
        }
        let [x, y, z] = self.moment;
        if x.hypot(y) <= SYMMETRIC * z.abs() {
            self.moment = [0.0, 0.0, z];
        }
        self
    }

    /// True if a rotation about the third axis has no effect.
    pub(super) fn is_symmetric(&self) -> bool {
        let [[a, b, c], [_, d, e], _] = self.inertia;
        let [x, y, _] = self.moment;
        a == d && [b, c, e, x, y].iter().all(|x| *x == 0.0)
    }
}

impl Model {
    pub(super) fn of(body: &MassProperties<Body>, gimbals: &Gimbals) -> Self {
        let (first, second) = (gimbals.outer_axis(), gimbals.inner_axis());
        let of_base = [first, second, first.cross(second)];
        let of_body = perpendicular_to(gimbals.rotor_axis());
        let along = |v: [f64; 3]| of_base.map(|axis| dot(axis.to_array(), v));
        let of_gimbal =
            |gimbal: &Gimbal| Form::along(of_base.map(Vector::to_array), gimbal.inertia(), gimbal.moment());
        let [outer, inner] = gimbals.masses();
        let arm = (body.center_of_mass() - gimbals.crossing()).to_array();
        let about = body.inertia_about(gimbals.crossing()).matrix();
        let rotor = Form::along(of_body.map(Vector::to_array), about, arm.map(|x| body.mass() * x));
        Self {
            turning: along(gimbals.base().angular_velocity().to_array()),
            gravity: along(gimbals.gravity().to_array()),
            outer: of_gimbal(outer),
            inner: of_gimbal(inner),
            rotor: rotor.symmetrised(),
            axes: *gimbals.axes(),
            in_base: Rotation::from_axes(of_base),
            in_body: Rotation::from_axes(of_body),
        }
    }

    /// True if the axis is free.
    pub(super) fn is_free(&self, axis: usize) -> bool {
        self.axes[axis].hold() == Hold::Free
    }
}

/// Returns axes whose third is `z`. If possible, the first is in the plane of `z` and x.
fn perpendicular_to(z: Direction<Body>) -> [Direction<Body>; 3] {
    let first = if z.x.abs() <= 0.9 { Direction::new(1.0, 0.0, 0.0) } else { Direction::new(0.0, 1.0, 0.0) };
    let x = (first - z * z.dot(first)).direction().unwrap_or(first);
    [x, z.cross(x), z]
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
