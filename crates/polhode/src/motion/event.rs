//! Events: something that is measured passes a value.

/// Something to look out for on the way.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// What it is called.
    pub name: String,
    /// What to do when it happens.
    pub action: EventAction,
}

/// What to do when an event happens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum EventAction {
    /// Write it down.
    Record,
    /// Write it down and stop there.
    Stop,
    /// Write it down and switch a torque on or off.
    Switch {
        /// Which of the torques, from 0.
        torque: usize,
        /// On or off.
        on: bool,
    },
}
