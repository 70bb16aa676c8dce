//! Foreign text as messages print it.

/// Returns a visible substitute for a control character: a space or U+FFFD; other characters are
/// unchanged.
pub fn visible(c: char) -> char {
    match c {
        '\t' | '\n' | '\r' => ' ',
        c if is_unseen(c) => char::REPLACEMENT_CHARACTER,
        c => c,
    }
}

/// Returns the first 60 characters of a text, with an ellipsis if the text is longer.
pub fn cut(text: &str) -> String {
    const MOST: usize = 60;
    let more = text.chars().nth(MOST).map(|_| '…');
    text.chars().take(MOST).chain(more).collect()
}

/// Returns true if the bytes are UTF-16 text: they have its byte order mark, or every other one of
/// the first bytes is zero.
pub fn is_utf16(bytes: &[u8]) -> bool {
    const LOOKED_AT: usize = 64;
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return true;
    }
    let pairs: Vec<[u8; 2]> =
        bytes.chunks_exact(2).take(LOOKED_AT / 2).filter_map(|p| p.try_into().ok()).collect();
    let ascii = |byte: u8| byte.is_ascii_graphic() || byte.is_ascii_whitespace();
    pairs.len() >= 2
        && (pairs.iter().all(|[a, b]| ascii(*a) && *b == 0)
            || pairs.iter().all(|[a, b]| *a == 0 && ascii(*b)))
}

/// Returns the whole text on one line, with invisible characters escaped.
pub fn escaped(text: &str) -> String {
    let mut shown = String::new();
    for c in text.chars() {
        if is_unseen(c) { shown.extend(c.escape_default()) } else { shown.push(c) }
    }
    shown
}

/// Returns true for a character that controls the terminal, changes the text direction, or has no
/// width.
pub fn is_unseen(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{ad}' | '\u{61c}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}')
        || matches!(c, '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{e0000}'..='\u{e007f}')
}

/// Returns a count with its noun: "1 hole", "2 holes".
pub fn counted(count: usize, noun: &str) -> String {
    match count {
        1 => format!("1 {noun}"),
        many => format!("{many} {noun}s"),
    }
}
