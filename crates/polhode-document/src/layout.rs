//! Layout of plain text: wrapping, labels, aligned columns, matrices.

use crate::number::{NO_BREAK, alike};

/// Default width of text, columns.
pub const WIDTH: usize = 100;

/// En space that marks an indented cell and that pages keep. Plain text replaces it by ordinary
/// spaces.
pub const INDENT: char = '\u{2002}';

/// Units that are not separated from their number by a line break.
const UNITS: [&str; 14] =
    ["s", "/s", "m", "kg", "rad", "rad/s", "rad/s²", "deg/s", "m/s", "N", "N·m", "J", "kg·m²", "kg·m²/s"];

/// Returns the width of a text on a terminal, columns; combining marks (the dot of ω̇) take none.
pub fn width(text: &str) -> usize {
    text.chars().filter(|c| !('\u{300}'..='\u{36f}').contains(c)).count()
}

/// Replaces no-break spaces by ordinary spaces, as the last step of plain text.
pub fn plain_spaces(text: &str) -> String {
    text.replace(NO_BREAK, " ")
}

/// Returns a name or title from a file on one line. Characters that control the terminal or the
/// text direction are escaped.
pub fn printable(text: &str) -> String {
    escaped(text, |_| false)
}

/// Returns lines for a terminal: as [`printable`], but line ends and tabs are kept. All output of
/// the command goes through it last.
pub fn printable_lines(text: &str) -> String {
    escaped(text, |c| matches!(c, '\n' | '\t'))
}

/// Escapes invisible characters, except those for which `leave` returns true.
fn escaped(text: &str, leave: impl Fn(char) -> bool) -> String {
    let mut shown = String::with_capacity(text.len());
    for c in text.chars() {
        if is_unseen(c) && !leave(c) { shown.extend(c.escape_default()) } else { shown.push(c) }
    }
    shown
}

/// Returns true for control characters, direction marks, line separators, and characters without
/// width.
pub fn is_unseen(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{ad}' | '\u{61c}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}')
        || matches!(c, '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{e0000}'..='\u{e007f}')
}

