//! Elementary functions and constants: `libm`, so that no result depends on the platform's own.

pub(crate) use core::f64::consts::PI;

/// sin x and cos x, x in rad.
pub(crate) fn sin_cos(x: f64) -> (f64, f64) {
    libm::sincos(x)
}
