//! Elementary functions and constants: `libm`, so that every platform computes the same bits.

pub(crate) use core::f64::consts::PI;

/// sin x and cos x, x in rad.
pub(crate) fn sin_cos(x: f64) -> (f64, f64) {
    libm::sincos(x)
}

/// sin(x)/x, exact to rounding through x = 0.
pub(crate) fn sinc(x: f64) -> f64 {
    if x.abs() < 1e-4 {
        let x2 = x * x;
        1.0 - x2 / 6.0 * (1.0 - x2 / 20.0)
    } else {
        libm::sin(x) / x
    }
}
