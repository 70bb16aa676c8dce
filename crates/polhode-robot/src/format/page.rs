//! Page: the findings by severity, and the links of each model.

use polhode_document::layout::printable;
use polhode_document::{Document, Level, Report as _, Section, Verdict};
use polhode_source::text::counted;

use super::Item;
use crate::checked::Checked;
use crate::finding::Severity;
use crate::policy::Reason;
use crate::report::Counts;
use crate::table::COLUMNS;

/// Title of the findings of each severity.
const TITLES: [(Severity, &str); 3] = [
    (Severity::Impossible, "Impossible: no body has these numbers"),
    (Severity::Suspect, "Suspect: possible, but probably an error"),
    (Severity::Note, "Notes"),
];

impl Checked {
    /// Returns the results as a document.
    pub(crate) fn page(&self) -> Document {
        let (Counts { impossible, suspect, note }, allowed, known) = self.counts();
        let mut answer = vec![format!(
            "{impossible} impossible, {suspect} suspect, {} in {}; {allowed} allowed, {known} known",
            counted(note, "note"),
            counted(self.files.len(), "file")
        )];
        let changes: usize = self.reports().map(|report| report.prospect().changes).sum();
        if changes > 0 {
            let (values, form) = (counted(changes, "value"), self.fix_form());
            answer
                .push(format!("{form} corrects {values}: the only fix that is consistent with all evidence"));
        }
        answer.extend(self.left_out());
        let items: Vec<Item<'_>> = self.items().collect();
        let mut sections: Vec<Section> = self.unreadable().into_iter().collect();
        for (severity, title) in TITLES {
            let is_shown = |item: &&Item<'_>| item.settled.is_none() && item.severity == severity;
            let rows: Vec<_> = items.iter().filter(is_shown).map(row).collect();
            sections.extend(section(title, &["link", "finding", "rule", "fix", "place"], rows));
        }
        let settled = items.iter().filter_map(|item| {
            let why = match item.settled? {
                Reason::Allowed(reason) => printable(reason),
                Reason::Known => "known, in the baseline".to_owned(),
            };
            let [link, finding, _, _, place] = row(item);
            Some([link, finding, why, place])
        });
        sections.extend(section(
            "Allowed and known",
            &["link", "finding", "reason", "place"],
            settled.collect(),
        ));
        let is_one = self.files.len() == 1;
        let mut last_links = None;
        for file in &self.files {
            let Ok(report) = &file.report else { continue };
            let of_file = |section: Section| match is_one {
                true => section,
                false => {
                    Section { title: format!("{} of {}", section.title, printable(&file.name)), ..section }
                }
            };
            last_links = Some(sections.len());
            sections.push(of_file(report.links()));
            sections.extend(report.pictures(is_one).map(of_file));
        }
        if let Some(last) = last_links.and_then(|k| sections.get_mut(k)) {
            COLUMNS.iter().for_each(|line| last.say(format!("{}.", line.replace("   ", "; "))));
        }
        for (k, section) in sections.iter_mut().enumerate() {
            section.number = u8::try_from(k + 1).unwrap_or(u8::MAX);
        }
        let title = match self.files.as_slice() {
            [file] => format!("Check of {}", printable(&file.name)),
            _ => "Check of robot models".to_owned(),
        };
        Document { title, verdict: Some(self.verdict(suspect)), answer, sections, findings: Vec::new() }
    }

    fn verdict(&self, suspect: usize) -> Verdict {
        if self.files.iter().any(|file| file.report.is_err()) {
            return Verdict::new(Level::Failure, "A file cannot be read");
        }
        match (self.has_failed(), suspect) {
            (true, _) => Verdict::new(Level::Failure, "Findings need a fix"),
            (false, 0) => Verdict::new(Level::Ok, "No impossible or suspect finding"),
            (false, _) => Verdict::new(Level::Warning, "Suspect findings, which do not fail this check"),
        }
    }

    /// Returns the files that cannot be read, with the reasons.
    fn unreadable(&self) -> Option<Section> {
        let rows = self.files.iter().filter_map(|file| {
            let (message, place) = file.unreadable()?;
            let place = place.map_or(String::new(), |[line, column]| format!(":{line}:{column}"));
            Some(["unreadable".to_owned(), printable(&format!("{}{place}", file.name)), printable(&message)])
        });
        section("Files that cannot be read", &["", "place", "reason"], rows.collect())
    }

    /// Returns the option that writes fixes; only one model can be written.
    fn fix_form(&self) -> &'static str {
        let is_expanded = self.reports().any(|report| report.model.expansion.is_some());
        if self.files.len() == 1 && !is_expanded { "--fix OUT" } else { "--fix" }
    }
}

fn row(item: &Item<'_>) -> [String; 5] {
    let (line, column) = item.start;
    [
        printable(item.subject),
        format!("{} [{}]", printable(&item.message), item.code),
        printable(item.rule),
        item.repair.as_ref().map_or_else(|| "—".to_owned(), |(fix, _)| printable(fix)),
        printable(&format!("{}:{line}:{column}", item.file)),
    ]
}

/// Returns a section with a table; `None` without rows.
fn section<const N: usize>(title: &str, headers: &[&str; N], rows: Vec<[String; N]>) -> Option<Section> {
    let mut section = Section::new(0, title);
    let is_empty = rows.is_empty();
    section.table(headers, rows.into_iter().map(Vec::from).collect());
    (!is_empty).then_some(section)
}
