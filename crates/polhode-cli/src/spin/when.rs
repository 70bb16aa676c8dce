//! The times that are asked for.

use std::io;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode_source::files::Disk;
use polhode_source::given::{Times, times};
use polhode_source::times;

use crate::failure::Failure;

/// The times to print the state at.
#[derive(Debug, Args)]
pub(super) struct TimeFlags {
    /// Print ω and the attitude at these times: in s, or each with its unit; 0:1:0.1 are those from 0 to 1 in steps of 0.1; negative
    /// ones are before the start.
    #[arg(long, value_name = "T,…", value_parser = times, allow_hyphen_values = true)]
    at: Vec<Times>,
    /// The same for a file with one time per line; blank lines and # comments are left out, and - is standard input.
    #[arg(long, value_name = "FILE")]
    at_file: Option<PathBuf>,
}

impl TimeFlags {
    /// All times, in the order in which they are given.
    pub(super) fn read(&self) -> Result<Vec<f64>, Failure> {
        let mut all: Vec<f64> = self.at.iter().flat_map(|Times(times)| times.iter().copied()).collect();
        match self.at_file.as_deref() {
            Some(file) if file == Path::new("-") => {
                all.extend(times::read_from(io::stdin().lock(), Path::new("standard input"))?);
            }
            Some(file) => all.extend(times::read(&Disk, file)?),
            None => {}
        }
        Ok(all)
    }
}
