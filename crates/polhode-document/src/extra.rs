//! Additional blocks of a report, beyond the mass properties.

use serde_json::Value;

/// Block of a report for some bodies only: rotational constants of a molecule, the proof of a sign.
#[derive(Clone, Debug, PartialEq)]
pub struct Extra {
    /// Key in the JSON.
    pub key: &'static str,
    /// Value in the JSON.
    pub json: Value,
    /// Lines of text, each with a line end.
    pub text: String,
}
