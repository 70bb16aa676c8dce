//! Chemical elements, by atomic number and by symbol.

use std::fmt;
use std::sync::LazyLock;

/// Chemical element, hydrogen to oganesson.
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
    /// Returns the element with an atomic number from 1 to 118.
    pub fn from_number(number: u8) -> Option<Self> {
        (1..=ROWS.len()).contains(&usize::from(number)).then_some(Self(number))
    }

    /// Returns the element with a symbol, in any case: `Cl`, `CL`, `cl`.
    pub fn from_symbol(symbol: &str) -> Option<Self> {
        let row = ROWS.iter().position(|row| row.symbol.eq_ignore_ascii_case(symbol))?;
        Self::from_number(u8::try_from(row + 1).ok()?)
    }

    /// Returns the atomic number.
    pub const fn number(self) -> u8 {
        self.0
    }

    /// Returns the symbol: `Cl`.
    pub fn symbol(self) -> &'static str {
        self.row().symbol
    }

    /// Returns the standard atomic weight, u: IUPAC 2021, abridged if the standard is an interval
    /// (hydrogen 1.0080). Returns `None` for elements without a standard weight, because none of
    /// their isotopes occurs on Earth in a characteristic amount.
    ///
    /// Source: Prohaska et al., Pure Appl. Chem. 94 (2022) 573.
    pub fn weight(self) -> Option<f64> {
        self.row().weight
    }

    pub(crate) fn row(self) -> &'static Row {
        // The number is always from 1 to 118.
        &ROWS[usize::from(self.0) - 1]
    }
}

/// Data of an element.
#[derive(Debug)]
pub(crate) struct Row {
    pub symbol: &'static str,
    /// Standard atomic weight, u; abridged if the standard is an interval.
    pub weight: Option<f64>,
    /// Mass number of the most abundant isotope; of the longest-lived one without a standard
    /// weight.
    pub first: u16,
    /// Isotopes: mass number and atomic mass, u.
    pub isotopes: Vec<(u16, f64)>,
}

/// Elements by atomic number, starting with hydrogen.
static ROWS: LazyLock<Vec<Row>> = LazyLock::new(|| {
    include_str!("isotopes.txt").lines().filter(|line| !line.starts_with('#')).filter_map(Row::read).collect()
});

impl Row {
    /// Parses a line of the table.
    fn read(line: &'static str) -> Option<Self> {
        let mut words = line.split(' ');
        let (symbol, weight, first) =
            (words.next()?, words.next()?.parse().ok(), words.next()?.parse().ok()?);
        let isotope = |word: &str| {
            let (number, mass) = word.split_once(':')?;
            Some((number.parse().ok()?, mass.parse().ok()?))
        };
        Some(Self { symbol, weight, first, isotopes: words.map(isotope).collect::<Option<_>>()? })
    }
}

impl fmt::Display for Element {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.symbol())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_read_whole() {
        let numbers = (1..=118).map(|number| Element::from_number(number).unwrap());
        let words = include_str!("isotopes.txt").matches(':').count();
        assert_eq!(numbers.map(|element| element.row().isotopes.len()).sum::<usize>(), words);
        assert_eq!((ROWS.len(), ROWS.iter().filter(|row| row.weight.is_none()).count()), (118, 34));
    }
}
