//! Pack: all files of a session in one answer.

use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::path::Path;
use std::sync::Arc;

use serde::Serialize;

use crate::error::LiveError;
use crate::gather::Gathered;

/// Files as bytes: a JSON index, as [`polhode_web::json_before_rows`] describes, and the contents
/// of the files in the order of the index.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pack {
    pub(crate) bytes: Arc<Vec<u8>>,
    /// Hash of the bytes, in quotes.
    pub(crate) etag: String,
}

#[derive(Serialize)]
struct Index {
    open: Vec<String>,
    lesson: Option<Lesson>,
    files: Vec<File>,
}

#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum Lesson {
    Id(String),
    Path(String),
}

#[derive(Serialize)]
struct File {
    path: String,
    length: usize,
}

impl Pack {
    pub(crate) fn of(gathered: &Gathered) -> Result<Self, LiveError> {
        let named = &gathered.named;
        let lesson = match named.lesson_file() {
            Some(path) => Some(Lesson::Path(text(path.as_ref())?)),
            None => named.lesson.clone().map(Lesson::Id),
        };
        let files =
            gathered.files.iter().map(|(path, bytes)| Ok(File { path: text(path)?, length: bytes.len() }));
        let index = Index {
            open: named.files.iter().map(|path| text(path)).collect::<Result<_, _>>()?,
            lesson,
            files: files.collect::<Result<_, LiveError>>()?,
        };
        let mut bytes = polhode_web::json_before_rows(&index).map_err(LiveError::refused)?;
        gathered.files.values().for_each(|file| bytes.extend_from_slice(file));
        let mut hasher = DefaultHasher::new();
        bytes.hash(&mut hasher);
        Ok(Self { bytes: Arc::new(bytes), etag: format!("\"{:016x}\"", hasher.finish()) })
    }
}

/// Returns a path with `/` between its names.
fn text(path: &Path) -> Result<String, LiveError> {
    let text = path.to_str().ok_or_else(|| LiveError::unreadable(path, "its name is not UTF-8 text"))?;
    Ok(text.replace(std::path::MAIN_SEPARATOR, "/"))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::LiveOptions;

    #[test]
    fn a_pack_is_an_index_and_the_bytes_of_its_files() {
        let named = LiveOptions { files: vec!["/b/x.toml".into()], ..LiveOptions::default() };
        let files = [("/a.stl".into(), b"solid".to_vec()), ("/b/x.toml".into(), b"y = 1\n".to_vec())].into();
        let pack = Pack::of(&Gathered { named, files }).unwrap();
        let index = r#"{"open":["/b/x.toml"],"lesson":null,"files":[{"path":"/a.stl","length":5},{"path":"/b/x.toml","length":6}]}"#;
        let length = index.len().next_multiple_of(8);
        let expected =
            [&length.to_le_bytes(), format!("{index:length$}").as_bytes(), b"solidy = 1\n"].concat();
        assert_eq!(*pack.bytes, expected);
        let named = LiveOptions { lesson: Some("cube".to_owned()), ..LiveOptions::default() };
        let lesson = Pack::of(&Gathered { named, ..Gathered::default() }).unwrap();
        assert!(lesson.bytes[8..].starts_with(br#"{"open":[],"lesson":{"id":"cube"},"files":[]}"#));
        assert_ne!(lesson.etag, pack.etag);
    }
}
