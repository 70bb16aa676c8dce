//! Tokens of USD text.

use polhode_source::{ContentError, ContentErrorKind};

use super::array;
use crate::model::Span;

/// Token with its position, without quotes.
#[derive(Debug)]
pub(super) struct Token<'s> {
    pub(super) kind: TokenKind<'s>,
    pub(super) span: Span,
    /// True if it is the first token on its line.
    pub(super) begins_line: bool,
}

#[derive(Debug, PartialEq, Eq)]
pub(super) enum TokenKind<'s> {
    /// Name with colons and points: `physics:mass`.
    Word(&'s str),
    /// Token that begins like a number, even if it is malformed.
    Number(&'s str),
    /// Text in quotes.
    Text(&'s str),
    /// Path in `<>`.
    Path(&'s str),
    /// Asset in `@@`.
    Asset(&'s str),
    /// Array of numbers with its brackets, not split into tokens.
    Array(&'s str),
    /// Any other character.
    Mark(char),
}

impl Token<'_> {
    pub(super) fn is(&self, mark: char) -> bool {
        self.kind == TokenKind::Mark(mark)
    }
}

impl TokenKind<'_> {
    pub(super) fn in_words(&self) -> String {
        match self {
            Self::Word(text)
            | Self::Number(text)
            | Self::Text(text)
            | Self::Path(text)
            | Self::Asset(text) => (*text).to_owned(),
            Self::Array(_) => "[".to_owned(),
            Self::Mark(mark) => mark.to_string(),
        }
    }
}

/// Splits a text into tokens; comments are skipped.
pub(super) fn tokens(text: &str) -> Result<Vec<Token<'_>>, ContentError> {
    let mut tokens: Vec<Token<'_>> = Vec::new();
    let (mut at, mut begins_line) = (0, true);
    while let Some(rest) = text.get(at..)
        && let Some(first) = rest.chars().next()
    {
        if first.is_whitespace() || first == '\u{feff}' {
            begins_line |= first == '\n' || first == '\r';
            at += first.len_utf8();
            continue;
        }
        if first == '#' {
            at += rest.find(['\n', '\r']).unwrap_or(rest.len());
            continue;
        }
        if let ('[', [.., name, equals]) = (first, tokens.as_slice())
            && let (true, TokenKind::Word(name)) = (equals.is('='), &name.kind)
            && let Some(length) = array::length(name, rest)
        {
            let kind = TokenKind::Array(rest.get(..length).unwrap_or_default());
            tokens.push(Token { kind, span: at..at + length, begins_line });
            begins_line = false;
            at += length;
            continue;
        }
        // Opening and closing delimiters of texts.
        let quoted = [
            ("\"\"\"", "\"\"\""),
            ("'''", "'''"),
            ("\"", "\""),
            ("'", "'"),
            ("@@@", "@@@"),
            ("@", "@"),
            ("<", ">"),
        ];
        let quoted = quoted.into_iter().find(|(opening, _)| rest.starts_with(opening));
        let (kind, span, length) = if let Some((opening, closing)) = quoted {
            let inner = rest.get(opening.len()..).unwrap_or("");
            let length = length_before(inner, closing).ok_or_else(|| {
                ContentErrorKind::expected(format!("the closing {closing}"), "").at(at..at + opening.len())
            })?;
            let words = inner.get(..length).unwrap_or("");
            let kind = match opening {
                "<" => TokenKind::Path(words),
                "@" | "@@@" => TokenKind::Asset(words),
                _ => TokenKind::Text(words),
            };
            let start = at + opening.len();
            (kind, start..start + length, opening.len() + length + closing.len())
        } else {
            let length = word_length(rest);
            let words = rest.get(..length).unwrap_or("");
            let is_number =
                first.is_ascii_digit() || matches!(first, '+' | '-' | '.') || matches!(words, "inf" | "nan");
            let kind = match length {
                0 => TokenKind::Mark(first),
                _ if is_number => TokenKind::Number(words),
                _ => TokenKind::Word(words),
            };
            let length = length.max(first.len_utf8());
            (kind, at..at + length, length)
        };
        tokens.push(Token { kind, span, begins_line });
        begins_line = false;
        at += length;
    }
    Ok(tokens)
}

/// Returns the number of bytes before the closing delimiter. A backslash escapes the next
/// character.
fn length_before(inner: &str, closing: &str) -> Option<usize> {
    let mut from = 0;
    loop {
        let found = from + inner.get(from..)?.find(closing)?;
        let slashes = inner.get(..found)?.bytes().rev().take_while(|byte| *byte == b'\\').count();
        if slashes % 2 == 0 || closing == ">" {
            return Some(found);
        }
        from = found + closing.len();
    }
}

/// Returns the length of a name or number in bytes. A sign may begin a number or its exponent.
fn word_length(rest: &str) -> usize {
    let numeric = rest.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '+' | '-' | '.'));
    let mut before = ' ';
    for (at, c) in rest.char_indices() {
        let sign = matches!(c, '+' | '-') && (at == 0 || numeric && matches!(before, 'e' | 'E'));
        let bang = c == '!' && at == 0;
        if !(c.is_alphanumeric() || matches!(c, '_' | ':' | '.') || sign || bang) {
            return at;
        }
        before = c;
    }
    rest.len()
}
