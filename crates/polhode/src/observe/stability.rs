//! Permanent rotations of a body, with or without wheels, and their stability.

mod friction;
mod momentum_sphere;

pub use friction::DissipativeLimit;

use crate::math::frame::{Body, Principal};
use crate::math::vector::{AngularMomentum, AngularVelocity, Torque};
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::rotor::Rotor;

/// Stability of a steady motion against small deviations.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Stability {
    /// Stable: a deviation oscillates with this angular frequency in the body.
    #[non_exhaustive]
    Stable {
        /// Angular frequency √c, rad/s.
        frequency: f64,
    },
    /// Unstable: a deviation grows as exp(rate t).
    #[non_exhaustive]
    Unstable {
        /// Growth rate √−c, 1/s.
        growth_rate: f64,
    },
    /// Marginal: the linear equations do not decide; a deviation neither grows exponentially nor
    /// oscillates.
    Marginal,
}

impl Stability {
    /// Returns the name in JSON: `stable`, `unstable` or `marginal`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Stable { .. } => "stable",
            Self::Unstable { .. } => "unstable",
            Self::Marginal => "marginal",
        }
    }
}

/// Permanent rotation: ω is constant in the body and in space, because it is parallel to L = I
/// ω + h.
///
/// A small deviation obeys I δω̇ = I δω × ω + L × δω. One of its three eigenvalues is zero; it
/// leads to a neighbouring rotation of this kind. The other two are ±√−c. Summed over the principal
/// axes k, with i and j the other two,
///
/// c = Σ (L_k − i_i ω_k) (L_k − i_j ω_k) / (i_i i_j)
///
/// Without wheels this is Euler's c = ω² (i_k − i_i)(i_k − i_j)/(i_i i_j) about axis k. It is
/// negative about the intermediate axis, with the growth rate ω √((i3 − i2)(i2 − i1)/(i1 i3)).
///
/// The motion stays on the sphere of constant |L|. If c > 0, the rotation is a strict extremum of
/// the energy there, so it is stable against finite small deviations too, not only to linear order.
///
/// The wheels' momentum h is constant: their speeds are held, or they rotate freely.
/// [`PermanentRotation::with_friction`] gives the effect of internal friction: it destabilises a
/// rotation that is an energy maximum.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::Motor;
/// use polhode::observe::{PermanentRotation, Stability};
/// let inertia = InertiaTensor::diagonal([1.0, 2.0, 3.0])?;
/// let body = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia)?);
/// let spin = PermanentRotation::of(&body, AngularVelocity::new(0.0, 5.0, 0.0))?;
/// let Stability::Unstable { growth_rate, .. } = spin.stability else { return Err("stable".into()) };
/// assert!((growth_rate - 5.0 / 3f64.sqrt()).abs() < 1e-14);
/// // A wheel with enough momentum along the intermediate axis makes the same spin stable.
/// let wheel = Wheel::new(Direction::new(0.0, 1.0, 0.0), 5.5, Motor::HeldSpeed)?;
/// let spin = PermanentRotation::of(&body.with_wheels(&[wheel])?, AngularVelocity::new(0.0, 5.0, 0.0))?;
/// assert!(matches!(spin.stability, Stability::Stable { .. }));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct PermanentRotation {
    /// Angular velocity ω, body axes, rad/s; zero if the body is at rest and the wheels carry all
    /// of L.
    pub omega: AngularVelocity<Body>,
    /// Angular momentum L = I ω + h, body axes, kg·m²/s.
    pub momentum: AngularMomentum<Body>,
    /// Stability without internal energy loss.
    pub stability: Stability,
    /// L² tr M, J: curvature of the energy on the sphere of constant |L| (`friction.rs`); zero if
    /// it is only rounding.
    bend: f64,
}

/// Largest |L × ω| of a permanent rotation, relative to |L| |ω|: the rounding of decimal input.
const STEADY: f64 = 1e-9;

/// Threshold of c, relative to the sizes of its terms, below which it is rounding: a few times the
/// error of principal moments.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

impl PermanentRotation {
    /// Returns the rotation of a body at ω, rad/s, with its wheels as at t = 0.
    ///
    /// # Errors
    /// [`MotionError::NotSteady`] if ω is not parallel to L to 1e-9, or if a motor accelerates a
    /// wheel; a parameter error ([`MotionError::is_parameter`]) for a rod, whose spin about its own
    /// line is undetermined, and for an ω that is not finite.
    pub fn of(rotor: &Rotor, omega: AngularVelocity<Body>) -> Result<Self, MotionError> {
        let wheels = held_wheels(rotor, 0.0)?;
        require::finite("the spin", omega.max_abs())?;
        let momentum = rotor.angular_momentum(omega) + rotor.wheel_momentum(0.0);
        let (torque, scale) = (momentum.cross(omega).norm(), momentum.norm() * omega.norm());
        if torque > STEADY * scale {
            return Err(MotionError::NotSteady { torque, scale });
        }
        Ok(Self::of_principal(rotor, wheels, rotor.principal().rotation().inverse() * omega))
    }

