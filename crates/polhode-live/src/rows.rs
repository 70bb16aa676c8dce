//! Rows of numbers that stand behind the JSON of an answer.

use bytes::Bytes;
use serde::Serialize;

/// Where a row begins, and how many numbers it has, counted in them.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Row {
    F32([usize; 2]),
    U32([usize; 2]),
}

/// Little-endian numbers of four bytes, one row after the other.
#[derive(Debug, Default)]
pub(crate) struct Rows(Vec<u8>);

impl Rows {
    pub(crate) fn f32s(&mut self, numbers: impl IntoIterator<Item = f32>) -> Row {
        Row::F32(self.put(numbers.into_iter().map(f32::to_le_bytes)))
    }

    pub(crate) fn u32s(&mut self, numbers: impl IntoIterator<Item = u32>) -> Row {
        Row::U32(self.put(numbers.into_iter().map(u32::to_le_bytes)))
    }

    pub(crate) fn into_bytes(self) -> Bytes {
        self.0.into()
    }

    fn put<const N: usize>(&mut self, numbers: impl Iterator<Item = [u8; N]>) -> [usize; 2] {
        let at = self.0.len();
        self.0.reserve(N * numbers.size_hint().0);
        numbers.for_each(|number| self.0.extend_from_slice(&number));
        [at / N, (self.0.len() - at) / N]
    }
}
