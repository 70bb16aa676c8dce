//! A session with files on disk, some of them dropped in sets.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

use polhode_source::files::Disk;
use polhode_web::{DocumentInfo, DroppedSet, Engine, Refusal, Watch};
use serde_json::{Value, json};

use crate::session::{Answer, motion};

/// Engine, and a folder for its dropped files.
pub(crate) struct Page {
    pub(crate) engine: Engine,
    folder: Folder,
    sets: RefCell<BTreeMap<u32, DroppedSet>>,
}

impl Page {
    /// Opens files, or the default scenario.
    pub(crate) fn open(files: &[PathBuf]) -> Self {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let engine = Engine::default();
        if files.is_empty() {
            engine.open_example(&Disk);
        }
        files.iter().for_each(|file| drop(engine.open(file, None, &Disk, &|| true).unwrap()));
        let folder = Folder::new(&format!("dropped-{}", COUNT.fetch_add(1, Ordering::Relaxed)));
        Self { engine, folder, sets: RefCell::default() }
    }

    /// Returns the answer to a message, with its rows at their places.
    pub(crate) fn ask(&self, message: &Value) -> Value {
        self.ask_watched(message, &|| true)
    }

    pub(crate) fn ask_watched(&self, message: &Value, watch: &dyn Watch) -> Value {
        with_rows(Answer::parse(&self.engine.answer(message.to_string().as_bytes(), &Disk, watch)))
    }

    pub(crate) fn documents(&self) -> Value {
        self.ask(&json!("documents"))["documents"].clone()
    }

    pub(crate) fn document(&self, id: &Value) -> Value {
        self.ask(&json!({ "document": { "id": id } }))
    }

    /// Computes the motion of a document.
    pub(crate) fn motion(&self, document: u32, text: &str) -> Value {
        let mut message = motion(text, &json!([]));
        message["motion"]["document"] = document.into();
        self.ask(&message)
    }

    /// Drops a file into a set of dropped files.
    pub(crate) fn drop_file(&self, set: u32, name: &str, bytes: &[u8]) {
        let mut sets = self.sets.borrow_mut();
        let folder = self.folder.0.join(set.to_string());
        let path = folder.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, bytes).unwrap();
        let set = sets.entry(set).or_insert(DroppedSet { folder, files: Vec::new() });
        set.files.push(path);
    }

    /// Opens a file of a set of dropped files.
    pub(crate) fn open_dropped(
        &self,
        set: u32,
        name: &str,
        watch: &dyn Watch,
    ) -> Result<DocumentInfo, Refusal> {
        let sets = self.sets.borrow();
        let path = sets[&set].folder.join(name);
        self.engine.open(&path, Some(&sets[&set]), &Disk, watch)
    }

    /// Drops and opens a file; returns its document.
    pub(crate) fn dropped(&self, set: u32, name: &str, bytes: &[u8]) -> Value {
        self.drop_file(set, name, bytes);
        self.document(&self.open_dropped(set, name, &|| true).unwrap().id.into())
    }
}

/// Inserts the rows of an answer at their places. Each number must belong to exactly one row.
fn with_rows(Answer { mut json, rows }: Answer) -> Value {
    let mut left: Vec<_> = rows.into_iter().map(Some).collect();
    put_rows(&mut json, &mut left);
    assert!(left.iter().all(Option::is_none), "a row is of nothing");
    json
}

fn put_rows(value: &mut Value, left: &mut [Option<u8>]) {
    fn row<const N: usize>(
        place: &Value,
        left: &mut [Option<u8>],
        number: impl Fn([u8; N]) -> Value,
    ) -> Value {
        let [at, count] = [0, 1].map(|k| usize::try_from(place[k].as_u64().unwrap()).unwrap());
        let words = left[N * at..N * (at + count)].as_chunks_mut().0.iter_mut();
        words
            .map(|word: &mut [_; N]| number(std::mem::replace(word, [None; N]).map(Option::unwrap)))
            .collect()
    }
    *value = match value {
        Value::Array(items) => return items.iter_mut().for_each(|item| put_rows(item, left)),
        Value::Object(entries) => match entries.iter().next() {
            Some((kind, place)) if kind == "f64" => row(place, left, |x| f64::from_le_bytes(x).into()),
            Some((kind, place)) if kind == "f32" => row(place, left, |x| f32::from_le_bytes(x).into()),
            Some((kind, place)) if kind == "u32" => row(place, left, |x| u32::from_le_bytes(x).into()),
            _ => return entries.values_mut().for_each(|entry| put_rows(entry, left)),
        },
        _ => return,
    };
}

/// Returns the path of a file of the repository.
pub(crate) fn repository(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

/// Temporary folder of this process, removed when dropped.
pub(crate) struct Folder(pub(crate) PathBuf);

impl Folder {
    pub(crate) fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("polhode-web-test-{}-{name}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    pub(crate) fn file(&self, name: &str, bytes: &[u8]) -> PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// Returns the f32 numbers of an array, or of a base64 text.
pub(crate) fn f32s(value: &Value) -> Vec<f32> {
    match value {
        Value::Array(_) => f64s(value).into_iter().map(|x| x as f32).collect(),
        _ => words(value).into_iter().map(f32::from_le_bytes).collect(),
    }
}

/// Returns the u32 numbers of an array, or of a base64 text.
pub(crate) fn u32s(value: &Value) -> Vec<u32> {
    match value.as_array() {
        Some(numbers) => numbers.iter().map(|x| x.as_u64().unwrap().try_into().unwrap()).collect(),
        None => words(value).into_iter().map(u32::from_le_bytes).collect(),
    }
}

/// Returns the f64 numbers of an array.
pub(crate) fn f64s(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

fn words<const N: usize>(value: &Value) -> Vec<[u8; N]> {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut value_of = [0_u32; 256];
    (0..).zip(DIGITS).for_each(|(k, &digit)| value_of[usize::from(digit)] = k);
    let mut bytes = Vec::new();
    for four in value.as_str().unwrap().as_bytes().chunks(4) {
        let bits = four.iter().fold(0, |bits, &digit| bits << 6 | value_of[usize::from(digit)]);
        let padding = four.iter().filter(|digit| **digit == b'=').count();
        bytes.extend_from_slice(&bits.to_be_bytes()[1..4 - padding]);
    }
    assert_eq!(bytes.len() % N, 0);
    bytes.chunks(N).map(|word| word.try_into().unwrap()).collect()
}
