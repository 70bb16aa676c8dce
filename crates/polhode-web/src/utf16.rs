//! Conversion between offsets in UTF-16 units, as in JavaScript, and in bytes.

/// Returns the offset in UTF-16 units of a byte; for a byte inside a character, that of the
/// character.
pub(crate) fn of_byte(text: &str, byte: usize) -> usize {
    text.char_indices().take_while(|(at, _)| *at < byte).map(|(_, c)| c.len_utf16()).sum()
}

/// Returns the byte of an offset in UTF-16 units, at most the end of the text.
pub(crate) fn to_byte(text: &str, offset: usize) -> usize {
    let mut units = 0;
    let found = text.char_indices().find(|(_, c)| {
        let here = units >= offset;
        units += c.len_utf16();
        here
    });
    found.map_or(text.len(), |(at, _)| at)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn offsets_go_there_and_back() {
        let text = "ω = 3 🜨 °";
        for (byte, _) in text.char_indices() {
            assert_eq!(to_byte(text, of_byte(text, byte)), byte);
        }
        assert_eq!((of_byte(text, 2), of_byte(text, text.len())), (1, text.encode_utf16().count()));
        assert_eq!(to_byte(text, 1000), text.len());
    }
}
