//! Splitting: impulses (kicks) by the torque, and the exact free flow between them.
//!
//! A kick changes the angular momentum at one attitude, L ← L + b h N(attitude, t). Between kicks
//! the body moves freely, without an error of the method: L in space is constant, and the attitude
//! rotates (`flow.rs`). L is stored in space axes, so that it is rounded only in kicks.
//!
//! If the torque has a potential, every step is a symplectic map. It does not preserve T + U but a
//! nearby quantity, so the energy error stays bounded; see `book/splitting.md`.
//!
//! Impulse is the sum that the kicks have added to L. Work is the sum that they have added to T, ΔL
//! · ½(ω before + ω after). Their balances test the free flow and rounding, but not the step
//! length. The latter is tested by T + U, or by a run with half the step.
//!
//! Source: J. Touma, J. Wisdom, Astron. J. 107 (1994) 1189 (rigid bodies split into free motion and
//! kicks); R. I. McLachlan, G. R. W. Quispel, Acta Numerica 11 (2002) 341.

mod flow;
mod scheme;

use std::rc::Rc;

use super::balanced::Balanced;
use super::noise::Noise;
use super::orientation::Orientation;
use super::piece::Piece;
use super::rounding::{ROUNDING, THIN};
use super::step_statistics::StepStatistics;
use crate::math::frame::{Body, Principal, Space};
use crate::math::rotation::Rotation;
use crate::math::sum::two_sum;
use crate::math::vector::{AngularMomentum, AngularVelocity, Torque, Vector};
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;
use flow::FreeFlow;
use scheme::Scheme;

pub use scheme::SplittingOrder;

/// Integrator with constant steps for the motion of one body.
#[derive(Debug)]
pub(super) struct Splitting<'a> {
    piece: Rc<Piece<'a>>,
    scheme: Scheme,
    flow: FreeFlow,
    /// Rotation from principal to body axes.
    to_body: Rotation<Body, Principal>,
    /// ω along an axis without inertia; constant.
    spin: f64,
    /// L at the start, space axes.
    start: AngularMomentum<Space>,
    /// State at the start of the last step.
    base: Head,
    /// State at the end of the last step, which is the state now.
    head: Head,
    /// Step length, s.
    h: f64,
    /// Time from which steps are counted. A sum of many step lengths would lose accuracy.
    origin: f64,
    count: u64,
    statistics: StepStatistics,
}

/// Point of the trajectory. Each sum carries its rounding error in a second word.
#[derive(Clone, Copy, Debug)]
struct Head {
    time: f64,
    orientation: Orientation,
    /// L, space axes.
    momentum: [[f64; 2]; 3],
    work: [f64; 2],
    /// Torque at this point. The last torque of a step is the first of the next one.
    torque: Torque<Principal>,
}

impl<'a> Splitting<'a> {
    /// Prepares the integration from a state.
    ///
    /// # Errors
    /// - A parameter error ([`MotionError::is_parameter`]) for a step that is not positive and
    ///   finite.
    /// - [`MotionError::NotSplittable`] for wheels, or a torque that is not a function of attitude
    ///   and time.
    /// - [`MotionError::TorqueWithoutInertia`] if the torque cannot be balanced.
    pub(super) fn new(
        piece: Rc<Piece<'a>>,
        torques: &[TorqueModel],
        start: State,
        order: SplittingOrder,
        step: f64,
    ) -> Result<Self, MotionError> {
        require::positive("the step", step)?;
        require_splittable(&piece, torques)?;
        let to_body = piece.rotor.principal().rotation();
        let omega = to_body.inverse() * start.omega;
        let attitude = start.attitude * to_body;
        let momentum = attitude * piece.angular_momentum(start.time, omega);
        let head = Head {
            time: start.time,
            orientation: Orientation::new(attitude),
            momentum: momentum.to_array().map(|l| [l, 0.0]),
            work: [0.0; 2],
            torque: Torque::ZERO,
        };
        let mut splitting = Self {
            flow: FreeFlow::of(piece.rotor),
            piece,
            scheme: Scheme::of(order),
            to_body,
            spin: omega.x,
            start: momentum,
            base: head,
            head,
            h: step,
            origin: start.time,
            count: 0,
            statistics: StepStatistics::default(),
        };
        splitting.begin()?;
        Ok(splitting)
    }

