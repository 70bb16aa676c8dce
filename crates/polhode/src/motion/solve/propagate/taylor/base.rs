//! Points of the trajectory at which steps start and end.

use super::Increment;
use super::row::Row;
use super::torque::StepStart;
use crate::math::frame::{Body, Principal, Space};
use crate::math::number::Number;
use crate::math::rotation::Rotation;
use crate::math::sum::two_sum;
use crate::math::vector::{AngularVelocity, Vector};
use crate::motion::model::state::State;

/// Point of the trajectory, for each lane. Each sum carries its rounding error in a second word.
#[derive(Clone, Copy, Debug)]
pub(super) struct ExpansionPoint<N = f64> {
    pub(super) time: N,
    /// Quaternion from principal axes to space, of norm 1 up to rounding.
    turn: Carried<N>,
    /// ω, principal axes, rad/s.
    omega: Carried<N>,
}

/// Row, and the rounding error of its sum.
#[derive(Clone, Copy, Debug)]
struct Carried<N> {
    row: Row<N>,
    low: Row<N>,
}

impl<N: Number> Carried<N> {
    #[inline(always)]
    fn plus(self, more: Row<N>) -> Self {
        let (row, low) = two_sum(self.row, more + self.low);
        Self { row, low }
    }
}

impl<N: Number> ExpansionPoint<N> {
    pub(super) fn all(zero: N) -> Self {
        let none = Carried { row: Row::splat(zero), low: Row::splat(zero) };
        Self { time: zero, turn: none, omega: none }
    }

    /// Adds an increment: q ← q ⊗ (1 + d) = q + q ⊗ d, and the increment of ω.
    #[inline(always)]
    pub(super) fn plus(&self, more: &Increment<N>, time: N) -> Self {
        let ([w, x, y, z], [dw, dx, dy, dz]) = (self.turn.row.0, more.turn.0);
        let sum = Row([w, x, y, z]) * Row::splat(dw);
        let sum = Row([-x, w, z, -y]).mul_add(Row::splat(dx), sum);
        let sum = Row([-y, -z, w, x]).mul_add(Row::splat(dy), sum);
        let turn = Row([-z, y, -x, w]).mul_add(Row::splat(dz), sum);
        Self { time, turn: self.turn.plus(turn), omega: self.omega.plus(more.omega) }
    }

    /// Sets the point of a lane.
    pub(super) fn put(&mut self, lane: usize, one: &ExpansionPoint) {
        self.time.put(lane, one.time);
        for (place, one) in [(&mut self.turn, &one.turn), (&mut self.omega, &one.omega)] {
            place.row.put(lane, one.row);
            place.low.put(lane, one.low);
        }
    }

    pub(super) fn lane(&self, lane: usize) -> ExpansionPoint {
        let at = |of: &Carried<N>| Carried { row: of.row.lane(lane), low: of.low.lane(lane) };
        ExpansionPoint { time: self.time.lane(lane), turn: at(&self.turn), omega: at(&self.omega) }
    }

    /// Returns the state from which a step starts.
    #[inline(always)]
    pub(super) fn start(&self) -> StepStart<N> {
        let Carried { row: omega, low: omega_low } = self.omega;
        StepStart { time: self.time, attitude: self.attitude(), omega, omega_low }
    }

    /// Returns q/|q|, where |q| is 1 up to rounding, as in [`Rotation::near_unit`].
    #[inline(always)]
    fn attitude(&self) -> Row<N> {
        let q = self.turn.row;
        let [w, x, y, z] = (q * q).0;
        let s = w.like(1.5) - w.like(0.5) * ((w + x) + (y + z));
        q * Row::splat(s)
    }

    /// Returns |ω|, if ω is finite.
    #[inline(always)]
    pub(super) fn rate(&self) -> N {
        self.omega.row.norm()
    }

    /// Returns zero if all numbers are finite, and NaN otherwise.
    #[inline(always)]
    pub(super) fn not_finite(&self) -> N {
        let none = Row::splat(self.time.like(0.0));
        let [x, y, z, w] = (self.turn.row * none + self.omega.row * none).0;
        (x + y) + (z + w)
    }
}

impl ExpansionPoint {
    pub(super) fn new(start: &State, to_body: Rotation<Body, Principal>) -> Self {
        let [x, y, z] = (to_body.inverse() * start.omega).to_array();
        let exact = |row: [f64; 4]| Carried { row: Row(row), low: Row::ZERO };
        let attitude = start.attitude * to_body;
        Self { time: start.time, turn: exact(attitude.quaternion()), omega: exact([x, y, z, 0.0]) }
    }

    pub(super) fn omega(&self) -> AngularVelocity<Principal> {
        let [x, y, z, _] = self.omega.row.0;
        Vector::new(x, y, z)
    }

    /// Returns the attitude of the principal axes.
    #[inline(always)]
    pub(super) fn rotation(&self) -> Rotation<Space, Principal> {
        Rotation::from_unit(self.attitude().0)
    }

    #[inline(always)]
    pub(super) fn state(&self, to_body: Rotation<Body, Principal>) -> State {
        State {
            time: self.time,
            attitude: self.rotation() * to_body.inverse(),
            omega: to_body * self.omega(),
        }
    }
}
