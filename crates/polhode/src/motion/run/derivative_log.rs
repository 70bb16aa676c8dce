//! The derivatives of a run as they are written down: of its samples, and of its events, whose times change too.

use crate::math::vector::Direction;
use crate::motion::error::MotionError;
use crate::motion::model::event::Event;
use crate::motion::model::state::State;
use crate::motion::model::state_derivatives::StateDerivatives;
use crate::motion::solve::propagate::stepper::Stepper;

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

/// The derivatives of a run as they are written down.
#[derive(Debug, Default)]
pub(super) struct DerivativeLog {
    pub(super) states: Vec<StateDerivatives>,
    pub(super) by_parameters: Vec<Vec<[f64; 6]>>,
    pub(super) events: Vec<CrossingDerivatives>,
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
