//! Unified diff of repairs, for `patch -p1` and `git apply`, with the proof of each change in a
//! line above.
//!
//! Lines end in `\n`, as in these tools: a preceding `\r` belongs to its line, and a missing line
//! end at the end of the file is marked. Lines that begin with `#` stand before the diff of a file,
//! where these tools ignore them.

use std::fmt::Write as _;
use std::ops::Range;

use polhode_document::layout::printable;

use crate::finding::Finding;
use crate::line_index::{FilePlace, Places};
use crate::model::{RobotModel, Span};
use crate::repair::Repaired;

/// Number of context lines around a change.
const CONTEXT: usize = 3;

impl Repaired {
    /// Returns the diff from the model's text to this text, with `name` as the file name. It is
    /// empty if nothing changed.
    ///
    /// `findings` are the findings of the repairs.
    pub fn diff(&self, model: &RobotModel, findings: &[Finding], name: &str) -> String {
        let mut text = String::new();
        let places = Places::of(model);
        for finding in self.applied.iter().filter_map(|&k| findings.get(k)) {
            let Finding { subject, code, message, rule, repair, .. } = finding;
            let Some(repair) = repair else { continue };
            let first = repair.edits.iter().map(|(span, _)| span).min_by_key(|span| span.start);
            let FilePlace { line, .. } = places.place(first.unwrap_or(&finding.span));
            let subject = if subject.is_empty() { "the model" } else { subject };
            let proof =
                format!("{name}:{line}: {subject} [{code}]: {}; {message}; rule: {rule}", repair.description);
            let _ = writeln!(text, "# {}", printable(&proof));
        }
        let hunks = hunks(&model.text, &self.edits);
        if hunks.is_empty() {
            return text;
        }
        let _ = writeln!(text, "--- {}\n+++ {}", header("a", name), header("b", name));
        text + &hunks
    }
}

/// Returns a file name after `a/` or `b/`, quoted if it has characters that need escapes. A tab
/// follows a name with spaces.
fn header(side: &str, name: &str) -> String {
    let name = format!("{side}/{}", name.trim_start_matches('/'));
    if name.contains(['"', '\\']) || name.chars().any(char::is_control) {
        let mut quoted = String::from("\"");
        for byte in name.bytes() {
            match byte {
                b'"' | b'\\' => quoted.extend(['\\', char::from(byte)]),
                0x20..=0x7e => quoted.push(char::from(byte)),
                _ => {
                    let _ = write!(quoted, "\\{byte:03o}");
                }
            }
        }
        return quoted + "\"";
    }
    if name.contains(' ') { name + "\t" } else { name }
}

/// Range of lines and its replacement.
struct Block {
    lines: Range<usize>,
    new: String,
}

/// Returns the hunks of edits that do not overlap, ascending.
fn hunks(text: &str, edits: &[(Span, String)]) -> String {
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    let blocks = blocks(text, &lines, edits);
    let mut hunks = String::new();
    // Number of lines that the text has grown before a hunk.
    let mut growth = 0_isize;
    let mut rest = blocks.as_slice();
    while let Some(first) = rest.first() {
        // Changes separated by no more than twice the context form one hunk.
        let joined = rest
            .windows(2)
            .take_while(|pair| matches!(pair, [a, b] if b.lines.start <= a.lines.end + 2 * CONTEXT));
        let (own, later) = rest.split_at(1 + joined.count());
        rest = later;
        let start = first.lines.start.saturating_sub(CONTEXT);
        let end = own.last().map_or(start, |last| (last.lines.end + CONTEXT).min(lines.len()));
        let mut body = String::new();
        let mut at = start;
        let mut new_count = 0;
        for Block { lines: changed, new } in own {
            new_count += write_lines(&mut body, ' ', lines.get(at..changed.start).unwrap_or_default());
            write_lines(&mut body, '-', lines.get(changed.clone()).unwrap_or_default());
            let new: Vec<&str> = new.split_inclusive('\n').collect();
            new_count += write_lines(&mut body, '+', &new);
            at = changed.end;
        }
        new_count += write_lines(&mut body, ' ', lines.get(at..end).unwrap_or_default());
        let old_count = end - start;
        let range = |start: usize, count: usize| match count {
            0 => format!("{start},0"),
            1 => format!("{}", start + 1),
            _ => format!("{},{count}", start + 1),
        };
        let new_start = start.saturating_add_signed(growth);
        let _ = writeln!(hunks, "@@ -{} +{} @@", range(start, old_count), range(new_start, new_count));
        hunks.push_str(&body);
        growth += new_count.cast_signed() - old_count.cast_signed();
    }
    hunks
}

