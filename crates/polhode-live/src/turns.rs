//! Turns of computations: light ones never wait for heavy ones.

use std::sync::{Arc, Mutex, PoisonError};

use hyper::StatusCode;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};

use crate::answer::Refusal;
use crate::limits;

/// Running and waiting computations, by their cost.
#[derive(Debug)]
pub(crate) struct Turns {
    light: Arc<Semaphore>,
    heavy: Arc<Semaphore>,
    /// Permits of heavy computations that run or wait.
    queue: Arc<Semaphore>,
}

/// Permission to compute, until it ends or the last clone is dropped.
#[derive(Clone, Debug)]
pub(crate) struct Turn(Arc<Mutex<Vec<OwnedSemaphorePermit>>>);

impl Turn {
    fn of(permits: Vec<OwnedSemaphorePermit>) -> Self {
        Self(Arc::new(Mutex::new(permits)))
    }

    pub(crate) fn end(&self) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).clear();
    }
}

impl Turns {
    pub(crate) fn new() -> Self {
        let semaphore = |permits| Arc::new(Semaphore::new(permits));
        Self {
            light: semaphore(limits::LIGHT),
            heavy: semaphore(limits::HEAVY),
            queue: semaphore(limits::HEAVY + limits::WAITING),
        }
    }

    /// Waits for the next turn of a short computation.
    pub(crate) async fn light(&self) -> Result<Turn, Refusal> {
        let running = self.light.clone().acquire_owned().await.map_err(|_| closed())?;
        Ok(Turn::of(vec![running]))
    }

    /// Waits for the next turn of a long computation.
    ///
    /// # Errors
    /// If too many wait already.
    pub(crate) async fn heavy(&self) -> Result<Turn, Refusal> {
        let waiting = self.queue.clone().try_acquire_owned().map_err(|_| {
            let rule = format!("{} computations are already waiting", limits::WAITING);
            Refusal::new(StatusCode::SERVICE_UNAVAILABLE, rule)
                .hint("try again when some of them have finished")
        })?;
        let running = self.heavy.clone().acquire_owned().await.map_err(|_| closed())?;
        Ok(Turn::of(vec![running, waiting]))
    }

    /// Counts a light turn that takes too long among the waiting heavy ones, so that it does not
    /// block a light one. Without a free place, nothing changes.
    pub(crate) fn make_heavy(&self, turn: &Turn) {
        let mut permits = turn.0.lock().unwrap_or_else(PoisonError::into_inner);
        // A turn without permits has ended.
        if let (false, Ok(waiting)) = (permits.is_empty(), self.queue.clone().try_acquire_owned()) {
            *permits = vec![waiting];
        }
    }
}

fn closed() -> Refusal {
    Refusal::new(StatusCode::SERVICE_UNAVAILABLE, "the server is shutting down")
}
