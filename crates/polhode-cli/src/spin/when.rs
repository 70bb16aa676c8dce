//! Input files of times.

use std::io;
use std::path::{Path, PathBuf};

use clap::Args;
use polhode_source::files::Disk;
use polhode_source::given::{Given, Times};
use polhode_source::times;

use crate::failure::Failure;

/// Option for a file of times at which the state is printed.
#[derive(Debug, Args)]
pub(super) struct TimeFlags {
    /// Like --at, for a file with one time per line; blank lines and # comments are ignored, and -
    /// is standard input.
    #[arg(long, value_name = "FILE")]
    at_file: Option<PathBuf>,
}

impl TimeFlags {
    /// Returns the times of the file in their order.
    pub(super) fn read(&self) -> Result<Option<Given<Times>>, Failure> {
        let Some(file) = &self.at_file else { return Ok(None) };
        let value = match file.as_path() == Path::new("-") {
            true => times::read_from(io::stdin().lock(), Path::new("standard input"))?,
            false => times::read(&Disk, file)?,
        };
        Ok(Some(Given { text: file.display().to_string(), value: Times(value) }))
    }
}
