//! Simulations with the derivatives of the motion: by its start, by the inertia, and by parameters of the torques.

use super::ending::Ending;
use super::integration::Integration;
use super::simulation::Simulation;
use crate::math::vector::Direction;
use crate::motion::error::MotionError;
use crate::motion::model::event::Event;
use crate::motion::model::state::State;
use crate::motion::model::state_derivatives::StateDerivatives;
use crate::motion::model::torque::TorqueParameter;
use crate::motion::solve::method::Method;
use crate::motion::solve::propagate::stepper::{Rule, Stepper};

/// The derivatives of a motion at given times.
#[derive(Clone, Debug, PartialEq)]
pub struct TrajectoryDerivatives {
    /// The state at each time, and its derivatives by the start and by the inertia.
    pub states: Vec<StateDerivatives>,
    /// For each time, the derivatives of θ1 θ2 θ3 ω1 ω2 ω3 by each parameter.
    pub by_parameters: Vec<Vec<[f64; 6]>>,
    /// The events that happened, in the order of time.
    pub events: Vec<CrossingDerivatives>,
    /// How the motion ended.
    pub ending: Ending,
}

/// The derivatives of a crossing, whose time changes too.
#[derive(Clone, Debug, PartialEq)]
pub struct CrossingDerivatives {
    /// Which of the events, from 0.
    pub event: usize,
    /// The state there, and its derivatives as its time changes with what they are by: not those at a fixed time.
    pub state: StateDerivatives,
    /// Its derivatives by each parameter, in the same way.
    pub by_parameters: Vec<[f64; 6]>,
    /// Of its time, by θ(0) and ω(0), s/rad and s/(rad/s).
    pub time_by_start: [f64; 6],
    /// Of its time, by the elements of the inertia tensor, s/(kg·m²).
    pub time_by_inertia: [f64; 6],
    /// Of its time, by each parameter.
    pub time_by_parameters: Vec<f64>,
}

impl Simulation<'_> {
    /// As [`Simulation::run`], with derivatives: by the start, by the inertia tensor about the point that the body turns about, whose mass and
    /// lever stay, and by parameters of torques. Those at a time follow from variational equations, which are expanded in the same Taylor
    /// series as the motion; an event that switches a torque changes them, as its time changes.
    ///
    /// # Errors
    /// As [`Simulation::run`]; [`MotionError::NotSmooth`] for a torque without a power series, [`MotionError::NoParameter`],
    /// [`MotionError::NoMotionDerivatives`] for a method that has none, a rod, an event of what has no derivatives, where a torque has none on the
    /// way, and where two switches happen at once.
    ///
    /// ```
    /// use polhode::prelude::*;
    /// use polhode::motion::torque::TorqueParameter;
    /// // Spun up from rest by N along z, which is a principal axis: ω = N t/I, so ∂ω/∂N = t/I, ∂ω/∂I = −N t/I².
    /// let body = MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([1.0, 2.0, 2.5])?)?;
    /// let torques = [TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.0, 0.0, 0.5)))];
    /// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::ZERO };
    /// let rotor = Rotor::free(&body);
    /// let parameters = [TorqueParameter { torque: 0, name: "z" }];
    /// let motion = Simulation::new(&rotor, &torques, start, &[4.0]).run_with_derivatives(&parameters)?;
    /// assert!((motion.by_parameters[0][0][5] - 4.0 / 2.5).abs() < 1e-14);
    /// assert!((motion.states[0].by_inertia[5][2] + 0.5 * 4.0 / (2.5 * 2.5)).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn run_with_derivatives(
        &self,
        parameters: &[TorqueParameter],
    ) -> Result<TrajectoryDerivatives, MotionError> {
        let Self { rotor, torques, switched_off, start, events, times, tolerance, method } = *self;
        self.require_possible()?;
        let why_not = |why| Err(MotionError::NoMotionDerivatives { why, time: start.time });
        if !matches!(method, Method::Auto | Method::Taylor) {
            return why_not("they are found by Taylor's method");
        }
        if rotor.principal().moments()[0] == 0.0 {
            return why_not("a rod has no inertia about its own line");
        }
        if let Some(why) = events.iter().find_map(Event::roughness) {
            return why_not(why);
        }
        for (torque, model) in torques.iter().enumerate() {
            if let Some(why) = model.model().roughness() {
                return Err(MotionError::NotSmooth { torque, why });
            }
        }
        let parameters =
            parameters.iter().map(|parameter| parameter.of(torques)).collect::<Result<_, _>>()?;
        let stepper = Stepper::new(Rule::Taylor, rotor, torques, switched_off, start, tolerance, false)?;
        let stepper = stepper.differentiated(parameters);
        let mut integration = Integration::new(stepper, events, start, times).with_derivatives();
        let (_, ending) = integration.run(start, &mut |_| true)?;
        if let Ending::Failed { cause: cause @ MotionError::NoMotionDerivatives { .. }, .. } = ending {
            return Err(cause);
        }
        let DerivativeLog { states, by_parameters, events, .. } = integration.derivatives.unwrap_or_default();
        Ok(TrajectoryDerivatives { states, by_parameters, events, ending })
    }
}

