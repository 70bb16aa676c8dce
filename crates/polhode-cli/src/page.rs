//! `report.html`: the page that shows a motion.

use std::fs;
use std::io::{self, Write as _};
use std::path::Path;

use polhode::body::PrincipalFrame;
use polhode::math::Body;
use polhode::motion::{Scenario, Trajectory};
use polhode_document::VERSION;
use polhode_scenario::report::{PageInput, PageSubject, explain_motion, page};
use polhode_source::shown;

use crate::failure::Failure;
use crate::folder::{Folder, PAGE};
use crate::partial;

/// What a page is made of, and by which command.
#[derive(Debug)]
pub(crate) struct Page<'a> {
    /// `simulate examples/t-handle.toml`
    pub(crate) command: String,
    /// A scenario and its text, or moments.
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
                // A scenario that cannot be explained, as a pendulum whose axis cannot hold it, can still be shown.
                let explanation = explain_motion(scenario, trajectory).ok();
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

    /// Writes the page into a folder of results; gives its name.
    pub(crate) fn write(&self, trajectory: &Trajectory, folder: &Folder) -> Result<&'static str, Failure> {
        let html = self.html(trajectory);
        folder.file(PAGE, |out| out.write_all(html.as_bytes()))?;
        Ok(PAGE)
    }
}

/// Writes a page as a file of its own, which appears complete or not at all and replaces nothing unless `force` is set.
pub(crate) fn write_file(html: &str, file: &Path, force: bool) -> Result<(), Failure> {
    check_file(file, force)?;
    partial::write(file, force, |out| out.write_all(html.as_bytes()))
}

/// Refuses a file that is there already, unless `force` is set.
pub(crate) fn check_file(file: &Path, force: bool) -> Result<(), Failure> {
    match fs::symlink_metadata(file) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        Err(error) => Err(Failure::Output { path: shown(file), error }),
        Ok(meta) if force && meta.is_file() => Ok(()),
        Ok(_) => Err(Failure::usage(
            format!("{} is there already", shown(file)),
            "name another file, or replace what an earlier run wrote there with --force",
        )),
    }
}
