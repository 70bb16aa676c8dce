//! DOP853 with torques that the caller computes, for many bodies simultaneously.

use super::super::dop853::STAGES;
use super::super::runge_kutta::{Attempt, End, RungeKutta};
use super::{Rule, Stepper, Steps};
use crate::motion::error::MotionError;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;

/// Motion of one body that pauses whenever a torque is needed. The caller reads the state, computes
/// the torque and resumes.
///
/// The steps are those of [`Stepper::step`], one evaluation at a time, and the results are
/// bit-identical.
#[derive(Debug)]
pub(in crate::motion) struct Resumable<'a> {
    stepper: Stepper<'a>,
    times: &'a [f64],
    /// States at the times reached so far.
    pub(in crate::motion) states: Vec<State>,
    waiting: Waiting<'a>,
}

/// Purpose for which the next torque is needed.
#[derive(Debug)]
enum Waiting<'a> {
    /// None: the last time has been reached.
    Done,
    /// A change of what acts.
    Change,
    /// A stage of a step, by index.
    Stage(Box<Attempt<'a>>, usize),
    /// The end of a step.
    End(Box<Attempt<'a>>, End),
    /// A stage of a shorter step, which ends at a sample time within the last step.
    Sample(Box<Attempt<'a>>, usize),
}

impl<'a> Resumable<'a> {
    /// Starts a motion at `start`. `times` must be ascending. The torque at the start must be
    /// known.
    ///
    /// # Errors
    /// Those of [`Stepper::new`], and those of the first step.
    pub(in crate::motion) fn new(
        rotor: &'a Rotor,
        torques: &'a [TorqueModel],
        start: State,
        times: &'a [f64],
        tolerance: f64,
    ) -> Result<Self, (Vec<State>, MotionError)> {
        let stepper = Stepper::new(Rule::Dop853, (rotor, None), torques, &[], start, tolerance, false);
        let stepper = stepper.map_err(|cause| (Vec::new(), cause))?;
        let states = Vec::with_capacity(times.len());
        let mut motion = Self { stepper, times, states, waiting: Waiting::Done };
        match motion.next() {
            Ok(()) => Ok(motion),
            Err(cause) => Err((motion.states, cause)),
        }
    }

    /// Returns the state at which the torque is needed; `None` at the end.
    pub(in crate::motion) fn wanted(&self) -> Option<State> {
        match &self.waiting {
            Waiting::Done => None,
            Waiting::Change => Some(self.stepper.now().state),
            Waiting::Stage(attempt, stage) | Waiting::Sample(attempt, stage) => Some(attempt.place(*stage)),
            Waiting::End(attempt, end) => Some(attempt.end(end)),
        }
    }

    /// Continues, now that the torque is known.
    ///
    /// # Errors
    /// Those of [`Stepper::step`].
    pub(in crate::motion) fn resume(&mut self) -> Result<(), MotionError> {
        match core::mem::replace(&mut self.waiting, Waiting::Done) {
            Waiting::Done => Ok(()),
            Waiting::Change => {
                self.stepper.change()?;
                self.begin()
            }
            Waiting::Stage(mut attempt, stage) => {
                attempt.evaluate(stage);
                if stage + 1 < STAGES {
                    self.waiting = Waiting::Stage(attempt, stage + 1);
                    return Ok(());
                }
                let judged = self.dop853()?.judge(&attempt);
                match judged.map_err(|cause| self.stepper.explained(cause))? {
                    Some(end) => self.waiting = Waiting::End(attempt, end),
                    None => {
                        let mut again = self.attempt()?;
                        again.was_rejected = true;
                        self.waiting = Waiting::Stage(again, 1);
                    }
                }
                Ok(())
            }
            Waiting::End(attempt, end) => {
                let finished = self.dop853()?.finish(&attempt, &end);
                finished.map_err(|cause| self.stepper.explained(cause))?;
                let end = self.end();
                self.stepper.require_bounded(end)?;
                self.next()
            }
            Waiting::Sample(mut attempt, stage) => {
                attempt.evaluate(stage);
                if stage + 1 < STAGES {
                    self.waiting = Waiting::Sample(attempt, stage + 1);
                    return Ok(());
                }
                self.states.push(attempt.reached());
                self.next()
            }
        }
    }

    /// Continues after a step or a sample.
    fn next(&mut self) -> Result<(), MotionError> {
        while let Some(&time) = self.times.get(self.states.len()) {
            if self.stepper.time() < time {
                if self.stepper.time() >= self.stepper.until {
                    self.waiting = Waiting::Change;
                    return Ok(());
                }
                return self.begin();
            }
            let shorter = match &self.stepper.steps {
                Steps::Dop853(steps) if time != steps.time() => steps.shorter(time),
                _ => None,
            };
            if let Some(shorter) = shorter {
                self.waiting = Waiting::Sample(Box::new(shorter), 1);
                return Ok(());
            }
            self.states.push(self.stepper.now().state);
        }
        Ok(())
    }

    /// Begins a step.
    fn begin(&mut self) -> Result<(), MotionError> {
        self.stepper.from = self.stepper.time();
        self.waiting = Waiting::Stage(self.attempt()?, 1);
        Ok(())
    }

    fn attempt(&mut self) -> Result<Box<Attempt<'a>>, MotionError> {
        let until = self.end().min(self.stepper.until);
        let attempt = self.dop853()?.attempt(until);
        attempt.map(Box::new).map_err(|cause| self.stepper.explained(cause))
    }

    fn dop853(&mut self) -> Result<&mut RungeKutta<'a>, MotionError> {
        let time = self.stepper.time();
        match &mut self.stepper.steps {
            Steps::Dop853(steps) => Ok(steps),
            // A `Resumable` is always created with DOP853.
            Steps::Taylor(_) | Steps::Splitting(_) => Err(MotionError::NotFinite { time }),
        }
    }

    /// Returns the last of the times, s.
    fn end(&self) -> f64 {
        self.times.last().copied().unwrap_or_else(|| self.stepper.time())
    }
}
