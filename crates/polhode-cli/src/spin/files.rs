//! Output files of a spin: table, curves and summary in one folder.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode::motion::FreeMotion;
use polhode_scenario::request::spin::Sampling;
use polhode_source::shown;
use polhode_table::output::Surroundings;

use super::curves::CurveFlags;
use crate::failure::Failure;
use crate::folder::{Folder, PAGE, Replace, wrote};
use crate::page::{Page, check_file, write_file};
use crate::table::{self, Format};

#[derive(Debug, Args)]
#[command(next_help_heading = "Files")]
pub(super) struct FileFlags {
    #[command(flatten)]
    pub(super) sampling: Sampling,
    /// Table format; may be repeated [default: parquet].
    #[arg(long, value_enum, value_name = "FORMAT", requires = "duration")]
    table: Vec<Format>,
    #[command(flatten)]
    curves: CurveFlags,
    /// Write a page that shows the motion, up to --duration or the last --at, else for several
    /// periods.
    #[arg(long, value_name = "FILE", num_args = 0..=1, require_equals = true, default_missing_value = PAGE)]
    html: Option<PathBuf>,
    /// Do not write report.html to the output folder.
    #[arg(long, requires = "folder", conflicts_with = "periods")]
    no_page: bool,
    /// Output folder [default: the scenario's name, else spin, in the working directory].
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Replace existing results and plots.
    #[arg(long, requires = "written")]
    force: bool,
}

impl FileFlags {
    /// Returns the output folder, which must not exist yet; `None` if no folder is requested.
    pub(super) fn target(&self, file: Option<&Path>) -> Result<Option<PathBuf>, Failure> {
        if self.sampling.duration.is_none() && !self.curves.wanted() && self.output.is_none() {
            return Ok(None);
        }
        let name = || file.and_then(Path::file_stem).map_or_else(|| PathBuf::from("spin"), PathBuf::from);
        let target = self.output.clone().unwrap_or_else(name);
        Folder::check(&target, &Replace::forced(self.force))?;
        Ok(Some(target))
    }

    pub(super) const fn force(&self) -> bool {
        self.force
    }

    /// Writes the folder; returns a summary of the files written.
    pub(super) fn write(
        &self,
        target: &Path,
        summary: &str,
        motion: &FreeMotion,
        metadata: &[(String, String)],
        page: &Page<'_>,
        at: &[f64],
    ) -> Result<String, Failure> {
        let trajectory = self.sampling.trajectory(motion)?;
        let motion_shown = if self.no_page { None } else { Some(self.sampling.shown(motion, at)?) };
        let curves = self.curves.draw(motion, self.sampling.duration())?;
        let folder = Folder::create(target, Replace::forced(self.force))?;
        folder.file("summary.json", |out| out.write_all(summary.as_bytes()))?;
        let mut names = vec!["summary.json"];
        if let Some(trajectory) = trajectory {
            let formats = if self.table.is_empty() { &[Format::Parquet] } else { self.table.as_slice() };
            names.extend(table::write(formats, &trajectory, &Surroundings::default(), metadata, &folder)?);
        }
        if let Some(curves) = curves {
            names.extend(curves.write(&folder)?);
        }
        if let Some(trajectory) = motion_shown {
            names.push(page.write(&trajectory, &folder)?);
        }
        folder.publish()?;
        let note = if self.no_page { String::new() } else { self.sampling.not_shown(motion, at) };
        Ok(format!("{}\n{note}", wrote(target, &names)))
    }

    /// Refuses an existing page before the computation starts.
    pub(super) fn check_html(&self) -> Result<(), Failure> {
        self.html.as_deref().map_or(Ok(()), |file| check_file(file, self.force))
    }

    /// Writes the page requested by `--html`; returns a message.
    pub(super) fn write_html(
        &self,
        motion: &FreeMotion,
        page: &Page<'_>,
        at: &[f64],
    ) -> Result<String, Failure> {
        let Some(file) = &self.html else { return Ok(String::new()) };
        write_file(&page.html(&self.sampling.shown(motion, at)?), file, self.force)?;
        Ok(format!("wrote {}\n{}", shown(file), self.sampling.not_shown(motion, at)))
    }
}