    /// Continues with other acting torques.
    ///
    /// # Errors
    /// [`MotionError::TorqueWithoutInertia`] if the torque cannot be balanced.
    pub(super) fn change(&mut self, piece: Rc<Piece<'a>>) -> Result<(), MotionError> {
        self.piece = piece;
        self.begin()
    }

    fn begin(&mut self) -> Result<(), MotionError> {
        let Head { time, orientation, .. } = self.head;
        self.head.torque = self.torque(time, orientation.rotation(), orientation.rotation());
        self.statistics.evaluations += 1;
        self.require_determined()
    }

    /// Takes one step forward, not beyond `until`.
    ///
    /// # Errors
    /// Those of [`super::stepper::Stepper::step`].
    pub(super) fn step(&mut self, until: f64) -> Result<(), MotionError> {
        let Head { time, .. } = self.head;
        let planned = self.origin + (self.count + 1) as f64 * self.h;
        // If the remaining time is only rounding, the step ends exactly at `until`.
        let is_last = planned >= until - 4.0 * f64::EPSILON * until.abs();
        let is_whole = planned <= until + 4.0 * f64::EPSILON * until.abs();
        let h = if is_whole { self.h } else { until - time };
        if !(time + h > time) {
            return Err(MotionError::StepTooSmall { time, step: h });
        }
        let mut head = self.after(&self.head, h);
        if !head.is_finite() {
            return Err(MotionError::NotFinite { time });
        }
        head.time = if is_last { until } else { planned };
        (self.base, self.head) = (self.head, head);
        (self.origin, self.count) = if is_whole { (self.origin, self.count + 1) } else { (until, 0) };
        self.statistics.accepted += 1;
        self.statistics.evaluations += self.scheme.stages.len() as u64;
        self.require_determined()
    }

    /// Perturbs the state at the end of the last step.
    pub(super) fn perturb(&mut self, noise: &mut Noise) {
        let in_body = |head: &Head| head.orientation.rotation().inverse() * head.momentum();
        let [before, after] = [&self.base, &self.head].map(in_body);
        let [p, q] = [before, after].map(|l| self.flow.omega(l, self.spin).to_array());
        let [x, y, z] = noise.turn(self.head.time - self.base.time, p, q);
        let more = noise.rate(before.to_array(), after.to_array());
        let more: AngularMomentum<Space> =
            self.head.orientation.rotation() * AngularMomentum::from_array(more);
        self.head.orientation.add([0.0, 0.5 * x, 0.5 * y, 0.5 * z]);
        for (l, more) in self.head.momentum.iter_mut().zip(more.to_array()) {
            l[0] += more;
        }
    }

    /// Returns the result of one step of any length from a point.
    fn after(&self, from: &Head, h: f64) -> Head {
        let mut head = *from;
        let mut momentum = self.kick(&mut head, self.scheme.first * h);
        for stage in &self.scheme.stages {
            head.orientation.add(self.flow.turn(momentum, self.spin, stage.flow * h));
            let time = from.time + stage.at * h;
            head.torque = self.torque(time, head.orientation.rotation(), from.orientation.rotation());
            momentum = self.kick(&mut head, stage.kick * h);
        }
        head
    }

    /// Applies a kick, L ← L + τ N, and returns the new L, principal axes.
    fn kick(&self, head: &mut Head, tau: f64) -> AngularMomentum<Principal> {
        let attitude = head.orientation.rotation();
        let before = attitude.inverse() * head.momentum();
        let mut torque = head.torque;
        if torque == Torque::ZERO {
            return before;
        }
        if self.piece.rotor.principal().moments()[0] == 0.0 {
            torque.x = 0.0;
        }
        let impulse: AngularMomentum<Principal> = (torque * tau).as_quantity();
        let after = before + impulse;
        let carried = |[high, carry]: [f64; 2], more: f64| {
            let (high, carry) = two_sum(high, more + carry);
            [high, carry]
        };
        let [x, y, z] = (attitude * impulse).to_array();
        let [l1, l2, l3] = head.momentum;
        head.momentum = [carried(l1, x), carried(l2, y), carried(l3, z)];
        let rate = self.flow.omega(before, self.spin) + self.flow.omega(after, self.spin);
        head.work = carried(head.work, 0.5 * impulse.dot(rate));
        after
    }

