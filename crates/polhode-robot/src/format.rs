//! Output formats for other programs: SARIF, JUnit, GitHub workflow commands, GitLab code quality,
//! Markdown table.

mod github;
mod gitlab;
mod junit;
mod markdown;
mod page;
mod pictures;
mod sarif;

use std::borrow::Cow;

use polhode_source::text::counted;

use crate::checked::{Checked, FileChecked};
use crate::finding::{Finding, Related, Severity};
use crate::line_index::{FilePlace, Places};
use crate::model::{RobotModel, Span};
use crate::policy::Reason;
use crate::report::Counts;

/// Finding with the fields that all formats use.
#[derive(Debug)]
struct Item<'a> {
    file: Cow<'a, str>,
    /// Line and column, from 1, of the first character; `end` is after the last character.
    start: (usize, usize),
    end: (usize, usize),
    code: &'static str,
    severity: Severity,
    /// Name of the link or joint; empty for the whole file.
    subject: &'a str,
    message: Cow<'a, str>,
    rule: &'a str,
    id: String,
    /// Reason why the finding does not count, if it is settled.
    settled: Option<&'a Reason>,
    /// Place in the model that this one is compared with.
    related: Option<&'a Related>,
    /// Repair: a description, and the edits.
    repair: Option<(&'a str, Vec<Edit<'a>>)>,
}

/// Replacement of a text range.
#[derive(Debug)]
struct Edit<'a> {
    file: Cow<'a, str>,
    start: (usize, usize),
    end: (usize, usize),
    new: &'a str,
}

impl FileChecked {
    /// Returns all findings of a file, in file order, open and settled.
    fn items<'a>(&'a self) -> Vec<Item<'a>> {
        let Ok(report) = &self.report else { return Vec::new() };
        let places = Places::of(&report.model);
        let start = |span: &Span| line_and_column(places.place(span));
        let end = |span: &Span| line_and_column(places.end(span));
        let item = |finding: &'a Finding, id: &str, settled: Option<&'a Reason>| Item {
            file: self.name_of(&report.model, places.place(&finding.span)),
            start: start(&finding.span),
            end: end(&finding.span),
            code: finding.code,
            severity: finding.severity,
            subject: &finding.subject,
            message: message(finding),
            rule: &finding.rule,
            id: id.to_owned(),
            settled,
            related: finding.related.as_ref(),
            repair: finding.repair.as_ref().map(|repair| {
                let edit = |(span, new): &'a (Span, String)| Edit {
                    file: self.name_of(&report.model, places.place(span)),
                    start: start(span),
                    end: end(span),
                    new,
                };
                (repair.description.as_str(), repair.edits.iter().map(edit).collect())
            }),
        };
        let open =
            report.findings().iter().zip(&report.judged.ids).map(|(finding, id)| item(finding, id, None));
        let settled = report.judged.settled.iter();
        let settled = settled.map(|settled| item(&settled.finding, &settled.id, Some(&settled.why)));
        let mut items: Vec<Item<'a>> = open.chain(settled).collect();
        items.sort_by_cached_key(|item| (item.file != self.name, item.file.clone(), item.start));
        items
    }

    /// Returns the reason why the file could not be read, with line and column if known.
    fn unreadable(&self) -> Option<(String, Option<[usize; 2]>)> {
        let failure = self.report.as_ref().err()?;
        Some((failure.message(), failure.place_in(&self.path)))
    }

    /// Returns the name of the file of a place: this file, or an included one relative to the same
    /// folder.
    fn name_of<'a>(&'a self, model: &RobotModel, place: FilePlace<'a>) -> Cow<'a, str> {
        if !place.is_included {
            return match model.expansion {
                Some(_) => Cow::Owned(format!("{} (expanded)", self.name)),
                None => Cow::Borrowed(&self.name),
            };
        }
        if place.file == model.path {
            return Cow::Borrowed(&self.name);
        }
        // Paths of included files are canonical.
        let within = model.folder.as_ref().and_then(|folder| place.file.strip_prefix(folder).ok());
        let folder = self.name.rsplit_once('/').map_or("", |(folder, _)| folder);
        let name = match within {
            Some(within) if folder.is_empty() => within.to_string_lossy().into_owned(),
            Some(within) => format!("{folder}/{}", within.to_string_lossy()),
            None => place.file.to_string_lossy().into_owned(),
        };
        Cow::Owned(name.replace('\\', "/"))
    }
}

fn line_and_column(place: FilePlace<'_>) -> (usize, usize) {
    (place.line, place.column)
}

impl Checked {
    /// Returns the findings of all files, then the remarks on the configuration and the baseline.
    fn items(&self) -> impl Iterator<Item = Item<'_>> {
        self.files.iter().flat_map(FileChecked::items).chain(self.remarks())
    }

    /// Returns the remarks on the configuration and the baseline.
    fn remarks(&self) -> impl Iterator<Item = Item<'_>> {
        self.remarks.iter().filter_map(|remark| {
            Some(Item {
                file: Cow::Borrowed(&remark.file),
                start: remark.place,
                end: remark.place,
                code: remark.code,
                severity: remark.severity?,
                subject: "",
                message: Cow::Borrowed(&remark.message),
                rule: crate::rule::rule(remark.code).map_or("", |rule| rule.title),
                id: remark.id(),
                settled: None,
                related: None,
                repair: None,
            })
        })
    }

    /// Describes files and findings that the configuration excludes, one line each.
    pub fn left_out(&self) -> Vec<String> {
        let off = self.reports().map(|report| report.judged.off).sum();
        let mut lines = Vec::new();
        if self.excluded > 0 {
            lines.push(format!(
                "excluded: {}, by exclude in the configuration",
                counted(self.excluded, "file")
            ));
        }
        if off > 0 {
            lines.push(format!("off: {} of disabled rules", counted(off, "finding")));
        }
        lines
    }

    /// Counts the open findings by severity, the allowed ones, and the known ones.
    fn counts(&self) -> (Counts, usize, usize) {
        let open = self.items().filter(|item| item.settled.is_none()).map(|item| item.severity);
        let settled: Vec<&Reason> = self.items().filter_map(|item| item.settled).collect();
        let known = settled.iter().filter(|why| ***why == Reason::Known).count();
        (Counts::of(open), settled.len() - known, known)
    }
}

/// Returns the message, with the nearest possible tensors if they were requested.
fn message(finding: &Finding) -> Cow<'_, str> {
    let Some(nearest) = &finding.nearest else { return Cow::Borrowed(&finding.message) };
    let lines = nearest.lines().map(|(label, line)| format!("; {label}{line}"));
    Cow::Owned(format!("{}{}", finding.message, lines.concat()))
}

/// Returns subject and message: `arm: i1 + i2 = …`.
fn about(item: &Item<'_>) -> String {
    if item.subject.is_empty() {
        item.message.to_string()
    } else {
        format!("{}: {}", item.subject, item.message)
    }
}
