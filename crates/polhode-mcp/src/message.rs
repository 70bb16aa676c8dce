//! Messages of JSON-RPC 2.0.

use polhode_source::json_value;
use serde::Deserialize;
use serde_json::{Map, Value, json};

/// Message of a client.
#[derive(Debug)]
pub(crate) enum Message {
    /// Request, which is answered. The answer repeats its id.
    Request { id: Value, method: String, params: Map<String, Value> },
    /// Notification, which is not answered.
    Notification { method: String, params: Map<String, Value> },
    /// Answer of the client. The server has asked nothing, so it is ignored.
    Answer,
}

#[derive(Deserialize)]
struct Fields {
    #[serde(rename = "jsonrpc")]
    _version: Version,
    method: Option<String>,
    #[serde(default)]
    params: Map<String, Value>,
    result: Option<Value>,
    error: Option<Value>,
}

#[derive(Deserialize)]
enum Version {
    #[serde(rename = "2.0")]
    Two,
}

/// Error of the protocol, in contrast to an error of a tool's input.
#[derive(Debug)]
pub(crate) struct ProtocolError {
    pub(crate) code: i32,
    pub(crate) message: String,
    pub(crate) data: Value,
}

impl ProtocolError {
    pub(crate) const PARSE: i32 = -32700;
    pub(crate) const INVALID_REQUEST: i32 = -32600;
    pub(crate) const UNKNOWN_METHOD: i32 = -32601;
    pub(crate) const INVALID_PARAMS: i32 = -32602;
    pub(crate) const INTERNAL: i32 = -32603;
    /// The protocol version of a request is not supported.
    pub(crate) const VERSION: i32 = -32022;

    pub(crate) fn new(code: i32, message: impl Into<String>) -> Self {
        Self { code, message: message.into(), data: json!({}) }
    }

    pub(crate) fn params(message: impl Into<String>) -> Self {
        Self::new(Self::INVALID_PARAMS, message)
    }

    /// Returns the answer to a request; `id` is null if it is not known.
    pub(crate) fn answer(self, id: &Value) -> Value {
        let Self { code, message, data } = self;
        json!({ "jsonrpc": "2.0", "id": id, "error": { "code": code, "message": message, "data": data } })
    }
}

/// Reads a message.
///
/// # Errors
/// The answer to a message that is not valid.
pub(crate) fn read(line: &[u8]) -> Result<Message, Value> {
    let message: Value = serde_json::from_slice(line)
        .map_err(|error| ProtocolError::new(ProtocolError::PARSE, error.to_string()).answer(&Value::Null))?;
    let id = message.get("id");
    let known = id.filter(|id| id.is_string() || id.is_i64() || id.is_u64());
    let refused = |rule: String| {
        Err(ProtocolError::new(ProtocolError::INVALID_REQUEST, rule).answer(known.unwrap_or(&Value::Null)))
    };
    // A key that is given twice is ambiguous.
    let fields: Fields = match json_value(line).and_then(serde_json::from_value) {
        Ok(fields) => fields,
        Err(error) => return refused(error.to_string()),
    };
    match (fields, id, known) {
        (Fields { method: Some(method), params, .. }, None, _) => {
            Ok(Message::Notification { method, params })
        }
        (Fields { method: Some(method), params, .. }, _, Some(id)) => {
            Ok(Message::Request { id: id.clone(), method, params })
        }
        (Fields { method: Some(_), .. }, ..) => refused("id must be a text or an integer".to_owned()),
        (Fields { result: None, error: None, .. }, ..) => refused("method is missing".to_owned()),
        _ => Ok(Message::Answer),
    }
}
