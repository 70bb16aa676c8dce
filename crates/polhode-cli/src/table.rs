//! File formats of the trajectory table.

use clap::ValueEnum;
use polhode::motion::Trajectory;
use polhode_scenario::read::TableFormat;
use polhode_table::output::{Surroundings, Table};

use crate::failure::Failure;
use crate::folder::Folder;

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Apache Parquet, units and conventions in its metadata.
    Parquet,
    /// Comma-separated text; numbers keep all their digits.
    Csv,
}

impl From<TableFormat> for Format {
    fn from(format: TableFormat) -> Self {
        match format {
            TableFormat::Csv => Self::Csv,
            _ => Self::Parquet,
        }
    }
}

impl Format {
    const fn file_name(self) -> &'static str {
        match self {
            Self::Parquet => "trajectory.parquet",
            Self::Csv => "trajectory.csv",
        }
    }
}

/// Writes a trajectory in each format, once; returns the names of the files.
pub(crate) fn write(
    formats: &[Format],
    trajectory: &Trajectory,
    surroundings: &Surroundings,
    metadata: &[(String, String)],
    folder: &Folder,
) -> Result<Vec<&'static str>, Failure> {
    let table = Table::of(trajectory, surroundings);
    let mut written = Vec::new();
    for format in formats {
        if written.contains(&format.file_name()) {
            continue;
        }
        folder.file(format.file_name(), |out| match format {
            Format::Parquet => table.write_parquet(metadata, out),
            Format::Csv => table.write_csv(out),
        })?;
        written.push(format.file_name());
    }
    Ok(written)
}
