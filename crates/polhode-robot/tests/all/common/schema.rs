//! A check of values against schemas, as far as the schemas of polhode go: a keyword that is not known here fails.

use serde_json::Value;

/// Panics if a value does not fit a schema.
pub(crate) fn require_fits(schema: &str, value: &Value) {
    let schema: Value = serde_json::from_str(schema).unwrap();
    if let Err(why) = fits(&schema, &schema, value, "") {
        panic!("{why}\n{value:#}");
    }
}

fn fits(root: &Value, schema: &Value, value: &Value, at: &str) -> Result<(), String> {
    for (keyword, wanted) in schema.as_object().unwrap() {
        let found = match keyword.as_str() {
            "$schema" | "title" | "description" | "default" | "$defs" | "properties" => Ok(()),
            "$ref" => {
                let target = wanted.as_str().unwrap().trim_start_matches('#');
                fits(root, root.pointer(target).unwrap(), value, at)
            }
            "anyOf" => {
                let tried = wanted.as_array().unwrap().iter().map(|one| fits(root, one, value, at));
                tried.reduce(|a, b| a.or_else(|first| b.map_err(|why| format!("{first}\n{why}")))).unwrap()
            }
            "enum" => require(wanted.as_array().unwrap().contains(value), "not one of the values"),
            "type" => match wanted {
                Value::Array(types) => require(types.iter().any(|one| is(one, value)), "another type"),
                one => require(is(one, value), "another type"),
            },
            "required" => {
                let mut keys = wanted.as_array().unwrap().iter().map(|key| key.as_str().unwrap());
                keys.find(|key| value.get(key).is_none()).map_or(Ok(()), |key| Err(format!("no {key}")))
            }
            "items" => value
                .as_array()
                .into_iter()
                .flatten()
                .enumerate()
                .try_for_each(|(k, item)| fits(root, wanted, item, &format!("{at}/{k}"))),
            "minItems" => require(
                value.as_array().is_none_or(|all| all.len() as u64 >= wanted.as_u64().unwrap()),
                "too few",
            ),
            "maxItems" => require(
                value.as_array().is_none_or(|all| all.len() as u64 <= wanted.as_u64().unwrap()),
                "too many",
            ),
            "additionalProperties" => value.as_object().into_iter().flatten().try_for_each(|(key, item)| {
                let at = format!("{at}/{key}");
                match (schema["properties"].get(key), wanted) {
                    (Some(known), _) => fits(root, known, item, &at),
                    (None, Value::Bool(_)) => Err(format!("{at}: not in the schema")),
                    (None, other) => fits(root, other, item, &at),
                }
            }),
            other => panic!("{other} is not known"),
        };
        found.map_err(|why| if why.starts_with('/') { why } else { format!("{at}: {why}") })?;
    }
    Ok(())
}

fn require(holds: bool, why: &str) -> Result<(), String> {
    if holds { Ok(()) } else { Err(why.to_owned()) }
}

fn is(kind: &Value, value: &Value) -> bool {
    match kind.as_str().unwrap() {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "number" => value.is_number(),
        "integer" => value.is_i64() || value.is_u64(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        other => panic!("{other} is not known"),
    }
}
