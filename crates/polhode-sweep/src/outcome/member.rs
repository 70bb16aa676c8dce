//! Outcome of one member.

use polhode::motion::{
    Ending, ErrorEffort, Event, FreeMotion, GlobalError, Mechanism, MotionError, Pointing, Regime, Rotor,
    Sample, Scenario, State, StateError, StepStatistics, Trajectory,
};
use polhode::observe::{Drift, FreeRegime};
use polhode_scenario::report::Periods;
use polhode_source::FormatError;

use super::extrema::Extrema;
use super::free;
use super::instant::Instant;

/// Outcome of one member. Quantities that do not exist or were not reached are `None`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Outcome {
    pub(super) status: Status,
    pub(super) cause: Option<String>,
    /// Mass, kg.
    pub(super) mass: Option<f64>,
    /// Principal moments about the point of rotation, kg·m².
    pub(super) moments: Option<[f64; 3]>,
    pub(super) regime: Option<Regime>,
    pub(super) end_regime: Option<Regime>,
    /// Periods, for free motion.
    pub(super) free: Option<FreePeriods>,
    pub(super) start: Option<Instant>,
    pub(super) end: Option<Instant>,
    pub(super) extrema: Option<Extrema>,
    /// Estimated error of the final state.
    pub(super) error: Option<StateError>,
    /// Occurrences of each event of the scenario.
    pub(super) events: Vec<Happened>,
    pub(super) steps: Option<StepStatistics>,
    /// Angles of each pointing of the scenario.
    pub(super) pointings: Vec<Pointed>,
}

/// Status of a member's motion at its end.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) enum Status {
    Complete,
    /// Stopped by the event with this name, or by a change of the contact with the ground.
    Stopped(String),
    #[default]
    Failed,
}

/// Periods of a free motion, s, and its regime.
#[derive(Clone, Copy, Debug)]
pub(super) struct FreePeriods {
    pub(super) regime: FreeRegime,
    pub(super) periods: Periods,
}

/// Occurrences of an event.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Happened {
    pub(super) count: u32,
    /// Time of the first occurrence, s.
    pub(super) first: Option<f64>,
}

/// Angle along the samples of a motion, rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pointed {
    pub(super) least: f64,
    pub(super) largest: f64,
    pub(super) end: f64,
}

impl Outcome {
    /// Computes the outcome of a member's scenario, or of the error in it.
    pub(crate) fn of(scenario: Result<&Scenario, &FormatError>) -> Self {
        let scenario = match scenario {
            Ok(scenario) => scenario,
            // Without the path, so that the row does not depend on the plan's location.
            Err(error) => return Self { cause: Some(error.message()), ..Self::default() },
        };
        let rotor = scenario.rotor();
        let body = Self {
            mass: Some(scenario.body().mass()),
            moments: Some(rotor.principal().moments()),
            ..Self::default()
        };
        body.moved(scenario, rotor)
    }

    /// Adds the outcome of the motion, or the cause of its failure.
    fn moved(self, scenario: &Scenario, rotor: &Rotor) -> Self {
        if let Some((motion, end)) = free::motion(scenario, rotor) {
            return match free::outcome(&motion, end) {
                Some(found) => self.with_free(&motion).with_found(&motion, &found),
                None => self.failed(&MotionError::NotFinite { time: end }),
            };
        }
        match scenario.simulate_with_error(ErrorEffort::Cheap, &mut |_| true) {
            Some(Ok(trajectory)) => self.with(scenario, rotor, &trajectory),
            Some(Err(error)) => self.failed(&error),
            None => Self { cause: Some("the plan has no [run] section".to_owned()), ..self },
        }
    }

    fn failed(self, error: &MotionError) -> Self {
        Self { status: Status::Failed, cause: Some(error.to_string()), ..self }
    }

    /// Adds the outcome of a trajectory. A failed one keeps its start and events.
    fn with(self, scenario: &Scenario, rotor: &Rotor, trajectory: &Trajectory) -> Self {
        let (first, last) = (trajectory.start(), trajectory.samples().last());
        let can_be_free = scenario.prescribed().is_none()
            && scenario.wheels().is_empty()
            && scenario.mechanism() == Mechanism::Rotor;
        let free = |state: &State| if can_be_free { FreeMotion::of(rotor, *state).ok() } else { None };
        let at_start = free(&first.state);
        let start = Self {
            regime: at_start.as_ref().map(FreeMotion::regime),
            start: Some(Instant::of(first)),
            ..self
        };
        let start = match at_start {
            Some(motion) if scenario.torques().is_empty() => start.with_free(&motion),
            _ => start,
        };
        let happened = Self {
            events: scenario.events().iter().enumerate().map(|(k, _)| happened(k, trajectory)).collect(),
            steps: trajectory.solution().statistics(),
            ..start
        };
        let status = match trajectory.ending() {
            Ending::Complete => Status::Complete,
            Ending::Stopped { event, .. } => {
                Status::Stopped(scenario.events().get(*event).map_or("", Event::name).to_owned())
            }
            Ending::Contact { change, .. } => Status::Stopped(change.name().to_owned()),
            Ending::Failed { cause, .. } => return happened.failed(cause),
        };
        Self {
            status,
            end: last.map(Instant::of),
            end_regime: last.and_then(|last| free(&last.state)).map(|motion| motion.regime()),
            extrema: Some(Extrema::of(rotor, trajectory, Drift::of(trajectory))),
            error: trajectory.error().map(GlobalError::end),
            pointings: scenario.pointings().iter().filter_map(|p| pointed(p, trajectory)).collect(),
            ..happened
        }
    }

    fn with_free(self, motion: &FreeMotion) -> Self {
        let regime = FreeRegime::of_motion(motion);
        let free = Some(FreePeriods { regime, periods: Periods::of(motion) });
        Self { regime: Some(regime.regime), free, ..self }
    }

    /// Adds the ends and extrema of a free motion.
    fn with_found(self, motion: &FreeMotion, found: &free::Found) -> Self {
        Self {
            status: Status::Complete,
            end_regime: self.regime,
            start: Some(found.start),
            end: Some(found.end),
            extrema: Some(found.extrema),
            error: Some(motion.formula_error(found.end.state.time - found.start.state.time)),
            ..self
        }
    }
}

impl Instant {
    fn of(sample: &Sample) -> Self {
        let momentum = sample.momentum.norm();
        Self { state: sample.state, kinetic_energy: sample.kinetic_energy, momentum }
    }
}

/// Returns the angles over start and samples; `None` without samples.
fn pointed(pointing: &Pointing, trajectory: &Trajectory) -> Option<Pointed> {
    let angle = |sample: &Sample| pointing.angle(&sample.state);
    let angles = || std::iter::once(trajectory.start()).chain(trajectory.samples()).map(angle);
    Some(Pointed {
        least: angles().fold(f64::INFINITY, f64::min),
        largest: angles().fold(0.0, f64::max),
        end: trajectory.samples().last().map(angle)?,
    })
}

fn happened(event: usize, trajectory: &Trajectory) -> Happened {
    let mut times = trajectory.events().iter().filter(|c| c.event == event).map(|c| c.state.time);
    let first = times.next();
    Happened { count: u32::from(first.is_some()).saturating_add(times.count() as u32), first }
}
