//! Messages of JSON-RPC 2.0.

use polhode_source::json_value;
use serde_json::{Map, Value, json};

/// Message of a client.
#[derive(Debug)]
pub(crate) enum Message {
    /// Request, which is answered.
    Request(Request),
    /// Notification, which is not answered.
    Notification { method: String, params: Map<String, Value> },
    /// Answer of the client. The server has asked nothing, so it is ignored.
    Answer,
}

/// Request of a client.
#[derive(Debug)]
pub(crate) struct Request {
    /// Text or number that the answer repeats.
    pub(crate) id: Value,
    pub(crate) method: String,
    pub(crate) params: Map<String, Value>,
}

/// Error of the protocol, in contrast to an error of a tool's input.
#[derive(Debug)]
pub(crate) struct ProtocolError {
    code: i32,
    message: String,
    data: Option<Value>,
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
        Self { code, message: message.into(), data: None }
    }

    pub(crate) fn with(self, data: Value) -> Self {
        Self { data: Some(data), ..self }
    }

    /// Returns the answer to a request; `id` is null if it is not known.
    pub(crate) fn answer(self, id: &Value) -> Value {
        let mut error = json!({ "code": self.code, "message": self.message });
        if let Some(data) = self.data {
            error["data"] = data;
        }
        json!({ "jsonrpc": "2.0", "id": id, "error": error })
    }
}

/// Reads a message.
///
/// # Errors
/// The answer to a message that is not valid.
pub(crate) fn read(line: &[u8]) -> Result<Message, Value> {
    let value = json_value(line).map_err(|error| match serde_json::from_slice::<Value>(line) {
        // A key that is given twice is ambiguous, but the request is known.
        Ok(value) => invalid(error.to_string()).answer(value.get("id").unwrap_or(&Value::Null)),
        Err(_) => ProtocolError::new(ProtocolError::PARSE, error.to_string()).answer(&Value::Null),
    })?;
    let Value::Object(mut message) = value else {
        let rule = "a message is an object; batches are not supported: write one message per line";
        return Err(invalid(rule).answer(&Value::Null));
    };
    let id = message.remove("id");
    let known = id.clone().filter(|id| id.is_string() || id.is_i64() || id.is_u64());
    let refused = |error: ProtocolError| Err(error.answer(known.as_ref().unwrap_or(&Value::Null)));
    if message.get("jsonrpc") != Some(&json!("2.0")) {
        return refused(invalid("jsonrpc must be \"2.0\""));
    }
    let method = match message.remove("method") {
        Some(Value::String(method)) => method,
        None if message.contains_key("result") || message.contains_key("error") => {
            return Ok(Message::Answer);
        }
        _ => return refused(invalid("method must be a text")),
    };
    let params = match message.remove("params") {
        None => Map::new(),
        Some(Value::Object(params)) => params,
        Some(_) => {
            return refused(ProtocolError::new(ProtocolError::INVALID_PARAMS, "params must be an object"));
        }
    };
    match (id, known) {
        (None, _) => Ok(Message::Notification { method, params }),
        (_, Some(id)) => Ok(Message::Request(Request { id, method, params })),
        (Some(_), None) => Err(invalid("id must be a text or an integer").answer(&Value::Null)),
    }
}

fn invalid(rule: impl Into<String>) -> ProtocolError {
    ProtocolError::new(ProtocolError::INVALID_REQUEST, rule)
}
