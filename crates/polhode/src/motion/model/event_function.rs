//! User-supplied functions that events measure.

use core::fmt;
use std::sync::Arc;

use super::rotor::Rotor;
use super::state::State;

type Function = dyn Fn(&Rotor, &State) -> f64 + Send + Sync;

/// Function of the state that an [`Event`](crate::motion::Event) measures. Two are equal only if
/// they are the same object.
///
/// The function should be continuous along a motion: a jump across the value counts as a crossing.
/// A NaN does not count as a crossing.
#[derive(Clone)]
pub struct EventFunction {
    function: Arc<Function>,
    needs_inertia: bool,
}

impl EventFunction {
    /// Creates a function of time, attitude and ω.
    pub fn new(function: impl Fn(&State) -> f64 + Send + Sync + 'static) -> Self {
        Self { function: Arc::new(move |_, state| function(state)), needs_inertia: false }
    }

    /// Creates a function of the state and of the body, whose mass properties must not change with
    /// time.
    pub fn of_body(function: impl Fn(&Rotor, &State) -> f64 + Send + Sync + 'static) -> Self {
        Self { function: Arc::new(function), needs_inertia: true }
    }

    pub(crate) fn value(&self, rotor: &Rotor, state: &State) -> f64 {
        (self.function)(rotor, state)
    }

    /// True if the function depends on the mass properties of the body.
    pub(crate) const fn needs_inertia(&self) -> bool {
        self.needs_inertia
    }
}

impl PartialEq for EventFunction {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.function, &other.function)
    }
}

impl fmt::Debug for EventFunction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("EventFunction")
    }
}
