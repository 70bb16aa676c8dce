//! A motion computed again, a little differently, and how far it is from the first.

use core::f64::consts::PI;

use super::StateError;
use super::inputs::Inputs;
use crate::motion::closed_form::ClosedForm;
use crate::motion::course::Course;
use crate::motion::error::MotionError;
use crate::motion::event::Event;
use crate::motion::propagate::noise::Noise;
use crate::motion::propagate::stepper::{Rule, Stepper};
use crate::motion::sample::Sample;
use crate::motion::simulation::Simulation;
use crate::motion::state::State;
use crate::motion::trajectory::Trajectory;

/// How much the error of ω at one time may be raised, as that of the attitude has been larger before.
const MOST_RAISED: f64 = 30.0;

/// A run from other inputs, with other steps.
pub(super) struct Perturbed<'a> {
    pub(super) simulation: &'a Simulation<'a>,
    pub(super) inputs: Inputs,
    /// `None` for a closed form.
    pub(super) rule: Option<Rule>,
    pub(super) tolerance: f64,
    pub(super) noise: Option<Noise>,
}

/// How far the states of two motions are from one another, at each sample.
#[derive(Clone, Debug, Default)]
pub(super) struct Distance {
    /// The angle between the attitudes, rad.
    attitude: Vec<f64>,
    /// |δω|, rad/s.
    omega: Vec<f64>,
}

impl Perturbed<'_> {
    /// From the samples of a trajectory; infinite where the perturbed motion does not get to.
    pub(super) fn distance(&self, trajectory: &Trajectory) -> Distance {
        let samples = trajectory.samples();
        let times: Vec<f64> = samples.iter().map(|sample| sample.state.time).collect();
        let states = self.states(&times);
        let mut states = states.iter();
        let apart = |sample: &Sample| match states.next() {
            None => [f64::INFINITY; 2],
            Some(state) => {
                let delta = (state.omega - sample.state.omega).norm();
                [state.attitude.angle_to(sample.state.attitude), delta]
            }
        };
        let (attitude, omega) = samples.iter().map(apart).map(|[angle, delta]| (angle, delta)).unzip();
        Distance { attitude, omega }
    }

    /// The states at the times, as far as the motion gets.
    fn states(&self, times: &[f64]) -> Vec<State> {
        let Inputs { rotor, start } = &self.inputs;
        match self.rule {
            Some(rule) => self.integrated(rule, times).unwrap_or_default(),
            None => {
                let torques = self.simulation.torques;
                let other = ClosedForm::of(rotor, torques, *start)
                    // Not every change keeps the symmetry that a closed form needs.
                    .or_else(|_| ClosedForm::of(self.simulation.rotor, torques, *start));
                other
                    .map_or_else(|_| Vec::new(), |motion| times.iter().map(|&time| motion.at(time)).collect())
            }
        }
    }

    fn integrated(&self, rule: Rule, times: &[f64]) -> Result<Vec<State>, MotionError> {
        let Simulation { torques, switched_off, events, .. } = *self.simulation;
        let Inputs { rotor, start } = &self.inputs;
        let mut stepper = Stepper::new(rule, rotor, torques, switched_off, *start, self.tolerance, false)?;
        if let Some(noise) = &self.noise {
            stepper = stepper.with_noise(noise.clone());
        }
        // What stops the motion, or is only written down, does not change it.
        let switches: Vec<Event> = events.iter().filter(|event| event.switches()).cloned().collect();
        let mut course = Course::new(stepper, &switches, *start, times);
        course.run(*start, &mut |_| {})?;
        Ok(course
            .samples
            .iter()
            .zip(times)
            .take_while(|(s, t)| s.state.time == **t)
            .map(|(s, _)| s.state)
            .collect())
    }
}

impl Distance {
    /// The larger of each.
    pub(super) fn worse(self, other: Self) -> Self {
        let worse = |a: Vec<f64>, b: Vec<f64>| a.into_iter().zip(b).map(|(a, b)| a.max(b)).collect();
        Self { attitude: worse(self.attitude, other.attitude), omega: worse(self.omega, other.omega) }
    }

    /// Divided by a number.
    pub(super) fn over(mut self, by: f64) -> Self {
        self.attitude.iter_mut().chain(&mut self.omega).for_each(|x| *x /= by);
        self
    }

    /// True if no attitude is further away than an angle.
    pub(super) fn is_within(&self, angle: f64) -> bool {
        self.attitude.iter().all(|a| *a <= angle)
    }

    /// Another distance where this one is beyond an angle.
    pub(super) fn or_beyond(mut self, angle: f64, other: &Self) -> Self {
        for (k, (a, w)) in self.attitude.iter_mut().zip(&mut self.omega).enumerate() {
            if !(*a <= angle)
                && let (Some(other_a), Some(other_w)) = (other.attitude.get(k), other.omega.get(k))
            {
                (*a, *w) = (*other_a, *other_w);
            }
        }
        self
    }

    /// The error along the way: the attitude's is the largest so far, and ω's is raised by as much, as both come from the same phase.
    pub(super) fn relative_to(&self, trajectory: &Trajectory, floor: StateError) -> Vec<StateError> {
        let mut largest = 0.0_f64;
        let samples = trajectory.samples().iter().zip(self.attitude.iter().zip(&self.omega));
        samples
            .map(|(sample, (&angle, &delta))| {
                largest = largest.max(angle);
                let raised = if angle > 0.0 { (largest / angle).min(MOST_RAISED) } else { 1.0 };
                let (delta, rate) = (raised * delta, sample.state.omega.norm());
                let omega = if delta == 0.0 { 0.0 } else { delta / rate };
                StateError { attitude: (largest + floor.attitude).min(PI), omega: omega + floor.omega }
            })
            .collect()
    }
}
