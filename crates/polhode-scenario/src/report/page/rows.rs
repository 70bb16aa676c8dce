//! Storage of long rows of numbers: in the JSON of a page, or outside it.

use serde_json::{Value, json};

use super::packed::f64s;
/// Rows of f64: as base64 in the JSON, or as bytes outside it.
#[derive(Debug)]
pub(crate) enum Rows {
    /// Base64 in the JSON, for a page that is a single file.
    Inside,
    /// Little-endian bytes of all rows. The JSON has `{"f64": [start, count]}`, in units of
    /// numbers.
    Beside(Vec<u8>),
}

impl Rows {
    /// Stores a row; returns its value in the JSON.
    pub(crate) fn put(&mut self, numbers: impl IntoIterator<Item = f64>) -> Value {
        match self {
            Self::Inside => f64s(numbers).into(),
            Self::Beside(bytes) => {
                let at = bytes.len();
                numbers.into_iter().for_each(|x| bytes.extend_from_slice(&x.to_le_bytes()));
                json!({ "f64": [at / size_of::<f64>(), (bytes.len() - at) / size_of::<f64>()] })
            }
        }
    }

    /// Returns the bytes outside the JSON.
    pub(crate) fn bytes(self) -> Vec<u8> {
        match self {
            Self::Inside => Vec::new(),
            Self::Beside(bytes) => bytes,
        }
    }

    /// Returns the number of bytes outside the JSON.
    pub(crate) const fn beside(&self) -> usize {
        match self {
            Self::Inside => 0,
            Self::Beside(bytes) => bytes.len(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_beside_the_json_is_named_by_its_place() {
        let mut rows = Rows::Beside(Vec::new());
        assert_eq!(rows.put([0.3, -2.5]), json!({ "f64": [0, 2] }));
        assert_eq!(rows.put([]), json!({ "f64": [2, 0] }));
        assert_eq!(rows.put([f64::MIN_POSITIVE]), json!({ "f64": [2, 1] }));
        let wanted: Vec<u8> = [0.3, -2.5, f64::MIN_POSITIVE].into_iter().flat_map(f64::to_le_bytes).collect();
        assert_eq!((rows.beside(), rows.bytes()), (24, wanted));
        assert_eq!(Rows::Inside.put([-2.5]), json!("AAAAAAAABMA="));
    }
}