    /// Finds all permanent rotations with the angular momentum |L|, kg·m²/s: two to six, the one of
    /// highest energy last. If there is a continuous circle of them, as for a body with two equal
    /// moments, those along the principal axes represent it.
    ///
    /// They are the extrema of the energy on the sphere of this |L|: I⁻¹ (L − h) = ν L. There is
    /// one for each ν that satisfies Σ h_k²/(1 − ν i_k)² = |L|², and those of ν = 1/i_k if h has no
    /// component along axis k.
    ///
    /// # Errors
    /// The errors of [`PermanentRotation::of`].
    pub fn all(rotor: &Rotor, momentum: f64) -> Result<Vec<Self>, MotionError> {
        Self::all_at(rotor, momentum, 0.0)
    }

    /// Finds the same rotations with the wheels as at a given time, s.
    ///
    /// # Errors
    /// The errors of [`PermanentRotation::of`].
    pub fn all_at(rotor: &Rotor, momentum: f64, time: f64) -> Result<Vec<Self>, MotionError> {
        let wheels = held_wheels(rotor, time)?;
        require::not_negative("the angular momentum", momentum)?;
        let moments = rotor.principal().moments();
        let spins = momentum_sphere::extrema(moments, wheels.to_array(), momentum);
        let mut all: Vec<Self> = spins.into_iter().map(|w| Self::of_principal(rotor, wheels, w)).collect();
        all.sort_by(|a, b| rotor.kinetic_energy(a.omega).total_cmp(&rotor.kinetic_energy(b.omega)));
        Ok(all)
    }

    /// Returns the times, s, from which on the wheels' momentum is constant, at least for a while:
    /// t = 0, if no motor accelerates a wheel then, and the last time at which a motor stops. The
    /// latter is absent if a motor never stops, or does not stop within 10⁴ pulses.
    ///
    /// ```
    /// use polhode::prelude::*;
    /// use polhode::motion::Motor;
    /// use polhode::motion::torque::Schedule;
    /// use polhode::observe::PermanentRotation;
    /// let inertia = InertiaTensor::diagonal([4.0, 5.0, 7.0])?;
    /// let body = Rotor::free(&MassProperties::new(10.0, Position::ZERO, inertia)?);
    /// let motor = Motor::Torque { inertia: 0.5, torque: 0.2, schedule: Some(Schedule::window(3.0, 8.0)?) };
    /// let body = body.with_wheels(&[Wheel::new(Direction::new(0.0, 1.0, 0.0), 0.0, motor)?])?;
    /// assert_eq!(PermanentRotation::times(&body), [0.0, 8.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn times(rotor: &Rotor) -> Vec<f64> {
        /// Maximum number of changes that are examined.
        const MOST: usize = 20_000;
        let is_still = |time: f64| rotor.motor_torque(time) == Torque::ZERO;
        let next =
            |time: f64| rotor.wheels().iter().map(|w| w.next_change(time)).fold(f64::INFINITY, f64::min);
        let last =
            core::iter::successors(Some(0.0), |&time| Some(next(time)).filter(|next| next.is_finite()));
        let last = last.take(MOST).last().filter(|&last| last > 0.0 && next(last) == f64::INFINITY);
        [Some(0.0), last].into_iter().flatten().filter(|&time| is_still(time)).collect()
    }

    fn of_principal(
        rotor: &Rotor,
        wheels: AngularMomentum<Principal>,
        omega: AngularVelocity<Principal>,
    ) -> Self {
        let (moments, w, h) = (rotor.principal().moments(), omega.to_array(), wheels.to_array());
        let (mut c, mut scale) = (0.0, 0.0);
        let (mut bend, mut bend_scale) = (0.0, 0.0);
        for k in 0..3 {
            // (L_k − i ω_k)/i for the other two axes, with L_k = i_k ω_k + h_k; i_k − i is
            // subtracted first, without cancellation.
            let factor = |i: f64| ((moments[k] - i) * w[k] + h[k]) / i;
            let size = |i: f64| (moments[k].max(i) * w[k].abs() + h[k].abs()) / i;
            let (i, j) = (moments[(k + 1) % 3], moments[(k + 2) % 3]);
            let l = moments[k] * w[k] + h[k];
            c += factor(i) * factor(j);
            scale += size(i) * size(j);
            bend += l * (factor(i) + factor(j));
            bend_scale += l.abs() * (size(i) + size(j));
        }
        let stability = match c {
            c if c > ROUNDING * scale => Stability::Stable { frequency: c.sqrt() },
            c if c < -ROUNDING * scale => Stability::Unstable { growth_rate: (-c).sqrt() },
            _ => Stability::Marginal,
        };
        let omega = rotor.principal().rotation() * omega;
        let momentum = rotor.principal().rotation()
            * (wheels + AngularMomentum::from_array([0, 1, 2].map(|k| moments[k] * w[k])));
        let bend = if bend.abs() > ROUNDING * bend_scale { bend } else { 0.0 };
        Self { omega, momentum, stability, bend }
    }
}

/// Returns h along principal axes at a time. It must be constant then, and L must determine ω.
fn held_wheels(rotor: &Rotor, time: f64) -> Result<AngularMomentum<Principal>, MotionError> {
    let [least, ..] = rotor.principal().moments();
    let rule = "above zero: a rod has a spin that L does not determine";
    require::that("the least moment of inertia", least, least > 0.0, rule)?;
    let motor: Torque<Body> = rotor.motor_torque(time);
    if motor != Torque::ZERO {
        return Err(MotionError::NotSteady { torque: motor.norm(), scale: motor.norm() });
    }
    Ok(rotor.principal().rotation().inverse() * rotor.wheel_momentum(time))
}
