//! Numbers of random draws: all with `cargo xtask test --nightly`, a quarter in the gate.

/// Returns the number of draws of a test that has `at_night` draws in the nightly run.
pub(crate) fn draws(at_night: u64) -> u64 {
    if is_night() { at_night } else { at_night / 4 }
}

/// Returns the tolerance of a mean over the draws. A quarter of the draws doubles the standard
/// error.
pub(crate) fn tolerance(at_night: f64) -> f64 {
    if is_night() { at_night } else { 2.0 * at_night }
}

/// Returns true if a number is one within the tolerance of a mean over the draws.
pub(crate) fn is_about_one(number: f64, at_night: f64) -> bool {
    (number - 1.0).abs() < tolerance(at_night)
}

fn is_night() -> bool {
    std::env::var_os("POLHODE_NIGHTLY").is_some()
}
