//! Symbols from their names.

use super::letter::{from_subscript, greek};
use super::{Formula, Style};

impl Formula {
    /// Returns the symbol with a name: a letter, or the name of a Greek letter, with an index.
    ///
    /// `m1`, `m_1` and `m₁` are m₁, `omega0` is ω₀, `I_xy` is I with the index xy. Other names are
    /// words: `arm`.
    pub fn named(name: &str) -> Self {
        let (base, index) = split(name);
        let letter = letter_of(base);
        if index.is_empty() {
            return letter;
        }
        letter.index(match index.bytes().all(|c| c.is_ascii_digit()) {
            true => Self::Number(index),
            // Two letters are two indices; more are a word.
            false if index.chars().count() == 2 => Self::Letter(index, Style::Italic),
            false => letter_of(&index),
        })
    }
}

/// Splits a name into its base and index: `m_1`, `m1`, `m₁`.
fn split(name: &str) -> (&str, String) {
    if let Some((base, index)) =
        name.split_once('_').filter(|(base, index)| !base.is_empty() && !index.is_empty())
    {
        return (base, index.to_owned());
    }
    let base = name.trim_end_matches(|c: char| c.is_ascii_digit() || from_subscript(c).is_some());
    if base.is_empty() {
        return (name, String::new());
    }
    (base, name[base.len()..].chars().map(|c| from_subscript(c).unwrap_or(c)).collect())
}

fn letter_of(name: &str) -> Formula {
    match greek(name) {
        Some(letter) => Formula::Letter(letter.into(), Style::Italic),
        None if name.chars().count() == 1 => Formula::Letter(name.to_owned(), Style::Italic),
        None => Formula::Letter(name.to_owned(), Style::Upright),
    }
}
