//! A motion by DOP853 under torques that somebody else computes, for many bodies at once.

use super::super::dop853::STAGES;
use super::super::runge_kutta::{Attempt, End, RungeKutta};
use super::{Rule, Stepper, Steps};
use crate::motion::error::MotionError;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;

/// The motion of one body that stops wherever a torque is to be known: it says in which state, and goes on from there.
///
/// Its steps are those of [`Stepper::step`], one evaluation after the other: the bits are those of the body alone.
#[derive(Debug)]
pub(in crate::motion) struct Resumable<'a> {
    stepper: Stepper<'a>,
    times: &'a [f64],
    /// The states at the times, as far as it came.
    pub(in crate::motion) states: Vec<State>,
    waiting: Waiting<'a>,
}

/// What the torque is needed for.
#[derive(Debug)]
enum Waiting<'a> {
    /// Nothing: it has come to the last time.
    Done,
    /// Something begins or ends now.
    Change,
    /// A stage of a step.
    Stage(Box<Attempt<'a>>, usize),
    /// The end of a step.
    End(Box<Attempt<'a>>, End),
    /// A stage of a shorter step, to a time within the last one.
    Sample(Box<Attempt<'a>>, usize),
}

impl<'a> Resumable<'a> {
    /// From a start to times, which ascend; the torque is that of the start.
    ///
    /// # Errors
    /// As [`Stepper::new`], and as of the first step.
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

    /// The state in which the torque is to be known; `None` at the end.
    pub(in crate::motion) fn wanted(&self) -> Option<State> {
        match &self.waiting {
            Waiting::Done => None,
            Waiting::Change => Some(self.stepper.now().state),
            Waiting::Stage(attempt, stage) | Waiting::Sample(attempt, stage) => Some(attempt.place(*stage)),
            Waiting::End(attempt, end) => Some(attempt.end(end)),
        }
    }

    /// Goes on, as the torque is known.
    ///
    /// # Errors
    /// As [`Stepper::step`].
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

    /// What comes after a step, or after a state that was wanted.
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
            // It was made with no other rule.
            Steps::Taylor(_) | Steps::Splitting(_) => Err(MotionError::NotFinite { time }),
        }
    }

    /// The last of the times, s.
    fn end(&self) -> f64 {
        self.times.last().copied().unwrap_or_else(|| self.stepper.time())
    }
}
