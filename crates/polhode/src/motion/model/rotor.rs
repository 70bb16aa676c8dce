//! A body and the reference point about which it turns.

use crate::body::inertia::InertiaAbout;
use crate::body::mass_properties::MassProperties;
use crate::body::principal::{PrincipalFrame, Symmetry};
use crate::math::frame::{Body, Space};
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::{AngularMomentum, AngularVelocity, Position, Torque};

use super::state::State;
use super::wheel::{Motor, Wheel};
use crate::motion::error::MotionError;
use crate::motion::model::require;

/// Body that turns about its reference point: the centre of mass of a free body, or the pivot.
///
/// Inertia, angular momentum, kinetic energy and torque refer to this point.
///
/// ```
/// use polhode::body::{InertiaTensor, MassProperties};
/// use polhode::math::{AngularVelocity, Position};
/// use polhode::motion::Rotor;
/// let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2])?;
/// let body = MassProperties::new(2.0, Position::new(0.0, 0.0, 0.5), inertia)?;
/// let omega = AngularVelocity::new(1.0, 0.0, 0.0);
/// assert_eq!(Rotor::free(&body).kinetic_energy(omega), 0.5 * 3.1);
/// assert_eq!(Rotor::pivoted(&body, Position::ZERO).kinetic_energy(omega), 0.5 * (3.1 + 2.0 * 0.25));
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Rotor {
    mass: f64,
    inertia: InertiaAbout<Body>,
    lever: Position<Body>,
    principal: PrincipalFrame<Body>,
    pivoted: bool,
    wheels: Vec<Wheel>,
}

/// Threshold, relative to the greatest moment, below which a moment reduced by wheels is rounding.
const MASSLESS: f64 = 1e-13;

impl Rotor {
    /// Creates a free body, which turns about its centre of mass.
    pub fn free(body: &MassProperties<Body>) -> Self {
        Self::about(body, body.center_of_mass(), false)
    }

    /// Creates a body whose point `pivot` is fixed in space.
    pub fn pivoted(body: &MassProperties<Body>, pivot: Position<Body>) -> Self {
        Self::about(body, pivot, true)
    }

    fn about(body: &MassProperties<Body>, point: Position<Body>, pivoted: bool) -> Self {
        let inertia = body.inertia_about(point);
        let principal = PrincipalFrame::about_pivot(&inertia);
        Self {
            mass: body.mass(),
            inertia,
            lever: body.center_of_mass() - point,
            principal,
            pivoted,
            wheels: Vec::new(),
        }
    }

    /// Adds momentum wheels.
    ///
    /// The inertia of the body includes the wheels. A wheel turned by a motor does not share its
    /// axial inertia with the carrier: I = `I_body` − Σ J a aᵀ, and L = I ω + Σ h a.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the inertia of a wheel is too large,
    /// so that the carrier has no inertia about some axis.
    pub fn with_wheels(mut self, wheels: &[Wheel]) -> Result<Self, MotionError> {
        for wheel in wheels {
            if let Motor::Torque { inertia: value, .. } = wheel.motor() {
                let axial = Symmetric3::outer(wheel.axis().to_array()) * value;
                let rest = *self.inertia.symmetric() - axial;
                let parameter = "the wheel's moment of inertia";
                let rule = "small enough for the rest of the body to be possible";
                self.inertia = InertiaAbout::from_symmetric(self.inertia.point(), rest)
                    .map_err(|_| MotionError::ParameterOutOfRange { parameter, value, rule })?;
            }
        }
        self.principal = PrincipalFrame::about_pivot(&self.inertia);
        let [least, _, greatest] = self.principal.moments();
        let rule = "above zero: a wheel turns the body, and a rod has nothing to balance it with";
        let holds = wheels.is_empty() || least > MASSLESS * greatest;
        require::that("the least moment of inertia of a body without its wheels", least, holds, rule)?;
        self.wheels = wheels.to_vec();
        Ok(self)
    }

    /// Replaces the inertia tensor about the same point, and the lever; `None` if the tensor is
    /// unphysical.
    pub(crate) fn with_inertia(&self, inertia: Symmetric3, lever: Position<Body>) -> Option<Self> {
        let inertia = InertiaAbout::from_symmetric(self.inertia.point(), inertia).ok()?;
        Some(Self { principal: PrincipalFrame::about_pivot(&inertia), inertia, lever, ..self.clone() })
    }

