//! Part of a program in the answer of a request.

use std::path::Path;

use polhode_source::Failure;

use super::kind::Kind;
use crate::report::InertiaReport;

/// Program that answers a request: kinds of files that other crates read, and progress.
pub trait Host {
    /// Returns true for robot models, which share .sdf with molecules and .xml with anything.
    fn is_robot(&self, _file: &Path) -> bool {
        false
    }

    /// Returns an option that only robot models have, if one is given.
    fn robot_option(&self) -> Option<&'static str> {
        None
    }

    /// Reads a scenario or a robot model.
    ///
    /// # Errors
    /// [`Failure`] if it cannot be read.
    fn reports(&self, file: &Path, kind: Kind) -> Result<Vec<InertiaReport>, Failure> {
        let message = format!("{} is {}, which is not read here", file.display(), kind.in_words());
        Err(Failure::usage(message, ""))
    }

    /// Takes note that a file is read next.
    fn begin(&mut self, _file: &Path) {}

    /// Takes note that the cubature of a density over `pieces` pieces begins.
    fn begin_cubature(&mut self, _pieces: usize) {}

    /// Takes note that one more piece has been sampled at `points` points.
    fn sampled(&mut self, _points: usize) {}
}

impl Host for () {}
