//! What a spin writes: a table, curves, and the summary, in one folder.

use std::f64::consts::TAU;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode::motion::{FreeMotion, Method, Regime, Run, Trajectory};
use polhode_source::given::{positive, quantity};
use polhode_source::shown;
use polhode_source::times;
use polhode_source::unit::Dimension;
use polhode_table::output::Surroundings;

use super::curves::CurveFlags;
use crate::failure::Failure;
use crate::folder::{Folder, PAGE, Replace};
use crate::page::{Page, check_file, write_file};
use crate::table::{self, Format};

/// Samples of a page that is not of a table.
const PAGE_SAMPLES: usize = 2_001;

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
    /// Write a page that shows the motion, up to --duration or the last --at, else for some periods.
    #[arg(long, value_name = "FILE", num_args = 0..=1, require_equals = true, default_missing_value = PAGE)]
    html: Option<PathBuf>,
    /// Leave report.html out of the folder that --duration, --curves or -o writes.
    #[arg(long, requires = "folder", conflicts_with = "periods")]
    no_page: bool,
    /// The folder to write [default: the scenario's name, else spin, here].
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Replace the results and the plots of an earlier run.
    #[arg(long, requires = "written")]
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
        Folder::check(&target, &Replace::forced(self.force))?;
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
        let failed = |error| Failure::motion("the plot".to_owned(), error);
        Trajectory::of_motion_with_error(*motion, &times).map_err(failed)
    }

    /// Writes the folder; says what was written.
    pub(super) fn write(
        &self,
        target: &Path,
        summary: &str,
        motion: &FreeMotion,
        metadata: &[(String, String)],
        page: &Page<'_>,
        at: &[f64],
    ) -> Result<String, Failure> {
        let trajectory = self.trajectory(motion)?;
        let motion_shown = if self.no_page { None } else { Some(self.shown(motion, at)?) };
        let curves = self.curves.draw(motion, self.duration)?;
        let folder = Folder::create(target, Replace::forced(self.force))?;
        folder.file("summary.json", |out| out.write_all(summary.as_bytes()))?;
        let mut names = Vec::new();
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
        let more: String = names.iter().map(|name| format!("  {name}")).collect();
        let note = if self.no_page { String::new() } else { self.not_shown(motion, at) };
        Ok(format!("wrote {}{more}\n{note}", shown(&target.join("summary.json"))))
    }

    /// Refuses a page that is there already, before anything is computed.
    pub(super) fn check_html(&self) -> Result<(), Failure> {
        self.html.as_deref().map_or(Ok(()), |file| check_file(file, self.force))
    }

    /// Writes the page that `--html` asks for; says so.
    pub(super) fn write_html(
        &self,
        motion: &FreeMotion,
        page: &Page<'_>,
        at: &[f64],
    ) -> Result<String, Failure> {
        let Some(file) = &self.html else { return Ok(String::new()) };
        write_file(&page.html(&self.shown(motion, at)?), file, self.force)?;
        Ok(format!("wrote {}\n{}", shown(file), self.not_shown(motion, at)))
    }

    /// Names a requested time that is not on the page, and the span that is.
    fn not_shown(&self, motion: &FreeMotion, at: &[f64]) -> String {
        let span = self.duration.unwrap_or_else(|| span_of_page(motion, at));
        match at.iter().find(|time| !(0.0..=span).contains(*time)) {
            Some(time) => {
                format!("the page shows 0 to {span:.6} s, not t = {time} s: --duration sets the span\n")
            }
            None => String::new(),
        }
    }

    /// The motion that a page shows: the table's, else up to the last time that is asked for, else some periods.
    fn shown(&self, motion: &FreeMotion, at: &[f64]) -> Result<Trajectory, Failure> {
        if let Some(trajectory) = self.trajectory(motion)? {
            return Ok(trajectory);
        }
        let times = Run::evenly(span_of_page(motion, at), PAGE_SAMPLES, Method::Exact, 0.0).times;
        let failed = |error| Failure::motion("the page".to_owned(), error);
        Trajectory::of_motion_with_error(*motion, &times).map_err(failed)
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
        let failed = |error| Failure::motion("the table".to_owned(), error);
        Trajectory::of_motion_with_error(*motion, &times).map(Some).map_err(failed)
    }
}

/// Duration of the motion on a page, s: up to the last of these times if samples can follow it, else some periods.
fn span_of_page(motion: &FreeMotion, at: &[f64]) -> f64 {
    let most = longest(motion);
    let asked = at.iter().copied().fold(0.0, f64::max);
    if asked > 0.0 && asked <= most { asked } else { sensible(motion).min(most) }
}

/// Some periods of ω, or some turns where it has none, s.
fn sensible(motion: &FreeMotion) -> f64 {
    const PERIODS: f64 = 4.0;
    let turn = TAU / motion.start().omega.norm();
    let duration = PERIODS * motion.period().unwrap_or(2.0 * turn).max(turn);
    if duration.is_finite() { duration } else { 1.0 }
}

/// For so long samples are near enough together to follow the body, s: a quarter of a radian.
fn longest(motion: &FreeMotion) -> f64 {
    const TURN: f64 = 0.25;
    let [a1, _, a3] = motion.amplitudes();
    let longest = TURN * PAGE_SAMPLES as f64 / a1.hypot(a3);
    if longest.is_finite() { longest } else { f64::MAX }
}

fn time(text: &str) -> Result<f64, String> {
    positive(quantity(text, Dimension::TIME)?)
}
