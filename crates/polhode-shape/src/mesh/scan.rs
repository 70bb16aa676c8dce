//! Tokenizer for the text of a mesh file: finds the next word, and creates errors with its place.

use polhode_source::{ContentError, ContentErrorKind};

/// Position in a text: `at` is the offset of the next byte.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scan<'a> {
    pub bytes: &'a [u8],
    /// Offset of the next byte, at most the length of the text.
    pub at: usize,
    /// Line end: `\n`; in a file without any, `\r`.
    line_end: u8,
}

impl<'a> Scan<'a> {
    /// Starts at the first byte, or after a byte order mark.
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        let at = if bytes.starts_with("\u{feff}".as_bytes()) { 3 } else { 0 };
        Self { bytes, at, line_end: if bytes.contains(&b'\n') { b'\n' } else { b'\r' } }
    }

    /// Returns the scan at another offset.
    pub(crate) const fn moved(self, at: usize) -> Self {
        Self { at, ..self }
    }

    /// Returns the scan of different bytes.
    pub(crate) const fn within(self, bytes: &'a [u8], at: usize) -> Self {
        Self { bytes, at, ..self }
    }

    #[inline(always)]
    pub(crate) fn is_done(&self) -> bool {
        self.at >= self.bytes.len()
    }

    /// Returns the next byte; at the end of the text, a line end.
    #[inline(always)]
    pub(crate) fn peek(&self) -> u8 {
        self.bytes.get(self.at).copied().unwrap_or(self.line_end)
    }

    /// Skips blanks of this line and returns the next byte. A line that ends in `\` continues in
    /// the next.
    #[inline(always)]
    pub(crate) fn skip_blanks(&mut self) -> u8 {
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

    /// Returns the length of a rare blank, or of a `\` with its line end.
    #[cold]
    fn rare_blank(self) -> usize {
        match &self.bytes[self.at..] {
            [b'\\', b'\r', b'\n', ..] => 3,
            [b'\\', next, ..] if *next == self.line_end => 2,
            [first, ..] if *first != self.line_end && first.is_ascii_whitespace() || *first == 0x0b => 1,
            _ => 0,
        }
    }

    /// Returns true at the end of the line or at a comment.
    #[inline(always)]
    pub(crate) fn at_line_end(&mut self) -> bool {
        let byte = self.skip_blanks();
        byte == self.line_end || byte == b'#'
    }

    /// Returns true if a line ends at this byte.
    #[inline(always)]
    pub(crate) fn is_line_end(&self, at: usize) -> bool {
        self.bytes.get(at) == Some(&self.line_end)
    }

    /// Returns the rest of the line, and moves to the next line.
    #[inline]
    pub(crate) fn line(&mut self) -> &'a [u8] {
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(|b| *b == self.line_end).unwrap_or(rest.len());
        let (line, end) = (&rest[..length], self.at + length);
        self.at = (end + 1).min(self.bytes.len());
        line
    }

    /// Moves to the line after this one and its continuations. A comment has no continuation.
    #[inline(always)]
    pub(crate) fn skip_line(&mut self) {
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

    /// Skips blanks, line ends and comments.
    pub(crate) fn skip_empty_lines(&mut self) {
        while !self.is_done() && self.at_line_end() {
            self.skip_line();
        }
    }

    /// Skips white space of every kind, including line ends.
    #[inline]
    pub(crate) fn skip_space(&mut self) {
        while self.bytes.get(self.at).is_some_and(u8::is_ascii_whitespace) {
            self.at += 1;
        }
    }

    /// Returns the bytes up to the next white space; empty at a line end.
    #[inline(always)]
    pub(crate) fn word(&mut self) -> &'a [u8] {
        let start = self.at;
        while self.bytes.get(self.at).is_some_and(|b| *b > b' ') {
            self.at += 1;
        }
        &self.bytes[start..self.at]
    }

    /// Reads a finite number.
    #[inline(always)]
    pub(crate) fn float(&mut self, what: &str) -> Result<f64, ContentError> {
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(|b| ends_number(*b)).unwrap_or(rest.len());
        match str::from_utf8(&rest[..length]).ok().and_then(|number| number.parse::<f64>().ok()) {
            Some(value) if value.is_finite() => {
                self.pass(self.at + length);
                Ok(value)
            }
            _ => Err(self.no_float(what)),
        }
    }

    /// Reads an integer.
    #[inline(always)]
    pub(crate) fn integer(&mut self, what: &str) -> Result<i64, ContentError> {
        match integer(self.bytes, self.at) {
            Some((value, end)) if self.pass(end) => Ok(value),
            _ => Err(self.expected(what)),
        }
    }

    /// Moves past a word that ends at `end`, and one blank after it. Returns false if the word does
    /// not end there.
    #[inline(always)]
    pub(crate) fn pass(&mut self, end: usize) -> bool {
        match self.bytes.get(end) {
            Some(b' ') => self.at = end + 1,
            Some(byte) if !ends_number(*byte) => return false,
            _ => self.at = end,
        }
        true
    }

    #[cold]
    fn no_float(self, what: &str) -> ContentError {
        let found = self.found();
        if found.parse::<f64>().is_ok() {
            return self
                .error(ContentErrorKind::not_finite(format!("the {what}"), found))
                .hint("the program that created the mesh wrote an invalid number: fix it there");
        }
        let error = self.expected("a number");
        if found.contains(',') { error.hint("use a decimal point") } else { error }
    }

    /// Returns the error for an unexpected word.
    #[cold]
    pub(crate) fn expected(self, what: &str) -> ContentError {
        let found = self.found();
        let what = what.to_owned();
        let is_cut = found.is_empty() && self.bytes[self.at..].iter().all(|b| b" \t".contains(b));
        let found = if found.is_empty() && !is_cut { "the end of the line".to_owned() } else { found };
        let error = self.error(ContentErrorKind::expected(what, found));
        if is_cut { error.hint("the file is truncated") } else { error }
    }

    /// Returns an error at the next word.
    #[cold]
    pub(crate) fn error(self, kind: ContentErrorKind) -> ContentError {
        kind.at(self.at..self.at + { self }.word().len())
    }

    /// Returns the next word, shortened for messages.
    pub(crate) fn found(self) -> String {
        const MOST: usize = 256;
        let word = { self }.word();
        String::from_utf8_lossy(&word[..word.len().min(MOST)]).into_owned()
    }
}

