//! ω as a function of time, and the attitude that follows from it.
//!
//! Ṙ = R [ω×] along body axes, Ṙ = [ω×] R along those of space. A step is the turn by the rotation vector of Magnus' series
//! to sixth order, with ω at the three nodes of Gauss and Legendre: a rotation whatever the step, and exact where ω keeps
//! its direction and is a polynomial of degree up to five. Steps are as long as one and two halves agree to 2·10⁻¹⁴ rad; the
//! halves are kept, and any time in between is one shorter step from the kept attitude before it.
//!
//! # Source
//! S. Blanes, F. Casas, J. A. Oteo & J. Ros, Physics Reports 470 (2009) 151.

use super::rates::Rates;
use crate::math::frame::{Body, Space};
use crate::math::rotation::{Attitude, Rotation};
use crate::math::vector::{AngularAcceleration, AngularVelocity, Direction};
use crate::motion::error::MotionError;
use crate::motion::model::state::State;

/// One step and two halves agree to this, rad; the halves are better by 2⁶.
const AGREEMENT: f64 = 2e-14;

/// Steps at least: what a longer one would jump over, it could not see.
const FEWEST: f64 = 256.0;

/// Kept attitudes; more is a mistake in the units.
const MOST: usize = 10_000_000;

/// Axes that ω is given along.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RateAxes {
    /// Fixed in the body.
    Body,
    /// Fixed in space.
    Space,
}

/// A motion whose ω(t) is given.
#[derive(Clone, Debug, PartialEq)]
pub struct Turning {
    rates: Rates,
    axes: RateAxes,
    /// Times and attitudes, from the start to the end; at least the start.
    kept: Vec<(f64, Attitude)>,
    end: f64,
    error: f64,
}

impl Turning {
    /// From an attitude at the time `start` up to `end`.
    ///
    /// # Errors
    /// [`MotionError`] where ω is not finite, or turns too often for any computer.
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
                // A step too long may meet what is not finite; a short one shows that it is there.
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

    /// From when to when it is known, s.
    pub fn span(&self) -> [f64; 2] {
        [self.kept.first().map_or(self.end, |(time, _)| *time), self.end]
    }

    /// The axes that ω is given along.
    pub const fn axes(&self) -> RateAxes {
        self.axes
    }

    /// An estimate of the error of the attitude at the end of the span, rad: those of all steps, added.
    pub const fn attitude_error(&self) -> f64 {
        self.error
    }

    /// The state at a time of the span, and dω/dt along body axes.
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
            // d/dt (Rᵀ ω) = Rᵀ ω̇: ω × ω is zero.
            RateAxes::Space => (
                attitude.inverse() * AngularVelocity::<Space>::from_array(omega),
                attitude.inverse() * AngularAcceleration::<Space>::from_array(acceleration),
            ),
        };
        (State { time, attitude, omega }, acceleration)
    }

    /// The attitude a step later.
    ///
    /// α₁ = h A₂,  α₂ = (√15/3) h (A₃ − A₁),  α₃ = (10/3) h (A₃ − 2 A₂ + A₁),  Aₖ at h (½ − √15/10, ½, ½ + √15/10)
    /// C₁ = [α₁, α₂],  C₂ = −[α₁, 2 α₃ + C₁]/60
    /// Ω = α₁ + α₃/12 + [−20 α₁ − α₃ + C₁, α₂ + C₂]/240
    fn step(&self, time: f64, attitude: Attitude, h: f64) -> Attitude {
        const NODE: f64 = 0.387_298_334_620_741_7; // √15/10
        // Y′ = A Y with Y = R and A = ω along space axes; along body axes Y = Rᵀ and A = −ω.
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

/// Three numbers along the axes of ω.
type Vector = Direction<Space>;
