//! XML helpers: names and warnings.

use std::collections::BTreeSet;

use polhode::body::Symmetry;
use polhode_document::layout::is_unseen;

use super::{ExportBody, ExportError, ExportFormat};

/// Escapes text for an attribute value in double quotes.
///
/// Line breaks, tabs, and invisible characters such as bidirectional controls become character
/// references, which read back. XML 1.0 cannot represent the remaining controls; they are shown as
/// in Rust, `\u{7}`.
pub(crate) fn attribute(text: &str) -> String {
    let mut value = String::new();
    for c in text.chars() {
        match c {
            '&' => value.push_str("&amp;"),
            '<' => value.push_str("&lt;"),
            '>' => value.push_str("&gt;"),
            '"' => value.push_str("&quot;"),
            '\t' | '\n' | '\r' => value.push_str(&format!("&#{};", u32::from(c))),
            '\u{0}'..'\u{20}' | '\u{fffe}' | '\u{ffff}' => value.extend(c.escape_unicode()),
            _ if is_unseen(c) => value.push_str(&format!("&#{};", u32::from(c))),
            _ => value.push(c),
        }
    }
    value
}

/// Returns the name of a model: that of its only body, or "bodies".
pub(crate) fn model(bodies: &[ExportBody]) -> String {
    match bodies {
        [body] => attribute(&body.name),
        _ => "bodies".to_owned(),
    }
}

/// Checks that every body has a name, and that all names differ.
pub(crate) fn check_names(format: ExportFormat, bodies: &[ExportBody]) -> Result<(), ExportError> {
    let refused = |body: &ExportBody, rule| ExportError::Name { format, name: body.name.clone(), rule };
    let mut seen = BTreeSet::new();
    for body in bodies {
        if body.name.is_empty() {
            return Err(refused(body, "it needs at least one letter"));
        }
        if !seen.insert(&body.name) {
            return Err(refused(body, "another body has the same name"));
        }
    }
    Ok(())
}

/// Returns warnings as comments on separate lines: numbers that are not those of a solid, and
/// bodies that simulators reject. Most bodies have none.
pub(crate) fn warning(indent: &str, body: &ExportBody) -> String {
    let refused = |what| format!("{what}, which many simulators refuse");
    let stumbles = match body.properties.principal().symmetry() {
        Symmetry::Point => Some(refused("a point mass without moments of inertia")),
        Symmetry::Rod => Some(refused("a rod without moment of inertia about its axis")),
        _ => None,
    };
    body.remark().into_iter().chain(stumbles).map(|text| format!("{indent}<!-- {text} -->\n")).collect()
}
