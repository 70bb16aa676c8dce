//! Moving wrist with a payload of particles, whose wrench is summed particle by particle.

use polhode::math::{
    Acceleration, AngularAcceleration, AngularVelocity, Attitude, Body, Direction, Force, Position, Space,
    Torque,
};
use polhode_identify::payload::{PayloadRow, WrenchSense, gravity_along};

use crate::noise::Normal;

/// Particles: mass, kg, and position from the sensor's origin, m.
pub(super) struct Carried(pub(super) Vec<(f64, [f64; 3])>);

impl Carried {
    /// Returns a body with three distinct moments, nonzero products and an offset centre.
    pub(super) fn generic() -> Self {
        Self(vec![
            (0.41, [0.13, -0.07, 0.21]),
            (0.72, [-0.08, 0.11, 0.09]),
            (0.33, [0.04, 0.15, 0.31]),
            (0.58, [-0.11, -0.14, 0.17]),
            (0.27, [0.17, 0.02, 0.06]),
        ])
    }

    /// Returns particles in a plane that is parallel to no axis.
    pub(super) fn plate() -> Self {
        let (a, b) = ([0.6, 0.64, -0.48], [0.8, -0.48, 0.36]);
        let at = |u: f64, v: f64| std::array::from_fn(|k| [0.03, -0.02, 0.11][k] + u * a[k] + v * b[k]);
        Self(vec![
            (0.52, at(0.12, 0.03)),
            (0.37, at(-0.09, 0.07)),
            (0.61, at(0.02, -0.13)),
            (0.29, at(-0.14, -0.06)),
        ])
    }

    /// Returns particles on a line that is parallel to no axis.
    pub(super) fn rod() -> Self {
        let a = [0.48, -0.6, 0.64];
        let at = |u: f64| std::array::from_fn(|k| [0.03, -0.02, 0.11][k] + u * a[k]);
        Self(vec![(0.52, at(0.14)), (0.37, at(-0.11)), (0.61, at(0.03)), (0.29, at(-0.18))])
    }

    /// Returns m, m c and the tensor about the origin.
    pub(super) fn about_origin(&self) -> [f64; 10] {
        let mut n = [0.0; 10];
        for (m, [x, y, z]) in &self.0 {
            let of = [1.0, *x, *y, *z, y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z];
            (0..10).for_each(|k| n[k] += m * of[k]);
        }
        n
    }

    /// Returns m, c and the tensor about the centre of mass.
    pub(super) fn about_center(&self) -> [f64; 10] {
        let n = self.about_origin();
        let c = [n[1] / n[0], n[2] / n[0], n[3] / n[0]];
        let moved = self.0.iter().map(|(m, r)| (*m, std::array::from_fn(|k| r[k] - c[k]))).collect();
        let own = Self(moved).about_origin();
        [n[0], c[0], c[1], c[2], own[4], own[5], own[6], own[7], own[8], own[9]]
    }

    pub(super) fn wrench(&self, row: &PayloadRow) -> (Force<Body>, Torque<Body>) {
        let (mut force, mut torque) = (Force::ZERO, Torque::ZERO);
        for (m, r) in &self.0 {
            let r = Position::<Body>::from_array(*r);
            let acceleration =
                row.acceleration - row.gravity + row.alpha.cross(r) + row.omega.cross(row.omega.cross(r));
            let f = Force::from_array((acceleration * *m).to_array());
            force += f;
            torque += r.cross(f);
        }
        (force, torque)
    }
}

/// Motion of the wrist.
#[derive(Clone, Copy)]
pub(super) enum Course {
    /// Rotation and acceleration in all directions, with this speed factor.
    Generic(f64),
    /// Rest in several attitudes.
    Poses,
    /// Rotation about the vertical z.
    OneAxis,
}

