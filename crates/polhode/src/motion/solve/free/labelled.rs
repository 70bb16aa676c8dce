//! Principal axes of the body, labelled so that L circles axis 3.

use core::cmp::Ordering;

use crate::math::double::Double;
use crate::math::frame::Body;
use crate::math::rotation::Rotation;
use crate::math::symmetric3::power_of_two_near;
use crate::math::triple::Triple;
use crate::math::vector::Vector;

/// Principal axis that L circles, given by the sign of L² − 2T i2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mode {
    /// L circles the axis of the greatest moment.
    Short,
    /// L circles the axis of the least moment.
    Long,
}

/// Moments and ω along right-handed principal axes.
///
/// The labels satisfy i1 < i2 < i3 in short-axis mode, i1 > i2 > i3 in long-axis mode, and ω3 ≥ 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Labelled {
    pub(super) mode: Mode,
    pub(super) moments: [Triple; 3],
    pub(super) omega: [Triple; 3],
    /// Components of each axis in the body axes in which the moments were given.
    pub(super) axes: [[f64; 3]; 3],
    /// L² − 2T i2 = i1 (i1 − i2) ω1² + i3 (i3 − i2) ω3². Its sign determines the mode; it is zero
    /// on the separatrix.
    ///
    /// Unit: `excess_unit`², a power of two. Near the intermediate axis the value itself can leave
    /// the range of f64.
    pub(super) excess: Double,
    pub(super) excess_unit: f64,
}

impl Labelled {
    /// Labels the axes. `moments`: principal moments in any order. `omega`: ω along the
    /// right-handed `axes`.
    pub(super) fn of(moments: [Triple; 3], omega: [Triple; 3], axes: [[f64; 3]; 3]) -> Self {
        let unsorted =
            Self { mode: Mode::Short, moments, omega, axes, excess: Double::default(), excess_unit: 1.0 };
        let ascending = unsorted.sorted();
        let (excess, excess_unit) = ascending.excess_of_momentum();
        let [_, i2, i3] = ascending.moments;
        // On the boundary a prolate body belongs to the long-axis mode; its two equal axes are then
        // 1 and 2.
        let long = excess.value() < 0.0 || (excess.value() == 0.0 && i2 == i3);
        let labelled = Self { excess: excess.double(), excess_unit, ..ascending };
        let labelled = if long { labelled.reversed() } else { labelled };
        if labelled.omega[2].value() < 0.0 { labelled.half_turned() } else { labelled }
    }

    /// Rotation from labelled components to those of the body axes.
    pub(super) fn rotation(&self) -> Rotation<Body, Body> {
        Rotation::from_axes(self.axes.map(Vector::from_array))
    }

    /// Returns true if ω is zero or lies exactly along one axis. It then stays there, for any
    /// moments.
    pub(super) fn is_permanent(&self) -> bool {
        self.omega.iter().filter(|w| !w.is_zero()).count() <= 1
    }

    /// Permutes the axes cyclically so that ω lies along axis 3.
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

    /// Sorts the axes by moment. Axis 2 is reversed if the order is otherwise left-handed.
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

    /// Relabels the axes as 3, −2, 1, which is again right-handed.
    fn reversed(self) -> Self {
        let ([i1, i2, i3], [w1, w2, w3], [e1, e2, e3]) = (self.moments, self.omega, self.axes);
        let reversed =
            Self { mode: Mode::Long, moments: [i3, i2, i1], omega: [w3, w2, w1], axes: [e3, e2, e1], ..self };
        reversed.with_second_reversed()
    }

    /// Rotates the axes by π about axis 1.
    fn half_turned(mut self) -> Self {
        self.omega[2] = -self.omega[2];
        self.axes[2] = self.axes[2].map(|c| -c);
        self.with_second_reversed()
    }

    /// Returns L² − 2T i2 = i1 (i1 − i2) ω1² + i3 (i3 − i2) ω3² and the square root of its unit.
    /// The sum is formed in three words because it can cancel.
    fn excess_of_momentum(&self) -> (Triple, f64) {
        let ([i1, i2, i3], [w1, _, w3]) = (self.moments, self.omega);
        let unit = power_of_two_near(w1.value().abs().max(w3.value().abs()));
        let [w1, w3] = [w1, w3].map(|w| w.scaled(1.0 / unit));
        (i1 * (i1 - i2) * w1.square() + i3 * (i3 - i2) * w3.square(), unit)
    }
}
