//! What all requests of a page share.

use std::sync::Arc;

use tokio::sync::Semaphore;

use crate::documents::Documents;
use crate::dropped::Dropped;
use crate::guard::Guard;
use crate::lesson::Lessons;

/// What all requests of a page share.
#[derive(Debug)]
pub(crate) struct Session {
    pub(crate) guard: Guard,
    pub(crate) documents: Documents,
    pub(crate) lessons: Lessons,
    pub(crate) dropped: Dropped,
    /// As many computations as may run at the same time.
    pub(crate) computations: Arc<Semaphore>,
}
