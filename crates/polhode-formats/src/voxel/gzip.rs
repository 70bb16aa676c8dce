//! Compressed voxels.

use std::io::{ErrorKind, Read};

use flate2::read::MultiGzDecoder;

use crate::content::{ContentError, ContentErrorKind, ContentPlace};

/// The `declared` bytes behind the first `skip` of what `data`, from byte `start` of the file, decompress to.
///
/// Memory grows with the bytes that come out, not with those that are declared, and no more than one beyond the
/// declared ones is taken. All that was written is read, so that its check sum is compared.
pub(super) fn inflated(data: &[u8], start: usize, skip: u64, declared: u64) -> Result<Vec<u8>, ContentError> {
    let place = || ContentPlace::Byte { offset: start as u64, what: "the compressed voxels".to_owned() };
    let mut decoder = MultiGzDecoder::new(data);
    let count = |declared: u64, present: u64, hint: &str| {
        let kind = ContentErrorKind::Count { what: "bytes of voxels".to_owned(), declared, present };
        ContentError::new(kind, place()).hint(hint.to_owned())
    };
    let broken = |error: &std::io::Error, present: u64| match error.kind() {
        ErrorKind::UnexpectedEof => count(declared, present, "the compressed data are cut short"),
        _ => {
            let what = "data that gzip has compressed".to_owned();
            ContentError::new(ContentErrorKind::Expected { what, found: error.to_string() }, place())
                .hint("the file is damaged: save it again, or with the encoding raw")
        }
    };
    std::io::copy(&mut decoder.by_ref().take(skip), &mut std::io::sink()).map_err(|e| broken(&e, 0))?;
    let mut bytes = Vec::new();
    // One more than declared, to notice that there is more.
    let read = decoder.take(declared.saturating_add(1)).read_to_end(&mut bytes);
    let present = bytes.len() as u64;
    read.map_err(|error| broken(&error, present))?;
    if present > declared {
        return Err(count(declared, present, "the compressed data hold more bytes than the sizes say"));
    }
    Ok(bytes)
}
