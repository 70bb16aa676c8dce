//! A model and what is wrong with it, ready to be read: by people ([`CheckReport::to_text`]), as a table of its links
//! ([`CheckReport::to_table`]), by programs ([`CheckReport::to_json`]).

use std::collections::BTreeMap;

use crate::check::LinkGeometry;
use crate::finding::{Finding, Severity};
use crate::model::{ModelFormat, RobotModel};
use crate::policy::Judged;
use crate::repair::{Repaired, repaired};

/// A checked model.
#[derive(Clone, Debug)]
pub struct CheckReport {
    /// The model.
    pub model: RobotModel,
    /// What its links look like, in their order: for the densities of the table.
    pub geometry: Vec<LinkGeometry>,
    /// What is wrong with it, and what of that counts.
    pub judged: Judged,
    /// What was repaired, and where that was written; `None` if nothing was asked for.
    pub fixed: Option<Fixed>,
    /// The model after all fixes; `None` if that was not computed, or if nothing can be fixed.
    pub prospect: Option<Prospect>,
}

/// A model as it would be after all fixes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Prospect {
    /// Places of the text that the fixes change.
    pub changes: usize,
    /// Impossible and suspect findings that remain.
    pub remaining: usize,
}

impl Prospect {
    /// Counts what [`crate::repair::proved`] returns.
    pub fn of(repaired: &Repaired, remaining: &[Finding]) -> Self {
        let remaining = remaining.iter().filter(|finding| finding.severity > Severity::Note).count();
        Self { changes: repaired.changes, remaining }
    }
}

/// A repaired model.
#[derive(Clone, Debug)]
pub struct Fixed {
    /// Where it was written; `None` if only the diff was asked for.
    pub out: Option<String>,
    /// What was changed.
    pub repaired: Repaired,
    /// The diff, the proof of each change above it.
    pub diff: String,
    /// What is wrong with it still.
    pub remaining: Vec<Finding>,
}

/// How many there are of each kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// [`Severity::Impossible`]
    pub impossible: usize,
    /// [`Severity::Suspect`]
    pub suspect: usize,
    /// [`Severity::Note`]
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

    /// All together.
    pub const fn sum(self) -> usize {
        self.impossible + self.suspect + self.note
    }
}

impl CheckReport {
    /// A checked model that is not repaired.
    pub const fn new(model: RobotModel, geometry: Vec<LinkGeometry>, judged: Judged) -> Self {
        Self { model, geometry, judged, fixed: None, prospect: None }
    }

    /// What counts of what is wrong with it.
    pub fn findings(&self) -> &[Finding] {
        &self.judged.open
    }

    /// Findings by their severity.
    pub fn counts(&self) -> Counts {
        Counts::of(self.findings().iter().map(|f| f.severity))
    }

    /// Links by the worst that was found about each; the others are without findings.
    pub fn link_counts(&self) -> Counts {
        let verdicts = self.verdicts();
        Counts::of(self.model.links.iter().filter_map(|link| verdicts.get(link.name.text.as_str()).copied()))
    }

    /// The worst that was found, of each subject about which something was.
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

    /// Counts what fixes would change and leave. If the fixed text was not checked, each fix is
    /// taken to remove its own finding alone.
    pub(crate) fn prospect(&self) -> Prospect {
        self.prospect.unwrap_or_else(|| {
            let repaired = repaired(&self.model, self.findings());
            let rest = self.findings().iter().enumerate();
            let rest = rest.filter(|(k, _)| repaired.applied.binary_search(k).is_err());
            let rest: Vec<Finding> = rest.map(|(_, finding)| finding.clone()).collect();
            Prospect::of(&repaired, &rest)
        })
    }

    /// Links that say something of their mass.
    pub(crate) fn inertials(&self) -> usize {
        self.model.links.iter().filter(|link| link.inertial.is_some()).count()
    }
}

/// The name of a language, as people write it.
pub(crate) const fn format_name(format: ModelFormat) -> &'static str {
    match format {
        ModelFormat::Urdf => "URDF",
        ModelFormat::Sdf => "SDF",
        ModelFormat::Mjcf => "MJCF",
        ModelFormat::Usd => "USD",
        ModelFormat::Osim => "OSIM",
    }
}
