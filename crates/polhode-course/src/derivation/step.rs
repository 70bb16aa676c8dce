//! Steps of a derivation.

/// Step of a derivation. Formulas are in the notation of the module `notation`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// Start of a part, with its title.
    Part(&'static str),
    /// Sentences without a formula.
    Remark(&'static str),
    /// Sentences and the formula that they lead to.
    Formula {
        /// Sentences before the formula.
        text: &'static str,
        /// Formula in the notation.
        notation: &'static str,
        /// Reason why it holds.
        ground: Ground,
    },
    /// Definition for the checks of the later steps, which is not printed: the position of the last
    /// particle from those of the others and the centre of mass.
    Setting(&'static str),
}

/// Reason why a formula holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ground {
    /// Identity under the definitions of the earlier steps, checked with generic components.
    Identity,
    /// As [`Ground::Identity`]; the formula is the result of the derivation.
    Result,
    /// Definition of its left side.
    Definition,
    /// Assumption about the body, its motion or the axes, or an equation that states the assumption
    /// in another form.
    Hypothesis,
    /// Law of mechanics.
    Law,
    /// Theorem of algebra or calculus.
    Theorem,
    /// Approximation, or limit of many particles.
    Limit,
}

impl Ground {
    /// Returns true for identities, which are checked.
    pub const fn is_identity(self) -> bool {
        matches!(self, Self::Identity | Self::Result)
    }

    /// Returns true if the symbol on the left has the value on the right from there on.
    pub(super) const fn defines(self) -> bool {
        matches!(self, Self::Definition | Self::Hypothesis | Self::Law)
    }
}

pub(super) const fn part(title: &'static str) -> Step {
    Step::Part(title)
}

pub(super) const fn remark(text: &'static str) -> Step {
    Step::Remark(text)
}

pub(super) const fn setting(notation: &'static str) -> Step {
    Step::Setting(notation)
}

/// Returns a formula that is checked.
pub(super) const fn shown(text: &'static str, notation: &'static str) -> Step {
    Step::Formula { text, notation, ground: Ground::Identity }
}

/// Returns the result, which is checked.
pub(super) const fn result(text: &'static str, notation: &'static str) -> Step {
    Step::Formula { text, notation, ground: Ground::Result }
}

/// Returns a formula that holds for another reason than algebra.
pub(super) const fn given(ground: Ground, text: &'static str, notation: &'static str) -> Step {
    Step::Formula { text, notation, ground }
}
