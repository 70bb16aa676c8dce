//! Policy for a model's findings: severity overrides, allowances with reasons, and baselines.
//!
//! No finding is lost. Allowed and known findings are settled and stay in the report. An allowance
//! without a reason or without a matching finding is itself a finding.

pub mod baseline;
mod comment;
pub mod config;
pub mod date;
pub mod glob;
mod identity;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::finding::{Finding, Severity};
use crate::model::RobotModel;
use crate::rule::rule;
use baseline::{Baseline, KnownFinding};
use comment::Comment;
use config::Config;
use date::Date;

/// Policy of a user. By default every finding counts, except those that comments in the model
/// allow.
#[derive(Clone, Debug, Default)]
pub struct Policy {
    /// Configuration: `polhode.toml`.
    pub config: Config,
    /// Baseline of known findings.
    pub baseline: Option<Baseline>,
    /// Current date, for allowances that expire.
    pub today: Date,
}

/// Findings of a model after the policy, each with its place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Judged {
    /// Findings that count, in file order.
    pub open: Vec<Finding>,
    /// Identifiers of the open findings. They do not depend on changes elsewhere in the file.
    pub ids: Vec<String>,
    /// Findings that do not count.
    pub settled: Vec<Settled>,
    /// Number of findings of rules that are off.
    pub off: usize,
    /// Allowances of the configuration that allowed a finding, by their index.
    used: BTreeSet<usize>,
    /// Links that remain without an allowance, by the allowance that covers other links of the same
    /// finding.
    lacking: BTreeMap<usize, BTreeSet<String>>,
    /// Names of the included files.
    included: Vec<String>,
}

impl Judged {
    /// Returns findings that all count; `file` is the name of the model.
    pub(crate) fn open(file: &str, findings: Vec<Finding>) -> Self {
        Self { ids: identity::ids(file, findings.iter()), open: findings, ..Self::default() }
    }
}

/// Finding that does not count.
#[derive(Clone, Debug, PartialEq)]
pub struct Settled {
    pub finding: Finding,
    /// Identifier, as in [`Judged::ids`].
    pub id: String,
    /// Reason why the finding does not count.
    pub why: Reason,
}

/// Reason why a finding does not count.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// Allowed, with the reason in the user's words.
    Allowed(String),
    /// Known: in the baseline.
    Known,
}

/// Finding about the policy itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remark {
    /// File that the remark is about: `polhode.toml` or a baseline.
    pub file: String,
    /// Line and column in the file, from 1.
    pub place: (usize, usize),
    /// Code of the rule: `"allow.unused"`.
    pub code: &'static str,
    /// Severity; `None` if the rule is off.
    pub severity: Option<Severity>,
    /// Message, one line.
    pub message: String,
}

/// Allowance of one link of a finding: index of a comment of the model, or of an entry of the
/// configuration.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Allowing {
    Comment(usize),
    Entry(usize),
}

/// Finding with the allowance of each of its links, or the link's name if it has none. A finding is
/// allowed if every link has an allowance of either kind.
struct Allowed {
    finding: Finding,
    each: Vec<Result<Allowing, String>>,
}

impl Allowed {
    fn is_whole(&self) -> bool {
        self.each.iter().all(Result::is_ok)
    }

    /// Returns the links without an allowance.
    fn lacking(&self) -> BTreeSet<String> {
        self.each.iter().filter_map(|one| one.as_ref().err().cloned()).collect()
    }

    /// Returns the entries of the configuration that allow some of the links.
    fn entries(&self) -> Vec<usize> {
        let entry = |one: &Result<Allowing, String>| match one {
            Ok(Allowing::Entry(k)) => Some(*k),
            _ => None,
        };
        self.each.iter().filter_map(entry).collect()
    }
}

/// Explains why a finding stays open although one of its links is allowed: these other links are
/// not.
fn not_enough(lacking: &BTreeSet<String>) -> Option<String> {
    let names: Vec<&str> = lacking.iter().map(String::as_str).collect();
    let are = if names.len() == 1 { "is" } else { "are" };
    let message = || format!("the finding is also about {}, which {are} not allowed", names.join(", "));
    (!names.is_empty()).then(message)
}

impl Remark {
    /// Returns the identifier of the remark.
    pub(crate) fn id(&self) -> String {
        identity::hash([self.code, &self.file, &self.message])
    }
}

