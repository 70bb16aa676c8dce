//! ZIP archive of a package: entries by name, decompressed while they are read.

use std::borrow::Cow;
use std::collections::HashMap;
use std::fmt;
use std::io::{self, BufRead, BufReader, Cursor, Read};

use zip::read::ZipFile;
use zip::result::ZipError;
use zip::{CompressionMethod, ZipArchive};

use crate::content::{ContentError, ContentErrorKind, ContentPlace};
use crate::package::unfolding::Budget;

/// Archive with safe entry names and non-overlapping entries.
pub struct Archive<'a> {
    zip: ZipArchive<Cursor<&'a [u8]>>,
    /// Index of each entry by its name in lower case: part names of a package are case-insensitive.
    numbers: HashMap<String, usize>,
    /// Limit on the unpacked size of all entries together.
    budget: Budget,
}

/// Text of an entry, read as a stream.
pub struct Stream<'s, 'a> {
    file: BufReader<ZipFile<'s, Cursor<&'a [u8]>>>,
    budget: &'s mut Budget,
    /// Bytes still to come, by the size in the header of the entry.
    declared: u64,
    /// Line number of the next byte, from 1.
    pub line: usize,
}

impl fmt::Debug for Archive<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Archive").field("entries", &self.numbers.len()).finish_non_exhaustive()
    }
}

impl fmt::Debug for Stream<'_, '_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Stream").field("line", &self.line).finish_non_exhaustive()
    }
}

impl<'a> Archive<'a> {
    /// Opens a ZIP archive.
    ///
    /// # Errors
    /// [`ContentError`] if the bytes are not an archive.
    pub fn open(bytes: &'a [u8]) -> Result<Self, ContentError> {
        if !bytes.starts_with(b"PK") {
            let found = String::from_utf8_lossy(&bytes[..bytes.len().min(16)]).into_owned();
            let kind = ContentErrorKind::Expected { what: "the \"PK\" of a ZIP archive".to_owned(), found };
            return Err(ContentError::new(kind, ContentPlace::Byte { offset: 0, what: String::new() }));
        }
        let fail = |e: ZipError| failed(&e, ContentPlace::Whole);
        let mut zip = ZipArchive::new(Cursor::new(bytes)).map_err(fail)?;
        let mut numbers = HashMap::new();
        for k in 0..zip.len() {
            let refuse = |value: &str, rule: &str| {
                let (what, value) = ("the name of an entry".to_owned(), value.to_owned());
                let kind = ContentErrorKind::Value { what, value, rule: rule.to_owned() };
                ContentError::new(kind, ContentPlace::Within(format!("entry {k} of the archive")))
            };
            let name = zip.name_for_index(k).transpose().map_err(fail)?.unwrap_or_default();
            if !is_inside(&name) {
                return Err(refuse(&name, "a path inside the archive"));
            }
            if numbers.insert(key(&name), k).is_some() {
                return Err(refuse(&name, "there once"));
            }
        }
        let is_repeated = directory_length(bytes, zip.central_directory_start()) != zip.len();
        if is_repeated || zip.has_overlapping_entries().map_err(fail)? {
            let (what, value) =
                ("the archive".to_owned(), "entries with the same name or overlapping bytes".to_owned());
            let kind = ContentErrorKind::Value { what, value, rule: "entries of their own".to_owned() };
            let hint = "the file is damaged or malicious";
            return Err(ContentError::new(kind, ContentPlace::Whole).hint(hint));
        }
        for k in 0..zip.len() {
            require_agreement(bytes, &zip.by_index_raw(k).map_err(fail)?)?;
        }
        Ok(Self { zip, numbers, budget: Budget::inflating(bytes.len() as u64) })
    }

    /// Returns true if an entry has this name, with or without a leading slash.
    pub fn has(&self, path: &str) -> bool {
        self.numbers.contains_key(&key(path))
    }

    /// Returns the names of all entries, in the order of the archive's directory.
    pub fn names(&self) -> Vec<String> {
        let all = (0..self.zip.len()).filter_map(|k| self.zip.name_for_index(k)?.ok());
        all.map(Cow::into_owned).collect()
    }

    /// Opens an entry for reading.
    pub fn stream(&mut self, path: &str) -> Result<Stream<'_, 'a>, ContentError> {
        let Some(&number) = self.numbers.get(&key(path)) else {
            let kind = ContentErrorKind::Missing { what: format!("part {path}") };
            return Err(ContentError::new(kind, ContentPlace::Whole));
        };
        let place = ContentPlace::Within(path.to_owned());
        let file = self.zip.by_index(number).map_err(|e| failed(&e, place))?;
        let declared = file.size();
        if declared > self.budget.left() {
            // Refused before any byte of it is unpacked.
            return Err(self.budget.exhausted(path.to_owned()));
        }
        Ok(Stream { file: BufReader::new(file), budget: &mut self.budget, declared, line: 1 })
    }
}

impl Stream<'_, '_> {
    /// Returns the next bytes that are unpacked already.
    pub fn unpacked(&self) -> &[u8] {
        let bytes = self.file.buffer();
        let most = usize::try_from(self.declared).unwrap_or(usize::MAX);
        &bytes[..bytes.len().min(most)]
    }
}

