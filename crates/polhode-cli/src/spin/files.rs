//! What a spin writes: a table, curves, and the summary, in one folder.

use std::f64::consts::TAU;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode::{FreeMotion, Method, Regime, Run, Trajectory};
use polhode_formats::times;
use polhode_formats::unit::Dimension;

use crate::failure::Failure;
use crate::folder::Folder;
use crate::numbers::{positive, quantity};
use crate::table::{self, Format};

use super::curves::CurveFlags;

/// Evenly spaced samples where nobody says how many.
const SAMPLES: u64 = 1001;

#[derive(Debug, Args)]
#[command(next_help_heading = "Files")]
pub(super) struct FileFlags {
    /// Write a trajectory table from t = 0 to this time.
    #[arg(long, value_name = "T", value_parser = time, allow_hyphen_values = true)]
    duration: Option<f64>,
    /// Rows of the table, evenly spaced [default: 1001].
    #[arg(
        long,
        value_name = "N",
        requires = "duration",
        conflicts_with = "every",
        value_parser = clap::value_parser!(u64).range(2..=times::MOST)
    )]
    samples: Option<u64>,
    /// Time between rows of the table.
    #[arg(long, value_name = "DT", requires = "duration", value_parser = time, allow_hyphen_values = true)]
    every: Option<f64>,
    /// The format of the table; may be given more than once [default: parquet].
    #[arg(long, value_enum, value_name = "FORMAT", requires = "duration")]
    table: Vec<Format>,
    #[command(flatten)]
    curves: CurveFlags,
    /// The folder to write [default: the scenario's name, else spin, here].
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Replace the results and the plots of an earlier run.
    #[arg(long)]
    force: bool,
}

impl FileFlags {
    /// The folder to write, which must not be there; `None` if nothing is to be written.
    pub(super) fn target(&self, file: Option<&Path>) -> Result<Option<PathBuf>, Failure> {
        if self.duration.is_none() && !self.curves.wanted() && self.output.is_none() {
            return Ok(None);
        }
        let name = || file.and_then(Path::file_stem).map_or_else(|| PathBuf::from("spin"), PathBuf::from);
        let target = self.output.clone().unwrap_or_else(name);
        Folder::check(&target, self.force)?;
        Ok(Some(target))
    }

    pub(super) const fn force(&self) -> bool {
        self.force
    }

    /// The motion as plots show it: up to --duration, else some periods.
    pub(super) fn to_be_drawn(&self, motion: &FreeMotion) -> Result<Trajectory, Failure> {
        const PERIODS: f64 = 3.0;
        const EACH: f64 = 128.0;
        let start = motion.start();
        let span = self.duration.unwrap_or_else(|| match (motion.regime(), motion.period()) {
            (_, Some(period)) => PERIODS * period,
            (Regime::AtRest, _) => 1.0,
            // Until nothing happens any more: sech 8 is 7e-4.
            (Regime::Separatrix, _) => 2.0 * 8.0 / motion.polhode_rate(),
            _ => PERIODS * TAU / start.omega.norm(),
        });
        let fine = motion.period().map_or(0.0, |period| EACH * span / period);
        let samples = fine.clamp(2001.0, 100_001.0) as usize;
        let times: Vec<f64> = Run::evenly(span, samples, Method::Exact, 0.0).times;
        let failed = |error| Failure::Motion { path: "the plot".to_owned(), error };
        Trajectory::of_motion(*motion, &times).map_err(failed)
    }

    /// Writes the folder; says what was written.
    pub(super) fn write(
        &self,
        target: &Path,
        summary: &str,
        motion: &FreeMotion,
        metadata: &[(String, String)],
    ) -> Result<String, Failure> {
        let trajectory = self.trajectory(motion)?;
        let curves = self.curves.draw(motion, self.duration)?;
        let folder = Folder::create(target, self.force)?;
        folder.file("summary.json", |out| out.write_all(summary.as_bytes()))?;
        let mut names = Vec::new();
        if let Some(trajectory) = trajectory {
            let formats = if self.table.is_empty() { &[Format::Parquet] } else { self.table.as_slice() };
            names.extend(table::write(formats, &trajectory, metadata, &folder)?);
        }
        if let Some(curves) = curves {
            names.extend(curves.write(&folder)?);
        }
        folder.publish()?;
        let more: String = names.iter().map(|name| format!("  {name}")).collect();
        Ok(format!("wrote {}{more}\n", target.join("summary.json").display()))
    }

    fn trajectory(&self, motion: &FreeMotion) -> Result<Option<Trajectory>, Failure> {
        let Some(duration) = self.duration else { return Ok(None) };
        let times = match self.every {
            Some(every) => times::every(every, duration).ok_or_else(|| {
                Failure::usage(
                    format!("--every {every} s makes more than {} rows of {duration} s", times::MOST),
                    "all rows are held in memory: sample less often, or write it in pieces",
                )
            })?,
            None => {
                let samples = self.samples.unwrap_or(SAMPLES) as usize;
                Run::evenly(duration, samples, Method::Exact, 0.0).times
            }
        };
        let failed = |error| Failure::Motion { path: "the table".to_owned(), error };
        Trajectory::of_motion(*motion, &times).map(Some).map_err(failed)
    }
}

fn time(text: &str) -> Result<f64, String> {
    positive(quantity(text, Dimension::TIME)?)
}
