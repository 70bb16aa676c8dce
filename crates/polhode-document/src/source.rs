//! Where an answer's input came from.

use serde_json::{Map, Value};

use crate::layout::printable;

/// Where the input came from, and what it is.
///
/// ```
/// let source = polhode_document::SourceInfo::new("bracket.stl", "stl")
///     .described("STL binary, 20,480 triangles, closed, consistently wound")
///     .with("triangles", 20_480);
/// assert_eq!(source.to_json()["triangles"], 20_480);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SourceInfo {
    /// The file as the user named it.
    pub path: String,
    /// What kind of file it is: `stl`, `scenario`, …
    pub format: String,
    /// What it is, in words, for the heading; the format if empty.
    pub description: String,
    /// More to say to programs, after `path` and `format`: `triangles`, …
    pub fields: Map<String, Value>,
}

impl SourceInfo {
    /// A file of a format.
    pub fn new(path: impl Into<String>, format: impl Into<String>) -> Self {
        Self { path: path.into(), format: format.into(), description: String::new(), fields: Map::new() }
    }

    /// The same, with words for the heading.
    #[must_use]
    pub fn described(self, description: impl Into<String>) -> Self {
        Self { description: description.into(), ..self }
    }

    /// The same, with one more field for programs.
    #[must_use]
    pub fn with(mut self, key: &str, value: impl Into<Value>) -> Self {
        self.fields.insert(key.to_owned(), value.into());
        self
    }

    /// `{"path": …, "format": …, …}`
    pub fn to_json(&self) -> Value {
        let mut object = Map::new();
        object.insert("path".to_owned(), self.path.as_str().into());
        object.insert("format".to_owned(), self.format.as_str().into());
        for (key, value) in &self.fields {
            object.entry(key.as_str()).or_insert_with(|| value.clone());
        }
        Value::Object(object)
    }

    /// The heading: the file, and what it is.
    pub fn heading(&self) -> String {
        let what = if self.description.is_empty() { &self.format } else { &self.description };
        format!("{}   {}", printable(&self.path), printable(what))
    }
}
