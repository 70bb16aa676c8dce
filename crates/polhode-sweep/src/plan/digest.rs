//! Digest of everything that a plan's results depend on.

use std::fmt::Write as _;

use polhode_scenario::read::Template;
use polhode_source::FormatError;
use polhode_source::files::Files;
use polhode_source::read_file;

use hmac_sha256::Hash as Sha256;

/// Version of the drawing method; increase it when members of the same plan change.
const FORMAT: &str = "polhode plan 1";

/// Returns the SHA-256 hash of the format, the program's version, the plan's text, the files that
/// it names, and the mass properties of each part. Each item is preceded by its length. The mass
/// properties cover files that are named indirectly.
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