    /// Returns the momentum wheels.
    pub fn wheels(&self) -> &[Wheel] {
        &self.wheels
    }

    /// Returns the angular momentum Σ h a of the wheels at a time (s), body axes, kg·m²/s.
    pub fn wheel_momentum(&self, time: f64) -> AngularMomentum<Body> {
        let along = |wheel: &Wheel| wheel.axis().as_quantity() * wheel.momentum_at(time);
        self.wheels.iter().fold(AngularMomentum::ZERO, |sum, wheel| sum + along(wheel))
    }

    /// Returns the torque of the motors on the wheels just after a time (s), body axes, N·m. The
    /// torque on the carrier is the opposite.
    pub fn motor_torque(&self, time: f64) -> Torque<Body> {
        let along = |wheel: &Wheel| wheel.axis().as_quantity() * wheel.torque_at(time);
        self.wheels.iter().fold(Torque::ZERO, |sum, wheel| sum + along(wheel))
    }

    /// Returns the reference point (centre of mass or pivot), body axes, m.
    pub const fn point(&self) -> Position<Body> {
        self.inertia.point()
    }

    /// Returns the mass, kg.
    pub const fn mass(&self) -> f64 {
        self.mass
    }

    /// Returns the inertia tensor about the reference point, body axes, kg·m².
    pub const fn inertia(&self) -> &InertiaAbout<Body> {
        &self.inertia
    }

    /// Returns the vector from the reference point to the centre of mass, body axes, m. It is zero
    /// for a free body.
    pub const fn lever(&self) -> Position<Body> {
        self.lever
    }

    /// Returns the principal moments and axes about the reference point.
    pub const fn principal(&self) -> &PrincipalFrame<Body> {
        &self.principal
    }

    /// True if the body is held at a pivot.
    pub const fn is_pivoted(&self) -> bool {
        self.pivoted
    }

    /// True if the body has inertia about some axis.
    pub fn is_spinnable(&self) -> bool {
        self.principal.symmetry() != Symmetry::Point
    }

    /// Returns the angular momentum L = I ω of the carrier, without wheels, body axes, kg·m²/s.
    pub fn angular_momentum(&self, omega: AngularVelocity<Body>) -> AngularMomentum<Body> {
        self.inertia * omega
    }

    /// Returns L = I ω + Σ h a, wheels included, in space axes, kg·m²/s.
    pub fn angular_momentum_space(&self, state: &State) -> AngularMomentum<Space> {
        state.attitude * (self.angular_momentum(state.omega) + self.wheel_momentum(state.time))
    }

    /// Returns the kinetic energy `T_rot` = ½ ω · I ω of the carrier, J.
    pub fn kinetic_energy(&self, omega: AngularVelocity<Body>) -> f64 {
        0.5 * omega.dot(self.angular_momentum(omega))
    }

    /// Returns true if `T_rot` is not zero but less than 2.2e-308 J, the smallest normal f64. With
    /// ω = 1e-200 rad/s it underflows to 0.
    ///
    /// ```
    /// use polhode::body::{InertiaTensor, MassProperties};
    /// use polhode::math::{AngularVelocity, Position};
    /// use polhode::motion::Rotor;
    /// let inertia = InertiaTensor::diagonal([2.0, 3.0, 4.0])?;
    /// let rotor = Rotor::free(&MassProperties::new(1.3, Position::ZERO, inertia)?);
    /// let turning = |rate: f64| AngularVelocity::new(0.3 * rate, -rate, 0.7 * rate);
    /// assert!(rotor.kinetic_energy_underflows(turning(1e-200)) && !rotor.kinetic_energy_underflows(turning(1e-150)));
    /// assert!(!rotor.kinetic_energy_underflows(AngularVelocity::ZERO));
    /// # Ok::<(), polhode::body::BodyError>(())
    /// ```
    pub fn kinetic_energy_underflows(&self, omega: AngularVelocity<Body>) -> bool {
        // A rod that turns about its own line has T = 0 at every rate.
        let [x, y, z] = omega.to_array();
        let size = omega.max_abs();
        let unit = AngularVelocity::from_array([x / size, y / size, z / size]);
        let small = |omega| self.kinetic_energy(omega) < f64::MIN_POSITIVE;
        size > 0.0 && small(omega) && !small(unit)
    }
}
