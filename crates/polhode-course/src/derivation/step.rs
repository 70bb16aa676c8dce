//! Steps of a derivation.

use polhode_algebra::Formula;

use super::notation;

/// Step of a derivation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// Start of a part, with its title.
    Part(&'static str),
    /// Paragraph without a formula.
    Remark(&'static str),
    /// Paragraph and the formula that it leads to.
    Formula {
        /// Text before the formula, in lines.
        text: &'static str,
        /// Formula in the [notation].
        notation: &'static str,
        /// Reason why it holds.
        ground: Ground,
        /// True if the formula is an answer of the derivation.
        is_result: bool,
    },
    /// Definition for the checks of later steps, which is not printed, in the [notation].
    Setting(&'static str),
}

/// Reason why a formula holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ground {
    /// Identity under the definitions of earlier steps.
    Shown,
    /// Definition of the symbol on its left.
    Definition,
    /// Assumption about the body, its motion or the axes, or an equation that follows from one.
    Hypothesis,
    /// Law of mechanics.
    Law,
    /// Theorem of algebra or calculus.
    Theorem,
    /// Approximation, or limit of many particles.
    Limit,
}

impl Step {
    /// Returns the formula that is printed, if there is one.
    pub fn formula(&self) -> Option<Formula> {
        match self {
            Self::Formula { notation, .. } => notation::read(notation),
            _ => None,
        }
    }

    /// Returns the formula that gives the symbol on its left the value on its right in later steps.
    pub fn definition(&self) -> Option<Formula> {
        match self {
            Self::Formula {
                ground: Ground::Definition | Ground::Hypothesis | Ground::Law, notation, ..
            }
            | Self::Setting(notation) => notation::read(notation),
            _ => None,
        }
    }

    /// Reads a paragraph: its text, and a formula after the reason why it holds.
    pub(super) fn read(paragraph: &'static str) -> Self {
        if let Some(title) = paragraph.strip_prefix("## ") {
            return Self::Part(title);
        }
        let starts = paragraph.match_indices('\n').map(|(at, _)| at + 1);
        for start in core::iter::once(0).chain(starts) {
            let (text, line) = paragraph.split_at(start);
            let Some((reason, notation)) = line.split_once(": ") else { continue };
            if reason == "setting" {
                return Self::Setting(notation);
            }
            let (reason, is_result) = reason.strip_suffix(", result").map_or((reason, false), |r| (r, true));
            if let Some(ground) = Ground::read(reason) {
                return Self::Formula { text: text.trim_end(), notation, ground, is_result };
            }
        }
        Self::Remark(paragraph)
    }
}

impl Ground {
    fn read(word: &str) -> Option<Self> {
        Some(match word {
            "shown" => Self::Shown,
            "definition" => Self::Definition,
            "hypothesis" => Self::Hypothesis,
            "law" => Self::Law,
            "theorem" => Self::Theorem,
            "limit" => Self::Limit,
            _ => return None,
        })
    }
}