/// Writes lines with a mark before each, and marks a missing line end.
fn write_lines(body: &mut String, mark: char, lines: &[&str]) -> usize {
    for line in lines {
        body.push(mark);
        body.push_str(line);
        if !line.ends_with('\n') {
            body.push_str("\n\\ No newline at end of file\n");
        }
    }
    lines.len()
}

/// Returns the lines that edits touch, as blocks.
fn blocks(text: &str, lines: &[&str], edits: &[(Span, String)]) -> Vec<Block> {
    let mut starts = vec![0];
    starts.extend(lines.iter().scan(0, |end, line| {
        *end += line.len();
        Some(*end)
    }));
    let start_of = |line: usize| starts.get(line).copied().unwrap_or(text.len());
    let line_of = |byte: usize| {
        starts.partition_point(|&start| start <= byte).saturating_sub(1).min(lines.len().saturating_sub(1))
    };
    let mut blocks: Vec<Block> = Vec::new();
    // Position in the text up to which the last block is complete.
    let mut done = 0;
    for (span, new) in edits {
        let touched = line_of(span.start)..(line_of(span.end) + 1).min(lines.len());
        match blocks.last_mut().filter(|last| touched.start < last.lines.end) {
            Some(last) => {
                // The text after the last edit is written again.
                let kept = last.new.len().saturating_sub(start_of(last.lines.end).saturating_sub(done));
                last.new.truncate(kept);
                last.new.push_str(text.get(done..span.start).unwrap_or_default());
                last.lines.end = last.lines.end.max(touched.end);
            }
            None => {
                let before = text.get(start_of(touched.start)..span.start).unwrap_or_default();
                blocks.push(Block { lines: touched, new: before.to_owned() });
            }
        }
        if let Some(last) = blocks.last_mut() {
            last.new.push_str(new);
            last.new.push_str(text.get(span.end..start_of(last.lines.end)).unwrap_or_default());
        }
        done = span.end;
    }
    blocks.into_iter().filter_map(|block| trimmed(block, lines)).collect()
}

/// Removes unchanged lines from both ends of a block; `None` if all are unchanged.
fn trimmed(Block { lines: mut changed, new }: Block, lines: &[&str]) -> Option<Block> {
    let mut new: Vec<&str> = new.split_inclusive('\n').collect();
    while !changed.is_empty() && !new.is_empty() && lines.get(changed.start) == new.first() {
        changed.start += 1;
        new.remove(0);
    }
    while !changed.is_empty() && !new.is_empty() && lines.get(changed.end - 1) == new.last() {
        changed.end -= 1;
        new.pop();
    }
    (!changed.is_empty() || !new.is_empty()).then(|| Block { lines: changed, new: new.concat() })
}

#[cfg(test)]
mod tests {
    use super::hunks;

    #[test]
    fn lines_come_and_go() {
        let text = "a\nb\nc\nd\ne\nf\ng\nh\ni\nj\n";
        let of = |edits: &[(std::ops::Range<usize>, &str)]| {
            let edits: Vec<_> = edits.iter().map(|(span, new)| (span.clone(), (*new).to_owned())).collect();
            hunks(text, &edits)
        };
        // One line deleted, one line inserted.
        assert_eq!(of(&[(2..4, "")]), "@@ -1,5 +1,4 @@\n a\n-b\n c\n d\n e\n");
        assert_eq!(of(&[(2..2, "x\n")]), "@@ -1,4 +1,5 @@\n a\n+x\n b\n c\n d\n");
        // Two edits in one line, and a deleted line end.
        assert_eq!(of(&[(2..2, "("), (3..3, ")")]), "@@ -1,5 +1,5 @@\n a\n-b\n+(b)\n c\n d\n e\n");
        assert_eq!(of(&[(1..2, "-")]), "@@ -1,5 +1,4 @@\n-a\n-b\n+a-b\n c\n d\n e\n");
        // Later hunks include the growth of earlier ones.
        let far = of(&[(0..0, "x\ny\n"), (18..19, "J")]);
        assert_eq!(far, "@@ -1,3 +1,5 @@\n+x\n+y\n a\n b\n c\n@@ -7,4 +9,4 @@\n g\n h\n i\n-j\n+J\n");
        // Six lines between two changes are context of both.
        assert_eq!(of(&[(0..1, "A"), (14..15, "H")]).matches("@@ -").count(), 1);
        assert_eq!(of(&[(0..1, "A"), (16..17, "I")]).matches("@@ -").count(), 2);
        // An insertion at the very end, and no change.
        assert_eq!(of(&[(20..20, "k")]), "@@ -8,3 +8,4 @@\n h\n i\n j\n+k\n\\ No newline at end of file\n");
        assert_eq!(of(&[(4..5, "c")]), "");
        assert_eq!(of(&[(0..20, "")]), "@@ -1,10 +0,0 @@\n-a\n-b\n-c\n-d\n-e\n-f\n-g\n-h\n-i\n-j\n");
    }
}
