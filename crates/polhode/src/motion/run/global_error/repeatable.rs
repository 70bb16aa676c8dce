//! Motions that can be computed again, with perturbed inputs and other steps.

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

/// Relative tolerance within which the times of two endings count as equal.
const SHIFT: f64 = 1e-6;

/// Largest number of steps and samples for which an estimate is thorough by default: some
/// hundredths of a second.
const FEW: u64 = 10_000;
/// The same limit for DOP853 and splitting, whose motions take several times as long as those of
/// Taylor's method.
const FEW_OF_MANY_STAGES: u64 = 3_000;
/// The same limit for motions on the ground and in gimbals, whose steps cost more.
const FEW_OF_HELD: u64 = 500;

/// Motion that can be computed again. Events that only stop it or are only recorded are omitted,
/// because they do not change it.
pub(super) trait Repeatable {
    /// Returns the largest number of steps and samples for which an estimate is thorough by
    /// default.
    fn few(&self) -> u64;

    /// Returns the states of a comparison run at the times, as far as it gets. `progress` receives
    /// the time after each step; if it returns `false`, the computation stops.
    ///
    /// # Errors
    /// The errors of [`Simulation::run_watched`](crate::motion::Simulation::run_watched).
    fn states(
        &self,
        run: ComparisonRun,
        times: &[f64],
        progress: &mut dyn FnMut(f64) -> bool,
    ) -> Result<Vec<State>, MotionError>;
}

/// Rotor whose motion was integrated by `rule`.
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
        // Taylor's method is the most accurate, and its order differs from that of the other
        // methods.
        let finest = || if self.problem.rough_torque().is_none() { Rule::Taylor } else { Rule::Dop853 };
        let rule = if run.is_finest { finest() } else { self.rule };
        let body = (rotor, history.as_ref());
        let tolerance = run.tolerance(tolerance);
        let stepper = Stepper::new(rule, body, torques, switched_off, *start, tolerance, false)?;
        // The times of the half turns of torsions also differ slightly.
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

    /// Computes a run with changed tensor and lever of the rotor, and changed angles and rates at
    /// the start.
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

/// Returns the states at the times, as far as the motion gets. A motion that ended by itself may
/// end slightly earlier or later.
fn reached(motion: &Trajectory, times: &[f64], ended: bool) -> Vec<State> {
    let is_at = |k: usize, there: f64, time: f64| {
        there == time || ended && k + 1 == times.len() && (there - time).abs() <= SHIFT * time.abs()
    };
    let both = motion.samples().iter().map(|sample| sample.state).zip(times).enumerate();
    both.take_while(|(k, (state, time))| is_at(*k, state.time, **time)).map(|(_, (state, _))| state).collect()
}
