//! Table or plan of a document: its kinds, its text, and its report.

use std::io;
use std::path::{Path, PathBuf};

use polhode_scenario::read::Draft;
use polhode_source::files::Files;

use super::report::{self, answer};
use super::seen::{OpenScenario, Seen};
use super::{ReportAnswer, ReportRequest, TableContent, TableKind};
use crate::refusal::{Refusal, RefusalKind};

/// Table or plan of a document.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Table<'a> {
    pub(crate) name: &'a str,
    pub(crate) path: &'a Path,
    /// Folder of the dropped set that the document is from.
    pub(crate) set: Option<&'a Path>,
    pub(crate) kinds: &'a [TableKind],
}

impl Table<'_> {
    /// Returns the possible kinds, and the text of a plan. `others` are the paths of other tables.
    pub(crate) fn content(&self, others: &[PathBuf], files: &dyn Files) -> Result<TableContent, Refusal> {
        let seen = Seen::new(files, self.set, Vec::new());
        let others: Vec<String> =
            others.iter().map(|other| seen.path(other).to_string_lossy().into_owned()).collect();
        let text = self.text(files)?;
        Ok(TableContent {
            kinds: self.kinds.iter().map(|kind| kind.known(text.is_some(), &others)).collect(),
            has_scenario: text.is_none() && self.has_scenario(&seen, files)?,
            text,
        })
    }

    /// Returns the report, or its error. `others` are the paths of other tables.
    pub(crate) fn report(
        &self,
        request: &ReportRequest,
        scenario: Option<&OpenScenario<'_>>,
        others: Vec<PathBuf>,
        files: &dyn Files,
    ) -> Result<ReportAnswer, Refusal> {
        if !self.kinds.contains(&request.kind) {
            let message = format!("{:?} is not a table of this kind", self.name);
            return Err(Refusal::new(RefusalKind::BadRequest, message));
        }
        let mut seen = Seen::new(files, self.set, others);
        let path = seen.path(self.path);
        let text = match &request.text {
            Some(text) => {
                seen.replace(self.path, text);
                Some(text.clone())
            }
            None => self.text(files)?,
        };
        let scenario = scenario.map(|scenario| seen.open_scenario(scenario, &path));
        let options = request.options.clone();
        Ok(answer(request.kind, (&path, text.as_deref()), scenario.as_deref(), options, &seen))
    }

    /// Opens every file that the table names.
    pub(crate) fn open_named(&self, files: &dyn Files) {
        let seen = Seen::new(files, self.set, Vec::new());
        self.kinds.iter().for_each(|kind| report::open_named(*kind, &seen.path(self.path), &seen));
    }

    /// Returns the paths in the text of a plan; they need not exist.
    pub(crate) fn named(&self, files: &dyn Files) -> Vec<PathBuf> {
        let text = self.text(files).ok().flatten();
        text.map_or_else(Vec::new, |text| {
            Draft::trusting(self.path, &text).files().map(Path::to_owned).collect()
        })
    }

    /// Returns the text of a plan; `None` for a table.
    fn text(&self, files: &dyn Files) -> Result<Option<String>, Refusal> {
        let is_plan = self.path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("toml"));
        let text = is_plan.then(|| files.open(self.path).and_then(io::read_to_string)).transpose();
        text.map_err(|error| self.unreadable(&error))
    }

    /// Returns true if the table is a log that names a scenario of its set.
    fn has_scenario(&self, seen: &Seen<'_>, files: &dyn Files) -> Result<bool, Refusal> {
        let mut bytes = Vec::new();
        let read = files.open(self.path).and_then(|mut file| io::Read::read_to_end(&mut file, &mut bytes));
        read.map_err(|error| self.unreadable(&error))?;
        let own = seen.path(self.path);
        let folder = own.parent().unwrap_or(Path::new(""));
        Ok(polhode_judge::scenario_named_by(&bytes).is_some_and(|name| seen.named(folder, &name).is_ok()))
    }

    fn unreadable(&self, error: &io::Error) -> Refusal {
        Refusal::new(RefusalKind::Unprocessable, format!("{:?} cannot be read: {error}", self.name))
    }
}