/// Breaks a text into lines of at most `columns` columns, each after `indent`; words are not
/// broken.
pub fn wrap(text: &str, indent: &str, columns: usize) -> Vec<String> {
    let mut lines = Vec::new();
    let mut line = String::new();
    for word in tied(text) {
        if !line.is_empty() && width(indent) + width(&line) + 1 + width(&word) > columns {
            lines.push(format!("{indent}{line}"));
            line.clear();
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(&word);
    }
    if !line.is_empty() {
        lines.push(format!("{indent}{line}"));
    }
    lines
}

/// Splits a text into words; a number and its unit form one word.
fn tied(text: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    for word in text.split([' ', '\n']).filter(|word| !word.is_empty()) {
        let unit = word.trim_end_matches([',', ';', '.', ':', ')']);
        match words.last_mut() {
            Some(last)
                if UNITS.contains(&unit) && last.ends_with(|c: char| c.is_ascii_digit() || c == ')') =>
            {
                last.push(NO_BREAK);
                last.push_str(word);
            }
            _ => words.push(word.to_owned()),
        }
    }
    words
}

/// Breaks a formula or a line of numbers into lines of at most `columns` columns, each after
/// `indent`. Breaks at wide gaps, else before an operator or after a comma outside brackets, else
/// between words.
///
/// Continued sums are aligned with their `=`; other continuation lines are indented by four
/// columns.
pub fn broken(line: &str, indent: &str, columns: usize) -> Vec<String> {
    const HANG: usize = 4;
    let equals = line.find(" = ").map(|at| width(&line[..=at])).filter(|at| *at <= 4 * HANG);
    let (mut lines, mut rest, mut hang) = (Vec::new(), line, 0);
    while width(indent) + hang + width(rest) > columns {
        let room = columns.saturating_sub(width(indent) + hang);
        let Some(at) = last_break(rest, room) else { break };
        let (head, tail) = rest.split_at(at);
        lines.push(format!("{indent}{}{}", " ".repeat(hang), head.trim_end_matches(' ')));
        rest = tail.trim_start_matches(' ');
        hang = equals.filter(|_| goes_on(rest)).unwrap_or(HANG);
    }
    lines.push(format!("{indent}{}{rest}", " ".repeat(hang)));
    lines
}

/// Returns true for a text that begins with an operator.
fn goes_on(text: &str) -> bool {
    ["= ", "+ ", "- ", "− "].iter().any(|operator| text.starts_with(operator))
}

/// Returns the best position of a line break with at most `room` columns before it; the last one
/// among equals.
fn last_break(line: &str, room: usize) -> Option<usize> {
    // A formula is not separated from its first `=`, nor an operator from its right operand.
    let first = if goes_on(line) { 2 } else { line.find(" = ").map_or(0, |at| at + 1) };
    let mut depth = 0_i32;
    // Best position so far, with its rank.
    let mut best: Option<(u8, usize)> = None;
    for (at, c) in line.char_indices() {
        match c {
            '(' | '{' => depth += 1,
            ')' | '}' => depth -= 1,
            _ => {}
        }
        let (head, tail) = (&line[..at], line[at..].trim_start_matches(' '));
        if c != ' ' || head.ends_with(' ') || head.is_empty() || width(head) > room {
            continue;
        }
        let gap = line.len() - at - tail.len();
        let word = tail.split([' ', ',', ';']).next().unwrap_or_default();
        let good = match () {
            () if at < first || head.ends_with(['=', '+', '-', '−']) => 0,
            () if gap > 1 && !head.ends_with('→') && !head.ends_with(" or") => 3,
            () if depth == 0 && (head.ends_with([',', ';']) || goes_on(tail)) => 2,
            () if !UNITS.contains(&word) => 1,
            () => 0,
        };
        if best.is_none_or(|(than, _)| good >= than) {
            best = Some((good, at));
        }
    }
    best.map(|(_, at)| at)
}

/// Returns a label and its text, `label            text`, with continuation lines aligned to the
/// text.
pub fn labelled(label: &str, text: &str) -> String {
    labelled_from(17, label, text)
}

/// Returns a label and a text that begins at `column`, with continuation lines aligned to the text.
pub fn labelled_from(column: usize, label: &str, text: &str) -> String {
    let indent = " ".repeat(column);
    let mut lines = wrap(text, &indent, WIDTH).into_iter();
    let first = lines.next().unwrap_or_default();
    let gap = column.saturating_sub(width(label)).max(1);
    let head = format!("{label}{}{}\n", " ".repeat(gap), first.trim_start_matches(' '));
    head + &lines.map(|line| line + "\n").collect::<String>()
}

/// Aligns cells in columns: numbers at their decimal points, text at the left; two spaces between
/// columns.
pub fn columns(rows: &[Vec<String>]) -> Vec<String> {
    let count = rows.iter().map(Vec::len).max().unwrap_or(0);
    let shape = |cell: &String| {
        let numeric = is_number(cell);
        let point = if numeric { cell.find(['.', 'e']).unwrap_or(cell.len()) } else { 0 };
        (numeric, if numeric { width(&cell[..point]) } else { 0 }, width(cell))
    };
    let column = |k: usize| rows.iter().filter_map(move |row| row.get(k));
    // Size of each column: digits before the decimal point, characters after it, and width of the
    // widest cell.
    let sizes: Vec<(usize, usize)> = (0..count)
        .map(|k| {
            let before = column(k).map(shape).map(|(_, before, _)| before).max().unwrap_or(0);
            let after =
                column(k).map(shape).filter(|s| s.0).map(|(_, before, all)| all - before).max().unwrap_or(0);
            let text = column(k).map(shape).filter(|s| !s.0).map(|(_, _, all)| all).max().unwrap_or(0);
            (before, (before + after).max(text))
        })
        .collect();
    let lay = |row: &Vec<String>| {
        let cells = row.iter().zip(&sizes).map(|(cell, &(before, all))| {
            let (numeric, mine, width) = shape(cell);
            let left = if numeric { before - mine } else { 0 };
            format!("{}{cell}{}", " ".repeat(left), " ".repeat(all.saturating_sub(left + width)))
        });
        cells.collect::<Vec<_>>().join("  ").trim_end_matches(' ').to_owned()
    };
    rows.iter().map(lay).collect()
}

/// Returns the rows of a matrix, aligned, without brackets.
pub fn matrix_rows(rows: &[[f64; 3]; 3], digits: usize) -> Vec<String> {
    let cells = alike(rows.as_flattened(), digits);
    let rows: Vec<Vec<String>> = cells.chunks(3).map(<[String]>::to_vec).collect();
    let lines = columns(&rows);
    let longest = lines.iter().map(|line| width(line)).max().unwrap_or(0);
    lines.into_iter().map(|line| format!("{line}{}", " ".repeat(longest - width(&line)))).collect()
}

fn is_number(cell: &str) -> bool {
    cell.chars().any(|c| c.is_ascii_digit())
        && cell.chars().all(|c| c.is_ascii_digit() || matches!(c, '-' | '.' | 'e'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_align_by_their_points() {
        let rows =
            [["0.25", "a"], ["-12", "bcd"], ["3.5e-7", "—"]].map(|row| row.map(str::to_owned).to_vec());
        assert_eq!(columns(&rows), ["  0.25    a", "-12       bcd", "  3.5e-7  —"]);
    }

    #[test]
    fn wrapping_counts_what_is_seen() {
        assert_eq!(width("ω\u{307}1"), 2);
        assert_eq!(wrap("one two three", "  ", 9), ["  one two", "  three"]);
    }

    #[test]
    fn names_steer_no_terminal() {
        assert_eq!(printable("a\u{1b}[31mRED\nx"), "a\\u{1b}[31mRED\\nx");
        assert_eq!(
            printable("\u{202e}\u{2066}\u{200b}\u{85}\u{2028}"),
            r"\u{202e}\u{2066}\u{200b}\u{85}\u{2028}"
        );
        assert_eq!(printable_lines("a\u{1b}[2J\r\n\u{9b}b\tc\n"), "a\\u{1b}[2J\\r\n\\u{9b}b\tc\n");
        assert_eq!(printable("ω\u{307}, Größe, 慣性, 'C:\\x'"), "ω\u{307}, Größe, 慣性, 'C:\\x'");
    }

    #[test]
    fn long_lines_break_where_they_may() {
        let line = "L1 = 1·2 + 3·4 = 14 kg·m²/s";
        assert_eq!(broken(line, "", 27), [line]);
        assert_eq!(broken(line, "", 20), ["L1 = 1·2 + 3·4", "   = 14 kg·m²/s"]);
        assert_eq!(broken("a = b,   c = d + e", "  ", 17), ["  a = b,", "      c = d + e"]);
        assert_eq!(broken("p = (1, 2, 3) m, below", "", 20), ["p = (1, 2, 3) m,", "    below"]);
        assert_eq!(broken("unbreakable", "", 5), ["unbreakable"]);
    }
}