/// Returns true for a byte that ends a number: white space, or the `\` of a continued line.
#[inline(always)]
const fn ends_number(byte: u8) -> bool {
    byte <= b' ' || byte == b'\\'
}

/// Reads the integer that starts at `start`. Returns it, saturated at ±`i64::MAX`, and the offset
/// of the next byte.
#[inline(always)]
pub(crate) fn integer(bytes: &[u8], start: usize) -> Option<(i64, usize)> {
    let sign = bytes.get(start);
    let first = start + usize::from(matches!(sign, Some(b'+' | b'-')));
    let (mut magnitude, mut end) = (0_i64, first);
    while let Some(digit @ b'0'..=b'9') = bytes.get(end) {
        magnitude = magnitude.saturating_mul(10).saturating_add(i64::from(digit - b'0'));
        end += 1;
    }
    (end > first).then(|| (if sign == Some(&b'-') { -magnitude } else { magnitude }, end))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_finite_decimals_that_end_with_the_word_are_numbers() {
        let read = |text: &str| {
            let mut scan = Scan::new(text.as_bytes());
            scan.float("coordinate").ok().map(|value| (value, scan.at))
        };
        for (number, value) in [
            ("1.", 1.0),
            (".5", 0.5),
            ("+1", 1.0),
            ("-0.25", -0.25),
            ("1e5", 1e5),
            ("1.5E-03", 1.5e-3),
            ("1e-999", 0.0),
        ] {
            for (end, length) in [("", 0), (" 2", 1), ("\t2", 0), ("\n", 0), ("\\\n2", 0), ("\0", 0)] {
                let text = format!("{number}{end}");
                assert_eq!(read(&text), Some((value, number.len() + length)), "{text:?}");
            }
        }
        for text in [
            "", "-", "+", ".", "-.", "e5", "x", "nan", "inf", "-inf", "infinity", "1e", "1e+", "1.5e-",
            "--1", "+-1", " 1", "1e999", "0x10", "1_000", "1.5.2", "1,5", "1/2", "1#", "1f64", "１",
        ] {
            assert_eq!(read(text), None, "{text:?}");
        }
    }

    #[test]
    fn integers_end_before_the_first_other_byte_and_saturate() {
        let read = |text: &str| integer(text.as_bytes(), 0);
        assert_eq!(read("-120345/7"), Some((-120_345, 7)));
        assert_eq!(read("+123456789012345678 "), Some((123_456_789_012_345_678, 19)));
        assert_eq!(read("000000000000000000000042"), Some((42, 24)));
        assert_eq!(read("-99999999999999999999"), Some((-i64::MAX, 21)));
        for text in ["", "-", "/", "a1", ":1", "+-1"] {
            assert_eq!(read(text), None, "{text:?}");
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
