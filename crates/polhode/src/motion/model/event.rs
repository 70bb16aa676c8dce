//! Events: something that is measured passes a value.
//!
//! An event is a function of the state that passes zero. Of an angle α between directions it is
//!
//! cos v − cos α = 2 sin ½(α + v) sin ½(α − v),
//!
//! and of an angle φ that comes round sin(φ − v), where cos(φ − v) > 0: these are smooth where the angles themselves are not, and
//! they rise where the angle does.

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
/// It happens when what is measured passes the value, not when the motion starts there, and not when it is only touched.
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

/// What an event measures. Directions need not be unit vectors.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Measure {
    /// t, s.
    Time,
    /// ω along a direction of the body, rad/s.
    OmegaBody(Direction<Body>),
    /// ω along a direction of space, rad/s.
    OmegaSpace(Direction<Space>),
    /// |ω|, rad/s.
    Rate,
    /// T_rot, J.
    KineticEnergy,
    /// T_rot + U, J; every torque has to have a potential.
    TotalEnergy,
    /// |L|, that of wheels included, kg·m²/s.
    Momentum,
    /// Between a direction of the body and one of space, rad.
    Tilt {
        /// Fixed in the body.
        body: Direction<Body>,
        /// Fixed in space, or given by the orbit or the field.
        space: Reference,
    },
    /// Between ω and a direction of the body, rad.
    OmegaAngle(Direction<Body>),
    /// Between L and a direction of the body, rad.
    MomentumAngle(Direction<Body>),
    /// θ of the 3-1-3 Euler angles, rad.
    Nutation,
    /// φ of the 3-1-3 Euler angles, rad, round and round.
    Precession,
    /// ψ of the 3-1-3 Euler angles, rad, round and round.
    Spin,
    /// A formula of the variables of [`StateVariables`](crate::motion::StateVariables). It should be continuous: a jump over the value counts
    /// as passing it.
    Formula(Formula),
    /// A function of the user's own, of which no derivatives are known.
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

/// In which direction a value is passed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// From below.
    Rising,
    /// From above.
    Falling,
    /// Both.
    Either,
}

/// What to do when an event happens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum EventAction {
    /// Write it down.
    Record,
    /// Write it down and stop there.
    Stop,
    /// Write it down and switch a torque on or off.
    Switch {
        /// Which of the torques, from 0.
        torque: usize,
        /// On or off.
        on: bool,
    },
}

/// An event that happened.
#[derive(Clone, Debug, PartialEq)]
pub struct Crossing {
    /// Which of the events, from 0.
    pub event: usize,
    /// Its name.
    pub name: String,
    /// The state there.
    pub state: State,
    /// Whether what is measured was rising.
    pub rising: bool,
}

impl Event {
    /// An event: `measure` passes `value` in the direction of `sense`.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the value is not finite, a direction has none, or an angle between directions is not between 0
    /// and π: such an angle is touched, never passed.
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

    /// What it is called.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What is measured.
    pub const fn measure(&self) -> &Measure {
        &self.measure
    }

    /// The value that it passes: s, rad/s, J, kg·m²/s or rad, as the measure says.
    pub const fn value(&self) -> f64 {
        self.value
    }

    /// In which direction.
    pub const fn sense(&self) -> Sense {
        self.sense
    }

    /// What to do then.
    pub const fn action(&self) -> EventAction {
        self.action
    }

    /// True if what it measures depends on the mass of the body.
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

    /// True if it switches a torque.
    pub(crate) const fn switches(&self) -> bool {
        matches!(self.action, EventAction::Switch { .. })
    }

    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if it cannot be measured, or switches what is not there.
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
        // Energy that comes and goes with a switch is no potential.
        let has_energy = torques.is_empty()
            || total_potential(torques, rotor, start).is_some() && !all.iter().any(Self::switches);
        if self.measure == Measure::TotalEnergy && !has_energy {
            return Err(MotionError::NoPotential);
        }
        Ok(())
    }

    /// True if it measures a function that may change faster than the body turns.
    pub(crate) const fn may_be_fast(&self) -> bool {
        matches!(self.measure, Measure::Formula(_) | Measure::Function(_))
    }

    /// The gap without the size of its terms, which takes two more evaluations of a formula.
    pub(crate) fn gap_alone(&self, rotor: &Rotor, torques: &[TorqueModel], state: &State) -> f64 {
        match &self.measure {
            Measure::Formula(formula) => formula.evaluate(&StateVariables::of(rotor, state)) - self.value,
            Measure::Function(function) => function.value(rotor, state) - self.value,
            _ => self.gap(rotor, torques, state).gap,
        }
    }

    /// How far it is from happening.
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

/// A function that passes zero when an event happens.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gap {
    /// The function.
    pub(crate) gap: f64,
    /// The size of what it is the difference of: its rounding is relative to that.
    pub(crate) scale: f64,
    /// True where sin(φ − v) vanishes at φ = v + π: not a crossing.
    pub(crate) is_opposite: bool,
}

impl Gap {
    /// True if rounding is all that there may be of it.
    pub(crate) fn may_be_zero(&self) -> bool {
        !(self.gap.abs() > 16.0 * f64::EPSILON * self.scale)
    }
}

/// The size of the terms of a function that is given as a whole: how fast it changes with relative changes of the
/// state. T_rot − 10 J has terms of 10 J where it vanishes.
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

/// 2 sin ½(α + v) sin ½(α − v)
fn between(angle: f64, v: f64) -> Gap {
    let slope = 2.0 * sin_cos(0.5 * (angle + v)).0;
    Gap { gap: slope * sin_cos(0.5 * (angle - v)).0, scale: slope, is_opposite: false }
}

/// sin(φ − v); where θ is small, a small turn of the body changes φ by 1/sin θ as much.
fn around(angles: [f64; 3], which: usize, v: f64) -> Gap {
    let (sin, cos) = sin_cos(angles[which] - v);
    Gap { gap: sin, scale: 1.0 / sin_cos(angles[1]).0, is_opposite: cos < 0.0 }
}

impl Measure {
    /// The unit that its value has; empty for a formula and a function, which may have any.
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

    /// The same with unit vectors.
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
    /// True if a crossing of this kind counts.
    pub(crate) const fn takes(self, rising: bool) -> bool {
        match self {
            Self::Rising => rising,
            Self::Falling => !rising,
            Self::Either => true,
        }
    }

    /// The name in scenario files and summaries.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rising => "rising",
            Self::Falling => "falling",
            Self::Either => "either",
        }
    }
}
