//! Integration tests of `polhode-mcp`, built as one program so that the library is linked only once.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test may")]

mod protocol;
#[path = "../../../polhode-robot/tests/all/common/schema.rs"]
mod schema;
mod tools;

use std::io::Write;
use std::sync::{Arc, Mutex};

use polhode_source::files::Memory;
use serde_json::{Value, json};

/// Output of a server in memory.
#[derive(Clone, Debug, Default)]
struct Output(Arc<Mutex<Vec<u8>>>);

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.0.lock().unwrap().write(bytes)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

/// Returns the messages with which a server answers lines.
fn answers(lines: &[&[u8]], files: Memory) -> Vec<Value> {
    let output = Output::default();
    polhode_mcp::serve(&lines.join(&b'\n')[..], output.clone(), files).unwrap();
    let written = String::from_utf8(output.0.lock().unwrap().clone()).unwrap();
    written.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

/// Returns a request of version 2026-07-28.
fn stated(method: &str, mut params: Value) -> Vec<u8> {
    params["_meta"] = json!({
        "io.modelcontextprotocol/protocolVersion": "2026-07-28",
        "io.modelcontextprotocol/clientCapabilities": {},
    });
    json!({ "jsonrpc": "2.0", "id": "a-1", "method": method, "params": params }).to_string().into_bytes()
}

/// Returns the only answer to a request of version 2026-07-28.
fn ask(method: &str, params: Value, files: Memory) -> Value {
    let [answer] = answers(&[&stated(method, params)], files).try_into().unwrap();
    answer
}
