//! Attitude from a prescribed ω(t).
//!
//! Ṙ = R [ω×] along body axes, and Ṙ = [ω×] R along space axes. A step is the rotation of the
//! sixth-order Magnus series, with ω at the three Gauss–Legendre nodes. It is an exact rotation for
//! every step size. It is the exact solution if ω has a constant direction and is a polynomial of
//! degree up to five. The step size is chosen so that one step and two half steps agree to
//! 2·10⁻¹⁴ rad. The half steps are stored. A state in between is one shorter step from the stored
//! attitude before it.
//!
//! # Source
//! S. Blanes, F. Casas, J. A. Oteo & J. Ros, Physics Reports 470 (2009) 151.

use super::rates::Rates;
use crate::math::frame::{Body, Space};
use crate::math::rotation::{Attitude, Rotation};
use crate::math::vector::{AngularAcceleration, AngularVelocity, Direction};
use crate::motion::error::MotionError;
use crate::motion::model::state::State;

/// Tolerance on the difference between one step and two half steps, rad. The error of the half
/// steps is smaller by 2⁶.
const AGREEMENT: f64 = 2e-14;

/// Minimum number of steps, as a long step may miss a short pulse.
const FEWEST: f64 = 256.0;

/// Maximum number of stored attitudes; a larger number indicates wrong units.
const MOST: usize = 10_000_000;

/// Axes of the components of ω.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RateAxes {
    /// Body axes.
    Body,
    /// Space axes.
    Space,
}

/// Motion with a prescribed ω(t).
#[derive(Clone, Debug, PartialEq)]
pub struct Turning {
    rates: Rates,
    axes: RateAxes,
    /// Times and attitudes from the start to the end; at least the start.
    kept: Vec<(f64, Attitude)>,
    end: f64,
    error: f64,
}

impl Turning {
    /// Integrates from an attitude at the time `start` to `end`.
    ///
    /// # Errors
    /// [`MotionError`] if ω is not finite, or if the body turns too often.
    pub(super) fn new(
        rates: Rates,
        axes: RateAxes,
        attitude: Attitude,
        [start, end]: [f64; 2],
    ) -> Result<Self, MotionError> {
        let mut motion = Self { rates, axes, kept: vec![(start, attitude)], end, error: 0.0 };
        let (mut time, mut attitude) = (start, attitude);
        let longest = (end - start) / FEWEST;
        let mut step = longest;
        while time < end {
            step = step.min(end - time);
            if time + 0.5 * step <= time {
                return Err(MotionError::StepTooSmall { time, step });
            }
            let half = motion.step(time, attitude, 0.5 * step);
            let whole = motion.step(time, attitude, step);
            let twice = motion.step(time + 0.5 * step, half, 0.5 * step);
            let difference = whole.angle_to(twice);
            if !difference.is_finite() {
                // A long step may meet a value that is not finite; a short step confirms it.
                if step < 1e-9 * (end - start) {
                    return Err(MotionError::NotFinite { time });
                }
                step *= 0.25;
                continue;
            }
            let factor = 0.9 * libm::pow(AGREEMENT / difference.max(1e-30), 1.0 / 7.0);
            if difference <= AGREEMENT {
                motion.kept.push((time + 0.5 * step, half));
                let last = if step >= end - time { end } else { time + step };
                motion.kept.push((last, twice));
                motion.error += difference / 63.0 + f64::EPSILON;
                (time, attitude) = (last, twice);
            }
            step = (step * factor.clamp(0.1, 4.0)).min(longest);
            if motion.kept.len() > MOST {
                return Err(MotionError::TooManySteps { time, step, most: MOST as u64 });
            }
        }
        Ok(motion)
    }

    /// Returns the interval in which the motion is defined, s.
    pub fn span(&self) -> [f64; 2] {
        [self.kept.first().map_or(self.end, |(time, _)| *time), self.end]
    }

    /// Returns the axes of the components of ω.
    pub const fn axes(&self) -> RateAxes {
        self.axes
    }

    /// Returns an estimate of the error of the attitude at the end of the span, rad: the sum over
    /// all steps.
    pub const fn attitude_error(&self) -> f64 {
        self.error
    }

    /// Returns the state at a time of the span, and dω/dt along body axes.
    pub(super) fn at(&self, time: f64) -> (State, AngularAcceleration<Body>) {
        let next = self.kept.partition_point(|(kept, _)| *kept <= time);
        let attitude = match self.kept.get(next.saturating_sub(1)) {
            Some((kept, attitude)) if *kept == time => *attitude,
            Some((kept, attitude)) => self.step(*kept, *attitude, time - kept),
            None => Attitude::identity(),
        };
        let [omega, acceleration] = self.rates.at(time);
        let (omega, acceleration) = match self.axes {
            RateAxes::Body => {
                (AngularVelocity::from_array(omega), AngularAcceleration::from_array(acceleration))
            }
            // d/dt (Rᵀ ω) = Rᵀ ω̇, as ω × ω is zero.
            RateAxes::Space => (
                attitude.inverse() * AngularVelocity::<Space>::from_array(omega),
                attitude.inverse() * AngularAcceleration::<Space>::from_array(acceleration),
            ),
        };
        (State { time, attitude, omega }, acceleration)
    }

    /// Returns the attitude one step later.
    ///
    /// α₁ = h A₂,  α₂ = (√15/3) h (A₃ − A₁),  α₃ = (10/3) h (A₃ − 2 A₂ + A₁),
    ///
    /// C₁ = [α₁, α₂],  C₂ = −[α₁, 2 α₃ + C₁]/60,
    ///
    /// Ω = α₁ + α₃/12 + [−20 α₁ − α₃ + C₁, α₂ + C₂]/240,
    ///
    /// where Aₖ is A at h (½ − √15/10, ½, ½ + √15/10).
    fn step(&self, time: f64, attitude: Attitude, h: f64) -> Attitude {
        const NODE: f64 = 0.387_298_334_620_741_7; // √15/10
        // Y′ = A Y. Along space axes Y = R and A = ω; along body axes Y = Rᵀ and A = −ω.
        let sign = if self.axes == RateAxes::Body { -1.0 } else { 1.0 };
        let a = |node: f64| Vector::from_array(self.rates.omega(time + node * h)) * (sign * h);
        let [a1, a2, a3] = [0.5 - NODE, 0.5, 0.5 + NODE].map(a);
        let alpha2 = (a3 - a1) * (10.0 * NODE / 3.0);
        let alpha3 = (a3 - a2 * 2.0 + a1) * (10.0 / 3.0);
        let c1 = a2.cross(alpha2);
        let c2 = a2.cross(alpha3 * 2.0 + c1) / -60.0;
        let omega = a2 + alpha3 / 12.0 + (c1 - a2 * 20.0 - alpha3).cross(alpha2 + c2) / 240.0;
        match self.axes {
            RateAxes::Space => Rotation::<Space, Space>::from_rotation_vector(omega.as_frame()) * attitude,
            RateAxes::Body => attitude * Rotation::<Body, Body>::from_rotation_vector((-omega).as_frame()),
        }
    }
}

/// Vector along the axes of ω.
type Vector = Direction<Space>;
