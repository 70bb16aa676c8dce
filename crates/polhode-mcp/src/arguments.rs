//! Arguments of a call, and the files that it may read.

use std::io;
use std::path::Path;

use polhode_source::files::{Files, Kind, Memory, NotOpened, lexical};
use polhode_source::text::cut;
use polhode_source::{Failure, nearest, shown};
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

use crate::definition::Definition;

/// Arguments that are paths, or lists of paths.
const PATHS: [&str; 7] = ["file", "files", "root", "config", "baseline", "against", "suite"];

/// Arguments of a tool. Their names are known, and the required ones are there.
#[derive(Debug)]
pub(crate) struct Arguments {
    tool: &'static Definition,
    values: Map<String, Value>,
    properties: Map<String, Value>,
}

impl Arguments {
    /// Checks the names of arguments.
    ///
    /// # Errors
    /// [`Failure`] for an unknown name, and for a missing argument.
    pub(crate) fn new(tool: &'static Definition, values: Map<String, Value>) -> Result<Self, Failure> {
        let properties = tool.properties();
        if let Some(unknown) = values.keys().find(|key| !properties.contains_key(*key)) {
            let names = || properties.keys().map(String::as_str);
            let hint = match nearest(unknown, names()) {
                Some(near) => format!("did you mean {near}?"),
                None => format!("the arguments are {}", names().collect::<Vec<_>>().join(", ")),
            };
            return Err(Failure::usage(format!("{} has no argument {:?}", tool.name, cut(unknown)), hint));
        }
        let arguments = Self { tool, values, properties };
        match tool.required.iter().find(|key| is_empty(arguments.values.get(**key))) {
            Some(key) => {
                let message = format!("the argument {key} of {} is missing", tool.name);
                Err(Failure::usage(message, arguments.about(key)))
            }
            None => Ok(arguments),
        }
    }

    /// Removes the arguments with these names.
    pub(crate) fn take<const N: usize>(&mut self, keys: [&str; N]) -> Self {
        let taken = keys.iter().filter_map(|key| self.values.remove_entry(*key)).collect();
        Self { tool: self.tool, values: taken, properties: self.properties.clone() }
    }

    /// Reads the request of a command.
    ///
    /// # Errors
    /// [`Failure`] that names the invalid argument, its value and its meaning.
    pub(crate) fn read<T: DeserializeOwned>(self) -> Result<T, Failure> {
        from::<T>(self.values.clone()).map_err(|error| {
            // Each argument is optional in a request, so that it can be read alone.
            let alone = self.values.iter().find_map(|(key, value)| {
                let error = from::<T>(Map::from_iter([(key.clone(), value.clone())])).err()?;
                Some((key, value, error))
            });
            match alone {
                Some((key, value, error)) => self.refused(key, value, &error.to_string()),
                None => Failure::usage(format!("arguments of {}: {error}", self.tool.name), ""),
            }
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
                Some(_) if memory.is_file(path.as_ref()) => {
                    return Err(self.refused(&place, text, "this path is given twice"));
                }
                Some(text) => memory.insert(path, text.as_bytes()),
                None => return Err(self.refused(&place, text, "it must be the text of a file")),
            }
        }
        Ok(Some(memory))
    }

    /// Refuses paths outside the folder of the server, and pipes and devices, which may block
    /// forever. The slices cannot open files outside either, but know nothing of the folder.
    ///
    /// # Errors
    /// [`Failure`] with the path.
    pub(crate) fn require_inside(&self, files: &dyn Files) -> Result<(), Failure> {
        let root = files.canonical(Path::new(".")).unwrap_or_default();
        for (key, value) in self.values.iter().filter(|(key, _)| PATHS.contains(&key.as_str())) {
            for path in value.as_array().into_iter().flatten().chain([value]).filter_map(Value::as_str) {
                let is_outside = match files.look(path.as_ref()) {
                    Ok(look) if look.kind == Kind::Other => {
                        let rule = "it is neither a file nor a folder";
                        return Err(self.refused(key, &path.into(), rule));
                    }
                    Ok(_) => false,
                    // Whether a file outside exists is not told.
                    Err(error) => is_outside(&error) || !lexical(&root.join(path)).starts_with(&root),
                };
                if is_outside {
                    let rule = format!("it lies outside the folder of the server, {}", shown(&root));
                    let hint =
                        "copy the file into this folder, or start the server with --root for another one";
                    return Err(Failure::usage(format!("{key} = {path:?}: {rule}"), hint));
                }
            }
        }
        Ok(())
    }

    fn refused(&self, key: &str, value: &Value, rule: &str) -> Failure {
        Failure::usage(format!("{key} = {}: {rule}", cut(&value.to_string())), self.about(key))
    }

    /// Returns the description of an argument, as advice.
    fn about(&self, key: &str) -> String {
        let key = key.split('[').next().unwrap_or_default();
        let text = self.properties.get(key).and_then(|property| property["description"].as_str());
        text.map_or_else(String::new, |text| format!("{key}: {text}"))
    }
}

/// Returns true for an argument without a value, such as an empty list of files.
fn is_empty(value: Option<&Value>) -> bool {
    match value {
        None | Some(Value::Null) => true,
        Some(Value::Array(values)) => values.is_empty(),
        Some(Value::String(text)) => text.is_empty(),
        Some(_) => false,
    }
}

fn from<T: DeserializeOwned>(values: Map<String, Value>) -> serde_json::Result<T> {
    serde_json::from_value(values.into())
}

/// Returns true for the error of a path outside the folders that may be read.
fn is_outside(error: &io::Error) -> bool {
    let reason = error.get_ref().and_then(|reason| reason.downcast_ref::<NotOpened>());
    reason == Some(&NotOpened::Outside)
}
