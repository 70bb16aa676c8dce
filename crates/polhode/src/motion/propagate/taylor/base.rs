//! Places on a trajectory, that steps lead from and to.

use super::Increment;
use crate::math::frame::{Body, Principal};
use crate::math::number::Number;
use crate::math::rotation::Rotation;
use crate::math::sum::two_sum;
use crate::math::vector::{AngularVelocity, Vector};
use crate::motion::propagate::orientation::Orientation;
use crate::motion::state::State;

/// A place on the trajectory of each lane; what rounding took from each sum is carried.
#[derive(Clone, Copy, Debug)]
pub(super) struct Base<N = f64> {
    pub(super) time: N,
    pub(super) orientation: Orientation<N>,
    /// Principal axes.
    omega: [[N; 2]; 3],
}

impl<N: Number> Base<N> {
    pub(super) fn all(zero: N) -> Self {
        Self { time: zero, orientation: Orientation::all(zero), omega: [[zero; 2]; 3] }
    }

    #[inline(always)]
    pub(super) fn plus(&self, more: &Increment<N>, time: N) -> Self {
        let mut orientation = self.orientation;
        orientation.add(more.turn);
        let omega = core::array::from_fn(|k| carried(self.omega[k], more.omega[k]));
        Self { time, orientation, omega }
    }

    pub(super) fn put(&mut self, lane: usize, one: &Base) {
        self.time.put(lane, one.time);
        self.orientation.put(lane, &one.orientation);
        for (place, value) in self.omega.iter_mut().flatten().zip(one.omega.iter().flatten()) {
            place.put(lane, *value);
        }
    }

    pub(super) fn lane(&self, lane: usize) -> Base {
        Base {
            time: self.time.lane(lane),
            orientation: self.orientation.lane(lane),
            omega: self.omega.map(|w| w.map(|w| w.lane(lane))),
        }
    }

    /// ω, principal axes.
    #[inline(always)]
    pub(super) fn rates(&self) -> [N; 3] {
        self.omega.map(|[high, _]| high)
    }
}

impl Base {
    pub(super) fn new(start: &State, to_body: Rotation<Body, Principal>) -> Self {
        let omega = (to_body.inverse() * start.omega).to_array();
        Self {
            time: start.time,
            orientation: Orientation::new(start.attitude * to_body),
            omega: omega.map(|w| [w, 0.0]),
        }
    }

    pub(super) fn omega(&self) -> AngularVelocity<Principal> {
        Vector::from_array(self.rates())
    }

    pub(super) fn is_finite(&self) -> bool {
        self.omega().is_finite() && self.orientation.rotation().quaternion().iter().all(|c| c.is_finite())
    }

    pub(super) fn state(&self, to_body: Rotation<Body, Principal>) -> State {
        let attitude = self.orientation.rotation() * to_body.inverse();
        State { time: self.time, attitude, omega: to_body * self.omega() }
    }
}

#[inline(always)]
pub(super) fn carried<N: Number>([high, carry]: [N; 2], more: N) -> [N; 2] {
    let (high, carry) = two_sum(high, more + carry);
    [high, carry]
}
