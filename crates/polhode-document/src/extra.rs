//! What a report says beyond the mass properties that every body has.

use serde_json::Value;

/// A block of a report that only some bodies have: a molecule's rotational constants, the proof of a sign.
#[derive(Clone, Debug, PartialEq)]
pub struct Extra {
    /// Its key in JSON.
    pub key: &'static str,
    /// Its value in JSON.
    pub json: Value,
    /// Its lines for people, each ended.
    pub text: String,
}
