//! The compound pendulum: a body suspended from a fixed axis.

use crate::math::elliptic::complete_k;
use crate::math::frame::Body;
use crate::math::number::{PI, sin_cos};
use crate::math::vector::{Acceleration, Direction};
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::rotor::Rotor;
use crate::motion::solve::pendulum_motion::PendulumMotion;

/// Body that swings about a fixed axis under gravity: θ̈ = −ω₀² sin θ.
///
/// ω₀² = M g⊥ d / I, with d the distance of the centre of mass from the axis, g⊥ the component of
/// gravity normal to the axis, and I the moment of inertia about it.
///
/// ```
/// use polhode::body::{InertiaTensor, MassProperties};
/// use polhode::math::{Acceleration, Direction, Position};
/// use polhode::motion::{Pendulum, Rotor};
/// // A uniform rod of 1.2 m hung by one end, √(3 g / 2 l)
/// let rod = MassProperties::new(0.8, Position::new(0.6, 0.0, 0.0), InertiaTensor::diagonal([0.0, 0.096, 0.096])?)?;
/// let hung = Rotor::pivoted(&rod, Position::ZERO);
/// let g = Acceleration::new(9.81, 0.0, 0.0);
/// let pendulum = Pendulum::hung(&hung, Direction::new(0.0, 0.0, 1.0), g)?;
/// assert!((pendulum.small_frequency() - (1.5 * 9.81_f64 / 1.2).sqrt()).abs() < 1e-14);
/// // at 10° the period is longer by nearly θ²/16
/// let longer = pendulum.period(10_f64.to_radians()) / pendulum.period(0.0) - 1.0;
/// assert!((longer - 0.001_907_188).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// Source: Thornton & Marion, example 11.4; Landau & Lifshitz, Mechanics, §11 problem 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pendulum {
    moment: f64,
    arm: f64,
    gravity: f64,
    frequency: f64,
    angle: f64,
}

/// Kind of motion of a pendulum, which depends on its energy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Swing {
    /// The pendulum hangs at rest.
    Rest,
    /// Oscillation between ± amplitude.
    Oscillation {
        /// Largest angle, rad.
        amplitude: f64,
        /// Period of a full swing, s.
        period: f64,
    },
    /// Exactly the energy to reach the upper equilibrium, after infinite time.
    Separatrix,
    /// Rotation over the top.
    Revolution {
        /// Period of one turn, s.
        period: f64,
    },
}

impl Pendulum {
    /// Creates a pendulum from a body suspended at the rotor's pivot. `axis` and gravity `g` (m/s²)
    /// are in the current body axes.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the axis is zero or not finite, if
    /// gravity is along it, or if the centre of mass is on it.
    pub fn hung(rotor: &Rotor, axis: Direction<Body>, g: Acceleration<Body>) -> Result<Self, MotionError> {
        let n = require::direction("the length of the axis", axis)?;
        let across = |v: Direction<Body>| v - n * n.dot(v);
        let (l, g): (Direction<Body>, Direction<Body>) = (rotor.lever().as_quantity(), g.as_quantity());
        let (arm, down) = (across(l), across(g));
        // A normal component within rounding is not an arm.
        let is_across = |v: Direction<Body>, of: Direction<Body>| v.norm() > 1e-12 * of.norm();
        let rule = "positive: it lies on the axis";
        require::that("the arm of the centre of mass", arm.norm(), is_across(arm, l), rule)?;
        let rule = "positive: it is along the axis";
        require::that("gravity across the axis", down.norm(), is_across(down, g), rule)?;
        let moment = rotor.inertia().about_axis(n);
        let frequency = (rotor.mass() * down.norm() * arm.norm() / moment).sqrt();
        let sine = n.dot(down.cross(arm));
        let angle = libm::atan2(sine, down.dot(arm));
        Ok(Self { moment, arm: arm.norm(), gravity: down.norm(), frequency, angle })
    }

    /// Returns the moment of inertia about the axis, kg·m².
    pub const fn moment(&self) -> f64 {
        self.moment
    }

    /// Returns the distance of the centre of mass from the axis, m.
    pub const fn arm(&self) -> f64 {
        self.arm
    }

    /// Returns the component of gravity normal to the axis, m/s².
    pub const fn gravity(&self) -> f64 {
        self.gravity
    }

    /// Returns the initial angle from the lower equilibrium, right-handed about the axis, rad, in
    /// −π … π.
    pub const fn angle(&self) -> f64 {
        self.angle
    }

    /// Returns the angular frequency of small oscillations, ω₀ = √(M g⊥ d / I), rad/s.
    pub const fn small_frequency(&self) -> f64 {
        self.frequency
    }

    /// Returns the exact period of oscillations between ± amplitude (rad), s:
    /// T = 4 K(sin²(θ₀/2)) / ω₀.
    ///
    /// It is 2π/ω₀ at 0, and infinite at π (upside down) and beyond.
    pub fn period(&self, amplitude: f64) -> f64 {
        if !(amplitude.abs() < PI) {
            return f64::INFINITY;
        }
        let (_, cosine) = sin_cos(0.5 * amplitude);
        4.0 * complete_k(cosine * cosine) / self.frequency
    }

    /// Returns the motion that starts at `angle` (rad from the lower equilibrium) with the rate
    /// `rate` (rad/s).
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the angle or the rate is not finite.
    pub fn motion(&self, angle: f64, rate: f64) -> Result<PendulumMotion, MotionError> {
        PendulumMotion::of(self.frequency, angle, rate)
    }

    /// Returns the kind of the motion that starts at `angle` (rad from the lower equilibrium) with
    /// the rate `rate` (rad/s).
    ///
    /// Let k² = sin²(θ/2) + (θ̇ / 2ω₀)². The motion is an oscillation of amplitude 2 asin k for
    /// k < 1, and a revolution of period 2 K(1/k²) / (ω₀ k) for k > 1.
    pub fn swing(&self, angle: f64, rate: f64) -> Swing {
        let (s, c) = sin_cos(0.5 * angle);
        let r = 0.5 * rate / self.frequency;
        let k = libm::hypot(s, r);
        // 1 − k² = cos²(θ/2) − r², without the cancellation of 1 − (s² + r²)
        let m1 = (c.abs() - r.abs()) * (c.abs() + r.abs());
        if angle == 0.0 && rate == 0.0 {
            Swing::Rest
        } else if m1 == 0.0 || (angle.abs() == PI && rate == 0.0) {
            Swing::Separatrix
        } else if m1 > 0.0 {
            let amplitude = 2.0 * libm::atan2(k, m1.sqrt());
            Swing::Oscillation { amplitude, period: 4.0 * complete_k(m1) / self.frequency }
        } else {
            // 1 − 1/k² = (|r| − |c|)(|r| + |c|) / k²
            let m1 = ((r.abs() - c.abs()) / k) * ((r.abs() + c.abs()) / k);
            Swing::Revolution { period: 2.0 * complete_k(m1) / (self.frequency * k) }
        }
    }
}
