//! Rows of numbers as base64: RFC 4648 §4, of little-endian numbers.

const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Each number as an f64.
pub(crate) fn f64s(numbers: impl IntoIterator<Item = f64>) -> String {
    arrays(numbers.into_iter().map(f64::to_le_bytes))
}

/// Each number as an f32.
pub(crate) fn f32s(numbers: impl IntoIterator<Item = f32>) -> String {
    arrays(numbers.into_iter().map(f32::to_le_bytes))
}

/// Each number as a u32.
pub(crate) fn u32s(numbers: impl IntoIterator<Item = u32>) -> String {
    arrays(numbers.into_iter().map(u32::to_le_bytes))
}

fn arrays<const N: usize>(arrays: impl Iterator<Item = [u8; N]>) -> String {
    encode(arrays.collect::<Vec<_>>().as_flattened())
}

/// Four digits for every three bytes.
pub(crate) fn encode(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    let (threes, rest) = bytes.as_chunks::<3>();
    for &[a, b, c] in threes {
        text.extend(digits([a, b, c]));
    }
    match *rest {
        [a, b] => text.extend(digits([a, b, 0]).into_iter().take(3).chain(['='])),
        [a] => text.extend(digits([a, 0, 0]).into_iter().take(2).chain(['=', '='])),
        _ => {}
    }
    text
}

/// The four digits of 24 bits, six bits each, from the left.
fn digits([a, b, c]: [u8; 3]) -> [char; 4] {
    let bits = u32::from_be_bytes([0, a, b, c]);
    [18, 12, 6, 0].map(|shift| char::from(DIGITS[(bits >> shift & 63) as usize]))
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
            assert_eq!(encode(bytes.as_bytes()), text);
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
