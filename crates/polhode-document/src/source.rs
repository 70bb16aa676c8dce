//! Source of the input of a result.

use serde_json::{Map, Value};

use crate::layout::printable;

/// Source of the input: path, format and description.
///
/// ```
/// let source = polhode_document::SourceInfo::new("bracket.stl", "stl")
///     .described("STL binary, 20,480 triangles, closed, consistently wound")
///     .with("triangles", 20_480);
/// assert_eq!(source.to_json()["triangles"], 20_480);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SourceInfo {
    /// Path as the user wrote it.
    pub path: String,
    /// Format of the file: `stl`, `scenario`, …
    pub format: String,
    /// Description for the heading; if empty, the format is used.
    pub description: String,
    /// Further fields of the JSON, after `path` and `format`: `triangles`, …
    pub fields: Map<String, Value>,
}

impl SourceInfo {
    /// Creates the source for a file of a format.
    pub fn new(path: impl Into<String>, format: impl Into<String>) -> Self {
        Self { path: path.into(), format: format.into(), description: String::new(), fields: Map::new() }
    }

    /// Returns the source with a description for the heading.
    #[must_use]
    pub fn described(self, description: impl Into<String>) -> Self {
        Self { description: description.into(), ..self }
    }

    /// Returns the source with one more field of the JSON.
    #[must_use]
    pub fn with(mut self, key: &str, value: impl Into<Value>) -> Self {
        self.fields.insert(key.to_owned(), value.into());
        self
    }

    /// Returns `{"path": …, "format": …, …}`.
    pub fn to_json(&self) -> Value {
        let mut object = Map::new();
        object.insert("path".to_owned(), self.path.as_str().into());
        object.insert("format".to_owned(), self.format.as_str().into());
        for (key, value) in &self.fields {
            object.entry(key.as_str()).or_insert_with(|| value.clone());
        }
        Value::Object(object)
    }

    /// Returns the heading: the path and the description.
    pub fn heading(&self) -> String {
        let what = if self.description.is_empty() { &self.format } else { &self.description };
        format!("{}   {}", printable(&self.path), printable(what))
    }
}
