//! Rows of numbers as base64: RFC 4648 §4, of little-endian numbers.

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Each number as an f64.
pub(crate) fn f64s(numbers: impl IntoIterator<Item = f64>) -> String {
    encode(numbers.into_iter().flat_map(f64::to_le_bytes))
}

/// Each number as an f32.
pub(crate) fn f32s(numbers: impl IntoIterator<Item = f32>) -> String {
    encode(numbers.into_iter().flat_map(f32::to_le_bytes))
}

/// Each number as a u32.
pub(crate) fn u32s(numbers: impl IntoIterator<Item = u32>) -> String {
    encode(numbers.into_iter().flat_map(u32::to_le_bytes))
}

/// Four digits for every three bytes.
pub(crate) fn encode(bytes: impl Iterator<Item = u8>) -> String {
    let mut text = String::new();
    let (mut held, mut count) = (0_u32, 0_u8);
    for byte in bytes {
        held = held << 8 | u32::from(byte);
        count += 1;
        if count == 3 {
            (0..4).for_each(|k| text.push(digit(held, k)));
            (held, count) = (0, 0);
        }
    }
    if count > 0 {
        held <<= 8 * (3 - count);
        (0..=count).for_each(|k| text.push(digit(held, k)));
        (count..3).for_each(|_| text.push('='));
    }
    text
}

/// The digit number `k` of 24 bits, from the left.
fn digit(bits: u32, k: u8) -> char {
    let index = bits >> (18 - 6 * k) & 63;
    DIGITS.get(index as usize).map_or('A', |&digit| char::from(digit))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_examples_of_rfc_4648_section_10() {
        for (bytes, text) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(encode(bytes.bytes()), text);
        }
    }

    #[test]
    fn numbers_are_little_endian() {
        // -2.5 = C004 0000 0000 0000
        assert_eq!(f64s([-2.5]), "AAAAAAAABMA=");
        // 1.5 = 3FC0 0000
        assert_eq!(f32s([1.5]), "AADAPw==");
        assert_eq!(u32s([0xFF00_0102]), "AgEA/w==");
    }
}
