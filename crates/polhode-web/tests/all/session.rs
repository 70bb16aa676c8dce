//! A session with files in memory, and the reader of its answers.

use polhode_source::files::Memory;
use polhode_web::{Engine, Watch};
use serde_json::{Value, json};

/// Engine and the files that it may read.
#[derive(Default)]
pub(crate) struct Session {
    pub(crate) engine: Engine,
    pub(crate) files: Memory,
}

/// Answer of the engine: JSON, and the rows that follow it.
pub(crate) struct Answer {
    pub(crate) json: Value,
    pub(crate) rows: Vec<u8>,
}

impl Session {
    pub(crate) fn ask(&self, message: &Value) -> Answer {
        self.ask_watched(message, &|| true)
    }

    pub(crate) fn ask_watched(&self, message: &Value, watch: &dyn Watch) -> Answer {
        Answer::parse(&self.engine.answer(message.to_string().as_bytes(), &self.files, watch))
    }

    /// Adds a file and opens it; returns its entry in the list.
    pub(crate) fn open(&mut self, path: &str, contents: &[u8]) -> Value {
        self.files.insert(path, contents);
        self.ask(&json!({ "open": { "path": path } })).json
    }

    /// Computes the motion of document 0 with a text and edits.
    pub(crate) fn motion(&self, text: &str, edits: &Value) -> Answer {
        self.ask(&motion(text, edits))
    }
}

/// Returns the message that requests a motion of document 0.
pub(crate) fn motion(text: &str, edits: &Value) -> Value {
    let (document, body) = (0, Value::Null);
    json!({ "motion": {
        "document": document, "text": text, "edits": edits, "error": false, "working": false, "body": body,
    } })
}

impl Answer {
    pub(crate) fn parse(bytes: &[u8]) -> Self {
        if bytes[0] == b'{' {
            return Self { json: serde_json::from_slice(bytes).unwrap(), rows: Vec::new() };
        }
        let (length, rest) = bytes.split_first_chunk().unwrap();
        let length = usize::try_from(u64::from_le_bytes(*length)).unwrap();
        assert_eq!(length % 8, 0);
        let (json, rows) = rest.split_at(length);
        Self { json: serde_json::from_slice(json).unwrap(), rows: rows.to_vec() }
    }

    /// Returns the numbers of a row of f64.
    pub(crate) fn f64s(&self, row: &Value) -> Vec<f64> {
        self.words(&row["f64"]).map(f64::from_le_bytes).collect()
    }

    /// Returns the numbers of a row of f32.
    pub(crate) fn f32s(&self, row: &Value) -> Vec<f32> {
        self.words(&row["f32"]).map(f32::from_le_bytes).collect()
    }

    /// Returns the numbers of a row of u32.
    pub(crate) fn u32s(&self, row: &Value) -> Vec<u32> {
        self.words(&row["u32"]).map(u32::from_le_bytes).collect()
    }

    fn words<const N: usize>(&self, row: &Value) -> impl Iterator<Item = [u8; N]> {
        let [at, count] = [0, 1].map(|k| usize::try_from(row[k].as_u64().unwrap()).unwrap());
        self.rows[N * at..N * (at + count)].chunks(N).map(|word| word.try_into().unwrap())
    }

    /// Returns the kind and the message of a refusal.
    #[track_caller]
    pub(crate) fn refusal(&self) -> [&str; 2] {
        let refusal = &self.json["refusal"];
        ["kind", "message"].map(|key| refusal[key].as_str().unwrap_or_else(|| panic!("{}", self.json)))
    }
}
