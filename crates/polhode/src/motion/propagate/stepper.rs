//! What steps from one time to the next, whichever method it is.

use std::rc::Rc;

use super::piece::Piece;
use super::runge_kutta::RungeKutta;
use super::splitting::{Splitting, SplittingOrder};
use super::taylor::Taylor;
use crate::math::frame::Space;
use crate::math::vector::AngularMomentum;
use crate::motion::error::MotionError;
use crate::motion::rotor::Rotor;
use crate::motion::state::State;
use crate::motion::torque::TorqueModel;

/// The tightest tolerance that rounding leaves room for.
pub const TIGHTEST_TOLERANCE: f64 = 1e-15;
/// The loosest tolerance that still means a solution.
pub const LOOSEST_TOLERANCE: f64 = 1e-2;

/// What a run cost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StepStatistics {
    /// Steps kept.
    pub accepted: u64,
    /// Steps whose error was too large.
    pub rejected: u64,
    /// Evaluations of the equations of motion for the steps, by DOP853, whose samples between steps cost eleven more; coefficients of
    /// all unknowns, by Taylor's method.
    pub evaluations: u64,
}

/// A state with the work and the angular impulse that torque has given the body since the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Balanced {
    pub(crate) state: State,
    /// ∫ N · ω dt, J.
    pub(crate) work: f64,
    /// ∫ N dt in space axes, N·m·s.
    pub(crate) impulse: AngularMomentum<Space>,
}

/// The integrators.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Rule {
    Taylor,
    Dop853,
    Splitting { order: SplittingOrder, step: f64 },
}

/// The motion of one body, step by step.
#[derive(Debug)]
pub(crate) struct Stepper<'a> {
    rotor: &'a Rotor,
    torques: &'a [TorqueModel],
    /// Which of them are switched on.
    switched_on: Vec<bool>,
    /// The first time at which something begins or ends by itself.
    until: f64,
    tolerance: f64,
    /// True if a spring or wire is among the torques: its twist is watched.
    is_sprung: bool,
    rule: Steps<'a>,
}