impl Policy {
    /// Applies the policy to the findings of a model. `name` returns the name of a file for globs
    /// and baselines: relative, with slashes.
    pub fn judge(
        &self,
        name: impl Fn(&Path) -> String,
        model: &RobotModel,
        findings: Vec<Finding>,
    ) -> Judged {
        let file = name(&model.path);
        let included: Vec<String> = model.included.iter().map(|source| name(&source.path)).collect();
        let comments = comment::comments(model);
        let allowing = |finding: Finding| -> Allowed {
            let within = model.included.iter().rposition(|source| source.start <= finding.span.start);
            let own = within.and_then(|k| included.get(k)).map_or(file.as_str(), String::as_str);
            let allows = |of: &String| {
                let is_included = within.is_some() && model.expansion.is_none();
                let comment = comments.iter().position(|one| one.allows(finding.code, of, is_included));
                let entry = || self.config.allowance(&[&file, own], finding.code, of, self.today);
                let by = comment.map(Allowing::Comment).or_else(|| entry().map(Allowing::Entry));
                by.ok_or_else(|| of.clone())
            };
            let each = std::iter::once(&finding.subject).chain(&finding.others).map(allows).collect();
            Allowed { finding, each }
        };
        let mut all: Vec<Allowed> = findings.into_iter().map(allowing).collect();
        let about_comments: Vec<Allowed> = comments
            .iter()
            .enumerate()
            .filter_map(|(k, comment)| {
                let uses = |one: &&Allowed| one.each.contains(&Ok(Allowing::Comment(k)));
                comment.fault(|code| {
                    let all: Vec<_> =
                        all.iter().filter(|one| one.finding.code == code).filter(uses).collect();
                    if all.iter().any(|one| one.is_whole()) {
                        return None;
                    }
                    Some(all.into_iter().flat_map(Allowed::lacking).collect())
                })
            })
            .map(allowing)
            .collect();
        all.extend(about_comments);
        all.sort_by_key(|one| one.finding.span.start);
        let ids = identity::ids(&file, all.iter().map(|one| &one.finding));

        let mut judged = Judged { included, ..Judged::default() };
        for (allowed, id) in all.into_iter().zip(ids) {
            let reasons = self.reasons(&allowed, &comments);
            let entries = allowed.entries();
            let lacking = allowed.lacking();
            let mut finding = allowed.finding;
            match self.config.severity_of(finding.code) {
                Some(None) => {
                    judged.off += 1;
                    continue;
                }
                Some(Some(severity)) => finding.severity = severity,
                None => {}
            }
            if reasons.is_some() {
                judged.used.extend(entries);
            } else {
                entries
                    .into_iter()
                    .for_each(|k| judged.lacking.entry(k).or_default().extend(lacking.clone()));
            }
            let why = match reasons {
                Some(reasons) => Some(Reason::Allowed(reasons)),
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

    /// Returns the reasons why a finding is allowed, each once; `None` if one of its links is not
    /// allowed.
    fn reasons(&self, allowed: &Allowed, comments: &[Comment]) -> Option<String> {
        let mut reasons: Vec<&str> = Vec::new();
        for by in &allowed.each {
            let reason = match by.as_ref().ok()? {
                Allowing::Comment(k) => &comments.get(*k)?.reason,
                Allowing::Entry(k) => &self.config.allowances.get(*k)?.reason,
            };
            if !reasons.contains(&reason.as_str()) {
                reasons.push(reason);
            }
        }
        Some(reasons.join("; "))
    }

    /// Returns remarks on the configuration and the baseline after these models: expired
    /// allowances, allowances without a finding, and known findings that have disappeared.
    /// `is_there` checks whether a file exists.
    pub fn remarks<'a>(
        &self,
        judged: impl Iterator<Item = (&'a str, &'a Judged)>,
        is_there: impl Fn(&str) -> bool,
    ) -> Vec<Remark> {
        let judged: BTreeMap<&str, &Judged> = judged.collect();
        let used: BTreeSet<usize> = judged.values().flat_map(|judged| judged.used.iter().copied()).collect();
        let mut remarks = Vec::new();
        for (k, allowance) in self.config.allowances.iter().enumerate() {
            let included = || judged.values().flat_map(|judged| &judged.included);
            let asked = judged.keys().any(|file| allowance.file.matches(file))
                || included().any(|file| allowance.file.matches(file))
                || allowance.file.plain().is_some_and(|file| !is_there(file));
            let (code, message) = if let Some(day) = allowance.expires.filter(|day| *day <= self.today) {
                ("allow.expired", format!("{} in {}: expired on {day}", allowance.rule, allowance.file))
            } else if asked && !used.contains(&k) {
                let lacking = judged.values().filter_map(|judged| judged.lacking.get(&k)).flatten();
                let why = not_enough(&lacking.cloned().collect())
                    .unwrap_or_else(|| "it matches no finding".to_owned());
                ("allow.unused", format!("{} in {}: {why}", allowance.rule, allowance.file))
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
                let message = format!("{rule}{about} in {file}: this finding no longer exists");
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
