//! Chemical elements, by number and by symbol.

use std::fmt;

use super::isotope_table::{ROWS, Row};

/// A chemical element, hydrogen to oganesson.
///
/// ```
/// use polhode_shape::molecule::Element;
/// let chlorine = Element::from_symbol("Cl").unwrap();
/// assert_eq!((chlorine.number(), chlorine.weight()), (17, Some(35.45)));
/// assert_eq!(Element::from_number(17), Some(chlorine));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Element(u8);

impl Element {
    /// The element of an atomic number, 1 to 118.
    pub fn from_number(number: u8) -> Option<Self> {
        (1..=ROWS.len()).contains(&usize::from(number)).then_some(Self(number))
    }

    /// The element of a symbol in whatever case: `Cl`, `CL`, `cl`.
    pub fn from_symbol(symbol: &str) -> Option<Self> {
        let row = ROWS.iter().position(|row| row.symbol.eq_ignore_ascii_case(symbol))?;
        Self::from_number(u8::try_from(row + 1).ok()?)
    }

    /// Atomic number.
    pub const fn number(self) -> u8 {
        self.0
    }

    /// Its symbol: `Cl`.
    pub fn symbol(self) -> &'static str {
        self.row().symbol
    }

    /// Its standard atomic weight, u: IUPAC 2021, abridged where the standard is an interval (hydrogen 1.0080). `None` of
    /// elements that have none, because no isotope of theirs is found on Earth in a characteristic amount.
    ///
    /// Source: Prohaska et al., Pure Appl. Chem. 94 (2022) 573.
    pub fn weight(self) -> Option<f64> {
        self.row().weight
    }

    pub(crate) fn row(self) -> &'static Row {
        // A number that exists is from 1 to 118.
        &ROWS[usize::from(self.0) - 1]
    }
}

impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.symbol())
    }
}
