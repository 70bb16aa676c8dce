//! One mode of small oscillation.

use crate::math::complex::Complex;
use crate::math::frame::Body;
use crate::math::vector::Direction;

/// One mode: δθ(t) = e^(σ t) (u cos ϖt + v sin ϖt), a turn along body axes.
///
/// u and v are the half axes of the ellipse that the turn describes: u ⊥ v, |u| = 1 ≥ |v|. With v = 0 the body swings about
/// one axis, u.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct OscillationMode {
    /// ϖ ≥ 0, rad/s; zero for one that only grows or dies away.
    pub frequency: f64,
    /// σ, 1/s: negative for one that is damped, zero for one that is kept.
    pub growth_rate: f64,
    /// u
    pub axis: Direction<Body>,
    /// v
    pub minor_axis: Direction<Body>,
    /// How many modes have this frequency and growth: the body then moves as any sum of them, and these are a basis.
    pub multiplicity: usize,
}

impl OscillationMode {
    /// Of δθ = Re (shape · e^((σ + iϖ) t)), whatever the shape's length and phase.
    pub(super) fn new(frequency: f64, growth_rate: f64, shape: [Complex<f64>; 3]) -> Self {
        // Multiplied by e^(iφ) such that Σ shape² is real and positive, its real and imaginary parts are u and −v.
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

    /// Of δθ = u cos ϖt, one of several like it.
    pub(super) fn along(frequency: f64, growth_rate: f64, axis: Direction<Body>) -> Self {
        Self { frequency, growth_rate, axis, minor_axis: Direction::ZERO, multiplicity: 1 }
    }

    /// True if it grows.
    pub fn is_growing(&self) -> bool {
        self.growth_rate > 0.0
    }

    /// ζ = −σ/√(σ² + ϖ²), the part of critical damping: 1 for one that dies away without swinging.
    pub fn damping_ratio(&self) -> f64 {
        let size = libm::hypot(self.growth_rate, self.frequency);
        if size == 0.0 { 0.0 } else { -self.growth_rate / size }
    }
}
