//! JSON value with its location in the document.

use polhode_source::{ContentError, ContentErrorKind, ContentPlace};
use serde_json::Value;

/// Value with its location: `nodes[3].matrix`.
#[derive(Clone, Debug)]
pub(crate) struct Json<'a> {
    value: &'a Value,
    place: String,
}

impl<'a> Json<'a> {
    pub(crate) fn root(value: &'a Value) -> Self {
        Self { value, place: String::new() }
    }

    pub(crate) fn place(&self) -> &str {
        &self.place
    }

    /// Returns a member of an object, if it is present.
    pub(crate) fn get(&self, key: &str) -> Option<Self> {
        let value = self.value.get(key)?;
        let place = if self.place.is_empty() { key.to_owned() } else { format!("{}.{key}", self.place) };
        Some(Self { value, place })
    }

    /// Returns a required member of an object.
    pub(crate) fn need(&self, key: &str) -> Result<Self, ContentError> {
        self.get(key).ok_or_else(|| ContentError::new(ContentErrorKind::missing(key), self.content_place()))
    }

    /// Returns the elements of an array member; empty if it is missing.
    pub(crate) fn list(
        &self,
        key: &str,
    ) -> Result<impl ExactSizeIterator<Item = Self> + use<'a>, ContentError> {
        let list = self.get(key);
        let values = match &list {
            Some(list) => list.value.as_array().ok_or_else(|| list.expected("an array"))?.as_slice(),
            None => &[],
        };
        let place = list.map_or(String::new(), |list| list.place);
        Ok(values.iter().enumerate().map(move |(k, value)| Self { value, place: format!("{place}[{k}]") }))
    }

    /// Returns the length of an array member; 0 if it is missing.
    pub(crate) fn count(&self, key: &str) -> usize {
        self.value.get(key).and_then(Value::as_array).map_or(0, Vec::len)
    }

    /// Returns the element of a top-level list with this value as its index.
    pub(crate) fn referred(&self, root: &Self, list: &str, one: &str) -> Result<(usize, Self), ContentError> {
        let index = self.whole()?;
        let values = root.value.get(list).and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
        match usize::try_from(index).ok().and_then(|k| Some((k, values.get(k)?))) {
            Some((k, value)) => Ok((k, Self { value, place: format!("{list}[{k}]") })),
            None => {
                let index = i64::try_from(index).unwrap_or(i64::MAX);
                Err(self.error(ContentErrorKind::index(one, index, values.len())))
            }
        }
    }

    /// Returns an integer of at least 0.
    pub(crate) fn whole(&self) -> Result<u64, ContentError> {
        // JSON does not distinguish 3 and 3.0, and some writers use the latter.
        let fractional = |x: f64| (x >= 0.0 && x < 2f64.powi(53) && x.fract() == 0.0).then_some(x as u64);
        let whole = self.value.as_u64().or_else(|| self.value.as_f64().and_then(fractional));
        whole.ok_or_else(|| self.expected("a whole number from 0"))
    }

    /// Returns an integer member of at least 0, or a default.
    pub(crate) fn whole_or(&self, key: &str, default: u64) -> Result<u64, ContentError> {
        self.get(key).map_or(Ok(default), |value| value.whole())
    }

    /// Returns a boolean member; false if it is missing.
    pub(crate) fn flag(&self, key: &str) -> Result<bool, ContentError> {
        self.get(key)
            .map_or(Ok(false), |flag| flag.value.as_bool().ok_or_else(|| flag.expected("true or false")))
    }

    pub(crate) fn text(&self) -> Result<&'a str, ContentError> {
        self.value.as_str().ok_or_else(|| self.expected("a text"))
    }

    /// Returns a text member; empty if it is missing.
    pub(crate) fn text_or_empty(&self, key: &str) -> Result<&'a str, ContentError> {
        self.get(key).map_or(Ok(""), |text| text.text())
    }

    /// Returns a finite number.
    pub(crate) fn number(&self) -> Result<f64, ContentError> {
        self.value.as_f64().ok_or_else(|| self.expected("a number"))
    }

    /// Returns exactly N finite numbers.
    pub(crate) fn numbers<const N: usize>(&self) -> Result<[f64; N], ContentError> {
        let expected = || self.expected(&format!("{N} numbers"));
        let values = self.value.as_array().ok_or_else(expected)?;
        let values: &[Value; N] = values.as_slice().try_into().map_err(|_| expected())?;
        let mut numbers = [0.0; N];
        for (number, value) in numbers.iter_mut().zip(values) {
            *number = value.as_f64().ok_or_else(expected)?;
        }
        Ok(numbers)
    }

    /// Returns an error about this value.
    pub(crate) fn error(&self, kind: ContentErrorKind) -> ContentError {
        ContentError::new(kind, self.content_place())
    }

    pub(crate) fn expected(&self, what: &str) -> ContentError {
        self.error(ContentErrorKind::expected(what, self.shown()))
    }

    /// Returns the error for a value that violates a rule.
    pub(crate) fn refused(&self, what: &str, rule: &str) -> ContentError {
        self.error(ContentErrorKind::value(what, self.shown(), rule))
    }

    fn content_place(&self) -> ContentPlace {
        match self.place.is_empty() {
            true => ContentPlace::Whole,
            false => ContentPlace::Within(self.place.clone()),
        }
    }

    /// Returns the value for a message; long values are shortened.
    fn shown(&self) -> String {
        match self.value {
            Value::Array(values) if values.len() > 16 => format!("an array of {}", values.len()),
            Value::Array(values) if values.iter().any(|v| v.is_array() || v.is_object()) => {
                format!("an array of {}", values.len())
            }
            Value::Object(_) => "an object".to_owned(),
            Value::String(text) => text.chars().take(80).collect(),
            value => value.to_string(),
        }
    }
}
