//! From a start along principal axes, in steps of one length, to states.

use super::Member;
use crate::math::frame::{Principal, Space};
use crate::math::rotation::Rotation;
use crate::math::vector::Vector;
use crate::motion::error::MotionError;
use crate::motion::propagate::bound::MOST_STEPS;
use crate::motion::state::State;

/// A start along principal axes.
pub(super) struct Begin {
    pub(super) omega: [f64; 3],
    pub(super) q: [f64; 4],
}

impl Begin {
    pub(super) fn of(member: &Member) -> Self {
        let r = member.rotor.principal().rotation();
        let attitude: Rotation<Space, Principal> = member.start.attitude * r;
        Self { omega: (r.inverse() * member.start.omega).to_array(), q: attitude.quaternion() }
    }
}

/// The state of q and ω along principal axes; `None` if they are not finite.
pub(super) fn finished(member: &Member, time: f64, q: [f64; 4], omega: [f64; 3]) -> Option<State> {
    let r = member.rotor.principal().rotation();
    let attitude = Rotation::<Space, Principal>::from_quaternion(q).ok()? * r.inverse();
    let omega = r * Vector::from_array(omega);
    omega.is_finite().then_some(State { time, attitude, omega })
}

/// Steps of one length from one time to another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pace {
    start: f64,
    pub(super) count: u64,
    pub(super) step: f64,
}

impl Pace {
    /// The longest that are not longer than a step, but for rounding.
    ///
    /// # Errors
    /// [`MotionError::TooManySteps`] from the `start` of all to the last of its times, [`MotionError::StepTooSmall`] beside the time.
    pub(super) fn new(
        time: f64,
        until: f64,
        longest: f64,
        start: f64,
        times: &[f64],
    ) -> Result<Self, MotionError> {
        let end = times.last().copied().unwrap_or(until);
        if (end - start) / longest > MOST_STEPS as f64 {
            return Err(MotionError::TooManySteps { time, step: longest, most: MOST_STEPS });
        }
        // A quotient that is whole but for rounding is whole.
        let count = ((until - time) / longest * (1.0 - 1e-12)).ceil().max(0.0);
        let step = if count > 0.0 { (until - time) / count } else { longest };
        if count > 0.0 && !(time + step > time) {
            return Err(MotionError::StepTooSmall { time, step });
        }
        Ok(Self { start: time, count: count as u64, step })
    }

    /// After so many steps.
    #[inline(always)]
    pub(super) fn time(&self, steps: f64) -> f64 {
        self.start + steps * self.step
    }
}
