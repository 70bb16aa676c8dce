//! Requests of the package as JSON.

use polhode_source::{Failure, json_value};
use serde::Deserialize;

use crate::free_motion;

/// Request of the package. An object has one key, the name of the function.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub(crate) enum Message {
    Check(polhode_robot::Request),
    FreeMotion(free_motion::Request),
    /// Mass properties; the keys of a link choice are among those of the request.
    #[cfg(feature = "full")]
    Inertia(serde_json::Map<String, serde_json::Value>),
    #[cfg(feature = "full")]
    Simulate(polhode_scenario::request::simulate::Request),
    #[cfg(feature = "full")]
    Explain {
        request: polhode_scenario::request::explain::Request,
        #[serde(default)]
        format: crate::scenario::Format,
    },
}

impl Message {
    /// Reads a request. A key that is unknown, or that an object has twice, is refused.
    ///
    /// # Errors
    /// [`Failure`] for JSON that is not a request.
    pub(crate) fn read(json: &[u8]) -> Result<Self, Failure> {
        json_value(json).and_then(serde_json::from_value).map_err(|error| invalid(&error))
    }
}

/// Returns the failure of an invalid request.
pub(crate) fn invalid(error: &serde_json::Error) -> Failure {
    Failure::usage(format!("the request is invalid: {error}"), "its type in TypeScript lists the keys")
}
