//! Versions of the protocol, and the answers to all requests but calls of tools.
//!
//! Clients of 2026-07-28 state the version in each request. Older ones begin with a handshake.
//! Specification: <https://modelcontextprotocol.io/specification/2026-07-28/basic/versioning>

use polhode_document::VERSION;
use serde_json::{Map, Value, json};

use crate::message::{Message, ProtocolError, read};
use crate::tool::{TOOLS, Tool};

/// Version that each request states.
const STATED: &str = "2026-07-28";
/// Versions that the handshake agrees on, from old to new. 2025-03-26 requires batches of messages.
const AGREED: [&str; 3] = ["2024-11-05", "2025-06-18", "2025-11-25"];

const VERSION_KEY: &str = "io.modelcontextprotocol/protocolVersion";
const CAPABILITIES_KEY: &str = "io.modelcontextprotocol/clientCapabilities";

const INSTRUCTIONS: &str = include_str!("../text/instructions.md");

/// State of a connection.
#[derive(Debug, Default)]
pub(crate) struct Session {
    /// True after a handshake.
    has_begun: bool,
}

/// Next action of the server.
#[derive(Debug)]
pub(crate) enum Step {
    Nothing,
    /// Sends a message.
    Send(Value),
    /// Calls a tool.
    Start(Call),
    /// Cancels the call with this id.
    Cancel(Value),
}

/// Call of a tool.
#[derive(Debug)]
pub(crate) struct Call {
    pub(crate) id: Value,
    pub(crate) era: Era,
    pub(crate) tool: &'static Tool,
    pub(crate) arguments: Map<String, Value>,
}

/// Way in which a client states the version of the protocol.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Era {
    /// Version agreed on by a handshake.
    Agreed,
    /// Version in each request.
    Stated,
}

impl Session {
    /// Returns the action that a line requires.
    pub(crate) fn step(&mut self, line: &[u8]) -> Step {
        match read(line) {
            Ok(Message::Request { id, method, params }) => {
                self.answer(&id, &method, params).unwrap_or_else(|error| Step::Send(error.answer(&id)))
            }
            Ok(Message::Notification { method, mut params }) if method == "notifications/cancelled" => {
                params.remove("requestId").map_or(Step::Nothing, Step::Cancel)
            }
            Ok(_) => Step::Nothing,
            Err(answer) => Step::Send(answer),
        }
    }

    fn answer(
        &mut self,
        id: &Value,
        method: &str,
        params: Map<String, Value>,
    ) -> Result<Step, ProtocolError> {
        let era = self.era(method, &params)?;
        let tools = json!({ "tools": {} });
        let result = match (method, era) {
            ("initialize", Era::Agreed) => {
                let version = agreed(&params)?;
                self.has_begun = true;
                json!({ "protocolVersion": version, "capabilities": tools, "serverInfo": server(), "instructions": INSTRUCTIONS })
            }
            ("ping", Era::Agreed) => json!({}),
            ("server/discover", Era::Stated) => {
                json!({ "supportedVersions": [STATED], "capabilities": tools, "instructions": INSTRUCTIONS })
            }
            ("tools/list", _) if params.get("cursor").is_none_or(Value::is_null) => {
                json!({ "tools": TOOLS.iter().map(Tool::definition).collect::<Vec<_>>() })
            }
            ("tools/list", _) => return Err(ProtocolError::params("unknown cursor: the list has one page")),
            ("tools/call", _) => {
                let (tool, arguments) = called(params)?;
                return Ok(Step::Start(Call { id: id.clone(), era, tool, arguments }));
            }
            _ => {
                let message = format!("unknown method {method:?}");
                return Err(ProtocolError::new(ProtocolError::UNKNOWN_METHOD, message));
            }
        };
        Ok(Step::Send(era.answer(id, result)))
    }

    /// Returns the way in which a request states its version.
    fn era(&self, method: &str, params: &Map<String, Value>) -> Result<Era, ProtocolError> {
        let of = |key: &str| params.get("_meta").and_then(|meta| meta.get(key));
        match of(VERSION_KEY) {
            None if self.has_begun || matches!(method, "initialize" | "ping") => Ok(Era::Agreed),
            None => {
                let rule = format!("_meta has no {VERSION_KEY}, and there was no initialize");
                Err(ProtocolError::params(rule))
            }
            Some(version) if version != STATED => {
                let data = json!({ "supported": [STATED], "requested": version });
                let error = ProtocolError::new(ProtocolError::VERSION, "unsupported protocol version");
                Err(ProtocolError { data, ..error })
            }
            _ if of(CAPABILITIES_KEY).is_some_and(Value::is_object) => Ok(Era::Stated),
            _ => Err(ProtocolError::params(format!("_meta has no {CAPABILITIES_KEY}"))),
        }
    }
}

impl Era {
    /// Returns the answer to a request.
    pub(crate) fn answer(self, id: &Value, mut result: Value) -> Value {
        if self == Self::Stated {
            result["resultType"] = "complete".into();
            result["_meta"] = json!({ "io.modelcontextprotocol/serverInfo": server() });
            // The tools and the versions stay the same while the server runs: hints for caches.
            if result.get("content").is_none() {
                result["ttlMs"] = 3_600_000.into();
                result["cacheScope"] = "public".into();
            }
        }
        json!({ "jsonrpc": "2.0", "id": id, "result": result })
    }
}

fn server() -> Value {
    json!({ "name": "polhode", "title": "polhode: rigid-body dynamics", "version": VERSION })
}

/// Returns the version for a handshake: the newest one that is not newer than the requested one,
/// otherwise the newest.
fn agreed(params: &Map<String, Value>) -> Result<&'static str, ProtocolError> {
    let [.., newest] = AGREED;
    match params.get("protocolVersion") {
        Some(Value::String(asked)) => {
            Ok(AGREED.into_iter().rfind(|version| *version <= asked.as_str()).unwrap_or(newest))
        }
        _ => Err(ProtocolError::params("protocolVersion must be a text")),
    }
}

/// Returns the tool of a call, and its arguments.
fn called(mut params: Map<String, Value>) -> Result<(&'static Tool, Map<String, Value>), ProtocolError> {
    let name = params.get("name").and_then(Value::as_str).unwrap_or_default();
    let tool = TOOLS.iter().find(|tool| tool.name == name).ok_or_else(|| {
        let names: Vec<&str> = TOOLS.iter().map(|tool| tool.name).collect();
        ProtocolError::params(format!("unknown tool {name:?}; the tools are {}", names.join(", ")))
    })?;
    match params.remove("arguments") {
        None | Some(Value::Null) => Ok((tool, Map::new())),
        Some(Value::Object(arguments)) => Ok((tool, arguments)),
        Some(_) => Err(ProtocolError::params("arguments must be an object")),
    }
}
