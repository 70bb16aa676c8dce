//! Taylor steps put together.

use std::rc::Rc;

use super::torque::StepStart;
use super::{Expansion, Increment};
use crate::math::frame::{Body, Principal, Space};
use crate::math::rotation::Rotation;
use crate::math::sum::two_sum;
use crate::math::vector::{AngularMomentum, AngularVelocity, Vector};
use crate::motion::error::MotionError;
use crate::motion::propagate::orientation::Orientation;
use crate::motion::propagate::piece::Piece;
use crate::motion::propagate::stepper::{Balanced, StepStatistics};
use crate::motion::state::State;

/// Adaptive Taylor steps over the motion of one body.
///
/// The series about the state that a step starts from is kept until the next step: it is the dense output. Each sum carries its rounding.
#[derive(Debug)]
pub(in crate::motion::propagate) struct Taylor<'a> {
    piece: Rc<Piece<'a>>,
    expansion: Box<Expansion>,
    /// Body axes from principal ones.
    to_body: Rotation<Body, Principal>,
    /// What the expansion is about.
    base: Base,
    /// Now.
    head: Base,
    h: f64,
    omega_scale: f64,
    statistics: StepStatistics,
}

/// A place on the trajectory; what rounding took from each sum is carried.
#[derive(Clone, Copy, Debug)]
struct Base {
    time: f64,
    orientation: Orientation,
    omega: [[f64; 2]; 3],
    work: [f64; 2],
    impulse: [[f64; 2]; 3],
}

impl<'a> Taylor<'a> {
    pub(in crate::motion::propagate) fn new(
        piece: Rc<Piece<'a>>,
        start: State,
        tolerance: f64,
    ) -> Result<Self, MotionError> {
        let to_body = piece.rotor.principal().rotation();
        let omega = (to_body.inverse() * start.omega).to_array();
        let head = Base {
            time: start.time,
            orientation: Orientation::new(start.attitude * to_body),
            omega: omega.map(|w| [w, 0.0]),
            work: [0.0; 2],
            impulse: [[0.0; 2]; 3],
        };
        let mut taylor = Self {
            expansion: Box::new(Expansion::new(&piece, tolerance)),
            // A body at rest is measured by how fast the torque makes it.
            omega_scale: start.omega.norm().max(torque_rate(&piece)),
            piece,
            to_body,
            base: head,
            head,
            h: 0.0,
            statistics: StepStatistics::default(),
        };
        taylor.expand()?;
        Ok(taylor)
    }

    /// Goes on from here with what acts from now on.
    ///
    /// # Errors
    /// As [`Taylor::new`].
    pub(in crate::motion::propagate) fn change(&mut self, piece: Rc<Piece<'a>>) -> Result<(), MotionError> {
        self.omega_scale = self.omega_scale.max(torque_rate(&piece));
        self.expansion.act(&piece);
        self.piece = piece;
        self.expand()
    }

    /// One step forward, not beyond `until`.
    ///
    /// # Errors
    /// As [`crate::motion::propagate::stepper::Stepper::step`].
    pub(in crate::motion::propagate) fn step(&mut self, until: f64) -> Result<(), MotionError> {
        if self.base.time != self.head.time {
            self.expand()?;
        }
        let (time, rest) = (self.base.time, until - self.base.time);
        let wanted = self.h.min(self.expansion.reach());
        let h = if wanted >= rest { rest } else { wanted };
        if h.is_nan() {
            return Err(MotionError::NotFinite { time });
        }
        if !(time + h > time) {
            return Err(MotionError::StepTooSmall { time, step: h });
        }
        let mut head = self.base.plus(&self.expansion.at(h));
        if !head.is_finite() {
            return Err(MotionError::NotFinite { time });
        }
        head.time = if wanted >= rest { until } else { time + h };
        self.head = head;
        self.omega_scale = self.omega_scale.max(head.omega().norm());
        self.statistics.accepted += 1;
        Ok(())
    }

    /// # Errors
    /// [`MotionError::TorqueWithoutInertia`] if nothing would balance the torque.
    fn expand(&mut self) -> Result<(), MotionError> {
        self.base = self.head;
        let Base { time, orientation, .. } = self.base;
        let start = StepStart { time, attitude: orientation.rotation(), omega: self.base.omega() };
        self.expansion.expand(&start, &self.piece);
        if let Some(torque) = self.expansion.unbalanced() {
            return Err(MotionError::TorqueWithoutInertia { torque, time: self.base.time });
        }
        self.h = self.expansion.step(self.omega_scale);
        self.statistics.evaluations += self.expansion.order() as u64;
        Ok(())
    }

    pub(in crate::motion::propagate) fn time(&self) -> f64 {
        self.head.time
    }

    /// The step that the tolerance allows, s: that of the last step until the next.
    pub(in crate::motion::propagate) fn next_step(&self) -> f64 {
        self.h
    }

    pub(in crate::motion::propagate) fn statistics(&self) -> StepStatistics {
        self.statistics
    }

    pub(in crate::motion::propagate) fn now(&self) -> Balanced {
        self.balanced(&self.head)
    }

    /// The state at a time within the last step.
    pub(in crate::motion::propagate) fn at(&self, time: f64) -> Balanced {
        let mut there = self.base.plus(&self.expansion.at(time - self.base.time));
        there.time = time;
        self.balanced(&there)
    }

    fn balanced(&self, base: &Base) -> Balanced {
        let attitude = base.orientation.rotation() * self.to_body.inverse();
        let omega = self.to_body * base.omega();
        let state = State { time: base.time, attitude, omega };
        Balanced {
            state,
            work: base.work[0],
            impulse: Vector::from_array(base.impulse.map(|[high, _]| high)),
        }
    }
}

/// √(N/I), rad/s.
fn torque_rate(piece: &Piece<'_>) -> f64 {
    (piece.largest_torque / piece.rotor.principal().moments()[2]).sqrt()
}

impl Base {
    fn omega(&self) -> AngularVelocity<Principal> {
        Vector::from_array(self.omega.map(|[high, _]| high))
    }

    fn is_finite(&self) -> bool {
        self.omega().is_finite() && self.orientation.rotation().quaternion().iter().all(|c| c.is_finite())
    }

    fn plus(&self, more: &Increment) -> Self {
        let mut sum = *self;
        sum.orientation.add(more.turn);
        let carried = |[high, carry]: [f64; 2], more: f64| {
            let (high, carry) = two_sum(high, more + carry);
            [high, carry]
        };
        let at_end: Rotation<Space, Principal> = sum.orientation.rotation();
        let impulse: AngularMomentum<Space> = at_end * AngularMomentum::from_array(more.impulse);
        let impulse = impulse.to_array();
        sum.omega = core::array::from_fn(|k| carried(self.omega[k], more.omega[k]));
        sum.impulse = core::array::from_fn(|k| carried(self.impulse[k], impulse[k]));
        sum.work = carried(self.work, more.work);
        sum
    }
}
