//! Head of a CSV: lines before its table that begin with `#`. The rest of each line is TOML.

use polhode_source::FormatError;
use polhode_source::toml::source::Source;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

/// Hint for a head that is not valid TOML.
pub(crate) const SYNTAX: &str = "lines above the table are TOML after their #; a remark begins with ##";

/// Returns the TOML of a head and the start of the table. Each byte keeps its position in the file.
pub(crate) fn toml(source: Source<'_>) -> Result<(String, usize), FormatError> {
    let mut toml = String::new();
    let mut end = 0;
    for line in source.text.split_inclusive('\n') {
        let mark = if end == 0 && line.starts_with('\u{feff}') { 3 } else { 0 };
        let content = &line[mark..];
        let blank = |toml: &mut String, part: &str| {
            toml.extend(part.chars().flat_map(|c| match c {
                '\n' => std::iter::repeat_n('\n', 1),
                other => std::iter::repeat_n(' ', other.len_utf8()),
            }));
        };
        if let Some(rest) = content.trim_start().strip_prefix('#') {
            // `##` begins a remark for people.
            if rest.starts_with('#') {
                blank(&mut toml, line);
            } else {
                let kept = kept(rest);
                blank(&mut toml, &line[..line.len() - rest.len()]);
                toml.push_str(kept);
                blank(&mut toml, &rest[kept.len()..]);
            }
        } else if content.trim().is_empty() {
            blank(&mut toml, line);
        } else if content.trim_start().starts_with("\"#") {
            let (what, found) = ("a line that begins with #".to_owned(), "\"#".to_owned());
            let at = end + mark;
            let error =
                ContentError::new(ContentErrorKind::Expected { what, found }, ContentPlace::Text(at..at + 2));
            let error = error.hint("a spreadsheet program has quoted the header: move it to a plan, a TOML file with parts = \"FILE.csv\"");
            return Err(FormatError::of_content(source.path, source.text.as_bytes(), error));
        } else {
            end += mark;
            blank(&mut toml, &line[..mark]);
            break;
        }
        end += line.len();
    }
    Ok((toml, end))
}

/// Removes the empty cells that spreadsheets append to a line. A single comma may belong to the
/// TOML.
fn kept(line: &str) -> &str {
    let text = line.trim_end();
    let kept = text.trim_end_matches([';', '\t']);
    let fewer = kept.trim_end_matches(',');
    if kept.len() - fewer.len() > 1 { fewer } else { kept }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use polhode_source::files::Disk;

    #[test]
    fn a_head_stays_where_it_is() {
        let text =
            "\u{feff}# title = \"µ\"\r\n## for people\n\n#growth.C = 0.1,,,,\n# draws = 3;;\nname,mass\n";
        let (toml, end) = toml(Source::new(&Disk, Path::new("a.csv"), text)).unwrap();
        assert_eq!(&text[end..], "name,mass\n");
        assert_eq!(toml.len(), end);
        for kept in ["title = \"µ\"", "growth.C = 0.1", "draws = 3"] {
            assert_eq!(toml.find(kept), text.find(kept));
        }
        assert!(!toml.contains("people") && !toml.contains(",,") && !toml.contains(';'));
    }
}
