//! Names in XML.

use super::{ExportBody, ExportError, ExportFormat};

/// The text as an attribute's value, between double quotes.
///
/// Line breaks, tabs and other controls become references, which read back. XML 1.0 has no way to say the rest of the
/// controls: they are shown as in Rust, `\u{7}`.
pub(super) fn attribute(text: &str) -> String {
    let mut value = String::new();
    for c in text.chars() {
        match c {
            '&' => value.push_str("&amp;"),
            '<' => value.push_str("&lt;"),
            '>' => value.push_str("&gt;"),
            '"' => value.push_str("&quot;"),
            '\t' | '\n' | '\r' | '\u{7f}'..='\u{9f}' => value.push_str(&format!("&#{};", u32::from(c))),
            '\u{0}'..'\u{20}' | '\u{fffe}' | '\u{ffff}' => value.extend(c.escape_unicode()),
            _ => value.push(c),
        }
    }
    value
}

/// Every body has a name, and each another.
pub(super) fn check_names(format: ExportFormat, bodies: &[ExportBody]) -> Result<(), ExportError> {
    let refused = |body: &ExportBody, rule| ExportError::Name { format, name: body.name.clone(), rule };
    let mut seen = std::collections::BTreeSet::new();
    for body in bodies {
        if body.name.is_empty() {
            return Err(refused(body, "it has to have a letter at least"));
        }
        if !seen.insert(&body.name) {
            return Err(refused(body, "another body has it too, and each needs its own"));
        }
    }
    Ok(())
}

/// A comment on a line of its own.
pub(super) fn comment(indent: &str, text: &str) -> String {
    format!("{indent}<!-- {text} -->\n")
}
