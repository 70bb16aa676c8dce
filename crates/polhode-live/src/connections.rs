//! Open connections, and the choice of the connection to close for a new one.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use tokio::sync::Notify;
use tokio::task::AbortHandle;

use crate::limits;

/// Open connections, at most [`limits::CONNECTIONS`].
#[derive(Debug, Default)]
pub(crate) struct Connections {
    state: Mutex<State>,
    room: Notify,
}

#[derive(Debug, Default)]
struct State {
    open: BTreeMap<u64, Open>,
    /// Number of the next connection or change from busy to idle. Numbers are in chronological
    /// order.
    next: u64,
}

#[derive(Debug)]
struct Open {
    /// Number of the event at which it was opened or last became idle.
    since: u64,
    is_busy: bool,
    task: Option<AbortHandle>,
}

/// Slot of one connection among those that may be open.
#[derive(Clone, Debug)]
pub(crate) struct Place(Arc<Held>);

#[derive(Debug)]
struct Held {
    connections: Arc<Connections>,
    number: u64,
}

/// Marks an admitted request in progress: its connection is not closed for another.
#[derive(Debug)]
pub(crate) struct Busy(Place);

impl Connections {
    /// Returns a place for one more connection. If there is none, it closes the connection that has
    /// been idle the longest; if all are busy, it waits.
    ///
    /// A connection is idle unless an admitted request is in progress. Without the token no request
    /// is admitted.
    pub(crate) async fn place(self: &Arc<Self>) -> Place {
        loop {
            if let Some(place) = self.free() {
                return place;
            }
            self.room.notified().await;
        }
    }

    fn free(self: &Arc<Self>) -> Option<Place> {
        let mut state = self.state();
        if state.open.len() >= limits::CONNECTIONS {
            let idle = state.open.iter().filter(|(_, open)| !open.is_busy);
            let (&oldest, _) = idle.min_by_key(|(_, open)| open.since)?;
            let task = state.open.remove(&oldest).and_then(|open| open.task);
            task.into_iter().for_each(|task| task.abort());
        }
        let number = state.next;
        state.next += 1;
        state.open.insert(number, Open { since: number, is_busy: false, task: None });
        Some(Place(Arc::new(Held { connections: self.clone(), number })))
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Place {
    /// Registers the task that serves the connection.
    pub(crate) fn served_by(&self, task: AbortHandle) {
        if let Some(open) = self.0.connections.state().open.get_mut(&self.0.number) {
            open.task = Some(task);
        }
    }

    /// Keeps the connection open until the returned guard is dropped.
    pub(crate) fn busy(&self) -> Busy {
        if let Some(open) = self.0.connections.state().open.get_mut(&self.0.number) {
            open.is_busy = true;
        }
        Busy(self.clone())
    }
}

impl Drop for Busy {
    fn drop(&mut self) {
        let Held { connections, number } = &*self.0.0;
        let mut state = connections.state();
        let since = state.next;
        state.next += 1;
        if let Some(open) = state.open.get_mut(number) {
            (open.is_busy, open.since) = (false, since);
        }
        connections.room.notify_one();
    }
}

impl Drop for Held {
    fn drop(&mut self) {
        self.connections.state().open.remove(&self.number);
        self.connections.room.notify_one();
    }
}
