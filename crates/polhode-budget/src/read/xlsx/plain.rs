//! Cells in the form in which programs write nearly all of them:
//! `<c r="F12" s="3"><v>0.25</v></c>`.
//!
//! Direct parsing of the bytes halves the time for a large workbook. Cells in another form, or cut
//! off at the end of the bytes, are left to the XML reader, which also reports their errors.

/// Cell as it is written.
pub(crate) struct PlainCell<'b> {
    /// Name of the cell, such as `F12`.
    pub name: &'b str,
    pub style: Option<&'b str>,
    pub kind: &'b str,
    pub formula: Option<&'b str>,
    pub text: &'b str,
    /// True if the text is in an element of its own, not a value.
    pub is_text: bool,
}

/// Parses the cell at the start of the bytes, and returns the remaining bytes.
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

/// Reads what follows an opening tag, if the tag is there.
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

/// Reads letters and digits up to a quote.
fn word(bytes: &[u8]) -> Read<'_> {
    let length = bytes.iter().position(|b| !b.is_ascii_alphanumeric())?;
    let (word, rest) = bytes.split_at(length);
    Some((str::from_utf8(word).ok()?, rest.strip_prefix(b"\"")?))
}

/// Reads text without entities up to its closing tag.
fn closed<'b>(bytes: &'b [u8], close: &[u8]) -> Read<'b> {
    let length = bytes.iter().position(|b| matches!(b, b'<' | b'&'))?;
    let (text, rest) = bytes.split_at(length);
    Some((str::from_utf8(text).ok()?, rest.strip_prefix(close)?))
}