/// The derivatives of a run as they are written down.
#[derive(Debug, Default)]
pub(super) struct DerivativeLog {
    states: Vec<StateDerivatives>,
    by_parameters: Vec<Vec<[f64; 6]>>,
    events: Vec<CrossingDerivatives>,
    /// How the time of a switch changes that is about to happen.
    switch: Option<Vec<f64>>,
}

impl DerivativeLog {
    /// Writes a sample down.
    pub(super) fn sample(&mut self, stepper: &Stepper<'_>, state: State) {
        let (derivatives, by_parameters) = arranged(state, &stepper.derivatives_at(state.time));
        self.states.push(derivatives);
        self.by_parameters.push(by_parameters);
    }

    /// Writes a crossing down.
    ///
    /// # Errors
    /// [`MotionError::NoMotionDerivatives`] if what is measured is at rest there, or if two switches happen at once.
    pub(super) fn cross(
        &mut self,
        stepper: &Stepper<'_>,
        (event, index): (&Event, usize),
        state: State,
    ) -> Result<(), MotionError> {
        let time = state.time;
        let rates = stepper.rates_at(time);
        let columns = stepper.derivatives_at(time);
        let (rotor, _) = stepper.subject();
        let slope = event.slope(rotor, &state, rates);
        let times: Vec<f64> =
            columns.iter().enumerate().map(|(k, column)| slope.time(column, k.checked_sub(6))).collect();
        if !times.iter().all(|time| time.is_finite()) {
            let why = "an event there is touched and not passed";
            return Err(MotionError::NoMotionDerivatives { why, time });
        }
        // x(t*): δx + ẋ δt*
        let moved: Vec<[f64; 6]> = columns
            .iter()
            .zip(&times)
            .map(|(column, time)| {
                let rates = rates.map(Direction::to_array);
                core::array::from_fn(|k| column[k] + rates[k / 3][k % 3] * time)
            })
            .collect();
        let (state, by_parameters) = arranged(state, &moved);
        let of = |first: usize| core::array::from_fn(|k| times.get(first + k).copied().unwrap_or_default());
        self.events.push(CrossingDerivatives {
            event: index,
            state,
            by_parameters,
            time_by_start: of(0),
            time_by_inertia: of(6),
            time_by_parameters: times.iter().skip(12).copied().collect(),
        });
        if event.switches() && self.switch.replace(times).is_some() {
            let why = "two events switch torques at once, in an order that a small change decides";
            return Err(MotionError::NoMotionDerivatives { why, time });
        }
        Ok(())
    }

    /// How the time of the switch changes that happens now, by each column.
    pub(super) fn take_switch(&mut self) -> Option<Vec<f64>> {
        self.switch.take()
    }

    /// Forgets what came after a time.
    pub(super) fn forget_after(&mut self, time: f64) {
        self.states.retain(|derivatives| derivatives.state.time <= time);
        self.by_parameters.truncate(self.states.len());
        self.events.retain(|crossing| crossing.state.state.time <= time);
    }
}

/// Columns by what they are by.
fn arranged(state: State, columns: &[[f64; 6]]) -> (StateDerivatives, Vec<[f64; 6]>) {
    let mut derivatives = StateDerivatives { state, ..StateDerivatives::unknown(state.time) };
    let (of_start, others) = columns.split_at(columns.len().min(6));
    let (of_inertia, of_parameters) = others.split_at(others.len().min(6));
    for (matrix, columns) in
        [(&mut derivatives.by_start, of_start), (&mut derivatives.by_inertia, of_inertia)]
    {
        for (k, column) in columns.iter().enumerate() {
            matrix.iter_mut().zip(column).for_each(|(row, x)| row[k] = *x);
        }
    }
    (derivatives, of_parameters.to_vec())
}
