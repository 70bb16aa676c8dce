//! Time limit of a computation.

use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use polhode_web::Watch;

/// Time limit of a computation, or of each motion of a lesson.
#[derive(Debug)]
pub(crate) struct Within {
    begun: Mutex<Instant>,
    most: Duration,
}

impl Within {
    pub(crate) fn new(most: Duration) -> Self {
        Self { begun: Mutex::new(Instant::now()), most }
    }
}

impl Watch for Within {
    fn goes_on(&self) -> bool {
        self.begun.lock().unwrap_or_else(PoisonError::into_inner).elapsed() < self.most
    }

    fn is_wanted(&self) -> bool {
        true
    }

    fn restart(&self) {
        *self.begun.lock().unwrap_or_else(PoisonError::into_inner) = Instant::now();
    }
}
