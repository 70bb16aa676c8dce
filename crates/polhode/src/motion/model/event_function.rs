//! What an event measures by a function of the user's.

use core::fmt;
use std::sync::Arc;

use super::rotor::Rotor;
use super::state::State;

type Function = dyn Fn(&Rotor, &State) -> f64 + Send + Sync;

/// A function of the state that an [`Event`](crate::motion::Event) measures; two are equal only if they are the same function.
///
/// It should be continuous along a motion: a jump over the value counts as passing it. Where it is NaN it passes nothing.
#[derive(Clone)]
pub struct EventFunction {
    function: Arc<Function>,
    needs_inertia: bool,
}

impl EventFunction {
    /// Of time, attitude and ω.
    pub fn new(function: impl Fn(&State) -> f64 + Send + Sync + 'static) -> Self {
        Self { function: Arc::new(move |_, state| function(state)), needs_inertia: false }
    }

    /// Of the body too, which is to be one whose mass properties do not change.
    pub fn of_body(function: impl Fn(&Rotor, &State) -> f64 + Send + Sync + 'static) -> Self {
        Self { function: Arc::new(function), needs_inertia: true }
    }

    pub(crate) fn value(&self, rotor: &Rotor, state: &State) -> f64 {
        (self.function)(rotor, state)
    }

    /// True if it depends on the mass of the body.
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
