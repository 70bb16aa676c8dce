//! Sizes that a binary layer (`.usdc`) states, checked against the length of the file.
//!
//! The reader of `openusd` allocates what a file states, and recurses into dictionaries. A few wrong
//! bytes could therefore exhaust the memory or the stack, which ends the process. Other damage
//! gives an error or a panic there, which [`super::read`] reports.
//!
//! Source: openusd.org, `crateFile.h`; AOUSD Core Specification 1.0.1, 16.3.

use std::io::Cursor;

use openusd::usdc::{CrateFile as Crate, MAGIC};
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

/// Versions whose arrays have 64-bit lengths and that `openusd` reads, 0.7 to 0.12.
const VERSIONS: std::ops::RangeInclusive<u8> = 7..=12;

/// Largest ratio of unpacked to packed bytes of LZ4.
const LZ4: u64 = 255;

/// Largest number of compressed elements, unless the file has more bytes.
const MOST_ELEMENTS: u64 = 1 << 24;

/// Largest size of an unpacked block, bytes.
const MOST_UNPACKED: u64 = 1 << 28;

/// Maximum nesting depth of dictionaries and time samples.
const MOST_DEPTH: usize = 50;

/// Checks all sizes in a binary layer.
pub(super) fn require_sound(bytes: &[u8]) -> Result<(), ContentError> {
    let mut claims = Claims { bytes, steps: 0, tokens: 0, strings: 0, paths: 0 };
    claims.sections()?;
    let file = Crate::open(Cursor::new(bytes))
        .map_err(|error| damaged(0, format!("a binary USD layer: {error:#}")))?;
    (claims.tokens, claims.strings, claims.paths) =
        (file.tokens.len() as u64, file.strings.len() as u64, file.paths.len() as u64);
    for token in &file.strings {
        claims.require(*token as u64 + 1, claims.tokens, 0)?;
    }
    for field in &file.fields {
        claims.value(field.value_rep.0, 0)?;
    }
    Ok(())
}

/// Bytes of a file whose statements about sizes are checked.
struct Claims<'b> {
    bytes: &'b [u8],
    /// Values that were visited; dictionaries may share values.
    steps: u64,
    /// Numbers of tokens, strings and paths, to which values refer by index.
    tokens: u64,
    strings: u64,
    paths: u64,
}

