//! Rows of numbers that follow the JSON of an answer.

use serde::Serialize;

/// Beginning and length of a row, both counted in numbers of its type.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Row {
    F32([usize; 2]),
    U32([usize; 2]),
}

/// Little-endian numbers of four bytes, row after row.
#[derive(Debug, Default)]
pub(crate) struct Rows(Vec<u8>);

impl Rows {
    pub(crate) fn f32s(&mut self, numbers: impl ExactSizeIterator<Item = f32>) -> Row {
        Row::F32(self.put(numbers.map(f32::to_le_bytes)))
    }

    pub(crate) fn u32s(&mut self, numbers: impl ExactSizeIterator<Item = u32>) -> Row {
        Row::U32(self.put(numbers.map(u32::to_le_bytes)))
    }

    pub(crate) fn into_bytes(self) -> Vec<u8> {
        self.0
    }

    fn put<const N: usize>(&mut self, numbers: impl ExactSizeIterator<Item = [u8; N]>) -> [usize; 2] {
        let (at, count) = (self.0.len(), numbers.len());
        self.0.resize(at + N * count, 0);
        // Writes into existing places: for a large mesh this is a copy, instead of a push for each
        // number.
        let (places, _) = self.0[at..].as_chunks_mut();
        places.iter_mut().zip(numbers).for_each(|(place, number)| *place = number);
        [at / N, count]
    }
}
