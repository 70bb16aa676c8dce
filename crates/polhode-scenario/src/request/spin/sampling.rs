//! Samples of a free motion, for tables, plots and pages.

use std::f64::consts::TAU;

use polhode::motion::{FreeMotion, Method, Regime, Run, Trajectory};
use polhode_source::Failure;
use polhode_source::given::{Given, Positive, Time};
use polhode_source::times;
use serde::{Deserialize, Serialize};

/// Number of samples of a page without a table.
const PAGE_SAMPLES: usize = 2_001;

/// Default number of equally spaced samples of a table.
const SAMPLES: u64 = 1001;

/// Samples of a table of free motion.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
#[cfg_attr(feature = "arguments", command(next_help_heading = "Files"))]
pub struct Sampling {
    /// Write a trajectory table from t = 0 to this time.
    #[cfg_attr(feature = "arguments", arg(long, value_name = "T", allow_hyphen_values = true))]
    pub duration: Option<Given<Positive<Time>>>,
    /// Rows of the table, evenly spaced [default: 1001].
    #[cfg_attr(feature = "arguments", arg(
        long,
        value_name = "N",
        requires = "duration",
        conflicts_with = "every",
        value_parser = clap::value_parser!(u64).range(2..=times::MOST)
    ))]
    pub samples: Option<u64>,
    /// Time between rows of the table.
    #[cfg_attr(
        feature = "arguments",
        arg(long, value_name = "DT", requires = "duration", allow_hyphen_values = true)
    )]
    pub every: Option<Given<Positive<Time>>>,
}

impl Sampling {
    /// Returns the duration of the table, s, if one is requested.
    pub fn duration(&self) -> Option<f64> {
        self.duration.as_ref().map(|duration| duration.value.0.into())
    }

    /// Returns the motion for plots: up to `--duration`, else over some periods.
    pub fn to_be_drawn(&self, motion: &FreeMotion) -> Result<Trajectory, Failure> {
        const PERIODS: f64 = 3.0;
        const EACH: f64 = 128.0;
        let start = motion.start();
        let span = self.duration().unwrap_or_else(|| match (motion.regime(), motion.period()) {
            (_, Some(period)) => PERIODS * period,
            (Regime::AtRest, _) => 1.0,
            // Practically complete: sech 8 is 7e-4.
            (Regime::Separatrix, _) => 2.0 * 8.0 / motion.polhode_rate(),
            _ => PERIODS * TAU / start.omega.norm(),
        });
        let fine = motion.period().map_or(0.0, |period| EACH * span / period);
        let samples = fine.clamp(2001.0, 100_001.0) as usize;
        let times: Vec<f64> = Run::evenly(span, samples, Method::Exact, 0.0).times;
        let failed = |error| Failure::Motion { path: "the plot".to_owned(), error };
        Trajectory::of_motion_with_error(*motion, &times).map_err(failed)
    }

    /// Returns a note if a requested time is outside the time span of the page.
    pub fn not_shown(&self, motion: &FreeMotion, at: &[f64]) -> String {
        let span = self.duration().unwrap_or_else(|| span_of_page(motion, at));
        match at.iter().find(|time| !(0.0..=span).contains(*time)) {
            Some(time) => {
                format!("the page shows 0 to {span:.6} s, not t = {time} s: --duration sets the span\n")
            }
            None => String::new(),
        }
    }

    /// Returns the motion for a page: that of the table, else up to the last requested time, else
    /// over some periods.
    pub fn shown(&self, motion: &FreeMotion, at: &[f64]) -> Result<Trajectory, Failure> {
        if let Some(trajectory) = self.trajectory(motion)? {
            return Ok(trajectory);
        }
        let times = Run::evenly(span_of_page(motion, at), PAGE_SAMPLES, Method::Exact, 0.0).times;
        let failed = |error| Failure::Motion { path: "the page".to_owned(), error };
        Trajectory::of_motion_with_error(*motion, &times).map_err(failed)
    }

    /// Returns the samples of the table; `None` if no table is requested.
    ///
    /// # Errors
    /// [`Failure`] for more samples than fit into memory.
    pub fn trajectory(&self, motion: &FreeMotion) -> Result<Option<Trajectory>, Failure> {
        let Some(duration) = self.duration() else { return Ok(None) };
        let times = match self.every.as_ref().map(|every| f64::from(every.value.0)) {
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
        Trajectory::of_motion_with_error(*motion, &times).map(Some).map_err(failed)
    }
}

/// Returns the duration of a page, s: up to the last of these times if the samples can resolve it,
/// else some periods.
fn span_of_page(motion: &FreeMotion, at: &[f64]) -> f64 {
    let most = longest(motion);
    let asked = at.iter().copied().fold(0.0, f64::max);
    if asked > 0.0 && asked <= most { asked } else { sensible(motion).min(most) }
}

/// Returns the duration of some periods of ω, or of some revolutions if it has no period, s.
fn sensible(motion: &FreeMotion) -> f64 {
    const PERIODS: f64 = 4.0;
    let turn = TAU / motion.start().omega.norm();
    let duration = PERIODS * motion.period().unwrap_or(2.0 * turn).max(turn);
    if duration.is_finite() { duration } else { 1.0 }
}

/// Returns the longest duration, s, for which the body turns by at most 0.25 rad between samples.
fn longest(motion: &FreeMotion) -> f64 {
    const TURN: f64 = 0.25;
    let [a1, _, a3] = motion.amplitudes();
    let longest = TURN * PAGE_SAMPLES as f64 / a1.hypot(a3);
    if longest.is_finite() { longest } else { f64::MAX }
}