/// Returns rows without noise.
pub(super) fn rows(carried: &Carried, course: Course, count: usize, sense: WrenchSense) -> Vec<PayloadRow> {
    let mut attitude = Attitude::from_axis_angle(Direction::new(0.3, -0.7, 0.5), 0.4).unwrap();
    let step = 0.01;
    let down = Acceleration::<Space>::new(0.0, 0.0, -9.81);
    let mut all = Vec::new();
    for k in 0..count {
        let t = k as f64 * step * 300.0 / count.max(300) as f64;
        let (omega, alpha, acceleration, gravity) = match course {
            Course::Generic(rate) => {
                let (w, dw) = series(t, rate, [[2.1, 1.3], [1.7, -1.1], [1.4, 1.9]], 0.3);
                let (_, a) = series(t, rate, [[0.31, -0.2], [0.24, 0.27], [-0.35, 0.18]], 1.1);
                (w, dw, a, gravity_along(attitude, down))
            }
            Course::Poses => {
                let axis = Direction::new((3.1 * t).sin(), (2.3 * t + 1.0).cos(), (1.7 * t).sin() + 0.2);
                let pose = Attitude::from_axis_angle(axis.direction().unwrap(), 4.0 * t).unwrap();
                ([0.0; 3], [0.0; 3], [0.0; 3], gravity_along(pose, down))
            }
            Course::OneAxis => {
                let (w, dw) = series(t, 1.0, [[2.1, 1.3]; 3], 0.3);
                let only = |v: [f64; 3]| [0.0, 0.0, v[2]];
                (only(w), only(dw), [0.0; 3], Acceleration::new(0.0, 0.0, -9.81))
            }
        };
        let omega = AngularVelocity::from_array(omega);
        let mut row = PayloadRow {
            time: t,
            omega,
            alpha: AngularAcceleration::from_array(alpha),
            acceleration: Acceleration::from_array(acceleration),
            gravity,
            force: Force::ZERO,
            torque: Torque::ZERO,
        };
        let (force, torque) = carried.wrench(&row);
        let sign = if sense == WrenchSense::OnPayload { 1.0 } else { -1.0 };
        (row.force, row.torque) = (force * sign, torque * sign);
        all.push(row);
        if let Some(axis) = Direction::from_array(omega.to_array()).direction() {
            attitude =
                attitude * polhode::math::Rotation::from_axis_angle(axis, omega.norm() * step).unwrap();
        }
    }
    all
}

/// Returns two sines in each direction, and their derivative.
fn series(t: f64, rate: f64, size: [[f64; 2]; 3], phase: f64) -> ([f64; 3], [f64; 3]) {
    let (mut value, mut slope) = ([0.0; 3], [0.0; 3]);
    for i in 0..3 {
        for (j, size) in size[i].into_iter().enumerate() {
            let frequency = rate * (2.9 + 1.7 * i as f64 + 3.3 * j as f64);
            let angle = frequency * t + phase * (1.0 + i as f64 + 2.0 * j as f64);
            value[i] += rate * size * angle.sin();
            slope[i] += rate * size * frequency * angle.cos();
        }
    }
    (value, slope)
}

/// Adds white noise to the wrench, with standard deviations of force and torque.
pub(super) fn noisy(rows: &[PayloadRow], force: f64, torque: f64, seed: u64) -> Vec<PayloadRow> {
    let mut normal = Normal::new(seed);
    let mut three = |sd: f64| [sd * normal.next(), sd * normal.next(), sd * normal.next()];
    rows.iter()
        .map(|row| PayloadRow {
            force: row.force + Force::from_array(three(force)),
            torque: row.torque + Torque::from_array(three(torque)),
            ..*row
        })
        .collect()
}

/// Adds white noise to the motion, with standard deviations of ω, α and a.
pub(super) fn shaken(rows: &[PayloadRow], [omega, alpha, a]: [f64; 3], seed: u64) -> Vec<PayloadRow> {
    let mut normal = Normal::new(seed + 77_000);
    let mut three = |sd: f64| [sd * normal.next(), sd * normal.next(), sd * normal.next()];
    rows.iter()
        .map(|row| PayloadRow {
            omega: row.omega + AngularVelocity::from_array(three(omega)),
            alpha: row.alpha + AngularAcceleration::from_array(three(alpha)),
            acceleration: row.acceleration + Acceleration::from_array(three(a)),
            ..*row
        })
        .collect()
}
