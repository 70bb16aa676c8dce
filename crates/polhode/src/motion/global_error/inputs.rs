//! The inputs of a simulation, a little different.

use crate::math::rotation::Rotation;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Vector;
use crate::motion::propagate::noise::Random;
use crate::motion::rotor::Rotor;
use crate::motion::simulation::Simulation;
use crate::motion::state::State;

/// Half a unit in the last place, relative to the number.
const HALF_BIT: f64 = 0.5 * f64::EPSILON;

/// A body and a start, each number of which is off by so many times what its rounding may be, to either side.
///
/// Each number is changed in proportion to itself, so that what is zero stays zero; and second moments that are equal stay equal, as
/// a body that is symmetric is so by construction, not by chance.
#[derive(Clone, Debug)]
pub(super) struct Inputs {
    pub(super) rotor: Rotor,
    pub(super) start: State,
}

impl Inputs {
    pub(super) fn of(simulation: &Simulation<'_>, seed: u64, amplitude: f64) -> Self {
        let (mut random, delta) = (Random::new(seed), amplitude * HALF_BIT);
        let mut factor = || if random.next() < 0.0 { 1.0 - delta } else { 1.0 + delta };
        let Simulation { rotor, start, .. } = simulation;
        let scale: [f64; 3] = core::array::from_fn(|_| factor());
        let lever = rotor.lever().to_array().map(|x| x * factor());
        let inertia = scaled(rotor, scale);
        let rotor =
            rotor.with_inertia(inertia, Vector::from_array(lever)).unwrap_or_else(|| (*rotor).clone());
        let quaternion = start.attitude.quaternion().map(|c| c * factor());
        let omega = start.omega.to_array().map(|w| w * factor());
        // Normalising a quaternion that is all but unit cannot fail.
        let attitude = Rotation::from_quaternion(quaternion).unwrap_or(start.attitude);
        Self { rotor, start: State { attitude, omega: Vector::from_array(omega), ..*start } }
    }
}

/// I of second moments D S D, D = diag(d): S = ½ tr(I) 1 − I stays positive semi-definite, so that a body stays one.
fn scaled(rotor: &Rotor, [a, b, c]: [f64; 3]) -> Symmetric3 {
    let i = rotor.inertia().symmetric();
    let half = 0.5 * (i.xx + i.yy + i.zz);
    let [sx, sy, sz] = [half - i.xx, half - i.yy, half - i.zz];
    let near = |p: f64, q: f64| (p - q).abs() <= 1e-12 * half;
    let b = if near(sx, sy) { a } else { b };
    let c = if near(sx, sz) {
        a
    } else if near(sy, sz) {
        b
    } else {
        c
    };
    Symmetric3 {
        xx: a * a * sx,
        yy: b * b * sy,
        zz: c * c * sz,
        xy: -a * b * i.xy,
        xz: -a * c * i.xz,
        yz: -b * c * i.yz,
    }
    .inertia_of_second_moments()
}
