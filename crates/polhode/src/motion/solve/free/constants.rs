//! Constants of a motion that the public methods return, in SI units.

use crate::math::double::Double;
use crate::math::frame::Body;
use crate::math::number::PI;
use crate::math::triple::Triple;
use crate::math::vector::{Direction, Vector};

use super::elements::Elements;
use super::labelled::Labelled;

/// Constants of a motion, along its labelled axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Constants {
    /// The labelled axes, in body axes.
    pub(super) axes: [Direction<Body>; 3],
    /// Principal moments i1, i2, i3, kg·m².
    pub(super) moments: [f64; 3],
    /// Coefficients of Euler's equations, (i2 − i3)/i1, (i3 − i1)/i2, (i1 − i2)/i3. Zero for the
    /// axis of a rod.
    pub(super) ratios: [f64; 3],
    /// L at the start, kg·m²/s.
    pub(super) momentum: [f64; 3],
    pub(super) kinetic_energy: f64,
    /// Largest |ω| along each axis, rad/s.
    pub(super) amplitudes: [f64; 3],
    /// Elliptic parameter m.
    pub(super) parameter: f64,
    /// √(1 − m); zero only on the separatrix.
    pub(super) complementary_modulus: f64,
    /// |λ|, rad/s.
    pub(super) polhode_rate: f64,
    /// Period 4K/λ of ω in the body, s; not finite if the motion does not repeat.
    pub(super) period: f64,
    /// Mean precession rate Ω, rad/s.
    pub(super) precession: f64,
    /// Smallest and largest angle between L and axis 3, rad.
    pub(super) nutation: [f64; 2],
}

impl Constants {
    /// Returns the components of a body vector along the labelled axes.
    pub(super) fn along<Q>(&self, v: Vector<Q, Body>) -> [f64; 3] {
        self.axes.map(|axis| axis.dot(v))
    }

    /// Returns the body vector with the given components along the labelled axes.
    pub(super) fn in_body<Q>(&self, [a, b, c]: [f64; 3]) -> Vector<Q, Body> {
        let [e1, e2, e3] = self.axes;
        (e1 * a + e2 * b + e3 * c).as_quantity()
    }

    /// Computes the constants. `kg_m2` and `rad_s`, powers of two, are the units of the labelled
    /// moments and rates.
    pub(super) fn of(elements: &Elements, labelled: &Labelled, kg_m2: f64, rad_s: f64) -> Self {
        let ([i1, i2, i3], w) = (labelled.moments, labelled.omega.map(Triple::double));
        let moments = labelled.moments.map(Triple::double);
        let ratio = |d: Triple, i: Double| if i.is_zero() { 0.0 } else { d.double().over(i).value() };
        let momentum = [0, 1, 2].map(|k| moments[k] * w[k]);
        let twice_t = momentum[0] * w[0] + momentum[1] * w[1] + momentum[2] * w[2];
        let k1 = elements.k1.value();
        let [a1, a2, a3] = elements.amplitudes.map(Double::value);
        Self {
            axes: labelled.axes.map(Vector::from_array),
            moments: moments.map(|i| i.value() * kg_m2),
            ratios: [ratio(i2 - i3, moments[0]), ratio(i3 - i1, moments[1]), ratio(i1 - i2, moments[2])],
            momentum: momentum.map(|l| l.value() * kg_m2 * rad_s),
            // The order of the factors matters: no intermediate product leaves the range of f64
            // unless T does.
            kinetic_energy: 0.5 * twice_t.value() * (kg_m2 * rad_s) * rad_s,
            amplitudes: elements.rates.map(|a| a.value() * rad_s),
            parameter: elements.m.value(),
            complementary_modulus: k1,
            polhode_rate: elements.lambda.abs().value() * rad_s,
            period: if k1 == 0.0 {
                f64::INFINITY
            } else {
                4.0 * (elements.quarter / elements.lambda.abs()).value() / rad_s
            },
            precession: elements.half_precession.value() * (4.0 * PI) * rad_s,
            // L3 = A3 dn lies between A3 and A3 √(1 − m); at the latter |L2| = A2.
            nutation: [libm::atan2(a1, a3), libm::atan2(a2, a3 * k1)],
        }
    }
}
