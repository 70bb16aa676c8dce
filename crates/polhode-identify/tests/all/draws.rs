//! Numbers of random draws: all of them in `cargo xtask test --nightly`, a quarter in the gate.

/// Number of draws of a test that has `at_night` of them at night.
pub(crate) fn draws(at_night: u64) -> u64 {
    if is_night() { at_night } else { at_night / 4 }
}

/// Tolerance of a mean over the draws. A mean of a quarter of them has twice the standard error.
pub(crate) fn tolerance(at_night: f64) -> f64 {
    if is_night() { at_night } else { 2.0 * at_night }
}

/// True if a number is one within the tolerance of a mean over the draws.
pub(crate) fn is_about_one(number: f64, at_night: f64) -> bool {
    (number - 1.0).abs() < tolerance(at_night)
}

fn is_night() -> bool {
    std::env::var_os("POLHODE_NIGHTLY").is_some()
}
