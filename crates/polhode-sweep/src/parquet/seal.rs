//! Checksum of a whole file, stored in the file: CRC-32 with zeros in place of the checksum.
//!
//! It is the last entry of the metadata, and is located without parsing, because a damaged file
//! must not be parsed.

/// Text before the checksum.
const MARK: &[u8] = b"crc32:";
/// Placeholder before the checksum is known.
pub(super) const OPEN: &str = "crc32:00000000";
const DIGITS: usize = 8;

/// Writes the checksum in its place; returns false if the place is missing.
pub(super) fn close(file: &mut [u8]) -> bool {
    let Some(digits) = digits(file) else { return false };
    let sum = sum(file, &digits);
    let Some(place) = file.get_mut(digits) else { return false };
    place.copy_from_slice(sum.as_bytes());
    true
}

/// Returns true if the checksum matches the file.
pub(super) fn is_right(file: &[u8]) -> bool {
    digits(file).is_some_and(|digits| file.get(digits.clone()) == Some(sum(file, &digits).as_bytes()))
}

/// Returns the place of the digits.
fn digits(file: &[u8]) -> Option<std::ops::Range<usize>> {
    let first = file.windows(MARK.len()).rposition(|window| window == MARK)? + MARK.len();
    (first + DIGITS <= file.len()).then_some(first..first + DIGITS)
}

/// Returns the checksum with zeros in its place, as eight hexadecimal digits.
fn sum(file: &[u8], digits: &std::ops::Range<usize>) -> String {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(file.get(..digits.start).unwrap_or_default());
    hasher.update(&[b'0'; DIGITS]);
    hasher.update(file.get(digits.end..).unwrap_or_default());
    format!("{:08x}", hasher.finalize())
}
