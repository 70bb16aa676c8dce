//! Arguments of a call.

use polhode_source::files::{Files as _, Memory};
use polhode_source::text::cut;
use polhode_source::{Failure, nearest};
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

/// Arguments of a tool. Their names are known, and the required ones are given.
#[derive(Debug)]
pub(crate) struct Arguments {
    values: Map<String, Value>,
    /// Schemas of the arguments by name.
    properties: Map<String, Value>,
}

impl Arguments {
    /// Checks the names of arguments.
    ///
    /// # Errors
    /// [`Failure`] for an unknown name, and for a missing or empty argument.
    pub(crate) fn new(
        tool: &str,
        values: Map<String, Value>,
        properties: Map<String, Value>,
        required: &[&str],
    ) -> Result<Self, Failure> {
        if let Some(unknown) = values.keys().find(|key| !properties.contains_key(*key)) {
            let names = || properties.keys().map(String::as_str);
            let hint = match nearest(unknown, names()) {
                Some(near) => format!("did you mean {near}?"),
                None => format!("the arguments are {}", names().collect::<Vec<_>>().join(", ")),
            };
            return Err(Failure::usage(format!("{tool} has no argument {:?}", cut(unknown)), hint));
        }
        let arguments = Self { values, properties };
        let is_empty = |key: &&&str| {
            let value = arguments.values.get(**key).map(Value::to_string);
            matches!(value.as_deref(), None | Some("null" | "[]" | "\"\""))
        };
        match required.iter().find(is_empty) {
            Some(key) => {
                let message = format!("the argument {key} of {tool} is missing");
                Err(Failure::usage(message, arguments.about(key)))
            }
            None => Ok(arguments),
        }
    }

    /// Removes the arguments with these names.
    pub(crate) fn take<const N: usize>(&mut self, keys: [&str; N]) -> Self {
        let values = keys.iter().filter_map(|key| self.values.remove_entry(*key)).collect();
        Self { values, properties: self.properties.clone() }
    }

    /// Reads the request of a command.
    ///
    /// # Errors
    /// [`Failure`] that names the invalid argument, its value and its meaning.
    pub(crate) fn read<T: DeserializeOwned>(self) -> Result<T, Failure> {
        serde_json::from_value(Value::Object(self.values.clone())).map_err(|error| {
            // Each argument is optional in a request, so that it can be read alone.
            let alone = self.values.iter().find_map(|(key, value)| {
                let one = Map::from_iter([(key.clone(), value.clone())]);
                let error = serde_json::from_value::<T>(one.into()).err()?;
                Some(self.refused(key, value, &error.to_string()))
            });
            alone.unwrap_or_else(|| Failure::usage(error.to_string(), ""))
        })
    }

    /// Returns the files in `contents`, if they are given.
    ///
    /// # Errors
    /// [`Failure`] unless these are texts by path.
    pub(crate) fn contents(&mut self) -> Result<Option<Memory>, Failure> {
        let files = match self.values.remove("contents") {
            None | Some(Value::Null) => return Ok(None),
            Some(Value::Object(files)) => files,
            Some(other) => return Err(self.refused("contents", &other, "it must be an object")),
        };
        let mut memory = Memory::default();
        for (path, text) in &files {
            let place = format!("contents[{:?}]", cut(path));
            match text.as_str() {
                Some(text) if !memory.is_file(path.as_ref()) => memory.insert(path, text.as_bytes()),
                Some(_) => return Err(self.refused(&place, text, "this path is given twice")),
                None => return Err(self.refused(&place, text, "it must be the text of a file")),
            }
        }
        Ok(Some(memory))
    }

    fn refused(&self, key: &str, value: &Value, rule: &str) -> Failure {
        Failure::usage(format!("{key} = {}: {rule}", cut(&value.to_string())), self.about(key))
    }

    /// Returns the description of an argument, as advice.
    fn about(&self, key: &str) -> String {
        let key = key.split('[').next().unwrap_or_default();
        let text = self.properties.get(key).and_then(|property| property["description"].as_str());
        format!("{key}: {}", text.unwrap_or_default())
    }
}
