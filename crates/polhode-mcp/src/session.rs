//! Versions of the protocol, and the answers to all requests but calls of tools.
//!
//! Clients of 2026-07-28 state the version in each request. Older ones begin with a handshake.
//! Specification: <https://modelcontextprotocol.io/specification/2026-07-28/basic/versioning>

use polhode_document::VERSION;
use serde_json::{Map, Value, json};

use crate::message::{Message, ProtocolError, Request, read};
use crate::tool::{TOOLS, Tool};

/// Version that each request states.
const STATED: &str = "2026-07-28";
/// Versions that the handshake agrees on, from old to new. 2025-03-26 requires batches of messages.
const AGREED: [&str; 3] = ["2024-11-05", "2025-06-18", "2025-11-25"];

const VERSION_KEY: &str = "io.modelcontextprotocol/protocolVersion";
const CAPABILITIES_KEY: &str = "io.modelcontextprotocol/clientCapabilities";

/// Time for which a client may keep the list of tools, ms.
const FRESH: u32 = 3_600_000;

const INSTRUCTIONS: &str = "\
polhode computes mass properties and rotational motion of rigid bodies, and checks robot models and logs of simulators. \
Prefer it to a hand-written check. Numbers in reports are in SI units. A quantity in an argument is a text with its unit, \
such as \"85 g\", or a number in SI units. Paths are relative to the folder of the server; no file is written. \
Messages name options of the command: --unit mm is the argument unit with the value \"mm\". \
exit_status in a result: 0 success, 1 findings, 2 invalid input, 3 tolerance not reached.";

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
    /// Once, by a handshake.
    Agreed,
    /// In each request.
    Stated,
}

impl Session {
    /// Returns the action that a line requires.
    pub(crate) fn step(&mut self, line: &[u8]) -> Step {
        let request = match read(line) {
            Ok(Message::Request(request)) => request,
            Ok(Message::Notification { method, mut params }) => match params.remove("requestId") {
                Some(id) if method == "notifications/cancelled" => return Step::Cancel(id),
                _ => return Step::Nothing,
            },
            Ok(Message::Answer) => return Step::Nothing,
            Err(answer) => return Step::Send(answer),
        };
        let id = request.id.clone();
        self.of_request(request).unwrap_or_else(|error| Step::Send(error.answer(&id)))
    }

    fn of_request(&mut self, mut request: Request) -> Result<Step, ProtocolError> {
        let era = self.era(&request)?;
        let (id, params) = (&request.id, &request.params);
        let send = |result: Value| Ok(Step::Send(era.answer(id, result)));
        match (request.method.as_str(), era) {
            ("initialize", Era::Agreed) => {
                let version = agreed(params.get("protocolVersion"))?;
                self.has_begun = true;
                send(json!({
                    "protocolVersion": version,
                    "capabilities": { "tools": {} },
                    "serverInfo": server_info(),
                    "instructions": INSTRUCTIONS,
                }))
            }
            ("ping", Era::Agreed) => send(json!({})),
            ("server/discover", Era::Stated) => send(cacheable(json!({
                "supportedVersions": [STATED],
                "capabilities": { "tools": {} },
                "instructions": INSTRUCTIONS,
            }))),
            ("tools/list", _) => match params.get("cursor") {
                None | Some(Value::Null) => {
                    let tools: Vec<Value> = TOOLS.iter().map(|tool| tool.definition.to_json()).collect();
                    let list = json!({ "tools": tools });
                    send(if era == Era::Stated { cacheable(list) } else { list })
                }
                Some(_) => Err(invalid("unknown cursor: the list of tools is one page")),
            },
            ("tools/call", _) => {
                let (tool, arguments) = called(&mut request.params)?;
                Ok(Step::Start(Call { id: request.id, era, tool, arguments }))
            }
            (unknown, _) => {
                let message = format!("unknown method {unknown:?}");
                Err(ProtocolError::new(ProtocolError::UNKNOWN_METHOD, message))
            }
        }
    }

    /// Returns the way in which a request states its version.
    fn era(&self, request: &Request) -> Result<Era, ProtocolError> {
        let meta = request.params.get("_meta");
        let of = |key: &str| meta.and_then(|meta| meta.get(key));
        match of(VERSION_KEY) {
            None if self.has_begun || matches!(request.method.as_str(), "initialize" | "ping") => {
                Ok(Era::Agreed)
            }
            None => Err(invalid(format!("_meta has no {VERSION_KEY}, and there was no initialize"))),
            Some(Value::String(version)) if version == STATED => match of(CAPABILITIES_KEY) {
                Some(Value::Object(_)) => Ok(Era::Stated),
                _ => Err(invalid(format!("_meta has no {CAPABILITIES_KEY}"))),
            },
            Some(Value::String(version)) => {
                let error = ProtocolError::new(ProtocolError::VERSION, "Unsupported protocol version");
                Err(error.with(json!({ "supported": [STATED], "requested": version })))
            }
            Some(_) => Err(invalid(format!("{VERSION_KEY} must be a text"))),
        }
    }
}

impl Era {
    /// Returns the answer to a request.
    pub(crate) fn answer(self, id: &Value, mut result: Value) -> Value {
        if self == Self::Stated {
            result["resultType"] = "complete".into();
            result["_meta"] = json!({ "io.modelcontextprotocol/serverInfo": server_info() });
        }
        json!({ "jsonrpc": "2.0", "id": id, "result": result })
    }
}

fn server_info() -> Value {
    json!({ "name": "polhode", "title": "polhode: rigid-body dynamics", "version": VERSION })
}

/// Adds the hints for caches.
fn cacheable(mut result: Value) -> Value {
    result["ttlMs"] = FRESH.into();
    result["cacheScope"] = "public".into();
    result
}

/// Returns the version for a handshake: the newest one that is not newer than the requested one,
/// otherwise the newest.
fn agreed(requested: Option<&Value>) -> Result<&'static str, ProtocolError> {
    let [.., newest] = AGREED;
    match requested {
        Some(Value::String(requested)) => {
            Ok(AGREED.into_iter().rfind(|version| *version <= requested.as_str()).unwrap_or(newest))
        }
        _ => Err(invalid("protocolVersion must be a text")),
    }
}

/// Returns the tool of a call, and its arguments.
fn called(params: &mut Map<String, Value>) -> Result<(&'static Tool, Map<String, Value>), ProtocolError> {
    let Some(Value::String(name)) = params.get("name") else {
        return Err(invalid("name must be the name of a tool"));
    };
    let tool = TOOLS.iter().find(|tool| tool.definition.name == name).ok_or_else(|| {
        let names: Vec<&str> = TOOLS.iter().map(|tool| tool.definition.name).collect();
        invalid(format!("unknown tool {name:?}; the tools are {}", names.join(", ")))
    })?;
    match params.remove("arguments") {
        None | Some(Value::Null) => Ok((tool, Map::new())),
        Some(Value::Object(arguments)) => Ok((tool, arguments)),
        Some(_) => Err(invalid("arguments must be an object")),
    }
}

fn invalid(rule: impl Into<String>) -> ProtocolError {
    ProtocolError::new(ProtocolError::INVALID_PARAMS, rule)
}