#[derive(Debug)]
enum Steps<'a> {
    Taylor(Box<Taylor<'a>>),
    Dop853(Box<RungeKutta<'a>>),
    Splitting(Box<Splitting<'a>>),
}

impl<'a> Stepper<'a> {
    /// # Errors
    /// [`MotionError::Parameter`] if the tolerance is outside 1e-15 … 1e-2, or a given step not positive and finite;
    /// [`MotionError::NotSplittable`]; [`MotionError::NotSpinnable`]; [`MotionError::TorqueWithoutInertia`] if the torque cannot be
    /// balanced.
    pub(crate) fn new(
        rule: Rule,
        rotor: &'a Rotor,
        torques: &'a [TorqueModel],
        start: State,
        tolerance: f64,
    ) -> Result<Self, MotionError> {
        let has_tolerance = !matches!(rule, Rule::Splitting { .. });
        if has_tolerance && !(TIGHTEST_TOLERANCE..=LOOSEST_TOLERANCE).contains(&tolerance) {
            let rule = "between 1e-15 and 1e-2";
            return Err(MotionError::Parameter { what: "the tolerance", value: tolerance, rule });
        }
        if !rotor.is_spinnable() {
            return Err(MotionError::NotSpinnable);
        }
        let piece = Rc::new(Piece::new(rotor, torques.iter(), &start));
        let until = piece.until;
        let is_sprung = torques.iter().any(|torque| torque.name() == "torsion");
        let rule = match rule {
            Rule::Taylor => Steps::Taylor(Box::new(Taylor::new(piece, start, tolerance)?)),
            Rule::Dop853 => Steps::Dop853(Box::new(RungeKutta::new(piece, start, tolerance)?)),
            Rule::Splitting { order, step } => {
                Steps::Splitting(Box::new(Splitting::new(piece, torques, start, order, step)?))
            }
        };
        Ok(Self { rotor, torques, switched_on: vec![true; torques.len()], until, tolerance, is_sprung, rule })
    }

    /// Looks again at what acts now.
    fn change(&mut self) -> Result<(), MotionError> {
        let state = self.now().state;
        let torques =
            self.torques.iter().zip(&self.switched_on).filter(|(_, on)| **on).map(|(torque, _)| torque);
        let piece = Rc::new(Piece::new(self.rotor, torques, &state));
        self.until = piece.until;
        match &mut self.rule {
            Steps::Taylor(taylor) => taylor.change(piece),
            Steps::Dop853(dop853) => dop853.change(piece),
            Steps::Splitting(splitting) => splitting.change(piece),
        }
    }

    /// What is stepped: the body, and what turns it.
    pub(crate) fn subject(&self) -> (&'a Rotor, &'a [TorqueModel]) {
        (self.rotor, self.torques)
    }

    /// `None` for steps of a given length.
    pub(crate) fn tolerance(&self) -> Option<f64> {
        (!matches!(self.rule, Steps::Splitting(_))).then_some(self.tolerance)
    }

    pub(crate) fn rule(&self) -> Rule {
        match &self.rule {
            Steps::Taylor(_) => Rule::Taylor,
            Steps::Dop853(_) => Rule::Dop853,
            Steps::Splitting(splitting) => splitting.rule(),
        }
    }

    /// One step forward, not beyond `until`, nor beyond a time at which a torque begins or ends.
    ///
    /// # Errors
    /// [`MotionError::StepTooSmall`], [`MotionError::NotFinite`] or [`MotionError::TorqueWithoutInertia`]; the stepper
    /// stays at the last good state. [`MotionError::HalfTurn`] after a step that went too far.
    pub(crate) fn step(&mut self, until: f64) -> Result<(), MotionError> {
        if self.time() >= self.until {
            self.change()?;
        }
        let until = until.min(self.until);
        let before = self.is_sprung.then(|| self.now().state);
        match &mut self.rule {
            Steps::Taylor(taylor) => taylor.step(until),
            Steps::Dop853(dop853) => dop853.step(until),
            Steps::Splitting(splitting) => splitting.step(until),
        }?;
        before.map_or(Ok(()), |before| self.require_untwisted(&before))
    }

    /// # Errors
    /// [`MotionError::HalfTurn`] if a spring or wire that acts has been twisted beyond half a turn.
    fn require_untwisted(&self, before: &State) -> Result<(), MotionError> {
        let after = self.now().state.attitude;
        let acting = self.torques.iter().zip(&self.switched_on).filter(|(_, on)| **on);
        let is_beyond =
            acting.filter_map(|(torque, _)| torque.acting(before.time)).any(|torque| match torque {
                TorqueModel::Torsion(torsion) => torsion.passes_half_turn(before.attitude, after),
                _ => false,
            });
        if is_beyond { Err(MotionError::HalfTurn { time: before.time }) } else { Ok(()) }
    }

    pub(crate) fn time(&self) -> f64 {
        match &self.rule {
            Steps::Taylor(taylor) => taylor.time(),
            Steps::Dop853(dop853) => dop853.time(),
            Steps::Splitting(splitting) => splitting.time(),
        }
    }

    /// The step that the tolerance allows next, or the given one, s.
    pub(crate) fn next_step(&self) -> f64 {
        match &self.rule {
            Steps::Taylor(taylor) => taylor.next_step(),
            Steps::Dop853(dop853) => dop853.next_step(),
            Steps::Splitting(splitting) => splitting.next_step(),
        }
    }

    pub(crate) fn statistics(&self) -> StepStatistics {
        match &self.rule {
            Steps::Taylor(taylor) => taylor.statistics(),
            Steps::Dop853(dop853) => dop853.statistics(),
            Steps::Splitting(splitting) => splitting.statistics(),
        }
    }

    /// The state now.
    pub(crate) fn now(&self) -> Balanced {
        match &self.rule {
            Steps::Taylor(taylor) => taylor.now(),
            Steps::Dop853(dop853) => dop853.now(),
            Steps::Splitting(splitting) => splitting.now(),
        }
    }

    /// The state at a time within the last step: dense output.
    pub(crate) fn at(&self, time: f64) -> Balanced {
        match &self.rule {
            Steps::Taylor(taylor) => taylor.at(time),
            Steps::Dop853(dop853) => dop853.at(time),
            Steps::Splitting(splitting) => splitting.at(time),
        }
    }
}
