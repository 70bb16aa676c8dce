//! Validation of JSON against JSON schemas: the keywords of draft 2020-12 that this project uses.
#![allow(dead_code, reason = "each program of tests uses one of them")]

use serde_json::Value;

/// Panics if a value does not conform to a schema.
pub(crate) fn require_fits(schema: &str, value: &Value) {
    let found = misfit(schema, value);
    assert!(found.is_none(), "{}\n{value:#}", found.unwrap_or_default());
}

/// Returns the place and reason why a value does not conform to a schema; `None` if it does.
pub(crate) fn misfit(schema: &str, value: &Value) -> Option<String> {
    let root = serde_json::from_str(schema).unwrap();
    fits(&root, &root, value, "").err()
}

/// Validates a value against a part of a schema; `at` is the place of the value.
pub(crate) fn fits(root: &Value, schema: &Value, value: &Value, at: &str) -> Result<(), String> {
    let (items, keys) = (value.as_array(), value.as_object());
    let known = schema["properties"].as_object();
    let of_list = |rule: &Value, of: &dyn Fn(&Value) -> bool| rule.as_array().unwrap().iter().any(of);
    for (word, rule) in schema.as_object().unwrap() {
        let is_kept = match word.as_str() {
            "$schema" | "$defs" | "title" | "description" | "default" | "tsType" => true,
            "$ref" => {
                let target = rule.as_str().unwrap().trim_start_matches('#');
                fits(root, root.pointer(target).unwrap(), value, at)?;
                true
            }
            "type" if rule.is_array() => of_list(rule, &|name| is(name, value)),
            "type" => is(rule, value),
            "enum" => of_list(rule, &|one| one == value),
            "const" => rule == value,
            "minimum" => value.as_f64().is_none_or(|number| number >= rule.as_f64().unwrap()),
            "maximum" => value.as_f64().is_none_or(|number| number <= rule.as_f64().unwrap()),
            "pattern" => {
                assert_eq!(rule, "[0-9]");
                value.as_str().is_none_or(|text| text.contains(|c: char| c.is_ascii_digit()))
            }
            "minItems" => items.is_none_or(|items| items.len() as u64 >= rule.as_u64().unwrap()),
            "maxItems" => items.is_none_or(|items| items.len() as u64 <= rule.as_u64().unwrap()),
            "items" => {
                let mut all = items.into_iter().flatten().enumerate();
                all.try_for_each(|(k, item)| fits(root, rule, item, &format!("{at}/{k}")))?;
                true
            }
            "required" => {
                let has = |key: &Value| keys.is_none_or(|keys| keys.contains_key(key.as_str().unwrap()));
                rule.as_array().unwrap().iter().all(has)
            }
            "properties" | "additionalProperties" => {
                for (key, inner) in keys.into_iter().flatten() {
                    let own = known.and_then(|known| known.get(key));
                    let at = format!("{at}/{key}");
                    match (word == "properties", own, rule) {
                        (true, Some(own), _) => fits(root, own, inner, &at)?,
                        (false, None, Value::Bool(false)) => return Err(format!("{at} is unknown")),
                        (false, None, rule) => fits(root, rule, inner, &at)?,
                        (true, None, _) | (false, Some(_), _) => {}
                    }
                }
                true
            }
            "oneOf" | "anyOf" => {
                let forms = rule.as_array().unwrap().iter().map(|form| fits(root, form, value, at));
                let (fitting, not): (Vec<_>, Vec<_>) = forms.partition(Result::is_ok);
                if fitting.is_empty() {
                    return Err(not.into_iter().filter_map(Result::err).collect::<Vec<_>>().join("\n"));
                }
                word == "anyOf" || fitting.len() == 1
            }
            other => panic!("{other} is not read here"),
        };
        if !is_kept {
            let value: String = value.to_string().chars().take(200).collect();
            return Err(format!("{at}: {value} breaks {word}: {rule}"));
        }
    }
    Ok(())
}

fn is(name: &Value, value: &Value) -> bool {
    match name.as_str().unwrap() {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "number" => value.is_number(),
        "integer" => value.is_u64() || value.is_i64(),
        "null" => value.is_null(),
        other => panic!("{other} is not a type"),
    }
}
