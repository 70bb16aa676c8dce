//! Answers to requests.

use polhode_source::files::Memory;
use serde_json::json;

use crate::message::Message;
use crate::outcome::Outcome;
use crate::{check, free_motion};

/// Answer to a request.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// `{"value": …}`, `{"failures": […]}`, or `{"needs": "full"}`.
    pub json: Vec<u8>,
    /// Numbers of the arrays that `value` describes.
    pub numbers: Vec<f64>,
}

/// Answers a request in JSON: an object with the name of a function and its request.
///
/// ```
/// use polhode_source::files::Memory;
/// let request = br#"{"free_motion": {"moments": [1, 2, 2.5], "omega": [0.1, 3, 0.2], "times": [0, 1.5]}}"#;
/// let answer = polhode_npm::answer(request, &Memory::default());
/// assert_eq!(answer.numbers.len(), 2 * (1 + 3 + 4));
/// assert_eq!(&answer.numbers[2..5], [0.1, 3.0, 0.2]);
/// ```
pub fn answer(request: &[u8], files: &Memory) -> Answer {
    let outcome = Message::read(request).map(|message| match message {
        Message::Check(request) => check::outcome(&request, files),
        Message::FreeMotion(request) => free_motion::outcome(&request),
        #[cfg(feature = "full")]
        Message::Inertia(request) => crate::inertia::outcome(request, files),
        #[cfg(feature = "full")]
        Message::Simulate(request) => crate::scenario::simulate(&request, files),
        #[cfg(feature = "full")]
        Message::Explain { request, format } => crate::scenario::explain(&request, format, files),
    });
    let (json, numbers) = match Outcome::from(outcome) {
        Outcome::Done { value, numbers } => (json!({ "value": value }), numbers),
        Outcome::Failed(failures) => (json!({ "failures": failures }), Vec::new()),
        Outcome::NeedsFull => (json!({ "needs": "full" }), Vec::new()),
    };
    Answer { json: json.to_string().into_bytes(), numbers }
}
