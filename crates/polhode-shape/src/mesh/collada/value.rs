//! Numbers and counts of a COLLADA file, and their errors.

use std::ops::Range;

use polhode_source::xml::{Element, Written};
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

/// Returns an integer attribute; the default if it is missing.
pub(crate) fn whole(element: Element<'_>, name: &str, default: usize) -> Result<usize, ContentError> {
    let Some(written) = element.attribute(name) else { return Ok(default) };
    written.value.parse().map_err(|_| expected("a whole number", written.value, written.span))
}

/// Checks that the attribute `count` of an element equals the actual number. They differ in a
/// truncated or edited file.
pub(crate) fn declared(element: Element<'_>, what: &str, present: usize) -> Result<(), ContentError> {
    match whole(element, "count", present)? {
        declared if declared == present => Ok(()),
        declared => Err(count(element, what, declared, present)),
    }
}

pub(crate) fn count(element: Element<'_>, what: &str, declared: usize, present: usize) -> ContentError {
    let (what, declared, present) = (what, declared as u64, present as u64);
    ContentError::new(ContentErrorKind::count(what, declared, present), start(element))
}

pub(crate) fn positive(written: &Written<'_>) -> Result<f64, ContentError> {
    match finite(written)?[..] {
        [number] if number > 0.0 => Ok(number),
        [] => Err(expected("a positive number", "nothing", written.span.clone())),
        _ => Err(expected("a positive number", written.value, written.span.clone())),
    }
}

/// Returns exactly N numbers of an element.
pub(crate) fn array<const N: usize>(element: Element<'_>) -> Result<[f64; N], ContentError> {
    let written = element.text().ok_or_else(|| missing("numbers", element))?;
    let values = finite(&written)?;
    let unlike =
        |values: Vec<f64>| expected(&format!("{N} numbers"), &format!("{}", values.len()), written.span);
    values.try_into().map_err(unlike)
}

/// Returns finite numbers separated by blanks.
pub(crate) fn finite(written: &Written<'_>) -> Result<Vec<f64>, ContentError> {
    let values: Vec<f64> = written.values().collect();
    if values.iter().all(|value| value.is_finite()) {
        return Ok(values);
    }
    let wrong = written.numbers().find(|number| !number.value.is_some_and(f64::is_finite));
    let (found, at) =
        wrong.map_or((String::new(), written.span.clone()), |number| (number.text, number.span));
    Err(expected("a finite number", &found, at))
}

pub(crate) fn expected(what: &str, found: &str, at: Range<usize>) -> ContentError {
    ContentErrorKind::expected(what, found).at(at)
}

pub(crate) fn missing(what: &str, at: Element<'_>) -> ContentError {
    ContentError::new(ContentErrorKind::missing(what), start(at))
}

/// Returns the error for an unsupported element; `what` adds details.
pub(crate) fn unsupported(element: Element<'_>, what: &str) -> ContentError {
    let what = format!("<{}> of COLLADA{what}", element.name());
    ContentError::new(ContentErrorKind::unsupported(what), start(element))
}

/// Returns the start of an element.
pub(crate) fn start(element: Element<'_>) -> ContentPlace {
    let start = element.span().start;
    ContentPlace::Text(start..start + 1)
}
