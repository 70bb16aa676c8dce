//! Conditions for the continuation of a computation.

use crate::refusal::{Refusal, RefusalKind};

/// Conditions for the continuation of a computation, from a caller that has a clock or can cancel.
///
/// Each closure that returns a `bool` is a watch: when it returns false, the computation is
/// cancelled. A watch with a time limit implements [`Watch::is_wanted`] as well.
///
/// ```
/// use std::sync::atomic::{AtomicBool, Ordering};
/// use polhode_web::Watch;
/// let is_cancelled = AtomicBool::new(false);
/// let watch: &dyn Watch = &|| !is_cancelled.load(Ordering::Relaxed);
/// assert!(watch.goes_on() && watch.is_wanted());
/// is_cancelled.store(true, Ordering::Relaxed);
/// assert!(!watch.goes_on() && !watch.is_wanted());
/// ```
pub trait Watch: Sync {
    /// Returns false when the computation must end. Called often, from any thread.
    ///
    /// A motion is then reported as stopped, and unfinished checks of a mesh as undecided.
    fn goes_on(&self) -> bool;

    /// Returns false when nobody waits for the answer: it is refused, and nothing is kept.
    fn is_wanted(&self) -> bool {
        self.goes_on()
    }

    /// Restarts the time limit. Called before each motion of a lesson.
    fn restart(&self) {}
}

impl<F: Fn() -> bool + Sync> Watch for F {
    fn goes_on(&self) -> bool {
        self()
    }
}

/// Refuses an answer that nobody waits for.
pub(crate) fn require_wanted(watch: &dyn Watch) -> Result<(), Refusal> {
    match watch.is_wanted() {
        true => Ok(()),
        false => Err(Refusal::new(RefusalKind::Ended, "the request was cancelled")),
    }
}
