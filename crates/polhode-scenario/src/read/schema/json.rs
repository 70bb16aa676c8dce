//! Conversion of accepted values to a JSON schema.

use std::collections::{BTreeMap, BTreeSet};

use polhode_source::unit::Dimension;
use serde_json::{Map, Value, json};

use super::accepted::{Accepted, Form, Plain};

/// Largest number of dimensions that are listed; more mean that another key decides.
const DIMENSIONS: usize = 3;

/// Returns the schema of a file.
pub(super) fn of(file: &Accepted) -> Value {
    let mut whole = json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Scenario file of polhode",
        "description": "One body and one motion: https://github.com/polhode/polhode/blob/main/book/scenario.md",
    });
    let mut tables = of_tables(&file.forms, &Place::default()).as_object().cloned().unwrap_or_default();
    tables.remove("title");
    let repeated = repeated(tables.values());
    if let Some(schema) = whole.as_object_mut() {
        let shared: Map<String, Value> =
            repeated.values().map(|(name, def)| (name.clone(), inside(def, &repeated))).collect();
        schema.extend(tables.into_iter().map(|(key, value)| (key, referring(&value, &repeated))));
        schema.insert("$defs".to_owned(), Value::Object(shared));
    }
    whole
}

/// Place of a value.
#[derive(Clone, Debug, Default)]
struct Place {
    /// Key path, separated by dots.
    path: String,
    is_element: bool,
}

impl Place {
    fn inside(&self, key: &str) -> Self {
        let path = if self.path.is_empty() { key.to_owned() } else { format!("{}.{key}", self.path) };
        Self { path, is_element: false }
    }

    fn element(&self) -> Self {
        Self { is_element: true, ..self.clone() }
    }

    /// Returns the title of a table with this name in messages; a header if the table may have one.
    fn title(&self, name: &str) -> String {
        let depth = self.path.matches('.').count();
        match (name.contains(' '), self.is_element, depth) {
            (false, true, 0 | 1) => format!("[[{}]]", self.path),
            (false, false, 0) => format!("[{}]", self.path),
            _ => name.to_owned(),
        }
    }
}

fn of_value(value: &Accepted, place: &Place) -> Value {
    let mut forms = Vec::new();
    if !value.names.is_empty() {
        forms.push(json!({ "enum": value.names }));
    }
    forms.extend(scalar(value));
    if let Some(element) = &value.element {
        let mut list = json!({ "type": "array", "items": of_value(element, &place.element()) });
        let lengths: BTreeSet<usize> = value.lengths.iter().copied().flatten().collect();
        if let (Some(least), Some(most)) = (lengths.first(), lengths.last()) {
            list["minItems"] = json!(least);
            list["maxItems"] = json!(most);
        }
        forms.push(list);
    }
    if !value.forms.is_empty() {
        forms.push(of_tables(&value.forms, place));
    }
    if let Some(any) = &value.any_key {
        forms.push(json!({ "type": "object", "additionalProperties": of_value(any, place) }));
    }
    match <[Value; 1]>::try_from(forms) {
        Ok([only]) => only,
        Err(several) => json!({ "anyOf": several }),
    }
}

/// Returns the schema of strings, numbers and booleans; names are strings.
fn scalar(value: &Accepted) -> Option<Value> {
    let has = |plain| value.plain.contains(&plain);
    let is_quantity = !value.dimensions.is_empty();
    // A number may be a formula of the file's symbols.
    let is_text = is_quantity || has(Plain::Number) || has(Plain::Text) && value.names.is_empty();
    let types = [
        ("number", is_quantity || has(Plain::Number)),
        ("integer", has(Plain::Count) && !is_quantity && !has(Plain::Number)),
        ("string", is_text),
        ("boolean", has(Plain::Truth)),
    ];
    let types: Vec<&str> = types.into_iter().filter(|(_, is)| *is).map(|(name, _)| name).collect();
    let mut schema = match types[..] {
        [] => return None,
        [only] => json!({ "type": only }),
        _ => json!({ "type": types }),
    };
    if types.contains(&"integer") {
        schema["minimum"] = json!(0);
    }
    if is_quantity {
        schema["description"] = json!(quantity(&value.dimensions));
    }
    Some(schema)
}

/// Describes a quantity by its dimension, unit and an example.
fn quantity(dimensions: &[Dimension]) -> String {
    if dimensions.len() > DIMENSIONS {
        return "a quantity, whose dimension depends on another key".to_owned();
    }
    let one = |dimension: &Dimension| {
        let (unit, _) = dimension.unit();
        let example =
            dimension.example().map(|example| format!(", such as \"{example}\"")).unwrap_or_default();
        match unit.is_empty() {
            true => dimension.to_string(),
            false => format!("{dimension}{example}; without a unit in {unit}"),
        }
    };
    dimensions.iter().map(one).collect::<Vec<_>>().join(", or ")
}

