//! Permanent rotations of a body, with or without wheels, and whether they last.

mod friction;
mod momentum_sphere;

pub use friction::DissipativeLimit;

use crate::math::frame::{Body, Principal};
use crate::math::vector::{AngularMomentum, AngularVelocity, Torque};
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::rotor::Rotor;

/// What becomes of a small departure from a steady motion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Stability {
    /// It goes round it, at this angular frequency in the body, rad/s.
    #[non_exhaustive]
    Stable {
        /// √c, rad/s.
        frequency: f64,
    },
    /// It grows as exp(rate t).
    #[non_exhaustive]
    Unstable {
        /// √−c, 1/s.
        growth_rate: f64,
    },
    /// The linear equations do not say: it neither grows as a power of e nor is held.
    Marginal,
}

impl Stability {
    /// The name in JSON: `stable`, `unstable` or `marginal`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Stable { .. } => "stable",
            Self::Unstable { .. } => "unstable",
            Self::Marginal => "marginal",
        }
    }
}

/// A permanent rotation: ω stays where it is in the body and in space, since it lies along L = I ω + h.
///
/// A small departure obeys I δω̇ = I δω × ω + L × δω. Of its three eigenvalues one is zero, on the way to the next such rotation; the
/// other two are ±√−c, with the sum over the principal axes k, and i, j the other two,
///
/// c = Σ (L_k − i_i ω_k) (L_k − i_j ω_k) / (i_i i_j)
///
/// Without wheels this is Euler's c = ω² (i_k − i_i)(i_k − i_j)/(i_i i_j) about axis k: negative about the intermediate axis, whose
/// growth rate is ω √((i3 − i2)(i2 − i1)/(i1 i3)).
///
/// On the sphere of constant |L|, on which the motion stays, c > 0 makes the rotation a strict extremum of the energy: it is
/// stable against finite small departures too, not only in linear order.
///
/// The wheels' h is constant: their speeds are held, or they turn freely. What friction inside makes of it says
/// [`PermanentRotation::with_friction`]: where the energy is greatest, it ends what is stable without it.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::Motor;
/// use polhode::observe::{PermanentRotation, Stability};
/// let inertia = InertiaTensor::diagonal([1.0, 2.0, 3.0])?;
/// let body = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia)?);
/// let spin = PermanentRotation::about(&body, AngularVelocity::new(0.0, 5.0, 0.0))?;
/// assert!(matches!(spin.stability, Stability::Unstable { growth_rate, .. } if (growth_rate - 5.0 / 3f64.sqrt()).abs() < 1e-14));
/// // A wheel with enough momentum along the intermediate axis makes the same spin stable.
/// let wheel = Wheel::new(Direction::new(0.0, 1.0, 0.0), 5.5, Motor::HeldSpeed)?;
/// let spin = PermanentRotation::about(&body.with_wheels(&[wheel])?, AngularVelocity::new(0.0, 5.0, 0.0))?;
/// assert!(matches!(spin.stability, Stability::Stable { .. }));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct PermanentRotation {
    /// ω, rad/s; zero where the body is at rest and its wheels have all of L.
    pub omega: AngularVelocity<Body>,
    /// L = I ω + h, kg·m²/s.
    pub momentum: AngularMomentum<Body>,
    /// Whether it lasts, while nothing inside loses energy.
    pub stability: Stability,
    /// L² tr M, J: how the energy bends on the sphere of constant |L| (`friction.rs`); zero where that is rounding.
    bend: f64,
}

/// L × ω of a permanent rotation, relative to |L| |ω|: what is left by the rounding of numbers that were written down.
const STEADY: f64 = 1e-9;

/// c relative to the sizes of its terms, below which it is rounding: a few times what principal moments are good to.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

impl PermanentRotation {
    /// The rotation of a body at ω, with its wheels as they are at t = 0.
    ///
    /// # Errors
    /// [`MotionError::NotSteady`] if ω is not along L to 1e-9, or if a motor turns a wheel; a parameter's error ([`MotionError::is_parameter`]) for a rod,
    /// whose spin about its own line is undetermined, and an ω that is not finite.
    pub fn about(rotor: &Rotor, omega: AngularVelocity<Body>) -> Result<Self, MotionError> {
        let wheels = held_wheels(rotor, 0.0)?;
        require::finite("the spin", omega.max_abs())?;
        let momentum = rotor.angular_momentum(omega) + rotor.wheel_momentum(0.0);
        let (torque, scale) = (momentum.cross(omega).norm(), momentum.norm() * omega.norm());
        if torque > STEADY * scale {
            return Err(MotionError::NotSteady { torque, scale });
        }
        Ok(Self::of(rotor, wheels, rotor.principal().rotation().inverse() * omega))
    }

    /// All permanent rotations with the angular momentum |L|, kg·m²/s: from two to six, the one of most energy last. Where
    /// a circle of them exists, as of a body with two equal moments, those along the principal axes stand for it.
    ///
    /// They are the extrema of the energy on the sphere of this |L|: I⁻¹ (L − h) = ν L, one for each ν at which
    /// Σ h_k²/(1 − ν i_k)² = |L|², and those of ν = 1/i_k where h has no component along axis k.
    ///
    /// # Errors
    /// As [`PermanentRotation::about`].
    pub fn all(rotor: &Rotor, momentum: f64) -> Result<Vec<Self>, MotionError> {
        Self::all_at(rotor, momentum, 0.0)
    }

    /// The same with the wheels as they are at a time, s.
    ///
    /// # Errors
    /// As [`PermanentRotation::about`].
    pub fn all_at(rotor: &Rotor, momentum: f64, time: f64) -> Result<Vec<Self>, MotionError> {
        let wheels = held_wheels(rotor, time)?;
        require::not_negative("the angular momentum", momentum)?;
        let moments = rotor.principal().moments();
        let spins = momentum_sphere::extrema(moments, wheels.to_array(), momentum);
        let mut all: Vec<Self> = spins.into_iter().map(|w| Self::of(rotor, wheels, w)).collect();
        all.sort_by(|a, b| rotor.kinetic_energy(a.omega).total_cmp(&rotor.kinetic_energy(b.omega)));
        Ok(all)
    }

    /// The times from which on the wheels' momentum stays what it is, for a while or for ever: t = 0, if no motor turns a wheel then,
    /// and the last time at which one stops. None if a motor never stops; of pulses, after 10⁴ of them.
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
        /// Changes that are looked at.
        const MOST: usize = 20_000;
        let is_still = |time: f64| rotor.motor_torque(time) == Torque::ZERO;
        let next =
            |time: f64| rotor.wheels().iter().map(|w| w.next_change(time)).fold(f64::INFINITY, f64::min);
        let last =
            core::iter::successors(Some(0.0), |&time| Some(next(time)).filter(|next| next.is_finite()));
        let last = last.take(MOST).last().filter(|&last| last > 0.0 && next(last) == f64::INFINITY);
        [Some(0.0), last].into_iter().flatten().filter(|&time| is_still(time)).collect()
    }

    fn of(rotor: &Rotor, wheels: AngularMomentum<Principal>, omega: AngularVelocity<Principal>) -> Self {
        let (moments, w, h) = (rotor.principal().moments(), omega.to_array(), wheels.to_array());
        let (mut c, mut scale) = (0.0, 0.0);
        let (mut bend, mut bend_scale) = (0.0, 0.0);
        for k in 0..3 {
            // (L_k − i ω_k)/i for the other two, L_k = i_k ω_k + h_k: what is equal in i_k and i cancels first.
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

/// h along principal axes at a time, which has to be constant, of a body whose ω follows from its L.
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
