//! Recorded derivatives of a run: at its samples, and at its events, including those of the event
//! times.

use crate::math::vector::Direction;
use crate::motion::error::MotionError;
use crate::motion::model::event::Event;
use crate::motion::model::state::State;
use crate::motion::model::state_derivatives::StateDerivatives;
use crate::motion::solve::propagate::stepper::Stepper;

/// Derivatives of an event, including those of its time.
#[derive(Clone, Debug, PartialEq)]
pub struct CrossingDerivatives {
    /// Index of the event, from 0.
    pub event: usize,
    /// State at the event, and its total derivatives: they include the change of the event time.
    pub state: StateDerivatives,
    /// Total derivatives of θ and ω with respect to each parameter.
    pub by_parameters: Vec<[f64; 6]>,
    /// Derivatives of the event time with respect to θ(0) and ω(0), s/rad and s/(rad/s).
    pub time_by_start: [f64; 6],
    /// Derivatives of the event time with respect to the elements of the inertia tensor, s/(kg·m²).
    pub time_by_inertia: [f64; 6],
    /// Derivatives of the event time with respect to each parameter.
    pub time_by_parameters: Vec<f64>,
}

/// Recorded derivatives of a run.
#[derive(Debug, Default)]
pub(super) struct DerivativeLog {
    pub(super) states: Vec<StateDerivatives>,
    pub(super) by_parameters: Vec<Vec<[f64; 6]>>,
    pub(super) events: Vec<CrossingDerivatives>,
    /// Derivatives of the time of a switch that is about to happen, by column.
    switch: Option<Vec<f64>>,
}

impl DerivativeLog {
    /// Records the derivatives at a sample.
    pub(super) fn sample(&mut self, stepper: &Stepper<'_>, state: State) {
        let (derivatives, by_parameters) = arranged(state, &stepper.derivatives_at(state.time));
        self.states.push(derivatives);
        self.by_parameters.push(by_parameters);
    }

    /// Records the derivatives at an event.
    ///
    /// # Errors
    /// [`MotionError::NoMotionDerivatives`] if the measured quantity is stationary there, or if two
    /// switches happen simultaneously.
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
        // total derivative of x(t*): δx + ẋ δt*
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

    /// Returns the derivatives of the time of the switch that happens now, by column, and clears
    /// them.
    pub(super) fn take_switch(&mut self) -> Option<Vec<f64>> {
        self.switch.take()
    }

    /// Deletes the records after a time.
    pub(super) fn forget_after(&mut self, time: f64) {
        self.states.retain(|derivatives| derivatives.state.time <= time);
        self.by_parameters.truncate(self.states.len());
        self.events.retain(|crossing| crossing.state.state.time <= time);
    }
}

/// Sorts columns into those of the start, of the inertia and of the parameters.
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
