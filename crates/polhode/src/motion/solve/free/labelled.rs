//! The body's principal axes, named so that L circles axis 3.

use core::cmp::Ordering;

use crate::math::double::Double;
use crate::math::frame::Body;
use crate::math::rotation::Rotation;
use crate::math::symmetric3::power_of_two_near;
use crate::math::triple::Triple;
use crate::math::vector::Vector;

/// Which axis L circles: the sign of L² − 2T i2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mode {
    /// Axis 3 is that of the greatest moment.
    Short,
    /// Axis 3 is that of the least moment.
    Long,
}

/// Moments and ω along right-handed principal axes, with i1 < i2 < i3 in short-axis mode and i1 > i2 > i3 in long-axis
/// mode, and ω3 ≥ 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Labelled {
    pub(super) mode: Mode,
    pub(super) moments: [Triple; 3],
    pub(super) omega: [Triple; 3],
    /// Each axis in the components of the to_body that the moments came in.
    pub(super) axes: [[f64; 3]; 3],
    /// L² − 2T i2 = i1 (i1 − i2) ω1² + i3 (i3 − i2) ω3²; its sign is the mode's. Zero on the separatrix.
    ///
    /// In units of `excess_unit`², a power of two: near the intermediate axis it leaves the range of f64.
    pub(super) excess: Double,
    pub(super) excess_unit: f64,
}

impl Labelled {
    /// From principal moments in any order, along right-handed `axes`, and ω along them.
    pub(super) fn of(moments: [Triple; 3], omega: [Triple; 3], axes: [[f64; 3]; 3]) -> Self {
        let unsorted =
            Self { mode: Mode::Short, moments, omega, axes, excess: Double::default(), excess_unit: 1.0 };
        let ascending = unsorted.sorted();
        let (excess, excess_unit) = ascending.excess_of_momentum();
        let [_, i2, i3] = ascending.moments;
        // On the boundary a prolate body belongs to the long-axis mode: its equal axes are then 1 and 2.
        let long = excess.value() < 0.0 || (excess.value() == 0.0 && i2 == i3);
        let labelled = Self { excess: excess.double(), excess_unit, ..ascending };
        let labelled = if long { labelled.reversed() } else { labelled };
        if labelled.omega[2].value() < 0.0 { labelled.half_turned() } else { labelled }
    }

    /// From labelled components to those of the to_body that the moments came in.
    pub(super) fn rotation(&self) -> Rotation<Body, Body> {
        Rotation::from_axes(self.axes.map(Vector::from_array))
    }

    /// True if ω lies exactly along one axis, or is zero: it stays there, whatever the moments.
    pub(super) fn is_permanent(&self) -> bool {
        self.omega.iter().filter(|w| !w.is_zero()).count() <= 1
    }

    /// The same axes, in cyclic order, with ω along axis 3.
    pub(super) fn about_omega(self) -> Self {
        let k = (0..3).find(|&k| !self.omega[k].is_zero()).unwrap_or(2);
        let order = [(k + 1) % 3, (k + 2) % 3, k];
        let turned = Self {
            moments: order.map(|k| self.moments[k]),
            omega: order.map(|k| self.omega[k]),
            axes: order.map(|k| self.axes[k]),
            ..self
        };
        if turned.omega[2].value() < 0.0 { turned.half_turned() } else { turned }
    }

    /// Axes in the order of their moments, axis 2 turned round if that makes them left-handed.
    fn sorted(self) -> Self {
        let mut order = [0, 1, 2];
        order.sort_by(|&a, &b| self.moments[a].partial_cmp(&self.moments[b]).unwrap_or(Ordering::Equal));
        let sorted = Self {
            moments: order.map(|k| self.moments[k]),
            omega: order.map(|k| self.omega[k]),
            axes: order.map(|k| self.axes[k]),
            ..self
        };
        let even = matches!(order, [0, 1, 2] | [1, 2, 0] | [2, 0, 1]);
        if even { sorted } else { sorted.with_second_reversed() }
    }

    fn with_second_reversed(mut self) -> Self {
        self.omega[1] = -self.omega[1];
        self.axes[1] = self.axes[1].map(|c| -c);
        self
    }

    /// Axes 3, −2, 1: right-handed again.
    fn reversed(self) -> Self {
        let ([i1, i2, i3], [w1, w2, w3], [e1, e2, e3]) = (self.moments, self.omega, self.axes);
        let reversed =
            Self { mode: Mode::Long, moments: [i3, i2, i1], omega: [w3, w2, w1], axes: [e3, e2, e1], ..self };
        reversed.with_second_reversed()
    }

    /// Turned by π about axis 1.
    fn half_turned(mut self) -> Self {
        self.omega[2] = -self.omega[2];
        self.axes[2] = self.axes[2].map(|c| -c);
        self.with_second_reversed()
    }

    /// L² − 2T i2 = i1 (i1 − i2) ω1² + i3 (i3 − i2) ω3², in three words: it may cancel.
    fn excess_of_momentum(&self) -> (Triple, f64) {
        let ([i1, i2, i3], [w1, _, w3]) = (self.moments, self.omega);
        let unit = power_of_two_near(w1.value().abs().max(w3.value().abs()));
        let [w1, w3] = [w1, w3].map(|w| w.scaled(1.0 / unit));
        (i1 * (i1 - i2) * w1.square() + i3 * (i3 - i2) * w3.square(), unit)
    }
}
