//! Derivatives of an event's gap with respect to time along a motion, to the state and to the
//! inertia tensor.

use super::event::{Event, Measure};
use super::law::LawInput;
use super::pointing::Reference;
use super::rotor::Rotor;
use super::state::State;
use super::state_variables::StateVariables;
use super::torque::formula::evaluate;
use super::torque::tangent::Tangent;
use crate::math::algebra::VectorAlgebra;
use crate::math::derivative::derivative;
use crate::math::frame::{Body, Space};
use crate::math::vector::Direction;

/// Derivatives of the gap g of an event at its crossing.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion) struct EventSlope {
    /// ġ along the motion, per second.
    rate: f64,
    /// ∂g/∂x: with respect to a rotation about the body axes and to ω along them.
    by_state: [f64; 6],
    /// ∂g/∂I: with respect to the elements of the inertia tensor.
    by_inertia: [f64; 6],
}

impl EventSlope {
    /// Returns the change of the event's time, δt = −(∂g/∂x · δx + ∂g/∂I)/ġ.
    /// `change` is the change δx of the state. If `element` is given, that element of the inertia
    /// tensor changes by one unit.
    pub(in crate::motion) fn time(&self, change: &[f64; 6], element: Option<usize>) -> f64 {
        let of_state: f64 = self.by_state.iter().zip(change).map(|(slope, change)| slope * change).sum();
        let of_inertia = element.and_then(|k| self.by_inertia.get(k)).copied().unwrap_or(0.0);
        -(of_state + of_inertia) / self.rate
    }
}

impl Event {
    /// Returns the rate of the gap along the motion, per second, in a state with turning rate Ω of
    /// the axes and acceleration ω̇, body axes. The rate is NaN for a function whose derivatives
    /// are not known.
    pub(crate) fn rate(
        &self,
        rotor: &Rotor,
        state: &State,
        [turning, acceleration]: [Direction<Body>; 2],
    ) -> f64 {
        // A torque with a potential conserves the energy; a motor in the body does not.
        if *self.measure() == Measure::TotalEnergy && rotor.wheels().is_empty() {
            return 0.0;
        }
        // A jump has no one-sided rate, and the rate of a user-supplied function is not known.
        if self.roughness().is_some() {
            return f64::NAN;
        }
        let still = Tangent::still(rotor, state);
        let along = Tangent { turn: turning, faster: acceleration.as_quantity(), later: 1.0, ..still };
        measured(self.measure(), &along).first
    }

    /// Returns the reason that the measured quantity has no derivatives, if it has none.
    pub(in crate::motion) fn roughness(&self) -> Option<&'static str> {
        match self.measure() {
            Measure::TotalEnergy => Some("an event measures the total energy, which stays the same"),
            Measure::Formula(formula) if formula.rough_function().is_some() => {
                Some("the formula of an event has a corner or a jump")
            }
            Measure::Function(_) => Some("an event watches a function, of which only values are known"),
            _ => None,
        }
    }

    /// Returns the derivatives of the gap in a state with turning rate Ω of the axes and
    /// acceleration ω̇, body axes.
    pub(in crate::motion) fn slope(
        &self,
        rotor: &Rotor,
        state: &State,
        [turning, acceleration]: [Direction<Body>; 2],
    ) -> EventSlope {
        let still = Tangent::still(rotor, state);
        let slope = |along: Tangent<'_>| measured(self.measure(), &along).first;
        let axis = |k: usize| Direction::from_array([0, 1, 2].map(|n| f64::from(u8::from(n == k % 3))));
        EventSlope {
            rate: self.rate(rotor, state, [turning, acceleration]),
            by_state: core::array::from_fn(|k| {
                let along = if k < 3 {
                    Tangent { turn: axis(k), ..still }
                } else {
                    Tangent { faster: axis(k).as_quantity(), ..still }
                };
                slope(along)
            }),
            by_inertia: core::array::from_fn(|k| slope(Tangent { element: Some(k), ..still })),
        }
    }
}

/// Returns the measured quantity, or a smooth function of it: for an angle between directions, its
/// cosine.
fn measured<'a>(measure: &Measure, at: &Tangent<'a>) -> <Tangent<'a> as LawInput>::Scalar {
    let momentum = || at.inertia(at.omega()) + at.wheel_momentum();
    let variable = |name: &str| {
        let place = StateVariables::NAMES.iter().position(|known| *known == name);
        StateVariables::variable(place.unwrap_or(usize::MAX), at)
    };
    match measure {
        Measure::Time => at.time(),
        Measure::OmegaBody(n) => at.omega().dot(at.in_body(*n)),
        Measure::OmegaSpace(n) => at.omega().dot(at.in_space(*n)),
        Measure::Rate => at.omega().norm(),
        Measure::KineticEnergy => variable("T_rot"),
        Measure::TotalEnergy | Measure::Function(_) => at.number(f64::NAN),
        Measure::Momentum => momentum().norm(),
        Measure::Tilt { body, space } => {
            let [here, rate] = direction(space, at.time().value);
            let elapsed = at.time() - at.number(at.time().value);
            let direction = at.in_space(here) + at.in_space(rate) * elapsed;
            at.in_body(*body).dot(direction) / direction.norm()
        }
        Measure::OmegaAngle(n) => at.in_body(*n).dot(at.omega()) / at.omega().norm(),
        Measure::MomentumAngle(n) => at.in_body(*n).dot(momentum()) / momentum().norm(),
        Measure::Nutation => variable("r33"),
        Measure::Precession => variable("phi"),
        Measure::Spin => variable("psi"),
        Measure::Formula(formula) => evaluate(formula, at),
    }
}

/// Returns a direction of space at a time, and its rate.
fn direction(reference: &Reference, time: f64) -> [Direction<Space>; 2] {
    let rate = reference.orbit().map_or(Direction::ZERO, |orbit| {
        // Step during which the orbit turns by a tenth of a radian.
        let step = 0.1 / orbit.angular_velocity(time).norm();
        let at = |h: f64| reference.direction(time + h).to_array();
        Direction::from_array(derivative(at, step).best())
    });
    [reference.direction(time), rate]
}
