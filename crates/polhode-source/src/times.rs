//! Lists of times from files, and evenly spaced times.
//!
//! A file has one time per line: a number in seconds, or a number with a unit. Blank lines and text
//! after `#` are ignored.

use std::io::{self, Read};
use std::path::Path;

use crate::error::{FormatError, FormatErrorKind, Place};
use crate::file;
use crate::files::Files;
use crate::text::{cut, is_utf16};
use crate::unit::{self, Dimension};

/// Largest number of times; at 240 bytes per sample, 2.4 GB.
pub const MOST: u64 = 10_000_000;

/// Largest accepted file, bytes: more than [`MOST`] times need.
const LARGEST_FILE: u64 = 256 << 20;

/// Reads a file of times.
///
/// # Errors
/// [`FormatError`] if the file cannot be read, has no times, or a line is not a time.
pub fn read(files: &dyn Files, path: &Path) -> Result<Vec<f64>, FormatError> {
    let bytes = file::bytes(files, path, &path.to_string_lossy(), LARGEST_FILE);
    from_bytes(&bytes.map_err(|kind| FormatError::new(path, None, kind))?, path)
}

/// Reads times from an open stream; `path` is its name in messages.
///
/// # Errors
/// Same as [`read`].
pub fn read_from(stream: impl Read, path: &Path) -> Result<Vec<f64>, FormatError> {
    let failed =
        |error: io::Error| FormatError::new(path, None, file::failed(&path.to_string_lossy(), &error));
    let mut bytes = Vec::new();
    stream.take(LARGEST_FILE + 1).read_to_end(&mut bytes).map_err(failed)?;
    if bytes.len() as u64 > LARGEST_FILE {
        let why = format!("it has more than {LARGEST_FILE} bytes");
        return Err(failed(io::Error::new(io::ErrorKind::FileTooLarge, why)));
    }
    from_bytes(&bytes, path)
}

/// Parses times from text; `path` is the name of the text in messages.
///
/// ```
/// use polhode_source::times;
/// let list = "# nights of observation\n0\n36 h\n\n-2.5 d   # before the start\n";
/// assert_eq!(times::parse(list, "nights.txt".as_ref()), Ok(vec![0.0, 129_600.0, -216_000.0]));
/// let error = times::parse("0\n3 kg\n", "nights.txt".as_ref()).unwrap_err();
/// assert_eq!(error.to_string(), "nights.txt:2:1: \"kg\" is a mass where a time belongs");
/// ```
///
/// # Errors
/// Same as [`read`].
pub fn parse(text: &str, path: &Path) -> Result<Vec<f64>, FormatError> {
    let (mut times, mut start) = (Vec::new(), 0);
    let mut nonzero: Option<&str> = None;
    for line in text.split_inclusive('\n') {
        let before_comment = line.split('#').next().unwrap_or_default();
        // A byte order mark does not belong to the first time.
        let time = before_comment.trim_start_matches('\u{feff}').trim();
        if !time.is_empty() {
            let from = start + line.find(time).unwrap_or_default();
            let failed =
                |kind| FormatError::new(path, Some(Place::in_text(text, from..from + time.len())), kind);
            let refused = |rule: String| {
                let (key, value) = ("time".to_owned(), cut(time));
                failed(FormatErrorKind::Value { key, value, rule })
            };
            let value =
                unit::parse(time, Dimension::TIME).map_err(|error| failed(FormatErrorKind::Unit(error)))?;
            if unit::may_be_several(time) {
                let hint = "write one time per line, without spaces inside a number";
                return Err(refused("one number".to_owned()).with_hint(hint));
            }
            // The first nonzero line decides for all lines: with units, or all in s.
            let first = *nonzero.get_or_insert(time);
            if let Some((bare, with)) = unit::bare_beside_units([first, time]) {
                let rule = format!("like the others: {with:?} has a unit, but {bare:?} has none");
                return Err(refused(rule).with_hint("give every time a unit, or write all times in s"));
            }
            nonzero = nonzero.filter(|_| value != 0.0 || times.iter().any(|time| *time != 0.0));
            times.push(value);
        }
        start += line.len();
    }
    if times.is_empty() {
        let (key, expected) = ("the file".to_owned(), "a list of times, one per line".to_owned());
        let kind = FormatErrorKind::WrongType { key, expected, found: "an empty one".to_owned() };
        return Err(FormatError::new(path, None, kind)
            .with_hint("each line is a time in s, such as 0.5, or with a unit, such as 3 d"));
    }
    Ok(times)
}

/// Returns 0, `every`, 2 `every`, … and `duration`, both arguments positive; `None` for more than
/// [`MOST`] times.
///
/// ```
/// use polhode_source::times;
/// assert_eq!(times::every(0.5, 1.25), Some(vec![0.0, 0.5, 1.0, 1.25]));
/// ```
pub fn every(every: f64, duration: f64) -> Option<Vec<f64>> {
    let intervals = duration / every;
    if !(intervals < MOST as f64) {
        return None;
    }
    // If the duration is a whole number of intervals up to rounding, the last interval is not cut
    // short.
    let whole = if (intervals - intervals.round()).abs() < 1e-9 * intervals {
        intervals.round()
    } else {
        intervals.ceil()
    };
    let last = whole as usize;
    Some((0..last).map(|k| every * k as f64).chain([duration]).collect())
}

/// Returns `from`, `from` + `step`, … up to `to`. The last time is `to` if the range is a whole
/// number of steps up to rounding. Returns `None` for more than [`MOST`] times or a step of the
/// wrong sign.
///
/// ```
/// use polhode_source::times;
/// assert_eq!(times::range(0.5, -1.0, -0.5), Some(vec![0.5, 0.0, -0.5, -1.0]));
/// assert_eq!(times::range(0.0, 1.0, -0.5), None);
/// ```
pub fn range(from: f64, to: f64, step: f64) -> Option<Vec<f64>> {
    let steps = (to - from) / step;
    if !(steps >= 0.0 && steps < MOST as f64) {
        return None;
    }
    let whole = (steps - steps.round()).abs() < 1e-9 * steps.max(1.0);
    let last = if whole { steps.round() } else { steps.floor() } as usize;
    let one = |k: usize| if whole && k == last { to } else { from + step * k as f64 };
    Some((0..=last).map(one).collect())
}

fn from_bytes(bytes: &[u8], path: &Path) -> Result<Vec<f64>, FormatError> {
    if is_utf16(bytes) {
        return Err(FormatError::new(path, None, FormatErrorKind::Utf16));
    }
    let text =
        str::from_utf8(bytes).map_err(|error| FormatError::not_utf8(path, bytes, error.valid_up_to()))?;
    parse(text, path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wrong_line_is_named() {
        let path = Path::new("t.txt");
        for (text, place) in
            [("1\n\n  2 x\n", "3:3"), ("\u{feff}nan", "1:1"), ("1, 2", "1:1"), ("1\n1e999 # far", "2:1")]
        {
            let error = parse(text, path).unwrap_err().to_string();
            assert!(error.starts_with(&format!("t.txt:{place}: ")), "{error}");
        }
        assert!(parse("# nothing\n \n", path).unwrap_err().message().contains("an empty one"));
        assert!(from_bytes(b"1\n\xff\n", path).unwrap_err().to_string().contains("t.txt:2:1"));
        assert_eq!(parse("\u{feff}1\r\n-0\r\n", path), Ok(vec![1.0, -0.0]));
    }
}
