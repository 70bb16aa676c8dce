//! Values of a variable from uniform numbers.

use core::f64::consts::TAU;

use polhode::math::{Attitude, Body, Direction, Rotation};
use polhode_scenario::read::{Dispersion, Law, Spread, Vary};

use super::second_moments::Root;
use super::{distribution, normal};

/// Maximum number of uniform numbers per variable.
pub(crate) const MOST_COORDINATES: usize = 16;

/// Probability distribution of a variable's values, with its nominal value.
#[derive(Clone, Debug)]
pub(crate) struct Draw {
    law: Law,
    nominal: Vec<f64>,
    root: Option<Root>,
    coordinates: usize,
}

impl Draw {
    /// Creates the distribution of a variable of a plan.
    pub(crate) fn new(vary: &Vary) -> Self {
        Self {
            law: vary.law.clone(),
            nominal: vary.target.nominal().to_vec(),
            root: vary.target.mass_properties().map(Root::of),
            coordinates: vary.coordinates(),
        }
    }

    /// Returns the number of uniform numbers that a draw needs.
    pub(crate) const fn coordinates(&self) -> usize {
        self.coordinates
    }

    /// Appends the values for these uniform numbers.
    pub(crate) fn put(&self, uniform: &[f64], values: &mut Vec<f64>) {
        match (&self.law, uniform) {
            (Law::Number(law), &[u]) => values.push(distribution::quantile(law, u)),
            (Law::Vector { direction: spread, magnitude }, &[u, v, ref rest @ ..]) => {
                let direction = self.direction(*spread, u, v);
                let length = match (magnitude, rest) {
                    (Some(law), &[w]) => distribution::quantile(law, w),
                    _ => Direction::<Body>::from_array(self.vector()).norm(),
                };
                values.extend(direction.map(|c| length * c));
            }
            (Law::Rotation(spread), &[u, v, w]) => values.extend(self.rotation(*spread, [u, v, w])),
            (Law::MassProperties(dispersion), _) => self.mass_properties(*dispersion, uniform, values),
            (Law::Correlated(law), _) => {
                values.extend(law.draw(uniform.iter().map(|u| normal::quantile(*u))));
            }
            _ => {}
        }
    }

    fn vector(&self) -> [f64; 3] {
        match *self.nominal {
            [x, y, z] => [x, y, z],
            _ => [0.0; 3],
        }
    }

    /// Returns a unit vector, uniform on the sphere or on a cap: cos θ and φ are uniform.
    fn direction(&self, spread: Spread, u: f64, v: f64) -> [f64; 3] {
        let around =
            Direction::<Body>::from_array(self.vector()).direction().map(polhode::math::Vector::to_array);
        // 1 − cos θ, with maximum 1 − cos α = 2 sin²(α/2).
        let (versine, axis) = match (spread, around) {
            (Spread::Within(angle), Some(axis)) => {
                let half = libm::sin(0.5 * angle);
                (2.0 * half * half * u, axis)
            }
            _ => (2.0 * u, [0.0, 0.0, 1.0]),
        };
        let (sine, cosine) = ((versine * (2.0 - versine)).max(0.0).sqrt(), 1.0 - versine);
        let (y, x) = libm::sincos(TAU * v);
        let [a, b] = across(axis);
        core::array::from_fn(|k| sine * (x * a[k] + y * b[k]) + cosine * axis[k])
    }

    /// Returns a quaternion (w, x, y, z) with w ≥ 0.
    fn rotation(&self, spread: Spread, uniform: [f64; 3]) -> [f64; 4] {
        let nominal = match *self.nominal {
            [w, x, y, z] => Attitude::from_quaternion([w, x, y, z]).unwrap_or(Attitude::identity()),
            _ => Attitude::identity(),
        };
        let turned = match spread {
            Spread::Normal(sd) => {
                let vector = Direction::<Body>::from_array(uniform.map(|u| sd * normal::quantile(u)));
                let turn = Rotation::<Body, Body>::from_axis_angle(vector, vector.norm());
                nominal * turn.unwrap_or(Rotation::identity())
            }
            _ => return shoemake(uniform),
        };
        turned.canonical_quaternion()
    }

    fn mass_properties(&self, dispersion: Dispersion, uniform: &[f64], values: &mut Vec<f64>) {
        let Some(root) = &self.root else { return };
        let drawn = root.draw(dispersion, uniform);
        if self.nominal.len() > 6 {
            values.push(drawn.mass);
            values.extend(drawn.center);
        }
        match (dispersion, self.nominal.get(4..)) {
            // Keep the tensor as in the plan, without the rounding errors of its root.
            (Dispersion::Apart { inertia: 0.0, .. }, Some(tensor)) => values.extend_from_slice(tensor),
            _ => values.extend(drawn.tensor),
        }
    }
}

/// Returns a uniformly distributed rotation (Shoemake, Uniform random rotations, Graphics Gems III,
/// 1992):
///
/// q = (√u cos 2πw, √(1−u) sin 2πv, √(1−u) cos 2πv, √u sin 2πw)
fn shoemake([u, v, w]: [f64; 3]) -> [f64; 4] {
    let ((sv, cv), (sw, cw)) = (libm::sincos(TAU * v), libm::sincos(TAU * w));
    let (a, b) = ((1.0 - u).sqrt(), u.sqrt());
    let q = [b * cw, a * sv, a * cv, b * sw];
    if q[0] < 0.0 { q.map(|c| 0.0 - c) } else { q }
}

/// Returns two unit vectors that form a right-handed orthonormal basis with a third (Duff and
/// others, Building an orthonormal basis, revisited, JCGT 6, 2017).
fn across([x, y, z]: [f64; 3]) -> [[f64; 3]; 2] {
    let sign = 1.0_f64.copysign(z);
    let a = -1.0 / (sign + z);
    let b = x * y * a;
    [[1.0 + sign * x * x * a, sign * b, -sign * x], [b, sign + y * y * a, -y]]
}
