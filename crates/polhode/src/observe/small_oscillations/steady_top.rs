//! Steady motions of a heavy symmetric top.
//!
//! Let θ be the angle of the axis e from the vertical k, and let p_φ = k · L and
//! p_ψ = e · L = C ω3, which are constant. The effective potential of the nutation is
//!
//! V(u) = ((p_φ − p_ψ)²/(1 − u) + (p_φ + p_ψ)²/(1 + u))/4A + M g l u,  u = cos θ
//!
//! It is convex: the top has one steady motion with its p_φ and p_ψ, and nutates about it. This
//! motion satisfies
//!
//! (p_φ − p_ψ)²/(1 − u)² − (p_φ + p_ψ)²/(1 + u)² + 4 A M g l = 0,
//!
//! or is upright or hanging if such a u does not exist. The axis precesses at
//!
//! φ̇ = (p_φ − p_ψ u)/(A (1 − u²)).
//!
//! Seen from axes that precess with the top, the body spins at ω3 − φ̇ cos θ about e. Its effect is
//! that of its angular momentum: the top is equivalent to a gyrostat with h = C (ω3 − φ̇ cos θ) e
//! that rotates at φ̇ k, and has the same small oscillations.

use super::SmallOscillations;
use crate::math::frame::{Body, Space};
use crate::math::root::root;
use crate::math::rotation::Rotation;
use crate::math::vector::{AngularVelocity, Direction};
use crate::motion::error::MotionError;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::{TorqueModel, UniformGravity};
use crate::motion::model::wheel::{Motor, Wheel};
use crate::motion::solve::heavy_top::{HeavyTop, TopPath};

/// Steady motion of a heavy symmetric top: steady precession at a constant angle, a sleeping top,
/// or a hanging top.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::{HeavyTop, TopPath};
/// use polhode::observe::SteadyTop;
/// let inertia = InertiaTensor::diagonal([1.0, 1.0, 0.5])?;
/// let top = Rotor::pivoted(&MassProperties::new(1.0, Position::new(0.0, 0.0, 0.5), inertia)?, Position::ZERO);
/// // Let go at 40° with spin and nothing else, it nods about the steady precession with its momenta.
/// let attitude = Attitude::from_euler313([0.0, 40_f64.to_radians(), 0.0])?;
/// let start = State { time: 0.0, attitude, omega: AngularVelocity::new(0.0, 0.0, 30.0) };
/// let steady = SteadyTop::with_momenta_of(&top, &UniformGravity::STANDARD, start)?;
/// assert_eq!(steady.path, TopPath::SteadySlow);
/// let nods = HeavyTop::of(&top, &UniformGravity::STANDARD, start)?.nutation_bounds();
/// assert!(nods[0] < steady.angle && steady.angle < nods[1]);
/// assert!(steady.oscillations.is_stable());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct SteadyTop {
    /// Kind of steady motion: [`TopPath::SteadySlow`], [`TopPath::SteadyFast`],
    /// [`TopPath::Conical`], [`TopPath::Sleeping`] or [`TopPath::Hanging`].
    pub path: TopPath,
    /// Angle θ from the upward vertical to the axis, rad.
    pub angle: f64,
    /// Precession rate φ̇ about the upward vertical, rad/s; zero for a vertical axis.
    pub precession: f64,
    /// Component ω3 of ω along the axis, rad/s.
    pub spin: f64,
    /// State at the start's time, with its axis in the vertical plane of the start's axis.
    pub state: State,
    /// Small oscillations. For a vertical axis they refer to body axes; otherwise to axes that
    /// precess with the top and coincide with the body axes at the start.
    pub oscillations: SmallOscillations,
}

/// Threshold of p_φ ∓ p_ψ, relative to both, below which it is rounding: the axis passes through
/// the vertical.
const ROUNDING: f64 = 1e-14;

impl SteadyTop {
    /// Finds the steady motion with the p_φ and p_ψ of a start, about which its top nutates. It is
    /// always stable.
    ///
    /// # Errors
    /// [`MotionError::NoClosedForm`] for a body that is not a symmetric top, as in
    /// [`HeavyTop::of`]; otherwise the errors of [`SmallOscillations::about_equilibrium`].
    pub fn with_momenta_of(
        rotor: &Rotor,
        gravity: &UniformGravity,
        start: State,
    ) -> Result<Self, MotionError> {
        let top = HeavyTop::of(rotor, gravity, start)?;
        let ([across, along], weight) = (top.moments(), top.weight_torque());
        let up = vertical(gravity, &start);
        let (p_phi, p_psi) = (up.dot(rotor.angular_momentum(start.omega)), along * top.spin());
        let [d, s] = [p_phi - p_psi, p_phi + p_psi]
            .map(|p| if p.abs() <= ROUNDING * (p_phi.abs() + p_psi.abs()) { 0.0 } else { p });
        // dV/du times 16 A, with 1 − u = 2 sin² ½θ and 1 + u = 2 cos² ½θ; it decreases with θ.
        let slope = |theta: f64| {
            let (sin, cos) = libm::sincos(0.5 * theta);
            let part = |p: f64, half: f64| if p == 0.0 { 0.0 } else { (p / half / half) * (p / half / half) };
            part(d, sin) - part(s, cos) + 16.0 * across * weight
        };
        let ends = [LEAST, core::f64::consts::PI - LEAST];
        let angle = match ends.map(slope) {
            [top, _] if top <= 0.0 => 0.0,
            [_, bottom] if bottom >= 0.0 => core::f64::consts::PI,
            slopes => root(slope, ends, slopes),
        };
        let precession = if angle == 0.0 || angle == core::f64::consts::PI {
            0.0
        } else {
            // p_φ − p_ψ u = (d (1 + u) + s (1 − u))/2, written with the half angles so that nothing
            // cancels.
            let (sin, cos) = libm::sincos(0.5 * angle);
            (d / (sin * sin) + s / (cos * cos)) / (4.0 * across)
        };
        Self::of(rotor, gravity, start, [angle, precession, top.spin()])
    }

