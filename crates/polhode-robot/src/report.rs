//! Model with its findings, for output as text ([`CheckReport::to_text`]), as a table of links
//! ([`CheckReport::to_table`]) or as JSON ([`CheckReport::to_json`]).

use std::collections::BTreeMap;

use crate::check::LinkGeometry;
use crate::finding::{Finding, Severity};
use crate::model::{ModelFormat, RobotModel};
use crate::policy::Judged;
use crate::repair::{Repaired, repaired};

/// Report of a checked model.
#[derive(Clone, Debug)]
pub struct CheckReport {
    /// Model as read.
    pub model: RobotModel,
    /// Measured geometry of the links, in their order, for the densities in the table.
    pub geometry: Vec<LinkGeometry>,
    /// Findings after the policy.
    pub judged: Judged,
    /// Repaired model; `None` if no repair was requested.
    pub fixed: Option<Fixed>,
    /// Expected result of all fixes; `None` if it was not computed, or if nothing can be fixed.
    pub prospect: Option<Prospect>,
}

/// Expected result of all fixes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Prospect {
    /// Number of text positions that the fixes change.
    pub changes: usize,
    /// Number of impossible and suspect findings that remain.
    pub remaining: usize,
}

impl Prospect {
    /// Counts the result of [`crate::repair::proved`].
    pub fn of(repaired: &Repaired, remaining: &[Finding]) -> Self {
        let remaining = remaining.iter().filter(|finding| finding.severity > Severity::Note).count();
        Self { changes: repaired.changes, remaining }
    }
}

/// Result of a repair: the text, the diff and the findings that remain.
#[derive(Clone, Debug)]
pub struct Fixed {
    /// Path of the output; `None` if only the diff was requested.
    pub out: Option<String>,
    /// Repaired text and the applied repairs.
    pub repaired: Repaired,
    /// Unified diff, with the proof of each change above it.
    pub diff: String,
    /// Findings that remain.
    pub remaining: Vec<Finding>,
}

/// Numbers of findings by severity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Number of [`Severity::Impossible`] findings.
    pub impossible: usize,
    /// Number of [`Severity::Suspect`] findings.
    pub suspect: usize,
    /// Number of [`Severity::Note`] findings.
    pub note: usize,
}

impl Counts {
    pub(crate) fn of(severities: impl Iterator<Item = Severity>) -> Self {
        severities.fold(Self::default(), |mut counts, severity| {
            match severity {
                Severity::Impossible => counts.impossible += 1,
                Severity::Suspect => counts.suspect += 1,
                Severity::Note => counts.note += 1,
            }
            counts
        })
    }

    /// Returns the total.
    pub const fn sum(self) -> usize {
        self.impossible + self.suspect + self.note
    }
}

impl CheckReport {
    /// Creates the report of a model without repairs.
    pub const fn new(model: RobotModel, geometry: Vec<LinkGeometry>, judged: Judged) -> Self {
        Self { model, geometry, judged, fixed: None, prospect: None }
    }

    /// Returns the findings that count.
    pub fn findings(&self) -> &[Finding] {
        &self.judged.open
    }

    /// Counts the findings by severity.
    pub fn counts(&self) -> Counts {
        Counts::of(self.findings().iter().map(|f| f.severity))
    }

    /// Counts the links by their worst finding. Links without findings are not counted.
    pub fn link_counts(&self) -> Counts {
        let verdicts = self.verdicts();
        Counts::of(self.model.links.iter().filter_map(|link| verdicts.get(link.name.text.as_str()).copied()))
    }

    /// Returns the worst severity for each subject with findings.
    pub(crate) fn verdicts(&self) -> BTreeMap<&str, Severity> {
        let mut verdicts: BTreeMap<&str, Severity> = BTreeMap::new();
        for Finding { subject, others, severity, .. } in self.findings() {
            for name in [subject].into_iter().chain(others) {
                let worst = verdicts.entry(name).or_insert(*severity);
                *worst = (*worst).max(*severity);
            }
        }
        verdicts
    }

    /// Counts the changes and the remaining findings after all fixes. If the fixed text was not
    /// checked, each fix is assumed to remove only its own finding.
    pub(crate) fn prospect(&self) -> Prospect {
        self.prospect.unwrap_or_else(|| {
            let repaired = repaired(&self.model, self.findings());
            let rest = self.findings().iter().enumerate();
            let rest = rest.filter(|(k, _)| repaired.applied.binary_search(k).is_err());
            let rest: Vec<Finding> = rest.map(|(_, finding)| finding.clone()).collect();
            Prospect::of(&repaired, &rest)
        })
    }

    /// Returns the number of links with an inertial.
    pub(crate) fn inertials(&self) -> usize {
        self.model.links.iter().filter(|link| link.inertial.is_some()).count()
    }
}

/// Returns the display name of a format.
pub(crate) const fn format_name(format: ModelFormat) -> &'static str {
    match format {
        ModelFormat::Urdf => "URDF",
        ModelFormat::Sdf => "SDF",
        ModelFormat::Mjcf => "MJCF",
        ModelFormat::Usd => "USD",
        ModelFormat::Osim => "OSIM",
    }
}
