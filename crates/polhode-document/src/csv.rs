//! Names as fields of CSV.

use crate::layout::printable;

/// Returns a name as a field of CSV: one line, quoted if necessary.
///
/// Spreadsheets evaluate a text that begins with the sign of a formula, quoted or not. Such a name
/// gets a leading apostrophe, which marks a text. Tabs and line ends can start a formula too; they
/// are escaped.
pub fn csv_name(name: &str) -> String {
    /// Signs that start a formula, with their full-width forms.
    const FORMULA: [char; 8] = ['=', '+', '-', '@', '\u{ff1d}', '\u{ff0b}', '\u{ff0d}', '\u{ff20}'];
    let mark = if name.trim_start().starts_with(FORMULA) { "'" } else { "" };
    let name = mark.to_owned() + &printable(name);
    if name.contains([',', '"']) { format!("\"{}\"", name.replace('"', "\"\"")) } else { name }
}

#[cfg(test)]
mod tests {
    use super::csv_name;

    #[test]
    fn a_name_is_no_formula() {
        for (name, cell) in [
            ("wheel", "wheel"),
            ("a=b-c", "a=b-c"),
            ("a,b", "\"a,b\""),
            ("=HYPERLINK(\"x\",\"y\")", "\"'=HYPERLINK(\"\"x\"\",\"\"y\"\")\""),
            ("+1", "'+1"),
            ("-1", "'-1"),
            ("@SUM(A1)", "'@SUM(A1)"),
            (" \t=1+1", "' \\t=1+1"),
            ("\r=1", "'\\r=1"),
            ("\u{ff1d}1", "'\u{ff1d}1"),
        ] {
            assert_eq!(csv_name(name), cell);
        }
    }
}