/// Check of an item of a list by its offset; returns its end.
type Item<'i> = &'i dyn Fn(&mut Claims<'_>, u64) -> Result<u64, ContentError>;

fn damaged(offset: u64, what: String) -> ContentError {
    let kind = ContentErrorKind::unsupported(what);
    let hint = "the file is damaged or malicious; export it again";
    ContentError::new(kind, ContentPlace::Byte { offset, what: String::new() }).hint(hint)
}

impl Claims<'_> {
    fn length(&self) -> u64 {
        self.bytes.len() as u64
    }

    /// Returns the number of bytes from here to the end.
    fn rest(&self, at: u64) -> u64 {
        self.length().saturating_sub(at)
    }

    fn array<const N: usize>(&self, at: u64) -> Result<[u8; N], ContentError> {
        let start = usize::try_from(at).unwrap_or(usize::MAX);
        let found = self.bytes.get(start..).and_then(|rest| rest.first_chunk::<N>());
        found.copied().ok_or_else(|| damaged(at, "a binary USD layer that ends too early".to_owned()))
    }

    fn byte(&self, at: u64) -> Result<u8, ContentError> {
        Ok(self.array::<1>(at)?[0])
    }

    fn long(&self, at: u64) -> Result<u64, ContentError> {
        Ok(u64::from_le_bytes(self.array(at)?))
    }

    /// Returns the count at an offset, if that many elements of `size` bytes follow it.
    fn counted(&self, at: u64, size: u64) -> Result<u64, ContentError> {
        let count = self.long(at)?;
        self.require(count.saturating_mul(size), self.rest(at + 8), at)?;
        Ok(count)
    }

    fn require(&self, stated: u64, most: u64, at: u64) -> Result<(), ContentError> {
        if stated <= most {
            return Ok(());
        }
        Err(damaged(at, format!("a size of {stated} in a binary USD layer of {} bytes", self.length())))
    }

    /// Returns the end of a compressed block of at most `unpacked` bytes.
    fn block(&self, at: u64, unpacked: u64) -> Result<u64, ContentError> {
        let packed = self.counted(at, 1)?;
        self.require(unpacked, (LZ4 * packed).min(MOST_UNPACKED), at)?;
        if packed > 0 && self.byte(at + 8)? != 0 {
            return Err(damaged(at, "a block of more than 2 GB".to_owned()));
        }
        Ok(at + 8 + packed)
    }

    /// Returns the end of a block of compressed integers; each has at least two bits.
    fn integers(&self, at: u64, count: u64) -> Result<u64, ContentError> {
        self.require(count, self.length().max(MOST_ELEMENTS), at)?;
        self.block(at, count / 4)
    }

    fn sections(&self) -> Result<(), ContentError> {
        let [_, _, _, _, _, _, _, _, major, minor, patch, ..] = self.array::<16>(0)?;
        if major != 0 || !VERSIONS.contains(&minor) {
            let what = format!("binary USD of version {major}.{minor}.{patch}");
            let error = ContentErrorKind::unsupported(what).of_whole();
            return Err(error.hint("convert it to text: usdcat robot.usd --out robot.usda"));
        }
        let table = self.long(16)?;
        let count = self.counted(table, 32)?;
        for k in 0..count.min(64) {
            let entry = table + 8 + 32 * k;
            let name: [u8; 16] = self.array(entry)?;
            let (start, size) = (self.long(entry + 16)?, self.long(entry + 24)?);
            self.require(size, self.rest(start), entry)?;
            let name = name.split(|byte| *byte == 0).next().unwrap_or_default();
            self.section(name, start)?;
        }
        Ok(())
    }

    fn section(&self, name: &[u8], start: u64) -> Result<(), ContentError> {
        match name {
            b"TOKENS" => {
                let (count, unpacked) = (self.long(start)?, self.long(start + 8)?);
                self.require(count, unpacked, start)?;
                self.block(start + 16, unpacked)?;
            }
            b"STRINGS" => drop(self.counted(start, 4)?),
            b"FIELDS" => {
                let count = self.long(start)?;
                let values = self.integers(start + 8, count)?;
                self.block(values, count.saturating_mul(8))?;
            }
            b"FIELDSETS" => drop(self.integers(start + 8, self.long(start)?)?),
            b"PATHS" => {
                let count = self.long(start + 8)?;
                self.require(self.long(start)?, count.saturating_mul(2), start)?;
                let tokens = self.integers(start + 16, count)?;
                let jumps = self.integers(tokens, count)?;
                self.integers(jumps, count)?;
            }
            b"SPECS" => {
                let count = self.long(start)?;
                let sets = self.integers(start + 8, count)?;
                let kinds = self.integers(sets, count)?;
                self.integers(kinds, count)?;
            }
            _ => {}
        }
        Ok(())
    }

    /// Checks a value: 8 bits of flags, 8 of type, and 48 with the value or its offset.
    fn value(&mut self, value: u64, depth: usize) -> Result<(), ContentError> {
        let (is_array, is_inlined, is_packed) =
            (value >> 63 & 1 == 1, value >> 62 & 1 == 1, value >> 61 & 1 == 1);
        let (kind, at) = (value >> 48 & 0xff, value & ((1 << 48) - 1));
        self.steps += 1;
        if depth > MOST_DEPTH || self.steps > 64 * self.length() {
            return Err(damaged(at, "dictionaries nested too deep".to_owned()));
        }
        if is_inlined {
            let index = at & u64::from(u32::MAX);
            return match kind {
                10 => self.require(index + 1, self.strings, at),
                11 | 12 | 53 | 57 => self.require(index + 1, self.tokens, at),
                _ => Ok(()),
            };
        }
        match kind {
            10 | 12 | 57 if is_array => self.indices(at, self.strings),
            10 | 12 | 57 => self.index(at, self.strings),
            11 if is_array && at > 0 => self.indices(at, self.tokens),
            11 if !is_array => self.require(self.long(at)?.saturating_add(1), self.tokens, at),
            48 => self.elements(at, 9, is_packed),
            _ if is_array => self.elements(at, kind, is_packed),
            31 => self.dictionary(at, depth).map(drop),
            35 => self.lists(at, &|claims, at| claims.dictionary(claims.arc(at)?, depth)),
            55 => self.lists(at, &|claims, at| claims.arc(at)),
            47 => self.arc(at).map(drop),
            32 => self.lists(at, &|claims, at| claims.index(at, claims.tokens).map(|()| at + 4)),
            33 | 54 => self.lists(at, &|claims, at| claims.index(at, claims.strings).map(|()| at + 4)),
            34 => self.lists(at, &|claims, at| claims.index(at, claims.paths).map(|()| at + 4)),
            36 | 38 => self.lists(at, &|_, at| Ok(at + 4)),
            37 | 39 => self.lists(at, &|_, at| Ok(at + 8)),
            40 => self.indices(at, self.paths),
            41 => self.indices(at, self.tokens),
            50 => self.indices(at, self.strings),
            45 => self.pairs(at, self.strings),
            58 => self.pairs(at, self.paths),
            46 => self.samples(at, depth),
            49 => self.counted(at, 16).map(drop),
            _ => Ok(()),
        }
    }

    /// Checks an index of 32 bits.
    fn index(&self, at: u64, most: u64) -> Result<(), ContentError> {
        self.require(u64::from(u32::from_le_bytes(self.array(at)?)) + 1, most, at)
    }

    /// Checks a counted list of indices.
    fn indices(&self, at: u64, most: u64) -> Result<(), ContentError> {
        (0..self.counted(at, 4)?).try_for_each(|k| self.index(at + 8 + 4 * k, most))
    }

    /// Checks a counted list of pairs of indices.
    fn pairs(&self, at: u64, most: u64) -> Result<(), ContentError> {
        (0..2 * self.counted(at, 8)?).try_for_each(|k| self.index(at + 8 + 4 * k, most))
    }

    /// Checks the name, path and layer offset of an arc, and returns their end.
    fn arc(&self, at: u64) -> Result<u64, ContentError> {
        self.index(at, self.strings)?;
        self.index(at + 4, self.paths)?;
        Ok(at + 24)
    }

    /// Checks an array of numbers or tokens.
    fn elements(&self, at: u64, kind: u64, is_packed: bool) -> Result<(), ContentError> {
        if at == 0 {
            return Ok(());
        }
        let size = match kind {
            1 | 2 => 1,
            7 => 2,
            5 | 6 | 9 | 18 | 20 | 22 | 26 | 56 => 4,
            13 | 16 => 32,
            14 => 72,
            15 => 128,
            19 | 17 => 8,
            23 | 27 => 24,
            _ => 2,
        };
        let count = self.long(at)?;
        let is_whole = matches!(kind, 3..=6);
        if !(is_packed && count >= 4 && (is_whole || matches!(kind, 7..=9 | 56))) {
            return self.require(count.saturating_mul(size), self.rest(at + 8), at);
        }
        if is_whole {
            return self.integers(at + 8, count).map(drop);
        }
        if self.byte(at + 8)? != b't' {
            return self.integers(at + 9, count).map(drop);
        }
        let values = u64::from(u32::from_le_bytes(self.array(at + 9)?));
        let width = match kind {
            7 => 2,
            8 => 4,
            _ => 8,
        };
        self.require(values * width, self.rest(at + 13), at)?;
        self.integers(at + 13 + values * width, count).map(drop)
    }

    /// Checks the lists of a list operation. `item` checks an item and returns its end.
    fn lists(&mut self, at: u64, item: Item<'_>) -> Result<(), ContentError> {
        let mut lists = self.byte(at)? >> 1;
        let mut at = at + 1;
        while lists != 0 {
            if lists & 1 == 1 {
                let count = self.counted(at, 4)?;
                at += 8;
                for _ in 0..count {
                    at = item(self, at)?;
                }
            }
            lists >>= 1;
        }
        Ok(())
    }

    /// Checks a dictionary, and returns its end.
    fn dictionary(&mut self, at: u64, depth: usize) -> Result<u64, ContentError> {
        let count = self.counted(at, 12)?;
        let mut at = at + 8;
        for _ in 0..count {
            self.index(at, self.strings)?;
            let value = self.jump(at + 4)?;
            self.value(self.long(value)?, depth + 1)?;
            at = value + 8;
        }
        Ok(at)
    }

    fn samples(&mut self, at: u64, depth: usize) -> Result<(), ContentError> {
        let times = self.jump(at)?;
        self.value(self.long(times)?, depth + 1)?;
        let values = self.jump(times + 8)?;
        let count = self.counted(values, 8)?;
        for k in 0..count {
            self.value(self.long(values + 8 + 8 * k)?, depth + 1)?;
        }
        Ok(())
    }

    /// Returns the target of a relative offset.
    fn jump(&self, at: u64) -> Result<u64, ContentError> {
        let offset = i64::from_le_bytes(self.array(at)?);
        let target = at.checked_add_signed(offset).filter(|target| *target < self.length());
        target.ok_or_else(|| damaged(at, "an offset outside a binary USD layer".to_owned()))
    }
}

/// Returns true if the bytes begin like a binary layer.
pub(super) fn is_crate(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}
