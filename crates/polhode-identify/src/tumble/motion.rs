//! The motion of a flight, with its derivatives.

use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{Attitude, Body, Direction, Position, Rotation};
use polhode::motion::torque::{Drag, DragLaw, TorqueModel, TorqueParameter};
use polhode::motion::{
    FreeMotionDerivatives, Method, Rotor, Simulation, State, StateDerivatives, Trajectory, Wheel,
};

use crate::error::IdentifyError;
use crate::six::{ELEMENTS, Six, matrix};

/// What turns a body in flight, besides itself.
#[derive(Clone, Debug)]
pub(crate) struct Flown<'a> {
    pub(crate) tensor: Six,
    pub(crate) drag: Option<(DragLaw, Six)>,
    pub(crate) wheels: &'a [Wheel],
    pub(crate) torques: &'a [TorqueModel],
}

/// A state with its derivatives: rows θ1 θ2 θ3 ω1 ω2 ω3 of attitude = R exp θ and ω.
pub(crate) struct Derived {
    pub(crate) of: StateDerivatives,
    /// By the elements of drag's matrix.
    pub(crate) by_drag: [[f64; 6]; 6],
}

/// Bound on the error of a step: far below the noise of any gyro, and of any tracker.
const TOLERANCE: f64 = 1e-10;

/// By how many factors of e drag may slow a body in a flight.
const HEAVIEST: f64 = 20.0;

impl Flown<'_> {
    fn rotor(&self) -> Result<Rotor, IdentifyError> {
        let tensor = InertiaTensor::from_matrix(matrix(self.tensor))?;
        let body = MassProperties::new(1.0, Position::ZERO, tensor)?;
        Ok(Rotor::free(&body).with_wheels(self.wheels)?)
    }

    /// All torques, drag's last.
    fn torques(&self) -> Result<Vec<TorqueModel>, IdentifyError> {
        let mut torques = self.torques.to_vec();
        if let Some((law, drag)) = self.drag {
            torques.push(TorqueModel::Drag(Drag::new(law, matrix(drag))?));
        }
        Ok(torques)
    }

    /// At each of the times, which ascend and are none before the start.
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

    /// That drag does not stop the body at once, which is no flight and takes the integrator for ever: ∫ dt drag/moment ≤ 20.
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
            Err(IdentifyError::NotFinite { quantity: "the rate after so much drag" })
        }
    }

    /// The state at a time that is not before the start.
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

/// R exp(θ)
pub(crate) fn turned(attitude: Attitude, theta: [f64; 3]) -> Attitude {
    attitude * turn(theta)
}

/// exp(θ); where θ is not finite none, which a step that far does not get.
pub(crate) fn turn(theta: [f64; 3]) -> Rotation<Body, Body> {
    Rotation::exp(Direction::from_array(theta)).unwrap_or_else(|_| Rotation::identity())
}
