//! Markdown table for a job summary or a pull request comment.

use std::fmt::Write as _;

use polhode_source::text::counted;

use super::Item;
use crate::checked::Checked;
use crate::policy::Reason;
use crate::report::Counts;

impl Checked {
    /// Returns the counts, the exclusions, the table of findings that count, and the allowed
    /// findings.
    pub fn to_markdown(&self) -> String {
        let (Counts { impossible, suspect, note }, allowed, known) = self.counts();
        let (files, note) = (counted(self.files.len(), "file"), counted(note, "note"));
        let mut text = format!(
            "### {}\n\n{files}: **{impossible} impossible**, {suspect} suspect, {note}; {allowed} allowed, {known} \
             known.\n",
            self.command
        );
        for line in self.left_out() {
            let _ = writeln!(text, "\n{}.", cell(&line));
        }
        let items: Vec<Item<'_>> = self.items().collect();
        let mut rows = String::new();
        for file in &self.files {
            if let Some((message, place)) = file.unreadable() {
                let line = place.map_or(String::new(), |[line, _]| format!(":{line}"));
                let _ = writeln!(rows, "| unreadable | {}{line} | | {} |", cell(&file.name), cell(&message));
            }
        }
        for item in items.iter().filter(|item| item.settled.is_none()) {
            let (severity, file, line) = (item.severity.name(), cell(&item.file), item.start.0);
            let (subject, code, message) = (cell(item.subject), cell(item.code), cell(&item.message));
            let _ = writeln!(rows, "| {severity} | {file}:{line} | {subject} | {code}: {message} |");
        }
        if !rows.is_empty() {
            let _ = write!(text, "\n| | where | link | what |\n|---|---|---|---|\n{rows}");
        }
        let allowed: Vec<String> = items
            .iter()
            .filter_map(|item| match item.settled {
                Some(Reason::Allowed(reason)) => Some(format!(
                    "- allowed: {} {}:{} {}: {}\n",
                    cell(item.subject),
                    cell(&item.file),
                    item.start.0,
                    cell(item.code),
                    cell(reason)
                )),
                _ => None,
            })
            .collect();
        if !allowed.is_empty() {
            let _ = write!(text, "\n{}", allowed.concat());
        }
        text
    }
}

/// Escapes text for a table cell: no markup, no HTML, and no mentions of users.
fn cell(text: &str) -> String {
    let mut cell = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\\' | '|' | '`' | '*' | '_' | '[' | ']' | '~' | '$' => {
                cell.push('\\');
                cell.push(c);
            }
            '<' => cell.push_str("&lt;"),
            '>' => cell.push_str("&gt;"),
            '&' => cell.push_str("&amp;"),
            '@' => cell.push_str("&#64;"),
            '#' => cell.push_str("&#35;"),
            c if c.is_control() => cell.push(' '),
            c => cell.push(c),
        }
    }
    cell
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_is_text() {
        assert_eq!(cell("a|b\n<i>_@x_ #1 c\\"), "a\\|b &lt;i&gt;\\_&#64;x\\_ &#35;1 c\\\\");
    }
}
