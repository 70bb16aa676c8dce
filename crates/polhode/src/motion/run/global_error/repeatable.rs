//! Motions that are computed again, from inputs and with steps that are a little different.

use super::comparison::ComparisonRun;
use super::inputs::{Change, Inputs};
use crate::body::inertia::InertiaTensor;
use crate::body::mass_properties::MassProperties;
use crate::math::vector::Vector;
use crate::motion::contact::ContactStart;
use crate::motion::contact::problem::ContactProblem;
use crate::motion::error::MotionError;
use crate::motion::gimbal::problem::GimbalProblem;
use crate::motion::model::event::Event;
use crate::motion::model::event_detection::{EventDetector, EventSide};
use crate::motion::model::state::State;
use crate::motion::run::ending::Ending;
use crate::motion::run::march::March;
use crate::motion::run::rotor_problem::RotorProblem;
use crate::motion::run::trajectory::Trajectory;
use crate::motion::run::turning::Turning;
use crate::motion::run::{in_gimbals, on_ground};
use crate::motion::solve::propagate::stepper::{Rule, Stepper};

/// Relative difference of the times of two ends that count as the same one.
const SHIFT: f64 = 1e-6;

/// Number of steps and samples up to which an estimate is thorough by default: some hundredths of a second.
const FEW: u64 = 10_000;
/// Steps of DOP853 and of splitting take several times as long as Taylor's for the same accuracy.
const FEW_OF_MANY_STAGES: u64 = 3_000;
/// Steps on the ground and in gimbals cost more than others.
const FEW_OF_HELD: u64 = 500;

/// A motion that is computed again. What stops it, or is only written down, does not change it and is left out.
pub(super) trait Repeatable {
    /// Number of steps and samples up to which an estimate is thorough by default.
    fn few(&self) -> u64;

    /// States of a comparison run at the times, as far as it gets. `progress` receives the time after
    /// each step; `false` ends the work.
    ///
    /// # Errors
    /// As [`Simulation::run_watched`](crate::motion::Simulation::run_watched).
    fn states(
        &self,
        run: ComparisonRun,
        times: &[f64],
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Vec<State>, MotionError>;
}

/// A rotor whose motion was integrated by a rule.
pub(super) struct IntegratedRotor<'a> {
    pub(super) problem: &'a RotorProblem<'a>,
    pub(super) rule: Rule,
}

impl Repeatable for IntegratedRotor<'_> {
    fn few(&self) -> u64 {
        if self.rule == Rule::Taylor { FEW } else { FEW_OF_MANY_STAGES }
    }

    fn states(
        &self,
        run: ComparisonRun,
        times: &[f64],
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Vec<State>, MotionError> {
        let RotorProblem { torques, switched_off, events, event_sides, tolerance, .. } = *self.problem;
        let Inputs { rotor, history, start } = &Inputs::of(self.problem, run.inputs);
        // Taylor's method is the most accurate, and of another order than the others.
        let finest = || if self.problem.rough_torque().is_none() { Rule::Taylor } else { Rule::Dop853 };
        let rule = if run.is_finest { finest() } else { self.rule };
        let body = (rotor, history.as_ref());
        let tolerance = run.tolerance(tolerance);
        let stepper = Stepper::new(rule, body, torques, switched_off, *start, tolerance, false)?;
        // The times of the half turns of torsions differ a little, too.
        let stepper = stepper.perturbed(run.steps).beyond_half_turns();
        let switches: Vec<Event> = events.iter().filter(|event| event.switches()).cloned().collect();
        let sides = events.iter().zip(event_sides).filter(|(event, _)| event.switches());
        let sides: Vec<EventSide> = sides.map(|(_, side)| *side).collect();
        let turning = Turning::new(stepper, &switches);
        let first = turning.first(*start)?;
        let detector = EventDetector::new(rotor, torques, (&switches, &sides), start);
        let mut march = March::new(turning, detector, times);
        march.run(first, None, progress)?;
        let got_there = march.samples.iter().zip(times).take_while(|(s, time)| s.state.time == **time);
        Ok(got_there.map(|(sample, _)| sample.state).collect())
    }
}

impl Repeatable for ContactProblem<'_> {
    fn few(&self) -> u64 {
        FEW_OF_HELD
    }

    fn states(
        &self,
        run: ComparisonRun,
        times: &[f64],
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Vec<State>, MotionError> {
        let (mut change, body) = (Change::new(run.inputs), self.body);
        let inertia = InertiaTensor::from_symmetric(change.inertia(body.inertia().symmetric()));
        let changed =
            inertia.and_then(|inertia| MassProperties::new(body.mass(), body.center_of_mass(), inertia));
        let start = ContactStart { state: change.start(self.start.state), ..self.start };
        let (tolerance, noise) = (run.tolerance(self.bound()), Some(run.steps));
        let (body, contact) = (changed.unwrap_or(*body), self.contact);
        let body = &body;
        let (events, event_sides) = (&[], &[]);
        let problem = ContactProblem { body, contact, start, times, events, event_sides, tolerance, noise };
        let motion = on_ground::run(&problem, progress)?;
        let ended = matches!(motion.ending(), Ending::Contact { .. });
        Ok(reached(&motion, times, ended))
    }
}

impl Repeatable for GimbalProblem<'_> {
    fn few(&self) -> u64 {
        FEW_OF_HELD
    }

    /// Changes the tensor and the lever of the rotor, and the angles and rates at the start.
    fn states(
        &self,
        run: ComparisonRun,
        times: &[f64],
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Vec<State>, MotionError> {
        let mut change = Change::new(run.inputs);
        let (body, gimbals) = (self.body, self.gimbals);
        let inertia = InertiaTensor::from_symmetric(change.inertia(body.inertia().symmetric()));
        let lever = (body.center_of_mass() - gimbals.crossing()).to_array();
        let center = gimbals.crossing() + Vector::from_array(change.each(lever));
        let changed = inertia.and_then(|inertia| MassProperties::new(body.mass(), center, inertia));
        let axes = gimbals.axes().map(|axis| {
            let [angle, rate] = change.each([axis.angle(), axis.rate()]);
            axis.starting(angle, rate)
        });
        let (body, gimbals) = (changed.unwrap_or(*body), gimbals.with_axes(axes));
        let (body, gimbals, start) = (&body, &gimbals, self.start);
        let (tolerance, noise) = (run.tolerance(self.tolerance), Some(run.steps));
        let (events, event_sides) = (&[], &[]);
        let problem = GimbalProblem { body, gimbals, start, times, events, event_sides, tolerance, noise };
        let motion = in_gimbals::run(&problem, progress)?;
        let ended = matches!(motion.ending(), Ending::Failed { .. });
        Ok(reached(&motion, times, ended))
    }
}

/// The states that are at the times, as far as a motion gets; one that ended by itself ends a little earlier or later.
fn reached(motion: &Trajectory, times: &[f64], ended: bool) -> Vec<State> {
    let is_at = |k: usize, there: f64, time: f64| {
        there == time || ended && k + 1 == times.len() && (there - time).abs() <= SHIFT * time.abs()
    };
    let both = motion.samples().iter().map(|sample| sample.state).zip(times).enumerate();
    both.take_while(|(k, (state, time))| is_at(*k, state.time, **time)).map(|(_, (state, _))| state).collect()
}
