//! Results as other programs read them: SARIF, JUnit, GitHub's commands, GitLab's code quality, a table in Markdown.

mod github;
mod gitlab;
mod junit;
mod markdown;
mod sarif;

use std::borrow::Cow;

use polhode_source::text::counted;

use crate::checked::{Checked, FileChecked};
use crate::finding::{Finding, Severity};
use crate::line_index::{FilePlace, Places};
use crate::model::{RobotModel, Span};
use crate::policy::Reason;
use crate::report::Counts;

/// A finding as all formats have it.
#[derive(Debug)]
struct Item<'a> {
    file: Cow<'a, str>,
    /// Line and column, from 1, of its first character and of that after its last.
    start: (usize, usize),
    end: (usize, usize),
    code: &'static str,
    severity: Severity,
    /// The link or joint; empty if it is about the whole file.
    subject: &'a str,
    message: &'a str,
    rule: &'a str,
    id: String,
    /// Why it does not count, if it does not.
    settled: Option<&'a Reason>,
    /// What would repair it: in words, and places with their new text.
    repair: Option<(&'a str, Vec<Edit<'a>>)>,
}

/// A text to put in the place of another.
#[derive(Debug)]
struct Edit<'a> {
    file: Cow<'a, str>,
    start: (usize, usize),
    end: (usize, usize),
    new: &'a str,
}

impl FileChecked {
    /// Everything that was found, in the order of the file, settled or not.
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
            message: &finding.message,
            rule: &finding.rule,
            id: id.to_owned(),
            settled,
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

    /// Reason why the file could not be read, with its line and column if these are known.
    fn unreadable(&self) -> Option<(String, Option<[usize; 2]>)> {
        let failure = self.report.as_ref().err()?;
        Some((failure.message(), failure.place_in(&self.path)))
    }

    /// The file of a place: this one, or one that the model includes, named from the same folder.
    fn name_of<'a>(&'a self, model: &RobotModel, place: FilePlace<'a>) -> Cow<'a, str> {
        if !place.is_included {
            return Cow::Borrowed(&self.name);
        }
        // Their paths are real ones.
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
    /// Findings of all files, and remarks on the configuration and the baseline.
    fn items(&self) -> impl Iterator<Item = Item<'_>> {
        self.files.iter().flat_map(FileChecked::items).chain(self.remarks())
    }

    /// What is said of the configuration and the baseline.
    fn remarks(&self) -> impl Iterator<Item = Item<'_>> {
        self.remarks.iter().filter_map(|remark| {
            Some(Item {
                file: Cow::Borrowed(&remark.file),
                start: remark.place,
                end: remark.place,
                code: remark.code,
                severity: remark.severity?,
                subject: "",
                message: &remark.message,
                rule: crate::rule::rule(remark.code).map_or("", |rule| rule.title),
                id: remark.id(),
                settled: None,
                repair: None,
            })
        })
    }

    /// What was not looked at, or is not shown, by the configuration's choice: in a line each.
    pub fn left_out(&self) -> Vec<String> {
        let off = self.reports().map(|report| report.judged.off).sum();
        let mut lines = Vec::new();
        if self.excluded > 0 {
            lines.push(format!(
                "left out: {}, by exclude of the configuration",
                counted(self.excluded, "file")
            ));
        }
        if off > 0 {
            lines.push(format!("off: {} of rules that are off", counted(off, "finding")));
        }
        lines
    }

    /// How many count, from impossible to note, how many are allowed, and how many known.
    fn counts(&self) -> (Counts, usize, usize) {
        let open = self.items().filter(|item| item.settled.is_none()).map(|item| item.severity);
        let settled: Vec<&Reason> = self.items().filter_map(|item| item.settled).collect();
        let known = settled.iter().filter(|why| ***why == Reason::Known).count();
        (Counts::of(open), settled.len() - known, known)
    }
}

/// The subject with its message: `arm: i1 + i2 = …`.
fn about(item: &Item<'_>) -> String {
    if item.subject.is_empty() {
        item.message.to_owned()
    } else {
        format!("{}: {}", item.subject, item.message)
    }
}
