//! Motion of a flight, with its derivatives.

use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{Attitude, Body, Direction, Position, Rotation};
use polhode::motion::torque::{Drag, DragLaw, TorqueModel, TorqueParameter};
use polhode::motion::{
    FreeMotionDerivatives, Method, Rotor, Simulation, State, StateDerivatives, Trajectory, Wheel,
};

use crate::error::IdentifyError;
use crate::six::{ELEMENTS, Six, matrix};

/// Body in flight, with drag, wheels and known torques.
#[derive(Clone, Debug)]
pub(crate) struct Flown<'a> {
    pub(crate) tensor: Six,
    pub(crate) drag: Option<(DragLaw, Six)>,
    pub(crate) wheels: &'a [Wheel],
    pub(crate) torques: &'a [TorqueModel],
}

/// State with its derivatives. Rows are θ1 θ2 θ3 ω1 ω2 ω3, with attitude R exp θ.
pub(crate) struct Derived {
    pub(crate) of: StateDerivatives,
    /// Derivatives by the elements of the drag matrix.
    pub(crate) by_drag: [[f64; 6]; 6],
}

/// Tolerance of the integration per step, far below the noise of any gyro or tracker.
const TOLERANCE: f64 = 1e-10;

/// Upper bound on the decay by drag during a flight: number of factors of e.
const HEAVIEST: f64 = 20.0;

impl Flown<'_> {
    fn rotor(&self) -> Result<Rotor, IdentifyError> {
        let tensor = InertiaTensor::from_matrix(matrix(self.tensor))?;
        let body = MassProperties::new(1.0, Position::ZERO, tensor)?;
        Ok(Rotor::free(&body).with_wheels(self.wheels)?)
    }

    /// Returns all torques, drag last.
    fn torques(&self) -> Result<Vec<TorqueModel>, IdentifyError> {
        let mut torques = self.torques.to_vec();
        if let Some((law, drag)) = self.drag {
            torques.push(TorqueModel::Drag(Drag::new(law, matrix(drag))?));
        }
        Ok(torques)
    }

    /// Returns the states and derivatives at ascending times, none before the start.
    pub(crate) fn derived(&self, start: State, times: &[f64]) -> Result<Vec<Derived>, IdentifyError> {
        let (rotor, torques) = (self.rotor()?, self.torques()?);
        if torques.is_empty() && self.wheels.is_empty() {
            let motion = FreeMotionDerivatives::of(&rotor, start)?;
            motion.motion().require(times)?;
            let each = motion.at_times(times).into_iter();
            return Ok(each.map(|of| Derived { of, by_drag: [[0.0; 6]; 6] }).collect());
        }
        self.require_light_drag(&rotor, start, times)?;
        let drag = torques.len().saturating_sub(1);
        let parameters: Vec<TorqueParameter> = if self.drag.is_some() {
            ELEMENTS.map(|name| TorqueParameter { torque: drag, name }).to_vec()
        } else {
            Vec::new()
        };
        let simulation = Simulation::new(&rotor, &torques, start, times).tolerance(TOLERANCE);
        let run = simulation.run_with_derivatives(&parameters)?;
        if run.states.len() < times.len() {
            return Err(IdentifyError::NotFinite { quantity: "a state of the flight" });
        }
        let by_drag = |columns: Vec<[f64; 6]>| {
            core::array::from_fn(|row| core::array::from_fn(|k| columns.get(k).map_or(0.0, |c| c[row])))
        };
        let each = run.states.into_iter().zip(run.by_parameters);
        Ok(each.map(|(of, columns)| Derived { of, by_drag: by_drag(columns) }).collect())
    }

    /// Returns an error if drag stops the body almost immediately: ∫ drag/moment dt must be at most
    /// 20. Such motion is not a flight, and the integration would take very long.
    fn require_light_drag(&self, rotor: &Rotor, start: State, times: &[f64]) -> Result<(), IdentifyError> {
        let (Some((law, matrix)), Some(last)) = (self.drag, times.last()) else { return Ok(()) };
        let trace = matrix[0] + matrix[1] + matrix[2];
        let rate = match law {
            DragLaw::Linear => trace,
            DragLaw::Quadratic => trace * start.omega.norm(),
        };
        let decay = rate * (last - start.time) / rotor.principal().moments()[0];
        if decay <= HEAVIEST {
            Ok(())
        } else {
            Err(IdentifyError::NotFinite { quantity: "the rate under this drag" })
        }
    }

    /// Returns the state at a time not before the start.
    pub(crate) fn state_at(&self, start: State, time: f64) -> Result<State, IdentifyError> {
        let (rotor, torques) = (self.rotor()?, self.torques()?);
        let motion = Trajectory::compute(&rotor, &torques, start, &[time], Method::Auto, TOLERANCE)?;
        motion
            .samples()
            .last()
            .map(|sample| sample.state)
            .ok_or(IdentifyError::NotFinite { quantity: "a state of the flight" })
    }
}

/// Returns R exp(θ).
pub(crate) fn turned(attitude: Attitude, theta: [f64; 3]) -> Attitude {
    attitude * turn(theta)
}

/// Returns exp(θ); the identity if θ is not finite, in which case the step is rejected elsewhere.
pub(crate) fn turn(theta: [f64; 3]) -> Rotation<Body, Body> {
    Rotation::exp(Direction::from_array(theta)).unwrap_or_else(|_| Rotation::identity())
}
