//! Curves of a free motion.

use clap::Args;
use polhode::motion::FreeMotion;
use polhode::observe::{CurveError, Herpolhode, MomentumTrace, Polhode, RollingCones};
use polhode_source::given::quantity;
use polhode_source::unit::Dimension;
use polhode_table::output::curve;

use crate::failure::Failure;
use crate::folder::Folder;

#[derive(Debug, Args)]
pub(super) struct CurveFlags {
    /// Write each curve to a CSV file: the paths of ω (polhode) and L in the body over one period;
    /// the path of ω on the invariable plane (herpolhode) and both cones up to --duration, else
    /// over three periods.
    #[arg(long)]
    curves: bool,
    /// Largest distance of the polyline from the curve, relative to the curve's largest vector
    /// [default: 1e-3].
    #[arg(long, value_name = "E", requires = "curves", value_parser = chord_error)]
    chord_error: Option<f64>,
}

/// All curves of one motion.
pub(super) struct Curves {
    polhode: Polhode,
    momentum: MomentumTrace,
    herpolhode: Herpolhode,
    cones: RollingCones,
}

impl CurveFlags {
    pub(super) const fn wanted(&self) -> bool {
        self.curves
    }

    /// Returns the curves if they are requested; curves in space extend to `duration`, s.
    pub(super) fn draw(&self, motion: &FreeMotion, duration: Option<f64>) -> Result<Option<Curves>, Failure> {
        const PERIODS: f64 = 3.0;
        let error = self.chord_error.unwrap_or(1e-3);
        let periods = duration.zip(motion.period()).map_or(PERIODS, |(duration, period)| duration / period);
        let draw = || -> Result<Curves, CurveError> {
            Ok(Curves {
                polhode: Polhode::of(motion, error)?,
                momentum: MomentumTrace::of(motion, error)?,
                herpolhode: Herpolhode::of(motion, periods, error)?,
                cones: RollingCones::of(motion, periods, error)?,
            })
        };
        let failed = |error: CurveError| {
            Failure::usage(
                format!("cannot compute a curve: {error}"),
                "try a larger --chord-error or a shorter --duration",
            )
        };
        self.curves.then(draw).transpose().map_err(failed)
    }
}

impl Curves {
    /// Writes one file per curve; returns their names.
    pub(super) fn write(&self, folder: &Folder) -> Result<[&'static str; 5], Failure> {
        let names = ["polhode.csv", "momentum.csv", "herpolhode.csv", "body_cone.csv", "space_cone.csv"];
        let [polhode, momentum, herpolhode, body_cone, space_cone] = names;
        folder.file(polhode, |out| curve::polhode(&self.polhode).write_csv(out))?;
        folder.file(momentum, |out| curve::momentum(&self.momentum).write_csv(out))?;
        folder.file(herpolhode, |out| curve::herpolhode(&self.herpolhode).write_csv(out))?;
        folder.file(body_cone, |out| curve::body_cone(&self.cones).write_csv(out))?;
        folder.file(space_cone, |out| curve::space_cone(&self.cones).write_csv(out))?;
        Ok(names)
    }
}

fn chord_error(text: &str) -> Result<f64, String> {
    let error = quantity(text, Dimension::NONE)?;
    if (1e-10..=0.1).contains(&error) { Ok(error) } else { Err("it must be from 1e-10 to 0.1".to_owned()) }
}