/// Returns the schema of a table with one of several forms.
///
/// A key with a different name in each form distinguishes them; without such a key the table
/// accepts the keys of all forms.
fn of_tables(forms: &[Form], place: &Place) -> Value {
    let [first, others @ ..] = forms else { return json!({ "type": "object" }) };
    if others.is_empty() {
        return of_form(first, place, None);
    }
    let tells_apart = |key: &&&str| {
        let mut names = BTreeSet::new();
        forms.iter().all(|form| {
            form.chosen.get(**key).is_some_and(|chosen| chosen.iter().all(|name| names.insert(name)))
        })
    };
    if let Some(key) = first.chosen.keys().find(tells_apart) {
        let order = |form: &&Form| {
            let (_, value) = form.keys.iter().find(|(other, _)| other == key)?;
            let chosen = form.chosen.get(key)?;
            value.names.iter().position(|name| chosen.contains(*name))
        };
        let mut forms: Vec<&Form> = forms.iter().collect();
        forms.sort_by_key(order);
        let all: Vec<Value> = forms.iter().map(|form| of_form(form, place, Some(key))).collect();
        return json!({ "oneOf": all });
    }
    let mut whole = of_form(first, place, None);
    for form in others {
        let other = of_form(form, place, None);
        if let (Some(keys), Some(more)) =
            (whole["properties"].as_object_mut(), other["properties"].as_object())
        {
            more.iter().for_each(|(key, value)| {
                keys.entry(key).or_insert_with(|| value.clone());
            });
        }
        let required = other["required"].as_array().cloned().unwrap_or_default();
        if let Some(keys) = whole["required"].as_array_mut() {
            keys.retain(|key| required.contains(key));
        }
    }
    whole
}

fn of_form(form: &Form, place: &Place, named_by: Option<&str>) -> Value {
    let key = |(key, value): &(&str, Accepted)| {
        let mut schema = of_value(value, &place.inside(key));
        if let Some(chosen) = form.chosen.get(key).filter(|_| named_by == Some(*key)) {
            let names: Vec<_> = value.names.iter().filter(|name| chosen.contains(**name)).collect();
            schema = json!({ "enum": names });
        }
        ((*key).to_owned(), schema)
    };
    let mut schema = json!({
        "title": place.title(&form.name),
        "type": "object",
        "properties": form.keys.iter().map(key).collect::<Map<_, _>>(),
        "additionalProperties": false,
    });
    let required: Vec<&str> =
        form.keys.iter().map(|(key, _)| *key).filter(|key| form.requires(key)).collect();
    if !required.is_empty() {
        schema["required"] = json!(required);
    }
    schema
}

/// Tables that occur at several places, with their names, by their JSON text.
type Repeated = BTreeMap<String, (String, Value)>;

fn repeated<'a>(values: impl Iterator<Item = &'a Value>) -> Repeated {
    let mut count = BTreeMap::new();
    values.for_each(|value| counted(value, &mut count));
    let mut names: BTreeSet<String> = BTreeSet::new();
    let several = count.into_iter().filter(|(_, (times, _))| *times > 1);
    several
        .map(|(text, (_, table))| {
            let title = table["title"].as_str().unwrap_or("table");
            let mut name = title.replace(|c: char| !c.is_ascii_alphanumeric(), "_");
            while !names.insert(name.clone()) {
                name += "_";
            }
            (text, (name, table))
        })
        .collect()
}

fn counted(value: &Value, count: &mut BTreeMap<String, (usize, Value)>) {
    if value.get("additionalProperties") == Some(&Value::Bool(false)) {
        count.entry(value.to_string()).or_insert_with(|| (0, value.clone())).0 += 1;
    }
    match value {
        Value::Array(values) => values.iter().for_each(|value| counted(value, count)),
        Value::Object(values) => values.values().for_each(|value| counted(value, count)),
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => {}
    }
}

/// Returns the value with references instead of repeated tables.
fn referring(value: &Value, repeated: &Repeated) -> Value {
    match value.is_object().then(|| repeated.get(&value.to_string())).flatten() {
        Some((name, _)) => json!({ "$ref": format!("#/$defs/{name}") }),
        None => inside(value, repeated),
    }
}

/// Applies [`referring`] to everything inside the value.
fn inside(value: &Value, repeated: &Repeated) -> Value {
    match value {
        Value::Array(values) => values.iter().map(|value| referring(value, repeated)).collect(),
        Value::Object(values) => {
            let pair = |(key, value): (&String, &Value)| (key.clone(), referring(value, repeated));
            Value::Object(values.iter().map(pair).collect())
        }
        Value::Null | Value::Bool(_) | Value::Number(_) | Value::String(_) => value.clone(),
    }
}
