//! Interface of a program that answers a request.

use std::path::Path;

use polhode_source::Failure;

use super::kind::Kind;
use crate::report::InertiaReport;

/// Callbacks of the program that answers a request: readers for further kinds of files, and
/// progress.
pub trait Host {
    /// Returns true for robot models. They share .sdf with molecules, and .xml with other files.
    fn is_robot(&self, _file: &Path) -> bool {
        false
    }

    /// Returns the name of an option for robot models, if one is set.
    fn robot_option(&self) -> Option<&'static str> {
        None
    }

    /// Reads a scenario or a robot model.
    ///
    /// # Errors
    /// [`Failure`] if it cannot be read.
    fn reports(&self, file: &Path, kind: Kind) -> Result<Vec<InertiaReport>, Failure> {
        let message = format!("{} is {}, which cannot be read here", file.display(), kind.in_words());
        Err(Failure::usage(message, ""))
    }

    /// Reports that a file is about to be read.
    fn begin(&mut self, _file: &Path) {}

    /// Reports that the cubature of a density over `pieces` pieces is about to begin.
    fn begin_cubature(&mut self, _pieces: usize) {}

    /// Reports that one more piece has been sampled at `points` points.
    fn sampled(&mut self, _points: usize) {}
}

impl Host for () {}
