//! The text of a mesh file, word by word: where the next one starts, and what to say if it is the wrong one.

use crate::content::{ContentError, ContentErrorKind, ContentPlace};

use crate::decimal;

/// A place in a text: `at` is the offset of the next byte.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scan<'a> {
    pub(super) bytes: &'a [u8],
    /// Up to the length of the text.
    pub(super) at: usize,
    /// `\n`; in a file without one, `\r`.
    line_end: u8,
}

impl<'a> Scan<'a> {
    /// At the first byte, or behind a byte order mark.
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        let at = if bytes.starts_with("\u{feff}".as_bytes()) { 3 } else { 0 };
        Self { bytes, at, line_end: if bytes.contains(&b'\n') { b'\n' } else { b'\r' } }
    }

    /// The same at another place.
    pub(super) const fn moved(self, at: usize) -> Self {
        Self { at, ..self }
    }

    /// The same in other bytes.
    pub(super) const fn within(self, bytes: &'a [u8], at: usize) -> Self {
        Self { bytes, at, ..self }
    }

    #[inline(always)]
    pub(super) fn is_done(&self) -> bool {
        self.at >= self.bytes.len()
    }

    /// The next byte; a line end behind the last one.
    #[inline(always)]
    pub(super) fn peek(&self) -> u8 {
        self.bytes.get(self.at).copied().unwrap_or(self.line_end)
    }

    /// Behind the blanks of this line, at the byte that it gives; a line that ends in `\` goes on in the next.
    #[inline(always)]
    pub(super) fn skip_blanks(&mut self) -> u8 {
        loop {
            let byte = self.peek();
            if byte > b' ' && byte != b'\\' || byte == self.line_end {
                return byte;
            }
            match if b" \t\r".contains(&byte) { 1 } else { self.rare_blank() } {
                0 => return byte,
                length => self.at += length,
            }
        }
    }

    /// The length of a blank that few files have, or of a `\` with its line end.
    #[cold]
    fn rare_blank(self) -> usize {
        match &self.bytes[self.at..] {
            [b'\\', b'\r', b'\n', ..] => 3,
            [b'\\', next, ..] if *next == self.line_end => 2,
            [first, ..] if *first != self.line_end && first.is_ascii_whitespace() || *first == 0x0b => 1,
            _ => 0,
        }
    }

    /// Whether the line has nothing more to say: its end, or a comment.
    #[inline(always)]
    pub(super) fn at_line_end(&mut self) -> bool {
        let byte = self.skip_blanks();
        byte == self.line_end || byte == b'#'
    }

    /// Whether a line ends at that byte.
    #[inline(always)]
    pub(super) fn is_line_end(&self, at: usize) -> bool {
        self.bytes.get(at) == Some(&self.line_end)
    }

    /// Behind the end of this line; gives what was left of it.
    #[inline]
    pub(super) fn line(&mut self) -> &'a [u8] {
        let end = find(self.bytes, self.at, self.line_end);
        let line = &self.bytes[self.at..end];
        self.at = (end + 1).min(self.bytes.len());
        line
    }

    /// Behind the end of this line and of those that it goes on in; a comment goes on in none.
    #[inline(always)]
    pub(super) fn skip_line(&mut self) {
        if self.bytes.get(self.at) == Some(&self.line_end) {
            self.at += 1;
        } else {
            *self = self.behind_line();
        }
    }

    #[inline(never)]
    fn behind_line(mut self) -> Self {
        loop {
            let line = self.line();
            if !line.trim_ascii_end().ends_with(b"\\") || line.contains(&b'#') || self.is_done() {
                return self;
            }
        }
    }

    /// Behind the blanks, line ends and comments.
    pub(super) fn skip_empty_lines(&mut self) {
        while !self.is_done() && self.at_line_end() {
            self.skip_line();
        }
    }

    /// Behind white space of every kind, line ends too.
    #[inline]
    pub(super) fn skip_space(&mut self) {
        while self.bytes.get(self.at).is_some_and(u8::is_ascii_whitespace) {
            self.at += 1;
        }
    }

    /// The run of bytes up to the next white space; empty at a line end.
    #[inline(always)]
    pub(super) fn word(&mut self) -> &'a [u8] {
        let start = self.at;
        while self.bytes.get(self.at).is_some_and(|b| *b > b' ') {
            self.at += 1;
        }
        &self.bytes[start..self.at]
    }

    /// The finite number that starts here.
    #[inline(always)]
    pub(super) fn float(&mut self, what: &str) -> Result<f64, ContentError> {
        match decimal::float(self.bytes, self.at) {
            Some((value, end)) if value.is_finite() && self.pass(end) => Ok(value),
            _ => Err(self.no_float(what)),
        }
    }

    /// The integer that starts here.
    #[inline(always)]
    pub(super) fn integer(&mut self, what: &str) -> Result<i64, ContentError> {
        match decimal::integer(self.bytes, self.at) {
            Some((value, end)) if self.pass(end) => Ok(value),
            _ => Err(self.expected(what)),
        }
    }

    /// Behind a word that ends here, if one does, and the blank that it ends with.
    #[inline(always)]
    pub(super) fn pass(&mut self, end: usize) -> bool {
        match self.bytes.get(end) {
            Some(b' ') => self.at = end + 1,
            Some(byte) if *byte > b' ' && *byte != b'\\' => return false,
            _ => self.at = end,
        }
        true
    }

    #[cold]
    fn no_float(self, what: &str) -> ContentError {
        let found = self.found();
        if found.parse::<f64>().is_ok() {
            let kind = ContentErrorKind::NotFinite { what: format!("the {what}"), found };
            return self
                .error(kind)
                .hint("the tool that made the mesh wrote no number here: repair it there");
        }
        let error = self.expected("a number");
        if found.contains(',') { error.hint("the decimal sign is a point") } else { error }
    }

    /// Something else stands here.
    #[cold]
    pub(super) fn expected(self, what: &str) -> ContentError {
        let found = self.found();
        let what = what.to_owned();
        let is_cut = found.is_empty() && self.bytes[self.at..].iter().all(|b| b" \t".contains(b));
        let found = if found.is_empty() && !is_cut { "the end of the line".to_owned() } else { found };
        let error = self.error(ContentErrorKind::Expected { what, found });
        if is_cut { error.hint("the file is cut short") } else { error }
    }

    /// Something is wrong with the word that starts here.
    #[cold]
    pub(super) fn error(self, kind: ContentErrorKind) -> ContentError {
        ContentError::new(kind, ContentPlace::Text(self.at..self.at + { self }.word().len()))
    }

    /// The word that starts here, not more of it than a message shows.
    pub(super) fn found(self) -> String {
        const MOST: usize = 256;
        let word = { self }.word();
        String::from_utf8_lossy(&word[..word.len().min(MOST)]).into_owned()
    }
}

