//! Events: a measured quantity crosses a value.
//!
//! Each event has a function of the state, the gap, that is zero at the crossing. For an angle α
//! between directions it is
//!
//! cos v − cos α = 2 sin ½(α + v) sin ½(α − v),
//!
//! and for a periodic angle φ it is sin(φ − v), where cos(φ − v) > 0. These functions are smooth
//! where the angles themselves are not, and they rise where the angle rises.

use super::event_function::EventFunction;
use super::pointing::Reference;
use super::rotor::Rotor;
use super::state::State;
use super::state_variables::StateVariables;
use super::torque::{TorqueModel, total_potential};
use crate::math::formula::Formula;
use crate::math::frame::{Body, Space};
use crate::math::number::{PI, sin_cos};
use crate::math::rotation::Rotation;
use crate::math::vector::{Direction, Vector};
use crate::motion::error::MotionError;
use crate::motion::model::require;

/// An event: a measure, the value that it crosses, and the action.
///
/// An event happens when the measured quantity crosses the value. A motion that starts at the
/// value, or only touches it, has no event.
///
/// ```
/// use polhode::motion::{Event, EventAction, Measure, Sense};
/// let nutation = Measure::Nutation;
/// let event = Event::new("40°", nutation, 40_f64.to_radians(), Sense::Rising, EventAction::Record)?;
/// assert_eq!(event.name(), "40°");
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    name: String,
    measure: Measure,
    value: f64,
    sense: Sense,
    action: EventAction,
}

/// Quantity that an event measures. Directions need not be unit vectors.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Measure {
    /// Time t, s.
    Time,
    /// Component of ω along a direction of the body, rad/s.
    OmegaBody(Direction<Body>),
    /// Component of ω along a direction of space, rad/s.
    OmegaSpace(Direction<Space>),
    /// Magnitude |ω|, rad/s.
    Rate,
    /// Rotational kinetic energy `T_rot`, J.
    KineticEnergy,
    /// Total energy `T_rot` + U, J. Every torque must have a potential.
    TotalEnergy,
    /// Magnitude |L| of the angular momentum, wheels included, kg·m²/s.
    Momentum,
    /// Angle between a direction of the body and a direction of space, rad.
    Tilt {
        /// Direction fixed in the body.
        body: Direction<Body>,
        /// Direction fixed in space, or given by the orbit or the magnetic field.
        space: Reference,
    },
    /// Angle between ω and a direction of the body, rad.
    OmegaAngle(Direction<Body>),
    /// Angle between L and a direction of the body, rad.
    MomentumAngle(Direction<Body>),
    /// Euler angle θ (3-1-3), rad.
    Nutation,
    /// Euler angle φ (3-1-3), rad, modulo 2π.
    Precession,
    /// Euler angle ψ (3-1-3), rad, modulo 2π.
    Spin,
    /// Formula of the variables of [`StateVariables`](crate::motion::StateVariables). It should be
    /// continuous: a jump across the value counts as a crossing.
    Formula(Formula),
    /// User-supplied function; its derivatives are not known.
    ///
    /// ```
    /// use polhode::motion::{Ending, Event, EventAction, EventFunction, Measure, Sense, Simulation};
    /// use polhode::prelude::*;
    /// let body = MassProperties::new(1.0, Position::ZERO, InertiaTensor::diagonal([1.0, 2.0, 2.5])?)?;
    /// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.0, 0.0, 2.0) };
    /// // The x axis has turned by a radian.
    /// let turned = EventFunction::new(|state| state.attitude.angle());
    /// let events = [Event::new("turned", Measure::Function(turned), 1.0, Sense::Rising, EventAction::Stop)?];
    /// let motion = Simulation::new(&Rotor::free(&body), &[], start, &[0.0, 1.0]).events(&events).run()?;
    /// let Ending::Stopped { time, .. } = *motion.ending() else { return Err("it does not stop".into()) };
    /// assert!((time - 0.5).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    Function(EventFunction),
}

/// Direction in which a value is crossed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// Upward crossing.
    Rising,
    /// Downward crossing.
    Falling,
    /// Crossing in either direction.
    Either,
}

/// Action to take when an event happens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum EventAction {
    /// Record the event.
    Record,
    /// Record the event and stop the motion there.
    Stop,
    /// Record the event and switch a torque on or off.
    Switch {
        /// Index of the torque, from 0.
        torque: usize,
        /// True to switch the torque on, false to switch it off.
        on: bool,
    },
}

/// An event that happened.
#[derive(Clone, Debug, PartialEq)]
pub struct Crossing {
    /// Index of the event, from 0.
    pub event: usize,
    /// Name of the event.
    pub name: String,
    /// State at the crossing.
    pub state: State,
    /// True if the measured quantity was rising.
    pub rising: bool,
}

