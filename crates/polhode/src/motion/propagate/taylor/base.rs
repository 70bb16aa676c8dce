//! Places on a trajectory, that steps lead from and to.

use super::Increment;
use super::row::Row;
use super::torque::StepStart;
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
        let ([x, y, z], [dx, dy, dz]) = (self.omega, more.omega);
        Self { time, orientation, omega: [carried(x, dx), carried(y, dy), carried(z, dz)] }
    }

    /// Sets a lane.
    pub(super) fn put(&mut self, lane: usize, one: &Base) {
        self.time.put(lane, one.time);
        self.orientation.put(lane, &one.orientation);
        for (place, value) in self.omega.iter_mut().flatten().zip(one.omega.iter().flatten()) {
            place.put(lane, *value);
        }
    }

    pub(super) fn lane(&self, lane: usize) -> Base {
        let at = |[high, carry]: &[N; 2]| [high.lane(lane), carry.lane(lane)];
        let [x, y, z] = &self.omega;
        Base {
            time: self.time.lane(lane),
            orientation: self.orientation.lane(lane),
            omega: [at(x), at(y), at(z)],
        }
    }

    /// What a step starts from.
    #[inline(always)]
    pub(super) fn start(&self) -> StepStart<N> {
        let [[x, _], [y, _], [z, _]] = self.omega;
        let attitude = Row(self.orientation.quaternion());
        StepStart { time: self.time, attitude, omega: Row([x, y, z, x.like(0.0)]) }
    }

    /// |ω|; only of what is finite.
    #[inline(always)]
    pub(super) fn rate(&self) -> N {
        self.start().omega.norm()
    }

    /// Zero of what is finite, and no number otherwise.
    #[inline(always)]
    pub(super) fn flaw(&self) -> N {
        let StepStart { attitude, omega, .. } = self.start();
        let none = |x: N| x * x.like(0.0);
        let ([x, y, z, _], [a, b, c, d]) = (omega.0, attitude.0);
        none(x) + none(y) + none(z) + (none(a) + none(b)) + (none(c) + none(d))
    }
}

impl Base {
    pub(super) fn new(start: &State, to_body: Rotation<Body, Principal>) -> Self {
        let [x, y, z] = (to_body.inverse() * start.omega).to_array();
        Self {
            time: start.time,
            orientation: Orientation::new(start.attitude * to_body),
            omega: [[x, 0.0], [y, 0.0], [z, 0.0]],
        }
    }

    pub(super) fn omega(&self) -> AngularVelocity<Principal> {
        let [[x, _], [y, _], [z, _]] = self.omega;
        Vector::new(x, y, z)
    }

    #[inline(always)]
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
