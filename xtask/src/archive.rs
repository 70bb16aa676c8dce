//! Reproducible archives: their bytes depend on the packed files only.
//!
//! Files are sorted, have one time and one owner, and contain nothing from this machine.

use std::io::{Cursor, Write as _};

use flate2::{Compression, GzBuilder};
use hmac_sha256::Hash as Sha256;
use zip::write::{SimpleFileOptions, ZipWriter};

/// File to be packed.
#[derive(Debug, Clone)]
pub(crate) struct Packed {
    /// Path in the archive, with slashes.
    pub(crate) path: String,
    pub(crate) is_program: bool,
    pub(crate) bytes: Vec<u8>,
}

impl Packed {
    fn mode(&self) -> u32 {
        if self.is_program { 0o755 } else { 0o644 }
    }
}

/// Returns a `.tar.gz` in ustar format; every file has the time `seconds` after 1970, and belongs
/// to root.
pub(crate) fn tar_gz(files: &[Packed], seconds: u64) -> Result<Vec<u8>, String> {
    let mut out = GzBuilder::new().write(Vec::new(), Compression::best());
    let failed = |error: std::io::Error| error.to_string();
    for file in in_order(files) {
        out.write_all(&header(file, seconds)?).map_err(failed)?;
        out.write_all(&file.bytes).map_err(failed)?;
        out.write_all(&vec![0; file.bytes.len().next_multiple_of(BLOCK) - file.bytes.len()])
            .map_err(failed)?;
    }
    out.write_all(&[0; 2 * BLOCK]).map_err(failed)?;
    out.finish().map_err(failed)
}

/// Returns a `.zip`.
///
/// Its files have the earliest time of the format, 1980-01-01, because the format has no time
/// zones.
pub(crate) fn zip(files: &[Packed]) -> Result<Vec<u8>, String> {
    let mut out = ZipWriter::new(Cursor::new(Vec::new()));
    for file in in_order(files) {
        let options = SimpleFileOptions::default()
            .last_modified_time(zip::DateTime::default())
            .unix_permissions(file.mode());
        out.start_file(&*file.path, options).map_err(|error| format!("{}: {error}", file.path))?;
        out.write_all(&file.bytes).map_err(|error| format!("{}: {error}", file.path))?;
    }
    out.finish().map(Cursor::into_inner).map_err(|error| error.to_string())
}

/// Returns a line in the format of `sha256sum`.
pub(crate) fn sha256_line(name: &str, bytes: &[u8]) -> String {
    let hash: String = Sha256::hash(bytes).iter().map(|byte| format!("{byte:02x}")).collect();
    format!("{hash}  {name}\n")
}

/// Block size of a tar file, bytes.
const BLOCK: usize = 512;

/// Returns the header of a file, ustar of POSIX.1-1988.
fn header(file: &Packed, seconds: u64) -> Result<[u8; BLOCK], String> {
    let mut header = [0; BLOCK];
    let mut set = |at: usize, most: usize, text: &str| {
        if text.len() > most {
            return Err(format!("{}: {text} is too long for a tar", file.path));
        }
        header[at..at + text.len()].copy_from_slice(text.as_bytes());
        Ok(())
    };
    set(0, 100, &file.path)?;
    set(100, 7, &format!("{:07o}", file.mode()))?;
    set(108, 7, "0000000")?; // user
    set(116, 7, "0000000")?; // group
    set(124, 11, &format!("{:011o}", file.bytes.len()))?;
    set(136, 11, &format!("{seconds:011o}"))?;
    set(148, 8, "        ")?; // the sum is made with blanks in its place
    set(156, 1, "0")?; // a regular file
    set(257, 8, "ustar\x0000")?;
    let sum: u32 = header.iter().copied().map(u32::from).sum();
    header[148..156].copy_from_slice(format!("{sum:06o}\0 ").as_bytes());
    Ok(header)
}

fn in_order(files: &[Packed]) -> Vec<&Packed> {
    let mut sorted: Vec<&Packed> = files.iter().collect();
    sorted.sort_by(|a, b| a.path.cmp(&b.path));
    sorted
}

#[cfg(test)]
mod tests {
    use std::io::Read as _;

    use super::*;

    fn files() -> Vec<Packed> {
        let text = |path: &str, text: &str| Packed {
            path: path.to_owned(),
            is_program: false,
            bytes: text.as_bytes().to_vec(),
        };
        let program = Packed { is_program: true, ..text("a-1/b", "#!/bin/sh\n") };
        vec![text("a-1/z/empty", ""), text("a-1/long", &"x".repeat(513)), program]
    }

    #[test]
    fn the_order_of_the_files_changes_no_byte() {
        let mut turned = files();
        turned.reverse();
        assert_eq!(tar_gz(&files(), 1_700_000_000), tar_gz(&turned, 1_700_000_000));
        assert_eq!(zip(&files()), zip(&turned));
        assert_ne!(tar_gz(&files(), 1), tar_gz(&files(), 2));
    }

    #[test]
    fn a_tar_is_blocks_with_sums() {
        let mut tar = Vec::new();
        let packed = tar_gz(&files(), 0o14_524_573_400).unwrap();
        assert_eq!(packed[4..8], [0; 4], "no time in the gzip header");
        flate2::read::GzDecoder::new(&packed[..]).read_to_end(&mut tar).unwrap();
        // The archive has a program of one block, a text of two, an empty file, and the end marker.
        assert_eq!(tar.len(), BLOCK * (2 + 3 + 1 + 2));
        assert_eq!(&tar[..6], b"a-1/b\0");
        assert_eq!(
            &tar[100..156],
            b"0000755\x000000000\x000000000\x0000000000012\x0014524573400\x00006526\x00 "
        );
        assert_eq!(tar[BLOCK..BLOCK + 10], *b"#!/bin/sh\n");
    }

    #[test]
    fn a_path_that_does_not_fit_is_refused() {
        let file = Packed { path: "x".repeat(101), is_program: false, bytes: Vec::new() };
        assert!(tar_gz(&[file], 0).unwrap_err().contains("too long"));
    }

    #[test]
    fn a_zip_is_read_back() {
        let mut read = zip::ZipArchive::new(Cursor::new(zip(&files()).unwrap())).unwrap();
        let names: Vec<_> = read.file_names().map(|name| name.unwrap().into_owned()).collect();
        assert_eq!(names, ["a-1/b", "a-1/long", "a-1/z/empty"]);
        assert_eq!(read.by_name("a-1/b").unwrap().unix_mode().map(|mode| mode & 0o777), Some(0o755));
    }

    #[test]
    fn a_sum_is_sha256() {
        let empty = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855  nothing\n";
        assert_eq!(sha256_line("nothing", b""), empty);
    }
}
