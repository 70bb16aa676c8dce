//! Rows of little-endian numbers as base64 (RFC 4648 §4).

use base64::prelude::{BASE64_STANDARD, Engine as _};

/// Encodes numbers as f64.
pub(crate) fn f64s(numbers: impl IntoIterator<Item = f64>) -> String {
    arrays(numbers.into_iter().map(f64::to_le_bytes))
}

/// Encodes numbers as f32.
pub(crate) fn f32s(numbers: impl IntoIterator<Item = f32>) -> String {
    arrays(numbers.into_iter().map(f32::to_le_bytes))
}

/// Encodes numbers as u32.
pub(crate) fn u32s(numbers: impl IntoIterator<Item = u32>) -> String {
    arrays(numbers.into_iter().map(u32::to_le_bytes))
}

fn arrays<const N: usize>(arrays: impl Iterator<Item = [u8; N]>) -> String {
    BASE64_STANDARD.encode(arrays.collect::<Vec<_>>().as_flattened())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_little_endian() {
        // The bytes of -2.5 are C004 0000 0000 0000.
        assert_eq!(f64s([-2.5]), "AAAAAAAABMA=");
        // The bytes of 1.5 are 3FC0 0000.
        assert_eq!(f32s([1.5]), "AADAPw==");
        assert_eq!(u32s([0xFF00_0102]), "AgEA/w==");
    }
}
