//! Permanent rotations of a body, with or without wheels, and whether they last.

mod momentum_sphere;

use crate::math::frame::{Body, Principal};
use crate::math::vector::{AngularMomentum, AngularVelocity, Torque};
use crate::motion::error::MotionError;
use crate::motion::rotor::Rotor;

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
/// The wheels' h is constant: their speeds are held, or they turn freely.
///
/// ```
/// use polhode::*;
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
    /// Whether it lasts.
    pub stability: Stability,
}

/// L × ω of a permanent rotation, relative to |L| |ω|: what is left by the rounding of numbers that were written down.
const STEADY: f64 = 1e-9;

/// c relative to the sizes of its terms, below which it is rounding: a few times what principal moments are good to.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

impl PermanentRotation {
    /// The rotation of a body at ω, with its wheels as they are at t = 0.
    ///
    /// # Errors
    /// [`MotionError::NotSteady`] if ω is not along L to 1e-9, or if a motor turns a wheel; [`MotionError::Parameter`] for a rod,
    /// whose spin about its own line is undetermined, and an ω that is not finite.
    pub fn about(rotor: &Rotor, omega: AngularVelocity<Body>) -> Result<Self, MotionError> {
        let wheels = held_wheels(rotor)?;
        if !omega.is_finite() {
            return Err(MotionError::Parameter { what: "the spin", value: omega.max_abs(), rule: "finite" });
        }
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
        let wheels = held_wheels(rotor)?;
        if !(momentum >= 0.0 && momentum.is_finite()) {
            let what = "the angular momentum";
            return Err(MotionError::Parameter { what, value: momentum, rule: "not negative, and finite" });
        }
        let moments = rotor.principal().moments();
        let spins = momentum_sphere::extrema(moments, wheels.to_array(), momentum);
        let mut all: Vec<Self> = spins.into_iter().map(|w| Self::of(rotor, wheels, w)).collect();
        all.sort_by(|a, b| rotor.kinetic_energy(a.omega).total_cmp(&rotor.kinetic_energy(b.omega)));
        Ok(all)
    }

    fn of(rotor: &Rotor, wheels: AngularMomentum<Principal>, omega: AngularVelocity<Principal>) -> Self {
        let (moments, w, h) = (rotor.principal().moments(), omega.to_array(), wheels.to_array());
        let (mut c, mut scale) = (0.0, 0.0);
        for k in 0..3 {
            // (L_k − i ω_k)/i for the other two, L_k = i_k ω_k + h_k: what is equal in i_k and i cancels first.
            let factor = |i: f64| ((moments[k] - i) * w[k] + h[k]) / i;
            let size = |i: f64| (moments[k].max(i) * w[k].abs() + h[k].abs()) / i;
            let (i, j) = (moments[(k + 1) % 3], moments[(k + 2) % 3]);
            c += factor(i) * factor(j);
            scale += size(i) * size(j);
        }
        let stability = match c {
            c if c > ROUNDING * scale => Stability::Stable { frequency: c.sqrt() },
            c if c < -ROUNDING * scale => Stability::Unstable { growth_rate: (-c).sqrt() },
            _ => Stability::Marginal,
        };
        let omega = rotor.principal().rotation() * omega;
        Self { omega, momentum: rotor.angular_momentum(omega) + rotor.wheel_momentum(0.0), stability }
    }
}

/// h along principal axes, which has to be constant, of a body whose ω follows from its L.
fn held_wheels(rotor: &Rotor) -> Result<AngularMomentum<Principal>, MotionError> {
    let [least, ..] = rotor.principal().moments();
    if !(least > 0.0) {
        let (what, rule) =
            ("the least moment of inertia", "above zero: a rod has a spin that L does not determine");
        return Err(MotionError::Parameter { what, value: least, rule });
    }
    let motor: Torque<Body> = rotor.motor_torque(0.0);
    if motor != Torque::ZERO {
        return Err(MotionError::NotSteady { torque: motor.norm(), scale: motor.norm() });
    }
    Ok(rotor.principal().rotation().inverse() * rotor.wheel_momentum(0.0))
}
