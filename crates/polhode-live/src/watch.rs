//! Conditions for the continuation of a computation.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use hyper::StatusCode;

use crate::answer::Refusal;

/// Returns a function that is true until `stop` is set, or until the time `most` has elapsed.
pub(crate) fn within(most: Duration, stop: &AtomicBool) -> impl Fn() -> bool + Sync {
    let begun = Instant::now();
    move || !stop.load(Ordering::Relaxed) && begun.elapsed() < most
}

/// Refuses an answer that nobody waits for.
pub(crate) fn is_wanted(stop: &AtomicBool) -> Result<(), Refusal> {
    match stop.load(Ordering::Relaxed) {
        true => Err(Refusal::new(StatusCode::REQUEST_TIMEOUT, "the connection was closed")),
        false => Ok(()),
    }
}
