//! Lengths in the options for mesh repairs.

use std::str::FromStr;

use polhode_source::unit::{self, Dimension, UnitError};

/// Length in an option for mesh repairs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MeshLength {
    /// Length, m.
    Metres(f64),
    /// Fraction of the mesh's size, the diagonal of the bounding box of all its triangles.
    OfSize(f64),
}

impl FromStr for MeshLength {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Self::parse(text).map_err(|error| match error.hint() {
            Some(hint) => format!("{error} (hint: {hint})"),
            None => error.to_string(),
        })
    }
}

impl From<MeshLength> for f64 {
    fn from(length: MeshLength) -> Self {
        length.value()
    }
}

impl MeshLength {
    /// Parses a length with its unit, or a plain number as a fraction of the mesh's size.
    ///
    /// ```
    /// use polhode_shape::mesh::MeshLength;
    /// assert_eq!(MeshLength::parse("0.01 mm"), Ok(MeshLength::Metres(0.00001)));
    /// assert_eq!(MeshLength::parse("3e-7"), Ok(MeshLength::OfSize(3e-7)));
    /// assert!(MeshLength::parse("2 kg").is_err());
    /// ```
    ///
    /// # Errors
    /// [`UnitError`] for any other text.
    pub fn parse(text: &str) -> Result<Self, UnitError> {
        if let Ok(part) = text.trim().parse() {
            return Ok(Self::OfSize(part));
        }
        unit::parse(text, Dimension::LENGTH).map(Self::Metres)
    }

    /// Returns the number without its meaning.
    pub const fn value(self) -> f64 {
        match self {
            Self::Metres(value) | Self::OfSize(value) => value,
        }
    }

    /// Returns the length in the mesh's own unit.
    pub(super) fn beside(self, diagonal: f64, unit: f64) -> f64 {
        match self {
            Self::Metres(length) => length / unit,
            Self::OfSize(part) => part * diagonal,
        }
    }
}
