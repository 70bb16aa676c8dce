//! Answers of the engine to the messages in the lines of the standard input, one line of JSON each:
//! prints a hash (FNV-1a, 64 bits) of the numbers of each answer, the rows after its JSON.
//!
//! `viewer/test/bits.test.mjs` compares them with those of the WebAssembly module.

use std::error::Error;
use std::io::{BufRead as _, Write as _, stdin, stdout};

use polhode_source::files::Memory;
use polhode_web::Engine;

fn main() -> Result<(), Box<dyn Error>> {
    let (engine, files) = (Engine::default(), Memory::default());
    let mut out = stdout().lock();
    for line in stdin().lock().lines() {
        let answer = engine.answer(line?.as_bytes(), &files, &|| true);
        writeln!(out, "{:016x}", fnv(rows(&answer)))?;
    }
    Ok(())
}

/// Returns the part after the length of the JSON and the JSON; nothing for an answer without rows.
fn rows(answer: &[u8]) -> &[u8] {
    let length = answer.first_chunk().map_or(usize::MAX, |bytes| u64::from_le_bytes(*bytes) as usize);
    answer.get(size_of::<u64>().saturating_add(length)..).unwrap_or_default()
}

fn fnv(bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}
