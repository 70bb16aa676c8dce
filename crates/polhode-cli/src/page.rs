//! `report.html`: the interactive page of a motion.

use std::fs;
use std::io::{self, Write as _};
use std::path::Path;

use polhode::body::PrincipalFrame;
use polhode::math::Body;
use polhode::motion::{Scenario, Trajectory};
use polhode_document::VERSION;
use polhode_scenario::read::exact;
use polhode_scenario::report::{PageInput, PageSubject, explain_motion, page};
use polhode_source::shown;

use crate::failure::Failure;
use crate::folder::{Folder, PAGE};
use crate::partial;

/// Contents of a page, and the command that makes it.
#[derive(Debug)]
pub(crate) struct Page<'a> {
    /// Command line without the program name, such as `simulate examples/t-handle.toml`.
    pub(crate) command: String,
    /// Subject of the page.
    pub(crate) shown: Shown<'a>,
}

#[derive(Debug)]
pub(crate) enum Shown<'a> {
    Scenario { scenario: &'a Scenario, text: &'a str, file: &'a Path },
    Moments(&'a PrincipalFrame<Body>),
}

impl Page<'_> {
    pub(crate) fn html(&self, trajectory: &Trajectory) -> String {
        let source = format!("polhode {VERSION} {}", self.command);
        match self.shown {
            Shown::Scenario { scenario, text, file } => {
                let name = file.file_stem().unwrap_or_default().to_string_lossy();
                // A scenario without an explanation can still be displayed, such as a pendulum
                // whose axis cannot carry it.
                let explanation = explain_motion(scenario, trajectory, &exact(text, file, scenario)).ok();
                page(&PageInput {
                    title: scenario.title().unwrap_or(&name),
                    source: &source,
                    scenario_text: Some(text),
                    subject: PageSubject::Scenario(scenario),
                    trajectory,
                    explanation: explanation.as_ref(),
                    whole: true,
                })
            }
            Shown::Moments(principal) => page(&PageInput {
                title: "Free motion",
                source: &source,
                scenario_text: None,
                subject: PageSubject::Moments(principal),
                trajectory,
                explanation: None,
                whole: true,
            }),
        }
    }

    /// Writes the page into a folder of results; returns its name.
    pub(crate) fn write(&self, trajectory: &Trajectory, folder: &Folder) -> Result<&'static str, Failure> {
        let html = self.html(trajectory);
        folder.file(PAGE, |out| out.write_all(html.as_bytes()))?;
        Ok(PAGE)
    }
}

/// Writes a page as a file of its own, completely or not at all. It replaces a file only if `force`
/// is set.
pub(crate) fn write_file(html: &str, file: &Path, force: bool) -> Result<(), Failure> {
    check_file(file, force)?;
    partial::write(file, force, |out| out.write_all(html.as_bytes()))
}

/// Refuses an existing file, unless `force` is set.
pub(crate) fn check_file(file: &Path, force: bool) -> Result<(), Failure> {
    match fs::symlink_metadata(file) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        Err(error) => Err(Failure::Output { path: shown(file), error }),
        Ok(meta) if force && meta.is_file() => Ok(()),
        Ok(_) => Err(Failure::usage(
            format!("{} already exists", shown(file)),
            "choose another file, or overwrite it with --force",
        )),
    }
}
