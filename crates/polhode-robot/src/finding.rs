//! Findings about a model.

use serde::{Deserialize, Serialize};

use crate::span::Span;

/// Severity of a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Severity {
    /// Information; does not fail by default.
    Note,
    /// Physically possible, but probably an error.
    Suspect,
    /// Physically impossible, or unusable for every program.
    Impossible,
}

impl Severity {
    /// All severities, the worst first.
    pub const ALL: [Self; 3] = [Self::Impossible, Self::Suspect, Self::Note];

    /// Returns the severity with this lower-case name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|severity| severity.name() == name)
    }

    /// Returns the lower-case name.
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

/// Finding: the error, its place, the rule, and the repair.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Stable code for programs: `"inertia.triangle"`.
    pub code: &'static str,
    pub severity: Severity,
    /// Name of the link or joint; empty if the finding is about the whole model.
    pub subject: String,
    /// Names of further links that the finding is about.
    pub others: Vec<String>,
    /// Position in the model's text.
    pub span: Span,
    /// Message with numbers and units, one line: `"i1 + i2 = 0.00496 < i3 = 1.67636 kg·m²"`.
    pub message: String,
    /// Rule that is broken, one line.
    pub rule: String,
    /// Numbers of the message by name, in SI units, for programs.
    pub numbers: Vec<(&'static str, f64)>,
    /// Repair, if exactly one is consistent with all evidence of the link.
    pub repair: Option<Repair>,
    /// Possible tensors nearest to an impossible one.
    pub nearest: Option<Proposal>,
    /// Place in another model with which the finding compares.
    pub related: Option<Related>,
}

/// Place in another model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Related {
    /// Name of the file.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
}

impl Finding {
    /// Creates a finding without numbers and repair about one link or joint, or about the model if
    /// `subject` is empty.
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
        let (repair, nearest, related) = (None, None, None);
        Self { code, severity, subject, others, span, message, rule, numbers, repair, nearest, related }
    }
}

/// Repair that is the only consistent one.
#[derive(Clone, Debug, PartialEq)]
pub struct Repair {
    /// Description, one line: `"izz 1676359E-6 → 1676.359E-6"`.
    pub description: String,
    /// Spans of the model's text and their replacements. The spans do not overlap.
    pub edits: Vec<(Span, String)>,
}

/// Possible tensors nearest to an impossible one in two metrics, or the reason why there is none.
#[derive(Clone, Debug, PartialEq)]
pub struct Proposal {
    /// Nearest in the Frobenius norm.
    pub frobenius: Result<NearestTensor, String>,
    /// Nearest in the affine-invariant metric, in which the log-Euclidean distance is the same.
    pub affine_invariant: Result<NearestTensor, String>,
}

/// Proposed tensor about the centre of mass, along the inertial's axes.
#[derive(Clone, Debug, PartialEq)]
pub struct NearestTensor {
    /// Description, one line: `"ixx 1.33334, …, iyz 0 kg·m², a flat body; distance …"`.
    pub description: String,
    /// Elements xx, yy, zz, xy, xz, yz, kg·m², rounded such that the tensor is possible.
    pub tensor: [f64; 6],
    /// Distance of the unrounded tensor, kg·m², or without a unit in the affine-invariant metric.
    pub distance: f64,
}

impl Proposal {
    /// Returns a label and a description for each metric.
    pub fn lines(&self) -> [(&'static str, &str); 2] {
        [
            ("nearest possible tensor, Frobenius: ", description(&self.frobenius)),
            ("nearest possible tensor, affine-invariant: ", description(&self.affine_invariant)),
        ]
    }
}

fn description(nearest: &Result<NearestTensor, String>) -> &str {
    match nearest {
        Ok(nearest) => &nearest.description,
        Err(why) => why,
    }
}
