//! Cells as programs write nearly all of them: `<c r="F12" s="3"><v>0.25</v></c>`.
//!
//! Read by their bytes they halve the time of a large workbook. A cell that is written otherwise, or is cut off by the end of the bytes, is none here:
//! the reader of XML has it then, and says what is wrong with it.

/// A cell, as it is written.
pub(crate) struct PlainCell<'b> {
    /// `F12`
    pub name: &'b str,
    pub style: Option<&'b str>,
    pub kind: &'b str,
    pub formula: Option<&'b str>,
    pub text: &'b str,
    /// Whether the text is an element of its own, and no value.
    pub is_text: bool,
}

/// The cell that bytes begin with, and the bytes behind it.
pub(crate) fn cell(bytes: &[u8]) -> Option<(PlainCell<'_>, &[u8])> {
    let (name, rest) = word(bytes.trim_ascii_start().strip_prefix(b"<c r=\"")?)?;
    let (style, rest) = optional(rest, b" s=\"", word)?;
    let (kind, rest) = optional(rest, b" t=\"", word)?;
    let rest = rest.strip_prefix(b">")?;
    let (formula, rest) = optional(rest, b"<f>", |rest| closed(rest, b"</f>"))?;
    let (value, rest) = optional(rest, b"<v>", |rest| closed(rest, b"</v></c>"))?;
    let (text, rest) = match value {
        Some(text) => (text, rest),
        None => closed(rest.strip_prefix(b"<is><t>")?, b"</t></is></c>")?,
    };
    let kind = kind.unwrap_or_default();
    Some((PlainCell { name, style, kind, formula, text, is_text: value.is_none() }, rest))
}

type Read<'b> = Option<(&'b str, &'b [u8])>;

/// What is read behind an opening, if that is there.
fn optional<'b>(
    bytes: &'b [u8],
    open: &[u8],
    read: impl Fn(&'b [u8]) -> Read<'b>,
) -> Option<(Option<&'b str>, &'b [u8])> {
    match bytes.strip_prefix(open) {
        Some(rest) => read(rest).map(|(text, rest)| (Some(text), rest)),
        None => Some((None, bytes)),
    }
}

/// Letters and digits up to a quote.
fn word(bytes: &[u8]) -> Read<'_> {
    let length = bytes.iter().position(|b| !b.is_ascii_alphanumeric())?;
    let (word, rest) = bytes.split_at(length);
    Some((str::from_utf8(word).ok()?, rest.strip_prefix(b"\"")?))
}

/// A text without entities, up to what closes it.
fn closed<'b>(bytes: &'b [u8], close: &[u8]) -> Read<'b> {
    let length = bytes.iter().position(|b| matches!(b, b'<' | b'&'))?;
    let (text, rest) = bytes.split_at(length);
    Some((str::from_utf8(text).ok()?, rest.strip_prefix(close)?))
}
