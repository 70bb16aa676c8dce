//! Workflow commands of GitHub Actions: an annotation at the line of each finding.

use std::fmt::Write as _;

use polhode_source::text::counted;

use super::{Item, about};
use crate::checked::Checked;
use crate::finding::Severity;
use crate::policy::Reason;
use crate::report::Counts;

impl Checked {
    /// Returns a command for each finding that counts. Allowed and known findings are plain log
    /// lines.
    pub fn to_github(&self) -> String {
        let mut text = String::new();
        for file in &self.files {
            if let Some((message, place)) = file.unreadable() {
                command(&mut text, "error", &file.name, place.unwrap_or([1; 2]), "unreadable", &message);
            }
        }
        let items: Vec<Item<'_>> = self.items().collect();
        for item in items.iter().filter(|item| item.settled.is_none()) {
            let name = match item.severity {
                Severity::Impossible => "error",
                Severity::Suspect => "warning",
                Severity::Note => "notice",
            };
            let [line, column] = [item.start.0, item.start.1];
            command(&mut text, name, &item.file, [line, column], item.code, &about(item));
        }
        for item in &items {
            if let Some(Reason::Allowed(reason)) = item.settled {
                let line = format!(
                    "allowed: {} {}:{} [{}]: {reason}",
                    item.subject, item.file, item.start.0, item.code
                );
                let _ = writeln!(text, "{}", logged(&line));
            }
        }
        for line in self.left_out() {
            let _ = writeln!(text, "::notice title={}::{}", self.command, data(&line));
        }
        let (Counts { impossible, suspect, note }, allowed, known) = self.counts();
        let (files, note) = (counted(self.files.len(), "file"), counted(note, "note"));
        let _ = writeln!(
            text,
            "{}: {files}, {impossible} impossible, {suspect} suspect, {note}, {allowed} allowed, {known} known",
            self.command
        );
        text
    }
}

/// Writes one command: `::error file=…,line=…,col=…,title=…::message`
fn command(
    text: &mut String,
    name: &str,
    file: &str,
    [line, column]: [usize; 2],
    title: &str,
    message: &str,
) {
    let (file, title) = (property(file), property(title));
    let _ = writeln!(text, "::{name} file={file},line={line},col={column},title={title}::{}", data(message));
}

/// Escapes a message: percent signs and line ends.
fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// Escapes a property: also commas and colons.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

/// Returns a log line that GitHub does not interpret as a command. It removes `::error` at line
/// starts and the older form `##[error]`, which is recognized anywhere in a line.
fn logged(line: &str) -> String {
    line.replace(['\r', '\n'], " ").replace("##[", "## [")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_in_a_message_is_a_command() {
        let mut text = String::new();
        command(&mut text, "error", "a,b:c.urdf", [3, 7], "x", "50 %\n::set-output name=a::b");
        assert_eq!(
            text,
            "::error file=a%2Cb%3Ac.urdf,line=3,col=7,title=x::50 %25%0A::set-output name=a::b\n"
        );
        assert_eq!(logged("a\r\n::error::b ##[error]c"), "a  ::error::b ## [error]c");
    }
}
