//! Tools for coding agents: commands of polhode by the Model Context Protocol.
//!
//! [`serve`] reads one JSON-RPC message per line and answers on another stream. The tools are
//! `inertia`, `check`, `simulate`, `judge` and `explain`. Their schemas are those of the requests and
//! reports of the commands.
//!
//! The protocol is written here on `serde_json`. The crate rmcp 3.11.0, reduced to a server on standard
//! streams, would add 41 crates with tokio, 1.8 MB and 103 s of CPU time to a release build.
//!
//! ```
//! use polhode_source::files::Memory;
//! let ask = br#"{"jsonrpc": "2.0", "id": 1, "method": "ping"}"#;
//! polhode_mcp::serve(&ask[..], std::io::sink(), Memory::default())?;
//! # Ok::<(), std::io::Error>(())
//! ```
#![forbid(unsafe_code)]

mod arguments;
mod command;
mod message;
mod outcome;
mod server;
mod session;
mod tool;

pub use server::serve;