    /// Returns the upright top with the spin ω3 of a start.
    ///
    /// # Errors
    /// The errors of [`SteadyTop::with_momenta_of`].
    pub fn upright(rotor: &Rotor, gravity: &UniformGravity, start: State) -> Result<Self, MotionError> {
        let top = HeavyTop::of(rotor, gravity, start)?;
        Self::of(rotor, gravity, start, [0.0, 0.0, top.spin()])
    }

    /// Returns the distance of a start from this motion: the angle between the axes, rad, and |Δω|,
    /// rad/s.
    pub fn distance_from(&self, rotor: &Rotor, start: &State) -> [f64; 2] {
        let axis = |state: &State| state.attitude * rotor.lever();
        [axis(start).angle_to(axis(&self.state)), (start.omega_space() - self.state.omega_space()).norm()]
    }

    fn of(
        rotor: &Rotor,
        gravity: &UniformGravity,
        start: State,
        [angle, precession, spin]: [f64; 3],
    ) -> Result<Self, MotionError> {
        let state = at(rotor, gravity, &start, [angle, precession, spin]);
        let torques = [TorqueModel::Gravity(*gravity)];
        let top = HeavyTop::of(rotor, gravity, state)?;
        let oscillations = if angle == 0.0 || angle == core::f64::consts::PI {
            SmallOscillations::about_equilibrium(rotor, &torques, state)?
        } else {
            let [_, along] = top.moments();
            let h = along * (spin - precession * libm::cos(angle));
            let wheel = Wheel::new(axis(rotor), h, Motor::HeldSpeed)?;
            let omega = (vertical(gravity, &state) * precession).as_quantity();
            let gyrostat = rotor.clone().with_wheels(&[wheel])?;
            SmallOscillations::about_equilibrium(&gyrostat, &torques, State { omega, ..state })?
        };
        let path = match angle {
            0.0 => TopPath::Sleeping { stable: spin.abs() >= top.sleeping_threshold() },
            angle if angle == core::f64::consts::PI => TopPath::Hanging,
            _ => top.path(),
        };
        Ok(Self { path, angle, precession, spin, state, oscillations })
    }
}

/// Angle from the vertical below which a steady axis counts as vertical, rad.
const LEAST: f64 = 1e-7;

/// Returns the start with its axis moved in its vertical plane to `angle` from the vertical, and
/// ω = φ̇ k + (ω3 − φ̇ cos θ) e.
fn at(rotor: &Rotor, gravity: &UniformGravity, start: &State, [angle, precession, spin]: [f64; 3]) -> State {
    let up: Direction<Space> = start.attitude * vertical(gravity, start);
    let e: Direction<Space> = start.attitude * axis(rotor);
    let any = if up.x.abs() < 0.7 { Direction::new(1.0, 0.0, 0.0) } else { Direction::new(0.0, 1.0, 0.0) };
    // Perpendicular to the vertical plane; for a vertical axis any horizontal direction.
    let horizontal = up.cross(e);
    let across = if horizontal.norm() > LEAST { horizontal } else { up.cross(any) };
    let turn = across.direction().map_or_else(Rotation::<Space, Space>::identity, |across| {
        Rotation::turn(across, angle - up.angle_to(e))
    });
    let attitude = turn * start.attitude;
    let state = State { attitude, ..*start };
    let own = spin - precession * libm::cos(angle);
    let omega: AngularVelocity<Body> =
        (vertical(gravity, &state) * precession + axis(rotor) * own).as_quantity();
    State { omega, ..state }
}

/// Returns the upward vertical (opposite to gravity), body axes.
fn vertical(gravity: &UniformGravity, state: &State) -> Direction<Body> {
    let up: Direction<Space> = (-gravity.acceleration).as_quantity();
    state.attitude.inverse() * up.direction().unwrap_or(Direction::ZERO)
}

/// Returns the direction from the pivot to the centre of mass, body axes.
fn axis(rotor: &Rotor) -> Direction<Body> {
    rotor.lever().direction().unwrap_or(Direction::ZERO)
}
