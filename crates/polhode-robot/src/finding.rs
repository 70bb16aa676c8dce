//! What is wrong with a model.

use serde::{Deserialize, Serialize};

use crate::span::Span;

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Severity {
    /// Worth knowing; no reason to fail.
    Note,
    /// Possible, but probably not meant.
    Suspect,
    /// No body has it, or no program can use it.
    Impossible,
}

impl Severity {
    /// All, the worst first.
    pub const ALL: [Self; 3] = [Self::Impossible, Self::Suspect, Self::Note];

    /// Returns the severity of a name in lower case.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|severity| severity.name() == name)
    }

    /// In lower case.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Impossible => "impossible",
            Self::Suspect => "suspect",
            Self::Note => "note",
        }
    }
}

#[cfg(feature = "arguments")]
impl clap::ValueEnum for Severity {
    fn value_variants<'a>() -> &'a [Self] {
        &Self::ALL
    }

    fn to_possible_value(&self) -> Option<clap::builder::PossibleValue> {
        Some(self.name().into())
    }
}

/// Something wrong, where, why, and what would repair it.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// A stable name for programs: `"inertia.triangle"`.
    pub code: &'static str,
    /// How bad it is.
    pub severity: Severity,
    /// The link or joint; empty if it is about the whole model.
    pub subject: String,
    /// Further links that it is about.
    pub others: Vec<String>,
    /// Where in the model's text.
    pub span: Span,
    /// What is wrong, with the numbers and their units, in a line: `"i1 + i2 = 0.00496 < i3 = 1.67636 kg·m²"`.
    pub message: String,
    /// The rule that it breaks, in a line.
    pub rule: String,
    /// The numbers of the message, by name and in SI units, for programs.
    pub numbers: Vec<(&'static str, f64)>,
    /// The fix, if exactly one is consistent with all evidence of the link.
    pub repair: Option<Repair>,
}

impl Finding {
    /// Creates a finding about a link or joint alone, or with an empty `subject` about the model, without numbers and repair.
    pub(crate) fn new(
        code: &'static str,
        severity: Severity,
        subject: &str,
        span: Span,
        message: impl Into<String>,
        rule: &str,
    ) -> Self {
        let (subject, rule, message) = (subject.to_owned(), rule.to_owned(), message.into());
        let (others, numbers) = (Vec::new(), Vec::new());
        Self { code, severity, subject, others, span, message, rule, numbers, repair: None }
    }
}

/// A repair that is sure.
#[derive(Clone, Debug, PartialEq)]
pub struct Repair {
    /// What it does, in a line: `"izz 1676359E-6 → 1676.359E-6"`.
    pub description: String,
    /// Text to put in place of spans of the model's text. They do not overlap.
    pub edits: Vec<(Span, String)>,
}
