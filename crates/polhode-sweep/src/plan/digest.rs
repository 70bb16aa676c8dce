//! What a plan's results depend on, as one name.

use std::fmt::Write as _;

use polhode_scenario::read::Template;
use polhode_source::FormatError;
use polhode_source::files::Files;
use polhode_source::read_file;

use hmac_sha256::Hash as Sha256;

/// Counted up when members of the same plan become others.
const FORMAT: &str = "polhode plan 1";

/// SHA-256 of the format, the program's version, the text, and the files that the text names, each with its length before it; and of
/// the mass properties of each part, which know what is in the files that those files name.
pub(crate) fn digest(files: &dyn Files, template: &Template) -> Result<String, FormatError> {
    let mut hash = Sha256::new();
    let mut put = |bytes: &[u8]| {
        hash.update((bytes.len() as u64).to_le_bytes());
        hash.update(bytes);
    };
    put(FORMAT.as_bytes());
    put(env!("CARGO_PKG_VERSION").as_bytes());
    put(template.text().as_bytes());
    for file in template.files() {
        read_file(files, file, |bytes| {
            put(bytes);
            Ok(())
        })?;
    }
    for part in template.nominal().parts() {
        let [x, y, z] = part.properties.center_of_mass().to_array();
        let tensor = part.properties.inertia().matrix();
        for number in [part.properties.mass(), x, y, z].into_iter().chain(tensor.into_iter().flatten()) {
            put(&number.to_bits().to_le_bytes());
        }
    }
    let mut name = String::new();
    for byte in hash.finalize() {
        // Writing to a string does not fail.
        let _ = write!(name, "{byte:02x}");
    }
    Ok(name)
}
