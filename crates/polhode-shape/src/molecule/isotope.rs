//! Isotopes, their masses, and their notation in files.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::element::Element;

/// Isotope with a known mass.
///
/// The table contains all natural isotopes, all others with a half-life of at least a minute, and
/// the longest-lived one of every element. Masses are those of neutral atoms in their ground state.
///
/// ```
/// use polhode_shape::molecule::{Element, Isotope};
/// let carbon = Element::from_symbol("C").unwrap();
/// let heavy = Isotope::new(carbon, 13).unwrap();
/// assert_eq!(heavy.mass(), 13.00335483534);
/// assert_eq!(heavy.to_string(), "13C");
/// assert_eq!(Isotope::first(carbon).mass(), 12.0);
/// assert!(Isotope::new(carbon, 25).is_none());
/// ```
///
/// # Source
/// Masses from AME2020: Wang et al., Chinese Physics C 45 (2021) 030003. Abundances and half-lives
/// from NUBASE2020: Kondev et al., Chinese Physics C 45 (2021) 030001.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isotope {
    element: Element,
    mass_number: u16,
    mass: f64,
}

impl Isotope {
    /// Returns the isotope with a mass number; `None` if its mass is not in the table.
    pub fn new(element: Element, mass_number: u16) -> Option<Self> {
        let found = element.row().isotopes.iter().find(|(number, _)| *number == mass_number);
        found.map(|&(mass_number, mass)| Self { element, mass_number, mass })
    }

    /// Returns the most abundant isotope; for elements without a standard atomic weight, the
    /// longest-lived one.
    pub fn first(element: Element) -> Self {
        let mass_number = element.row().first;
        Self::new(element, mass_number).unwrap_or(Self { element, mass_number, mass: f64::from(mass_number) })
    }

    /// Returns all isotopes of an element in the table, the lightest first.
    pub fn all(element: Element) -> impl Iterator<Item = Self> {
        element.row().isotopes.iter().map(move |&(mass_number, mass)| Self { element, mass_number, mass })
    }

    /// Returns the element.
    pub const fn element(self) -> Element {
        self.element
    }

    /// Returns the mass number: protons plus neutrons.
    pub const fn mass_number(self) -> u16 {
        self.mass_number
    }

    /// Returns the atomic mass, u.
    pub const fn mass(self) -> f64 {
        self.mass
    }
}

impl fmt::Display for Isotope {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.mass_number, self.element)
    }
}

/// Kind of an atom: an element, or one of its isotopes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Species {
    /// Element without a given isotope; the user selects the masses, see [`Isotopes`].
    Element(Element),
    /// Isotope given by the file.
    Isotope(Isotope),
}

/// Choice of masses for atoms whose isotope the file does not give.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::ValueEnum))]
pub enum Isotopes {
    /// Masses of the most abundant isotopes.
    #[default]
    Abundant,
    /// Standard atomic weights.
    Average,
}

impl Isotopes {
    /// Returns the lower-case name, as in JSON and options.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Abundant => "abundant",
            Self::Average => "average",
        }
    }
}

impl Species {
    /// Returns the element.
    pub const fn element(self) -> Element {
        match self {
            Self::Element(element) => element,
            Self::Isotope(isotope) => isotope.element(),
        }
    }

    /// Returns the mass of one atom, u. An element without a standard atomic weight has the mass of
    /// its longest-lived isotope.
    pub fn mass(self, isotopes: Isotopes) -> f64 {
        match (self, isotopes) {
            (Self::Isotope(isotope), _) => isotope.mass(),
            (Self::Element(element), Isotopes::Abundant) => Isotope::first(element).mass(),
            (Self::Element(element), Isotopes::Average) => {
                element.weight().unwrap_or_else(|| Isotope::first(element).mass())
            }
        }
    }

    /// Returns the species of an element and a mass number; `None` if the mass of that isotope is
    /// not in the table.
    pub fn with_mass_number(element: Element, mass_number: Option<u16>) -> Option<Self> {
        match mass_number {
            None => Some(Self::Element(element)),
            Some(number) => Isotope::new(element, number).map(Self::Isotope),
        }
    }
}

/// Formats the species as in a formula: `C`, `[13C]`, `D`.
impl fmt::Display for Species {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Element(element) => element.fmt(f),
            Self::Isotope(isotope) => match (isotope.element().number(), isotope.mass_number()) {
                (1, 2) => f.write_str("D"),
                (1, 3) => f.write_str("T"),
                _ => write!(f, "[{isotope}]"),
            },
        }
    }
}

