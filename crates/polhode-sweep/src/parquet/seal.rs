//! A checksum of a whole file, within the file: CRC-32 with zeros in its own place.
//!
//! It stands last among the metadata, and is found without reading the file as Parquet: a damaged file is not to be trusted with
//! that.

/// What the checksum stands after.
const MARK: &[u8] = b"crc32:";
/// The value before it is known.
pub(super) const OPEN: &str = "crc32:00000000";
const DIGITS: usize = 8;

/// Puts the checksum in its place; false if there is none.
pub(super) fn close(file: &mut [u8]) -> bool {
    let Some(digits) = digits(file) else { return false };
    let sum = sum(file, &digits);
    let Some(place) = file.get_mut(digits) else { return false };
    place.copy_from_slice(sum.as_bytes());
    true
}

/// True if the checksum is that of the file.
pub(super) fn is_right(file: &[u8]) -> bool {
    digits(file).is_some_and(|digits| file.get(digits.clone()) == Some(sum(file, &digits).as_bytes()))
}

/// Where the digits are.
fn digits(file: &[u8]) -> Option<std::ops::Range<usize>> {
    let first = file.windows(MARK.len()).rposition(|window| window == MARK)? + MARK.len();
    (first + DIGITS <= file.len()).then_some(first..first + DIGITS)
}

/// The checksum with zeros in its place: eight hexadecimal digits.
fn sum(file: &[u8], digits: &std::ops::Range<usize>) -> String {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(file.get(..digits.start).unwrap_or_default());
    hasher.update(&[b'0'; DIGITS]);
    hasher.update(file.get(digits.end..).unwrap_or_default());
    format!("{:08x}", hasher.finalize())
}
