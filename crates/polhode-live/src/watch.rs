//! Time limits of computations that end early if nobody waits.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

use hyper::StatusCode;
use polhode_web::Watch;

use crate::answer::Refusal;

/// Time limit of a computation that ends early if nobody waits.
#[derive(Debug)]
pub(crate) struct Within<'a> {
    origin: Instant,
    /// Time from `origin` to the last restart, ns.
    begun: AtomicU64,
    most: Duration,
    /// Set when nobody waits.
    stop: &'a AtomicBool,
}

impl<'a> Within<'a> {
    pub(crate) fn new(most: Duration, stop: &'a AtomicBool) -> Self {
        Self { origin: Instant::now(), begun: AtomicU64::new(0), most, stop }
    }
}

impl Watch for Within<'_> {
    fn goes_on(&self) -> bool {
        let begun = Duration::from_nanos(self.begun.load(Ordering::Relaxed));
        self.is_wanted() && self.origin.elapsed().saturating_sub(begun) < self.most
    }

    fn is_wanted(&self) -> bool {
        !self.stop.load(Ordering::Relaxed)
    }

    fn restart(&self) {
        let now = u64::try_from(self.origin.elapsed().as_nanos()).unwrap_or(u64::MAX);
        self.begun.store(now, Ordering::Relaxed);
    }
}

/// Refuses an answer that nobody waits for.
pub(crate) fn is_wanted(stop: &AtomicBool) -> Result<(), Refusal> {
    match stop.load(Ordering::Relaxed) {
        true => Err(Refusal::new(StatusCode::REQUEST_TIMEOUT, "the connection was closed")),
        false => Ok(()),
    }
}