impl Event {
    /// Creates an event: `measure` crosses `value` in the direction `sense`.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the value is not finite or a
    /// direction has zero length. Also if the value of an angle between directions is not strictly
    /// between 0 and π: such an angle can be touched but not crossed.
    pub fn new(
        name: impl Into<String>,
        measure: Measure,
        value: f64,
        sense: Sense,
        action: EventAction,
    ) -> Result<Self, MotionError> {
        require::finite("the value of an event", value)?;
        let measure = measure.normalised()?;
        if measure.is_between_directions() {
            let rule = "between 0 and π: at its ends an angle between directions turns back";
            require::that("the angle of an event", value, value > 0.0 && value < PI, rule)?;
        }
        Ok(Self { name: name.into(), measure, value, sense, action })
    }

    /// Returns the name of the event.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the measured quantity.
    pub const fn measure(&self) -> &Measure {
        &self.measure
    }

    /// Returns the value to cross: s, rad/s, J, kg·m²/s or rad, depending on the measure.
    pub const fn value(&self) -> f64 {
        self.value
    }

    /// Returns the direction of the crossing.
    pub const fn sense(&self) -> Sense {
        self.sense
    }

    /// Returns the action to take.
    pub const fn action(&self) -> EventAction {
        self.action
    }

    /// True if the measured quantity depends on the mass properties of the body.
    pub(crate) fn needs_inertia(&self) -> bool {
        match &self.measure {
            Measure::KineticEnergy | Measure::TotalEnergy | Measure::Momentum | Measure::MomentumAngle(_) => {
                true
            }
            Measure::Function(function) => function.needs_inertia(),
            Measure::Formula(formula) => StateVariables::of_inertia().any(|k| formula.depends_on(k)),
            _ => false,
        }
    }

    /// True if the event switches a torque.
    pub(crate) const fn switches(&self) -> bool {
        matches!(self.action, EventAction::Switch { .. })
    }

    /// Checks that the event is possible for this rotor and these torques.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the quantity cannot be measured, or
    /// if the event switches a torque that does not exist.
    pub(crate) fn require_possible(
        &self,
        rotor: &Rotor,
        torques: &[TorqueModel],
        all: &[Self],
        start: &State,
    ) -> Result<(), MotionError> {
        let error = |parameter, value, rule| Err(MotionError::ParameterOutOfRange { parameter, value, rule });
        match self.action {
            EventAction::Switch { torque, .. } if torque >= torques.len() => {
                return error(
                    "the number of the torque to switch",
                    torque as f64,
                    "that of one, counted from 0",
                );
            }
            _ => {}
        }
        // A torque that is switched on and off has no potential.
        let has_energy = torques.is_empty()
            || total_potential(torques, rotor, start).is_some() && !all.iter().any(Self::switches);
        if self.measure == Measure::TotalEnergy && !has_energy {
            return Err(MotionError::NoPotential);
        }
        Ok(())
    }

    /// True if the event measures a function that may change faster than the body turns.
    pub(crate) const fn may_be_fast(&self) -> bool {
        matches!(self.measure, Measure::Formula(_) | Measure::Function(_))
    }

    /// Returns the gap without the size of its terms, which costs two more evaluations of a
    /// formula.
    pub(crate) fn gap_alone(&self, rotor: &Rotor, torques: &[TorqueModel], state: &State) -> f64 {
        match &self.measure {
            Measure::Formula(formula) => formula.evaluate(&StateVariables::of(rotor, state)) - self.value,
            Measure::Function(function) => function.value(rotor, state) - self.value,
            _ => self.gap(rotor, torques, state).gap,
        }
    }

    /// Returns the gap of the event in a state.
    pub(crate) fn gap(&self, rotor: &Rotor, torques: &[TorqueModel], state: &State) -> Gap {
        let (v, omega) = (self.value, state.omega);
        let momentum = || state.attitude.inverse() * rotor.angular_momentum_space(state);
        let plain = |x: f64, size: f64| Gap { gap: x - v, scale: size.max(v.abs()), is_opposite: false };
        match &self.measure {
            Measure::Time => plain(state.time, state.time.abs()),
            Measure::OmegaBody(n) => plain(n.dot(omega), omega.norm()),
            Measure::OmegaSpace(n) => plain(n.dot(state.omega_space()), omega.norm()),
            Measure::Rate => plain(omega.norm(), omega.norm()),
            Measure::KineticEnergy => {
                let kinetic = rotor.kinetic_energy(omega);
                plain(kinetic, kinetic)
            }
            Measure::TotalEnergy => {
                let kinetic = rotor.kinetic_energy(omega);
                let potential = total_potential(torques, rotor, state).unwrap_or(0.0);
                plain(kinetic + potential, kinetic + potential.abs())
            }
            Measure::Momentum => plain(momentum().norm(), momentum().norm()),
            Measure::Tilt { body, space } => {
                between(body.angle_to(state.attitude.inverse() * space.direction(state.time)), v)
            }
            Measure::OmegaAngle(n) => between(n.angle_to(omega), v),
            Measure::MomentumAngle(n) => between(n.angle_to(momentum()), v),
            Measure::Nutation => between(state.attitude.euler313()[1], v),
            Measure::Precession => around(state.attitude.euler313(), 0, v),
            Measure::Spin => around(state.attitude.euler313(), 2, v),
            Measure::Formula(formula) => {
                let value = |state: &State| formula.evaluate(&StateVariables::of(rotor, state));
                plain(value(state), scale(&value, state))
            }
            Measure::Function(function) => {
                let value = |state: &State| function.value(rotor, state);
                plain(value(state), scale(&value, state))
            }
        }
    }
}

