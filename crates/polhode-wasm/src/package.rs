//! Functions of the modules of the npm package.

use polhode_source::files::Memory;

/// Functions without state: the files of a request are dropped with it.
#[derive(Default)]
pub(crate) struct Functions;

impl Functions {
    /// Returns the answer as the length of its JSON, a little-endian u64, the JSON, padded with
    /// spaces to a multiple of eight bytes, and the numbers, little-endian f64.
    pub(crate) fn answer(&self, request: &[u8], files: &mut Memory) -> Vec<u8> {
        let polhode_npm::Answer { mut json, numbers } = polhode_npm::answer(request, &std::mem::take(files));
        json.resize(json.len().next_multiple_of(size_of::<u64>()), b' ');
        let mut bytes = (json.len() as u64).to_le_bytes().to_vec();
        bytes.append(&mut json);
        bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
        bytes
    }
}
