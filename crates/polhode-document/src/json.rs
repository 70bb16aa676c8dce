//! JSON values and their formatting.

use polhode::math::Vector;
use serde_json::Value;

use crate::layout::is_unseen;

/// Formats JSON with an indentation of two spaces and with lists of numbers on one line, so that a
/// tensor looks like a matrix.
///
/// ```
/// let value = serde_json::json!({"mass": 1.5, "tensor": [[1.0, 0.0], [0.0, 2.0]]});
/// let text = polhode_document::json::pretty(&value);
/// assert_eq!(text, "{\n  \"mass\": 1.5,\n  \"tensor\": [\n    [1.0, 0.0],\n    [0.0, 2.0]\n  ]\n}");
/// ```
///
/// Strings are exact. Control characters are escaped as `\u009b`; they occur only in strings.
pub fn pretty(value: &Value) -> String {
    pretty_at(value, 0)
}

/// Formats a value as [`pretty`] does, at this depth of nesting.
pub fn pretty_at(value: &Value, depth: usize) -> String {
    let mut text = String::new();
    write(&mut text, value, depth);
    if !text.contains(|c| is_unseen(c) && c != '\n') {
        return text;
    }
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        if is_unseen(c) && c != '\n' {
            safe.extend(c.encode_utf16(&mut [0; 2]).iter().map(|unit| format!("\\u{unit:04x}")));
        } else {
            safe.push(c);
        }
    }
    safe
}

/// Returns the three components as a JSON array.
pub fn vector<Q, F>(v: Vector<Q, F>) -> Value {
    numbers(&v.to_array())
}

/// Returns a JSON array of numbers; a number that is not finite becomes `null`.
pub fn numbers(values: &[f64]) -> Value {
    values.iter().map(|&x| Value::from(x)).collect()
}

/// Returns a JSON array of rows.
pub fn matrix(rows: [[f64; 3]; 3]) -> Value {
    rows.iter().map(|row| numbers(row)).collect()
}

fn write(text: &mut String, value: &Value, depth: usize) {
    let open = |text: &mut String| {
        text.push('\n');
        text.push_str(&"  ".repeat(depth + 1));
    };
    let close = |text: &mut String, bracket: char| {
        text.push('\n');
        text.push_str(&"  ".repeat(depth));
        text.push(bracket);
    };
    match value {
        Value::Array(items) if items.iter().any(|item| item.is_array() || item.is_object()) => {
            text.push('[');
            for (k, item) in items.iter().enumerate() {
                if k > 0 {
                    text.push(',');
                }
                open(text);
                write(text, item, depth + 1);
            }
            close(text, ']');
        }
        Value::Array(items) => {
            let items: Vec<String> = items.iter().map(Value::to_string).collect();
            text.push_str(&format!("[{}]", items.join(", ")));
        }
        Value::Object(entries) if !entries.is_empty() => {
            text.push('{');
            for (k, (key, item)) in entries.iter().enumerate() {
                if k > 0 {
                    text.push(',');
                }
                open(text);
                text.push_str(&format!("{}: ", Value::from(key.as_str())));
                write(text, item, depth + 1);
            }
            close(text, '}');
        }
        other => text.push_str(&other.to_string()),
    }
}

/// Returns a finite number unchanged, else 0; JSON has no other numbers.
pub fn finite(x: f64) -> f64 {
    if x.is_finite() { x } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_string_is_exact_and_steers_no_terminal() {
        let value =
            serde_json::json!({ "a\u{202e}": ["\u{9b}2J\u{1b}[m\r\n\t", "\u{e0041}ω\u{307}"], "b": {} });
        let text = pretty(&value);
        assert!(!text.contains(|c| is_unseen(c) && c != '\n'), "{text:?}");
        assert!(
            text.contains("\"\\u009b2J\\u001b[m\\r\\n\\t\"") && text.contains("\\udb40\\udc41ω"),
            "{text}"
        );
        assert_eq!(serde_json::from_str::<Value>(&text).ok(), Some(value));
    }
}
