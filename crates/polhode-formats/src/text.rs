//! Text of others, as messages print it.

/// A character of one column that leaves the terminal and the direction of the text alone.
pub(crate) fn visible(c: char) -> char {
    match c {
        '\t' | '\n' | '\r' => ' ',
        c if is_unseen(c) => char::REPLACEMENT_CHARACTER,
        c => c,
    }
}

/// The start of a text, and a mark if that is not all of it.
pub(crate) fn cut(text: &str) -> String {
    const MOST: usize = 60;
    let more = text.chars().nth(MOST).map(|_| '…');
    text.chars().take(MOST).chain(more).collect()
}

/// The whole text on one line: what cannot be seen is escaped.
pub(crate) fn escaped(text: &str) -> String {
    let mut shown = String::new();
    for c in text.chars() {
        if is_unseen(c) { shown.extend(c.escape_default()) } else { shown.push(c) }
    }
    shown
}

/// Whether a character controls the terminal, turns the text around, or has no width.
fn is_unseen(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{ad}' | '\u{61c}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}')
        || matches!(c, '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{e0000}'..='\u{e007f}')
}
