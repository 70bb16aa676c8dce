//! Names of symbols with their indices.

use std::collections::HashMap;

use polhode_algebra::{Accent, Fence, Formula, Style};

/// Letters that are indices.
pub(super) const INDICES: &str = "ijklαβ";

/// Symbol apart from its dots.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Name {
    pub(super) letter: String,
    pub(super) is_hat: bool,
    pub(super) is_bold: bool,
    pub(super) is_matrix: bool,
    pub(super) index: Vec<char>,
}

impl Name {
    /// Returns the values of the indices of a defined name that make it another name.
    pub(super) fn matched(&self, name: &Self) -> Option<HashMap<char, usize>> {
        let is_alike = Self { index: name.index.clone(), ..self.clone() } == *name;
        let mut values = HashMap::new();
        for (pattern, value) in self.index.iter().zip(&name.index) {
            let is_match = match value.to_digit(10).map(|number| number as usize) {
                Some(number) if INDICES.contains(*pattern) => {
                    *values.entry(*pattern).or_insert(number) == number
                }
                _ => pattern == value,
            };
            if !is_match {
                return None;
            }
        }
        (is_alike && self.index.len() == name.index.len()).then_some(values)
    }
}

pub(super) fn digit(value: usize) -> char {
    char::from_digit(value as u32, 10).unwrap_or('?')
}

/// Returns the name of a symbol and the number of its dots; `None` for other formulas.
pub(super) fn name(formula: &Formula) -> Option<(Name, usize)> {
    let plain = |letter: &str, is_bold| Name {
        letter: letter.to_owned(),
        is_hat: false,
        is_bold,
        is_matrix: false,
        index: Vec::new(),
    };
    match formula {
        Formula::Letter(letter, style) => Some((plain(letter, *style == Style::Bold), 0)),
        Formula::Group(Fence::Braces, inside) => {
            let (name, dots) = name(inside)?;
            Some((Name { is_bold: false, is_matrix: true, ..name }, dots))
        }
        Formula::Accent(accent, base) => {
            let (name, dots) = name(base)?;
            match accent {
                Accent::Hat => Some((Name { is_hat: true, ..name }, dots)),
                Accent::Dot => Some((name, dots + 1)),
                Accent::DoubleDot => Some((name, dots + 2)),
                _ => None,
            }
        }
        Formula::Subscript(base, index) => {
            let (name, dots) = name(base)?;
            match &**index {
                // A word is a part of the name: T_rot.
                Formula::Letter(word, Style::Upright) => {
                    let letter = name.letter + word;
                    Some((Name { letter, ..name }, dots))
                }
                Formula::Letter(index, _) | Formula::Number(index) => {
                    Some((Name { index: index.chars().collect(), ..name }, dots))
                }
                _ => None,
            }
        }
        _ => None,
    }
}
