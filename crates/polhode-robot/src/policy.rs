//! What of a model's findings counts: severities of a user's own, what is allowed and why, what is known already.
//!
//! Nothing is lost: what is allowed or known is settled and stays in the report, and an allowance without a reason or without a finding is
//! a finding itself.

pub mod baseline;
mod comment;
pub mod config;
pub mod date;
pub mod glob;
mod identity;

use std::collections::{BTreeMap, BTreeSet};

use crate::finding::{Finding, Severity};
use crate::model::RobotModel;
use crate::rule::rule;
use baseline::{Baseline, KnownFinding};
use config::Config;
use date::Date;

/// What a user asks for. By default everything counts but what comments of the model allow.
#[derive(Clone, Debug, Default)]
pub struct Policy {
    /// `polhode.toml`
    pub config: Config,
    /// Findings that are known.
    pub baseline: Option<Baseline>,
    /// For allowances that expire.
    pub today: Date,
}

/// A model's findings, each at its place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Judged {
    /// Those that count, in the order of the file.
    pub open: Vec<Finding>,
    /// What each of them is known by, whatever changes elsewhere in the file.
    pub ids: Vec<String>,
    /// Those that do not.
    pub settled: Vec<Settled>,
    /// How many there are of rules that are off.
    pub off: usize,
    /// Allowances of the configuration that allowed something, by their place in it.
    used: BTreeSet<usize>,
}

/// A finding that does not count.
#[derive(Clone, Debug, PartialEq)]
pub struct Settled {
    /// The finding.
    pub finding: Finding,
    /// As in [`Judged::ids`].
    pub id: String,
    /// Why it does not count.
    pub why: Reason,
}

/// Why a finding does not count.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// It is allowed, for a reason in the user's words.
    Allowed(String),
    /// A baseline has it.
    Known,
}

/// What is to be said of the policy itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remark {
    /// The file that it is about: `polhode.toml`, a baseline.
    pub file: String,
    /// Line and column in it, from 1.
    pub place: (usize, usize),
    /// A rule's: `"allow.unused"`.
    pub code: &'static str,
    /// How bad it is; `None` if its rule is off.
    pub severity: Option<Severity>,
    /// What, in a line.
    pub message: String,
}

/// What allows what is said of a link, by its place among the comments of the model or the entries of the configuration.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Allowing {
    Comment(usize),
    Entry(usize),
}

impl Remark {
    /// What it is known by.
    pub(crate) fn id(&self) -> String {
        identity::hash([self.code, &self.file, &self.message])
    }
}