impl Read for Stream<'_, '_> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let taken = self.fill_buf()?.read(into)?;
        self.consume(taken);
        Ok(taken)
    }
}

impl BufRead for Stream<'_, '_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if !self.file.fill_buf()?.is_empty() && self.declared == 0 {
            return Err(io::Error::other("more bytes than the archive's directory says"));
        }
        Ok(self.unpacked())
    }

    fn consume(&mut self, count: usize) {
        let taken = self.file.buffer().get(..count).unwrap_or_default();
        self.line += taken.iter().filter(|&&b| b == b'\n').count();
        // `fill_buf` returns at most `declared` bytes, and never more than are present.
        self.declared -= count as u64;
        let _ = self.budget.spend(count, 1, String::new);
        self.file.consume(count);
    }
}

/// Returns the number of entries in the directory at the end of the archive, which begins at
/// `start`. [`ZipArchive`] keeps only the last of those with the same name.
fn directory_length(bytes: &[u8], start: u64) -> usize {
    const LENGTH: usize = 46;
    let mut rest = usize::try_from(start).ok().and_then(|start| bytes.get(start..)).unwrap_or_default();
    let mut count = 0;
    while let Some(header) = rest.first_chunk::<LENGTH>().filter(|header| header.starts_with(b"PK\x01\x02")) {
        let long = |at: usize| usize::from(u16::from_le_bytes([header[at], header[at + 1]]));
        // The name, extra fields and comment follow.
        rest = rest.get(LENGTH + long(28) + long(30) + long(32)..).unwrap_or_default();
        count += 1;
    }
    count
}

/// Checks that the two descriptions of an entry agree: in the directory at the end of the archive,
/// and in front of the data. Programs differ in which one they use.
fn require_agreement(bytes: &[u8], entry: &ZipFile<'_, Cursor<&[u8]>>) -> Result<(), ContentError> {
    const LENGTH: usize = 30;
    /// Flag bit: sizes and checksum follow the data.
    const LATER: u16 = 8;
    let start = usize::try_from(entry.header_start()).unwrap_or(usize::MAX);
    let rest = bytes.get(start..).unwrap_or_default();
    let refuse = |what: &str, value: String, rule: String| {
        let what = format!("the {what} in the entry's local header");
        let place = ContentPlace::Within(String::from_utf8_lossy(entry.name_raw()).into_owned());
        Err(ContentError::new(ContentErrorKind::Value { what, value, rule }, place)
            .hint("the file is damaged or malicious; export it again"))
    };
    let Some(header) = rest.first_chunk::<LENGTH>() else {
        return refuse("header", "cut short".to_owned(), format!("{LENGTH} bytes long"));
    };
    let short = |at: usize| u16::from_le_bytes([header[at], header[at + 1]]);
    let long = |at: usize| u64::from(short(at)) | u64::from(short(at + 2)) << 16;
    let name = &rest[LENGTH..rest.len().min(LENGTH + usize::from(short(26)))];
    if name != entry.name_raw() {
        let value = format!("{:?}", String::from_utf8_lossy(name));
        return refuse("name", value, "that of the archive's directory".to_owned());
    }
    let method = match entry.compression() {
        CompressionMethod::Stored => 0,
        CompressionMethod::Deflated => 8,
        _ => short(8),
    };
    let is_later = short(6) & LATER != 0;
    for (what, value, central) in [
        ("method", short(8).into(), u64::from(method)),
        ("check sum", long(14), entry.crc32().into()),
        ("packed size", long(18), entry.compressed_size()),
        ("size", long(22), entry.size()),
    ] {
        // 2³² − 1 means that the size needs more than four bytes and is in another field.
        let is_elsewhere = value == u64::from(u32::MAX) || is_later && value == 0;
        if value != central && !is_elsewhere {
            return refuse(what, value.to_string(), format!("{central}, that of the archive's directory"));
        }
    }
    Ok(())
}

/// Returns the normalized name of a part: lower case, without a leading slash.
pub fn key(path: &str) -> String {
    path.strip_prefix('/').unwrap_or(path).to_ascii_lowercase()
}

/// Returns true if the entry name stays inside any folder to which the archive is unpacked.
fn is_inside(name: &str) -> bool {
    let path = name.strip_prefix('/').unwrap_or(name);
    let climbs = path.split('/').any(|segment| segment == "..");
    !(path.starts_with('/') || path.contains(['\\', '\0']) || climbs || path.get(1..2) == Some(":"))
}

fn failed(error: &ZipError, place: ContentPlace) -> ContentError {
    let kind = match error {
        ZipError::CompressionMethodNotSupported(method) => {
            ContentErrorKind::Unsupported { what: format!("entries packed by method {method}") }
        }
        ZipError::UnsupportedArchive(what) => {
            ContentErrorKind::Unsupported { what: format!("this ZIP archive ({what})") }
        }
        error => {
            let (what, value) = ("the archive".to_owned(), error.to_string());
            ContentErrorKind::Value { what, value, rule: "a whole ZIP archive".to_owned() }
        }
    };
    ContentError::new(kind, place).hint("the file is truncated, damaged or of another type; export it again")
}