/// Meaning of an atom label.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Label {
    /// Element or isotope.
    Atom(Species),
    /// Element followed by an atom number: `C13` is the thirteenth atom.
    Numbered(Element),
    /// Isotope whose mass is not in the table.
    UnknownIsotope(Element, u16),
    /// Point without mass: a ghost atom, a lone pair, a centre.
    Massless,
}

/// Parses `C`, `D`, `13C`, `C-13`, `[13C]`, `^13C`, `C(Iso=13)`, `C7` (the seventh atom), `X`.
pub(crate) fn label(text: &str) -> Option<Label> {
    const MASSLESS: [&str; 7] = ["X", "Xx", "Bq", "Du", "Lp", "Ep", "Gh"];
    if MASSLESS.iter().any(|name| name.eq_ignore_ascii_case(text)) {
        return Some(Label::Massless);
    }
    let bare = text.strip_prefix('[').and_then(|t| t.strip_suffix(']')).unwrap_or(text);
    let bare = bare.strip_prefix('^').unwrap_or(bare);
    let (front, rest) = digits(bare);
    let letters = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_alphabetic()).len();
    let (symbol, back) = rest.split_at(letters);
    if !front.is_empty() && back.is_empty() {
        return isotope_label(symbol, front);
    }
    if !front.is_empty() {
        return None;
    }
    if back.is_empty() {
        return Some(Label::Atom(match symbol {
            "D" | "d" => Species::Isotope(hydrogen(2)?),
            "T" | "t" => Species::Isotope(hydrogen(3)?),
            _ => Species::Element(Element::from_symbol(symbol)?),
        }));
    }
    let lower = back.to_ascii_lowercase();
    let isotope = lower.strip_prefix("(iso=").and_then(|t| t.strip_suffix(')'));
    if let Some(number) = isotope.or_else(|| lower.strip_prefix('-')) {
        return isotope_label(symbol, number);
    }
    if !back.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    Element::from_symbol(symbol).map(Label::Numbered)
}

fn isotope_label(symbol: &str, number: &str) -> Option<Label> {
    let element = Element::from_symbol(symbol)?;
    let number = number.parse().ok()?;
    Some(match Isotope::new(element, number) {
        Some(isotope) => Label::Atom(Species::Isotope(isotope)),
        None => Label::UnknownIsotope(element, number),
    })
}

fn hydrogen(mass_number: u16) -> Option<Isotope> {
    Isotope::new(Element::from_number(1)?, mass_number)
}

/// Splits off the digits at the start.
fn digits(text: &str) -> (&str, &str) {
    text.split_at(text.len() - text.trim_start_matches(|c: char| c.is_ascii_digit()).len())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mass(text: &str) -> Option<f64> {
        match label(text) {
            Some(Label::Atom(species)) => Some(species.mass(Isotopes::Abundant)),
            _ => None,
        }
    }

    #[test]
    fn labels_say_element_and_isotope() {
        for text in ["13C", "C-13", "[13C]", "^13C", "C(Iso=13)", "13c"] {
            assert_eq!(mass(text), Some(13.003_354_835_34), "{text}");
        }
        assert_eq!(mass("D"), Some(2.014_101_777_844));
        assert_eq!(mass("T"), Some(3.016_049_281_32));
        assert_eq!(mass("2H"), mass("D"));
        assert_eq!(mass("CL"), Some(34.968_852_694));
        assert_eq!(label("C13"), Element::from_symbol("C").map(Label::Numbered));
        assert_eq!(label("25C"), Element::from_symbol("C").map(|c| Label::UnknownIsotope(c, 25)));
        assert_eq!(label("Bq"), Some(Label::Massless));
        for text in ["", "Qq", "13", "1C3", "C-", "C+", "[C", "C(Iso=)", "99999C", "Ω"] {
            assert_eq!(label(text), None, "{text}");
        }
    }

    #[test]
    fn every_element_has_its_first_isotope_and_a_mass_near_its_number() {
        for number in 1..=118 {
            let element = Element::from_number(number).unwrap();
            assert_eq!(Element::from_symbol(element.symbol()), Some(element));
            let first = Isotope::first(element);
            assert!(Isotope::all(element).any(|i| i == first));
            for isotope in Isotope::all(element) {
                assert!((isotope.mass() - f64::from(isotope.mass_number())).abs() < 0.25);
            }
            if let Some(weight) = element.weight() {
                let mut masses = Isotope::all(element).map(Isotope::mass);
                assert!(
                    masses.next().unwrap() <= weight * (1.0 + 1e-8)
                        && weight * (1.0 - 1e-8) <= masses.last().unwrap()
                );
            }
        }
        assert_eq!((Element::from_number(0), Element::from_number(119)), (None, None));
    }
}