impl Policy {
    /// What becomes of the findings in a model. `file` is its name for globs and baselines: relative, with slashes.
    pub fn judge(&self, file: &str, model: &RobotModel, findings: Vec<Finding>) -> Judged {
        let comments = comment::comments(model);
        // Of a finding about several links each has to be allowed, whichever way.
        let allowing = |finding: &Finding| -> Option<Vec<Allowing>> {
            let is_included = model.is_included(&finding.span);
            let allows = |of: &String| {
                let comment = comments.iter().position(|one| one.allows(finding.code, of, is_included));
                let entry = || self.config.allowance(file, finding.code, of, self.today);
                comment.map(Allowing::Comment).or_else(|| entry().map(Allowing::Entry))
            };
            std::iter::once(&finding.subject).chain(&finding.others).map(allows).collect()
        };
        let by_finding: Vec<Vec<Allowing>> =
            findings.iter().map(|finding| allowing(finding).unwrap_or_default()).collect();
        let used: BTreeSet<(Allowing, &str)> = findings
            .iter()
            .zip(&by_finding)
            .flat_map(|(finding, all)| all.iter().map(|one| (*one, finding.code)))
            .collect();
        let about_comments: Vec<(Vec<Allowing>, Finding)> = comments
            .iter()
            .enumerate()
            .filter_map(|(k, c)| c.fault(|code| used.contains(&(Allowing::Comment(k), code))))
            .map(|finding| (allowing(&finding).unwrap_or_default(), finding))
            .collect();
        let mut all: Vec<(Vec<Allowing>, Finding)> =
            by_finding.into_iter().zip(findings).chain(about_comments).collect();
        all.sort_by_key(|(_, finding)| finding.span.start);
        let ids = identity::ids(file, all.iter().map(|(_, finding)| finding));

        let mut judged = Judged::default();
        for ((allowing, mut finding), id) in all.into_iter().zip(ids) {
            match self.config.severity_of(finding.code) {
                Some(None) => {
                    judged.off += 1;
                    continue;
                }
                Some(Some(severity)) => finding.severity = severity,
                None => {}
            }
            judged.used.extend(allowing.iter().filter_map(|one| match one {
                Allowing::Entry(k) => Some(*k),
                Allowing::Comment(_) => None,
            }));
            let reason = allowing.first().and_then(|first| match first {
                Allowing::Comment(k) => comments.get(*k).map(|comment| &comment.reason),
                Allowing::Entry(k) => self.config.allowances.get(*k).map(|entry| &entry.reason),
            });
            let why = match reason {
                Some(reason) => Some(Reason::Allowed(reason.clone())),
                None if self.baseline.as_ref().is_some_and(|known| known.has(&id)) => Some(Reason::Known),
                None => None,
            };
            match why {
                Some(why) => judged.settled.push(Settled { finding, id, why }),
                None => {
                    judged.open.push(finding);
                    judged.ids.push(id);
                }
            }
        }
        judged
    }

    /// What is to be said of the configuration and the baseline after these models were judged: allowances that have expired or allow
    /// nothing in them, and what a baseline knows and is not there. `is_there` says whether a file is.
    pub fn remarks<'a>(
        &self,
        judged: impl Iterator<Item = (&'a str, &'a Judged)>,
        is_there: impl Fn(&str) -> bool,
    ) -> Vec<Remark> {
        let judged: BTreeMap<&str, &Judged> = judged.collect();
        let used: BTreeSet<usize> = judged.values().flat_map(|judged| judged.used.iter().copied()).collect();
        let mut remarks = Vec::new();
        for (k, allowance) in self.config.allowances.iter().enumerate() {
            let asked = judged.keys().any(|file| allowance.file.matches(file))
                || allowance.file.plain().is_some_and(|file| !is_there(file));
            let (code, message) = if let Some(day) = allowance.expires.filter(|day| *day <= self.today) {
                ("allow.expired", format!("{} in {}: expired on {day}", allowance.rule, allowance.file))
            } else if asked && !used.contains(&k) {
                ("allow.unused", format!("{} in {}: nothing to allow", allowance.rule, allowance.file))
            } else {
                continue;
            };
            remarks.push(self.remark(&self.config.file, allowance.place, code, message));
        }
        let Some(baseline) = &self.baseline else { return remarks };
        let there: BTreeSet<&str> = judged
            .values()
            .flat_map(|judged| judged.ids.iter().chain(judged.settled.iter().map(|settled| &settled.id)))
            .map(String::as_str)
            .collect();
        for KnownFinding { id, rule, file, link } in &baseline.findings {
            let is_asked = judged.contains_key(file.as_str()) || !is_there(file);
            if is_asked && !there.contains(id.as_str()) {
                let about = if link.is_empty() { String::new() } else { format!(" of {link}") };
                let message = format!("{rule}{about} in {file}: it is not there any more");
                remarks.push(self.remark(&baseline.file, (1, 1), "baseline.gone", message));
            }
        }
        remarks
    }

    fn remark(&self, file: &str, place: (usize, usize), code: &'static str, message: String) -> Remark {
        let usual = rule(code).map_or(Severity::Note, |rule| rule.severity);
        let severity = self.config.severity_of(code).unwrap_or(Some(usual));
        Remark { file: file.to_owned(), place, code, severity, message }
    }
}