/// The first `byte` at `start` or behind it; the length if there is none. Eight bytes at a time.
#[inline]
fn find(bytes: &[u8], start: usize, byte: u8) -> usize {
    const ONES: u64 = 0x0101_0101_0101_0101;
    let wanted = u64::from(byte) * ONES;
    let mut at = start;
    while at < bytes.len() {
        // The lowest zero of x is found surely: no borrow reaches it from below.
        let x = decimal::word(bytes, at) ^ wanted;
        let zeros = x.wrapping_sub(ONES) & !x & (0x80 * ONES);
        if zeros != 0 {
            return at + zeros.trailing_zeros() as usize / 8;
        }
        at += 8;
    }
    bytes.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_byte_is_found_wherever_it_stands() {
        for length in 0..40 {
            for place in 0..=length {
                let mut text = vec![b'\x0b'; length];
                text.iter_mut().skip(place).step_by(3).for_each(|b| *b = b'\n');
                for start in 0..=place {
                    assert_eq!(find(&text, start, b'\n'), place);
                }
                assert_eq!(find(&text, 0, b'\r'), length);
            }
        }
    }

    #[test]
    fn lines_go_on_behind_a_backslash() {
        let mut scan = Scan::new(b"\xef\xbb\xbfa \\\r\n\t b\\\n c # d\\\r\ne \\f\n");
        assert_eq!(scan.word(), b"a");
        assert!(!scan.at_line_end());
        scan.at -= 1;
        scan.skip_line();
        scan.skip_blanks();
        assert_eq!(scan.word(), b"e");
        assert!(!scan.at_line_end());
        assert_eq!(scan.word(), b"\\f");
        assert!(scan.at_line_end() && !scan.is_done());
        scan.skip_empty_lines();
        assert!(scan.is_done() && scan.line().is_empty() && scan.word().is_empty() && scan.at_line_end());
    }

    #[test]
    fn what_stands_there_is_said() {
        let message = |text: &str| Scan::new(text.as_bytes()).float("coordinate").unwrap_err().to_string();
        assert_eq!(message("1,5 2\n"), "byte 0: expected a number, found \"1,5\"");
        assert_eq!(message("-inf 2"), "byte 0: the coordinate -inf is not finite");
        assert_eq!(message("2e999\n"), "byte 0: the coordinate 2e999 is not finite");
        assert_eq!(message("\n2"), "byte 0: expected a number, found \"the end of the line\"");
        assert_eq!(message(" "), "byte 0: expected a number, found the end of the file");
    }
}
