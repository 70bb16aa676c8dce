//! Turns of computations: light ones never wait for heavy ones.

use std::sync::Arc;

use hyper::StatusCode;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};

use crate::answer::Refusal;
use crate::limits;

/// Computations that run and wait, by what they may cost.
#[derive(Debug)]
pub(crate) struct Turns {
    light: Arc<Semaphore>,
    heavy: Arc<Semaphore>,
    /// Heavy computations that run or wait.
    queue: Arc<Semaphore>,
}

/// A turn to compute, until it is dropped.
#[derive(Debug)]
pub(crate) struct Turn {
    _running: OwnedSemaphorePermit,
    _waiting: Option<OwnedSemaphorePermit>,
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

    /// The next turn for what is done soon.
    pub(crate) async fn light(&self) -> Result<Turn, Refusal> {
        let running = self.light.clone().acquire_owned().await.map_err(|_| closed())?;
        Ok(Turn { _running: running, _waiting: None })
    }

    /// The next turn for what may take long.
    ///
    /// # Errors
    /// If too many wait already.
    pub(crate) async fn heavy(&self) -> Result<Turn, Refusal> {
        let waiting = self.queue.clone().try_acquire_owned().map_err(|_| {
            let rule = format!("{} computations wait already", limits::WAITING);
            Refusal::new(StatusCode::SERVICE_UNAVAILABLE, rule).hint("try again when some of them are done")
        })?;
        let running = self.heavy.clone().acquire_owned().await.map_err(|_| closed())?;
        Ok(Turn { _running: running, _waiting: Some(waiting) })
    }
}

fn closed() -> Refusal {
    Refusal::new(StatusCode::SERVICE_UNAVAILABLE, "the server ends")
}
