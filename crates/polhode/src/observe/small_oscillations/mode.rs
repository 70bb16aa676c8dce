//! Mode of small oscillation.

use crate::math::complex::Complex;
use crate::math::frame::Body;
use crate::math::vector::Direction;

/// Mode δθ(t) = e^(σ t) (u cos ϖt + v sin ϖt), a small rotation along body axes.
///
/// u and v are the semi-axes of the ellipse that δθ describes: u ⊥ v, |u| = 1 ≥ |v|. If v = 0, the
/// body oscillates about one axis, u.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct OscillationMode {
    /// Frequency ϖ ≥ 0, rad/s; zero for a mode that only grows or decays.
    pub frequency: f64,
    /// Growth rate σ, 1/s: negative for a damped mode, zero for an undamped one.
    pub growth_rate: f64,
    /// Major semi-axis u, body axes.
    pub axis: Direction<Body>,
    /// Minor semi-axis v, body axes.
    pub minor_axis: Direction<Body>,
    /// Number of modes with this frequency and growth rate. They form a basis: the body can perform
    /// any linear combination of them.
    pub multiplicity: usize,
}

impl OscillationMode {
    /// Returns the mode δθ = Re (shape · e^((σ + iϖ) t)), for any length and phase of the shape.
    pub(super) fn new(frequency: f64, growth_rate: f64, shape: [Complex<f64>; 3]) -> Self {
        // The shape is multiplied by e^(iφ) such that Σ shape² is real and positive; its real and
        // imaginary parts are then u and −v.
        let zero = Complex { re: 0.0, im: 0.0 };
        let square = shape.iter().fold(zero, |sum, c| sum.minus(zero.minus(c.times(*c))));
        let phi = -0.5 * libm::atan2(square.im, square.re);
        let (sin, cos) = libm::sincos(phi);
        let turned = shape.map(|c| c.times(Complex { re: cos, im: sin }));
        let (u, v) = (turned.map(|c| c.re), turned.map(|c| -c.im));
        let largest = u.iter().copied().fold(0.0, |max: f64, x| if x.abs() > max.abs() { x } else { max });
        let length = Direction::<Body>::from_array(u).norm().copysign(largest);
        let unit =
            |v: [f64; 3]| Direction::from_array(v.map(|x| if length == 0.0 { 0.0 } else { x / length }));
        Self { frequency, growth_rate, axis: unit(u), minor_axis: unit(v), multiplicity: 1 }
    }

    /// Returns the mode δθ = u cos ϖt, one of several of equal frequency.
    pub(super) fn along(frequency: f64, growth_rate: f64, axis: Direction<Body>) -> Self {
        Self { frequency, growth_rate, axis, minor_axis: Direction::ZERO, multiplicity: 1 }
    }

    /// Returns true if the mode grows.
    pub fn is_growing(&self) -> bool {
        self.growth_rate > 0.0
    }

    /// Returns the damping ratio ζ = −σ/√(σ² + ϖ²); 1 for a mode that decays without oscillation.
    pub fn damping_ratio(&self) -> f64 {
        let size = libm::hypot(self.growth_rate, self.frequency);
        if size == 0.0 { 0.0 } else { -self.growth_rate / size }
    }
}
