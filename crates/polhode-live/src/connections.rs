//! Open connections, and the choice of the connection to close for a new one.

use std::collections::BTreeMap;
use std::io;
use std::net::{Shutdown, TcpStream};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};

use crate::limits;

/// Open connections, at most [`limits::CONNECTIONS`].
#[derive(Debug, Default)]
pub(crate) struct Connections {
    state: Mutex<State>,
    room: Condvar,
}

#[derive(Debug, Default)]
struct State {
    /// Open connections by their number, in chronological order.
    open: BTreeMap<u64, Open>,
    next: u64,
}

#[derive(Debug)]
struct Open {
    stream: TcpStream,
    /// True while an admitted request is answered.
    is_busy: bool,
}

/// Slot of one connection among those that may be open.
#[derive(Debug)]
pub(crate) struct Place {
    connections: Arc<Connections>,
    number: u64,
}

impl Connections {
    /// Returns a place for one more connection. If there is none, it closes the oldest connection
    /// that is idle; if all are busy, it waits.
    ///
    /// A connection is idle unless an admitted request is answered. Without the token no request
    /// is admitted.
    pub(crate) fn place(self: &Arc<Self>, stream: &TcpStream) -> io::Result<Place> {
        let stream = stream.try_clone()?;
        let mut state = self.state();
        while state.open.len() >= limits::CONNECTIONS {
            let oldest = state.open.iter().find(|(_, open)| !open.is_busy).map(|(number, _)| *number);
            match oldest.and_then(|number| state.open.remove(&number)) {
                Some(idle) => drop(idle.stream.shutdown(Shutdown::Both)),
                None => state = self.room.wait(state).unwrap_or_else(PoisonError::into_inner),
            }
        }
        let number = state.next;
        state.next += 1;
        state.open.insert(number, Open { stream, is_busy: false });
        drop(state);
        Ok(Place { connections: self.clone(), number })
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Place {
    /// Keeps the connection open until its answer is written.
    pub(crate) fn set_busy(&self, is_busy: bool) {
        if let Some(open) = self.connections.state().open.get_mut(&self.number) {
            open.is_busy = is_busy;
        }
        self.connections.room.notify_one();
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        self.connections.state().open.remove(&self.number);
        self.connections.room.notify_one();
    }
}