/// Gap of an event: a function of the state that is zero when the event happens.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gap {
    /// Value of the function.
    pub(crate) gap: f64,
    /// Magnitude of the terms whose difference is the gap. The rounding of the gap is relative to
    /// it.
    pub(crate) scale: f64,
    /// True at φ = v + π, where sin(φ − v) also vanishes: this zero is not a crossing.
    pub(crate) is_opposite: bool,
}

impl Gap {
    /// Returns true if the gap is zero to within rounding.
    pub(crate) fn may_be_zero(&self) -> bool {
        !(self.gap.abs() > 16.0 * f64::EPSILON * self.scale)
    }
}

/// Estimates the magnitude of the terms of a function that is given as a whole.
/// The estimate is the change of the function per relative change of the state. Example: `T_rot` −
/// 10 J has terms of 10 J where it vanishes.
fn scale(value: &dyn Fn(&State) -> f64, state: &State) -> f64 {
    const STEP: f64 = 1.0 / (1_u64 << 40) as f64;
    let [x, y, z] = state.omega.to_array();
    let turn = Rotation::from_rotation_vector(Direction::<Body>::new(0.48, -0.6, 0.64) * STEP);
    let moved = State {
        time: state.time * (1.0 - STEP),
        attitude: state.attitude * turn,
        omega: Vector::new(x * (1.0 + STEP), y * (1.0 - STEP), z * (1.0 + 0.5 * STEP)),
    };
    let here = value(state);
    here.abs().max((value(&moved) - here).abs() / STEP)
}

/// Gap of an angle between directions: 2 sin ½(α + v) sin ½(α − v).
fn between(angle: f64, v: f64) -> Gap {
    let slope = 2.0 * sin_cos(0.5 * (angle + v)).0;
    Gap { gap: slope * sin_cos(0.5 * (angle - v)).0, scale: slope, is_opposite: false }
}

/// Gap of a periodic Euler angle: sin(φ − v). A small rotation of the body by δ changes φ by up to
/// δ/sin θ, so the scale is 1/sin θ.
fn around(angles: [f64; 3], which: usize, v: f64) -> Gap {
    let (sin, cos) = sin_cos(angles[which] - v);
    Gap { gap: sin, scale: 1.0 / sin_cos(angles[1]).0, is_opposite: cos < 0.0 }
}

impl Measure {
    /// Returns the unit of the value. It is empty for a formula or a function, which may have any
    /// unit.
    pub const fn unit(&self) -> &'static str {
        match self {
            Self::Time => "s",
            Self::OmegaBody(_) | Self::OmegaSpace(_) | Self::Rate => "rad/s",
            Self::KineticEnergy | Self::TotalEnergy => "J",
            Self::Momentum => "kg·m²/s",
            Self::Formula(_) | Self::Function(_) => "",
            _ => "rad",
        }
    }

    const fn is_between_directions(&self) -> bool {
        matches!(self, Self::Tilt { .. } | Self::OmegaAngle(_) | Self::MomentumAngle(_) | Self::Nutation)
    }

    /// Normalises the directions to unit vectors.
    fn normalised(self) -> Result<Self, MotionError> {
        Ok(match self {
            Self::OmegaBody(n) => Self::OmegaBody(unit(n)?),
            Self::OmegaSpace(n) => Self::OmegaSpace(unit(n)?),
            Self::Tilt { body, space } => Self::Tilt { body: unit(body)?, space: space.normalised()? },
            Self::OmegaAngle(n) => Self::OmegaAngle(unit(n)?),
            Self::MomentumAngle(n) => Self::MomentumAngle(unit(n)?),
            other => other,
        })
    }
}

fn unit<Q, F>(v: Vector<Q, F>) -> Result<Direction<F>, MotionError> {
    require::direction("the length of a direction of an event", v)
}

impl Sense {
    /// True if a crossing in this direction counts.
    pub(crate) const fn takes(self, rising: bool) -> bool {
        match self {
            Self::Rising => rising,
            Self::Falling => !rising,
            Self::Either => true,
        }
    }

    /// Returns the name used in scenario files and summaries.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rising => "rising",
            Self::Falling => "falling",
            Self::Either => "either",
        }
    }
}