    /// Returns the torque at an attitude. Twists are continued from `near`, the attitude at the
    /// start of the step.
    fn torque(
        &self,
        time: f64,
        attitude: Rotation<Space, Principal>,
        near: Rotation<Space, Principal>,
    ) -> Torque<Principal> {
        if self.piece.torques.is_empty() {
            return Torque::ZERO;
        }
        // None of these torques depends on ω.
        let state = State { time, attitude: attitude * self.to_body.inverse(), omega: AngularVelocity::ZERO };
        let torque = self.to_body.inverse() * self.piece.torque(&state, near * self.to_body.inverse());
        // As in `chart.rs`: about the axis of a needle the torque is only rounding.
        let [i1, i2, i3] = self.piece.rotor.principal().moments();
        let clean = |n: f64, i: f64| {
            if i < THIN * i3 && n.abs() < ROUNDING * self.piece.largest_torque { 0.0 } else { n }
        };
        Torque::new(clean(torque.x, i1), clean(torque.y, i2), torque.z)
    }

    /// Returns an error for a torque about an axis without inertia. Only a rod has one, and it is
    /// principal axis 1.
    fn require_determined(&self) -> Result<(), MotionError> {
        let Head { time, torque, .. } = self.head;
        if self.piece.rotor.principal().moments()[0] == 0.0 && torque.x != 0.0 {
            return Err(MotionError::TorqueWithoutInertia { torque: torque.x, time });
        }
        Ok(())
    }

    pub(super) fn time(&self) -> f64 {
        self.head.time
    }

    /// Returns the step length, s.
    pub(super) fn next_step(&self) -> f64 {
        self.h
    }

    pub(super) fn statistics(&self) -> StepStatistics {
        self.statistics
    }

    pub(super) fn now(&self) -> Balanced {
        self.balanced(&self.head)
    }

    /// Returns the state at a time within the last step, by a shorter step from the same start.
    pub(super) fn at(&self, time: f64) -> Balanced {
        let mut there = self.after(&self.base, time - self.base.time);
        there.time = time;
        self.balanced(&there)
    }

    /// Returns to a time within the last step.
    pub(super) fn cut(&mut self, time: f64) {
        if time != self.head.time {
            self.head = self.after(&self.base, time - self.base.time);
            self.head.time = time;
            (self.origin, self.count) = (time, 0);
        }
    }

    fn balanced(&self, head: &Head) -> Balanced {
        let attitude = head.orientation.rotation();
        let omega = self.flow.omega(attitude.inverse() * head.momentum(), self.spin);
        let state = State {
            time: head.time,
            attitude: attitude * self.to_body.inverse(),
            omega: self.to_body * omega,
        };
        Balanced { state, work: head.work[0], impulse: head.momentum() - self.start }
    }
}

impl Head {
    fn momentum(&self) -> AngularMomentum<Space> {
        Vector::from_array(self.momentum.map(|[high, _]| high))
    }

    fn is_finite(&self) -> bool {
        self.momentum().is_finite()
            && self.torque.is_finite()
            && self.orientation.rotation().quaternion().iter().all(|c| c.is_finite())
    }
}

/// Returns an error for wheels, and for torques that are not functions of attitude and time.
fn require_splittable(piece: &Piece<'_>, torques: &[TorqueModel]) -> Result<(), MotionError> {
    if !piece.rotor.wheels().is_empty() {
        return Err(MotionError::NotSplittable { what: "wheel", why: "it acts inside the body" });
    }
    let refused = torques.iter().find_map(|torque| Some((torque.name(), torque.model().unsplittable()?)));
    refused.map_or(Ok(()), |(what, why)| Err(MotionError::NotSplittable { what, why }))
}
