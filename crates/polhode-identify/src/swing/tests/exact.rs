//! Exact motion of a body on wires: multipliers from the second derivatives of the constraints,
//! integrated with classical Runge–Kutta steps.

use nalgebra::{DMatrix, DVector, Matrix3, Quaternion, UnitQuaternion, Vector3};

use crate::decomposition::lu;

/// Body on wires.
pub(super) struct Hanging {
    pub(super) mass: f64,
    pub(super) inertia: Matrix3<f64>,
    pub(super) gravity: f64,
    pub(super) stiffness: f64,
    /// Upper end, and lower end relative to the centre of mass, m.
    pub(super) wires: Vec<(Vector3<f64>, Vector3<f64>)>,
    /// Viscous coefficient 2 a, 1/s: torque −2 a I_zz θ̇ about the vertical.
    pub(super) viscous: f64,
    /// Coefficient β of quadratic damping.
    pub(super) quadratic: f64,
}

/// Position, attitude, velocity, and angular velocity in the body.
#[derive(Clone, Copy, Debug)]
pub(super) struct State {
    pub(super) p: Vector3<f64>,
    pub(super) e: Quaternion<f64>,
    pub(super) v: Vector3<f64>,
    pub(super) w: Vector3<f64>,
}

impl State {
    pub(super) fn twist(&self) -> f64 {
        2.0 * self.e.k.atan2(self.e.w)
    }

    pub(super) fn twist_rate(&self) -> f64 {
        let d = self.e * Quaternion::from_imag(self.w) * 0.5;
        2.0 * (self.e.w * d.k - self.e.k * d.w) / (self.e.w * self.e.w + self.e.k * self.e.k)
    }
}

impl Hanging {
    fn slope(&self, s: &State) -> State {
        let r = UnitQuaternion::from_quaternion(s.e).to_rotation_matrix().into_inner();
        let n = self.wires.len();
        // ∇θ in space, from tan ½θ = z/w.
        let square = s.e.w * s.e.w + s.e.k * s.e.k;
        let gradient = Vector3::new(
            (s.e.w * s.e.j + s.e.i * s.e.k) / square,
            (s.e.j * s.e.k - s.e.w * s.e.i) / square,
            1.0,
        );
        let rate = s.twist_rate();
        let brake = self.inertia[(2, 2)] * (self.viscous * rate + self.quadratic * rate.abs() * rate);
        let torque = r.transpose() * gradient * (-self.stiffness * s.twist() - brake);
        // Unknowns: v̇, ẇ, λ.
        let mut a = DMatrix::zeros(6 + n, 6 + n);
        let mut b = DVector::zeros(6 + n);
        a.view_mut((0, 0), (3, 3)).fill_with_identity();
        a.view_mut((0, 0), (3, 3)).scale_mut(self.mass);
        a.view_mut((3, 3), (3, 3)).copy_from(&self.inertia);
        b[2] = -self.mass * self.gravity;
        b.rows_mut(3, 3).copy_from(&(torque - s.w.cross(&(self.inertia * s.w))));
        for (k, (top, d)) in self.wires.iter().enumerate() {
            let reach = s.p + r * d - top;
            let speed = s.v + r * s.w.cross(d);
            let in_body = d.cross(&(r.transpose() * reach));
            a.view_mut((0, 6 + k), (3, 1)).copy_from(&reach);
            a.view_mut((3, 6 + k), (3, 1)).copy_from(&in_body);
            a.view_mut((6 + k, 0), (1, 3)).copy_from(&reach.transpose());
            a.view_mut((6 + k, 3), (1, 3)).copy_from(&in_body.transpose());
            b[6 + k] = -speed.norm_squared() - reach.dot(&(r * s.w.cross(&s.w.cross(d))));
        }
        let x = lu("a test matrix", a).unwrap().solve(&b).unwrap();
        State {
            p: s.v,
            e: s.e * Quaternion::from_imag(s.w) * 0.5,
            v: x.fixed_rows::<3>(0).into_owned(),
            w: x.fixed_rows::<3>(3).into_owned(),
        }
    }

    pub(super) fn step(&self, s: &State, h: f64) -> State {
        let go = |k: &State, h: f64| State {
            p: s.p + k.p * h,
            e: s.e + k.e * h,
            v: s.v + k.v * h,
            w: s.w + k.w * h,
        };
        let k1 = self.slope(s);
        let k2 = self.slope(&go(&k1, 0.5 * h));
        let k3 = self.slope(&go(&k2, 0.5 * h));
        let k4 = self.slope(&go(&k3, h));
        let mean = |f: fn(&State) -> Vector3<f64>| (f(&k1) + (f(&k2) + f(&k3)) * 2.0 + f(&k4)) / 6.0;
        let e = s.e + (k1.e + (k2.e + k3.e) * 2.0 + k4.e) * (h / 6.0);
        State {
            p: s.p + mean(|k| k.p) * h,
            e: e.normalize(),
            v: s.v + mean(|k| k.v) * h,
            w: s.w + mean(|k| k.w) * h,
        }
    }
}
