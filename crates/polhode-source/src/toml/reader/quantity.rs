//! Numbers and quantities of values: as written, replaced, cached, or formulas of symbols.

use super::{Value, each};
use crate::text::cut;
use crate::toml::asked::What;
use crate::toml::tree::{Kind, Known, Replacement};
use crate::unit::{self, Dimension};
use crate::{FormatError, FormatErrorKind};

impl Value<'_> {
    /// Returns the value as a finite plain number.
    pub fn number(&self) -> Result<f64, FormatError> {
        self.asks(|| What::Number);
        match self.evaluated(Dimension::NONE) {
            Some(value) => value,
            None => self.varying(Dimension::NONE, || self.written_number()),
        }
    }

    fn written_number(&self) -> Result<f64, FormatError> {
        let digits = match &self.value.kind {
            Kind::Float(digits) | Kind::Whole { digits, radix: 10 } => digits.clone(),
            Kind::Whole { digits, radix } => {
                u128::from_str_radix(digits, *radix).map_err(|_| self.invalid("below 2^128"))?.to_string()
            }
            _ => return Err(self.wrong_type("a number", "write a plain number, without unit and quotes")),
        };
        if digits.ends_with(['n', 'f']) {
            return Err(self.invalid("finite").with_hint("write a finite number instead of nan or inf"));
        }
        unit::parse(&digits, Dimension::NONE).map_err(|e| self.error(FormatErrorKind::Unit(e)))
    }

    /// Returns a quantity in SI units, from a number or a string with a unit.
    pub fn quantity(&self, dimension: Dimension) -> Result<f64, FormatError> {
        self.asks(|| What::Quantity(dimension));
        match self.evaluated(dimension) {
            Some(value) => value,
            None => self.varying(dimension, || self.written_quantity(dimension)),
        }
    }

    /// Returns the value of a formula of symbols; `None` for other values. It is not cached,
    /// because it changes with the symbols.
    fn evaluated(&self, dimension: Dimension) -> Option<Result<f64, FormatError>> {
        let (Kind::Text(text), Some(symbols)) = (&self.value.kind, self.source.symbols) else { return None };
        let value = || symbols.evaluate(text, dimension).map_err(|error| self.formula(error));
        symbols.is_formula(text).then(value)
    }

    /// Returns true for a text with the name of a symbol.
    pub fn names_symbol(&self) -> bool {
        match (&self.value.kind, self.source.symbols) {
            (Kind::Text(text), Some(symbols)) => symbols.are_in(text),
            _ => false,
        }
    }

    /// Returns a quantity of any dimension in SI units, with its dimension.
    pub fn any_quantity(&self) -> Result<(f64, Dimension), FormatError> {
        self.asks(|| What::Number);
        self.asks(|| What::Text);
        // A replaced quantity keeps its dimension.
        let text = match &self.value.kind {
            Kind::Replaced(_) => {
                self.source.text.get(self.span()).unwrap_or_default().trim_matches(['"', '\''])
            }
            Kind::Text(text) => text,
            _ => "1",
        };
        let (_, dimension) = unit::measured(text).map_err(|e| self.error(FormatErrorKind::Unit(e)))?;
        self.quantity(dimension).map(|value| (value, dimension))
    }

    fn written_quantity(&self, dimension: Dimension) -> Result<f64, FormatError> {
        match &self.value.kind {
            Kind::Text(text) => {
                unit::parse(text, dimension).map_err(|e| self.error(FormatErrorKind::Unit(e)))
            }
            Kind::Float(_) | Kind::Whole { .. } => self.written_number(),
            _ => {
                let example = dimension.example().unwrap_or("1");
                Err(self.wrong_type(&dimension.to_string(), &self.write(&format!("\"{example}\""))))
            }
        }
    }

    /// Returns the replacement number if there is one, else the cached number, else the written
    /// one.
    fn varying(
        &self,
        dimension: Dimension,
        written: impl FnOnce() -> Result<f64, FormatError>,
    ) -> Result<f64, FormatError> {
        if let Some(Replacement::Number(value)) = self.replacement() {
            return Ok(*value);
        }
        match self.known() {
            Some(Known::Number(value, known)) if *known == dimension => Ok(*value),
            _ => written().inspect(|value| self.keep(Known::Number(*value, dimension))),
        }
    }

    /// Returns a positive quantity in SI units.
    pub fn positive(&self, dimension: Dimension) -> Result<f64, FormatError> {
        let value = self.quantity(dimension)?;
        if value > 0.0 {
            return Ok(value);
        }
        let error = self.invalid("positive");
        Err(match dimension {
            Dimension::LENGTH => {
                error.with_hint("a size is positive; set its place with position and rotate")
            }
            Dimension::TIME => error.with_hint("time runs forward from 0"),
            Dimension::ANGLE => error.with_hint("it is measured to both sides"),
            Dimension::MASS | Dimension::DENSITY | Dimension::AREA_DENSITY | Dimension::LINE_DENSITY => {
                error.with_hint("negative mass cannot model a hole: use a hollow shape, or a mesh")
            }
            _ => error,
        })
    }

    /// Returns N quantities in SI units.
    pub fn quantities<const N: usize>(&self, dimension: Dimension) -> Result<[f64; N], FormatError> {
        let elements = self.fixed::<N>("numbers or strings with units");
        let elements = elements.map_err(|error| error.with_hint_of(self.as_array(N, dimension, "0")))?;
        each(elements, |value| value.quantity(dimension))
    }

    /// Returns N positive quantities in SI units.
    pub fn positives<const N: usize>(&self, dimension: Dimension) -> Result<[f64; N], FormatError> {
        let elements = self.fixed::<N>("numbers or strings with units");
        let elements = elements.map_err(|error| error.with_hint_of(self.as_array(N, dimension, "")))?;
        each(elements, |value| value.positive(dimension))
    }

    /// Returns advice to write an array of `n` elements instead of a single quantity, which becomes
    /// its last element; the others are `filler`, or the same quantity if `filler` is empty.
    fn as_array(&self, n: usize, dimension: Dimension, filler: &str) -> Option<String> {
        self.written_quantity(dimension).ok()?;
        let text = cut(self.source.text.get(self.span())?);
        let filler = if filler.is_empty() { text.as_str() } else { filler };
        let mut elements = vec![filler; n.saturating_sub(1)];
        elements.push(&text);
        Some(self.write(&format!("[{}]", elements.join(", "))))
    }

    /// Returns N finite plain numbers.
    pub fn numbers<const N: usize>(&self) -> Result<[f64; N], FormatError> {
        each(self.fixed("numbers")?, Value::number)
    }
}
