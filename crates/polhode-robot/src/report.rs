//! A model and what is wrong with it, ready to be read: by people ([`CheckReport::to_text`]), as a table of its links
//! ([`CheckReport::to_table`]), by programs ([`CheckReport::to_json`]).

use std::collections::BTreeMap;

use crate::check::LinkGeometry;
use crate::finding::{Finding, Severity};
use crate::line_index::LineIndex;
use crate::model::{ModelFormat, RobotModel, Span};
use crate::repair::{Repaired, repaired};

/// A checked model.
#[derive(Clone, Debug)]
pub struct CheckReport {
    /// The model.
    pub model: RobotModel,
    /// What its links look like, in their order: for the densities of the table.
    pub geometry: Vec<LinkGeometry>,
    /// What is wrong with it.
    pub findings: Vec<Finding>,
    /// What was repaired, and where that was written; `None` if nothing was asked for.
    pub fixed: Option<Fixed>,
}

/// A repaired model.
#[derive(Clone, Debug)]
pub struct Fixed {
    /// Where it was written.
    pub out: String,
    /// What was changed.
    pub repaired: Repaired,
    /// What is wrong with it still.
    pub remaining: Vec<Finding>,
}

/// How many findings and links there are of each kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Findings: [`Severity::Impossible`].
    pub impossible: usize,
    /// Findings: [`Severity::Suspect`].
    pub suspect: usize,
    /// Findings: [`Severity::Note`].
    pub note: usize,
    /// Links about which nothing was found, or notes only.
    pub ok: usize,
}

impl CheckReport {
    /// How many findings and links there are of each kind.
    pub fn counts(&self) -> Counts {
        let of = |severity| self.findings.iter().filter(|f| f.severity == severity).count();
        let verdicts = self.verdicts();
        let good = |name: &str| verdicts.get(name).copied().unwrap_or(Severity::Note) == Severity::Note;
        Counts {
            impossible: of(Severity::Impossible),
            suspect: of(Severity::Suspect),
            note: of(Severity::Note),
            ok: self.model.links.iter().filter(|link| good(&link.name.text)).count(),
        }
    }

    /// The worst that was found, of each subject about which something was.
    pub(crate) fn verdicts(&self) -> BTreeMap<&str, Severity> {
        let mut verdicts: BTreeMap<&str, Severity> = BTreeMap::new();
        for Finding { subject, severity, .. } in &self.findings {
            let worst = verdicts.entry(subject).or_insert(*severity);
            *worst = (*worst).max(*severity);
        }
        verdicts
    }

    /// What repairs would change.
    pub(crate) fn possible_repairs(&self) -> Repaired {
        repaired(&self.model, &self.findings)
    }

    /// Links that say something of their mass.
    pub(crate) fn inertials(&self) -> usize {
        self.model.links.iter().filter(|link| link.inertial.is_some()).count()
    }
}

/// Line and column of a span's first byte.
pub(crate) fn place(lines: &LineIndex<'_>, span: &Span) -> (usize, usize) {
    lines.place(span.start)
}

/// A severity in lower case.
pub(crate) const fn severity_name(severity: Severity) -> &'static str {
    match severity {
        Severity::Impossible => "impossible",
        Severity::Suspect => "suspect",
        Severity::Note => "note",
    }
}

/// The name of a language, as people write it.
pub(crate) const fn format_name(format: ModelFormat) -> &'static str {
    match format {
        ModelFormat::Urdf => "URDF",
        ModelFormat::Sdf => "SDF",
        ModelFormat::Mjcf => "MJCF",
    }
}
