//! `polhode torque`

use std::path::{Path, PathBuf};

use clap::Args;
use polhode::motion::Scenario;
use polhode_document::json::pretty;
use polhode_scenario::request::torque::{Request, run};
use polhode_source::files::Disk;
use polhode_source::shown;
use polhode_table::output::{Table, required};

use crate::failure::Failure;
use crate::page::check_file;
use crate::partial;
use crate::stdout::print;
use crate::table::Format;

/// Compute the torque, power and forces that a prescribed motion requires.
///
/// The scenario prescribes the motion: a fixed axis; Euler angles, a quaternion or ω as formulas of
/// t; a table; or a shaft on two bearings. For a shaft, the bearing reactions and the correction
/// masses are printed too. Only ω is integrated.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode torque examples/notes/11-10-dumbbell.toml
  polhode torque examples/slew.toml --at \"0 s, 30 s\" --table csv -o slew-torque.csv
  polhode torque examples/shaft.toml --json | jq .shaft.correction_masses",
    group = clap::ArgGroup::new("written").args(["table", "output"]).multiple(true)
)]
pub(crate) struct Torque {
    #[command(flatten)]
    request: Request,
    /// Write a table with one row per sample of [run], in this format [default: from the extension
    /// of -o, else csv].
    #[arg(long, value_enum, value_name = "FORMAT")]
    table: Option<Format>,
    /// Output file of the table [default with --table: SCENARIO-torque in the working directory].
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Overwrite an existing table.
    #[arg(long, requires = "written")]
    force: bool,
    /// Print JSON.
    #[arg(long)]
    json: bool,
}

impl Torque {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let target = self.target();
        let report = run(&self.request, &Disk)?;
        if let Some((file, _)) = &target {
            require_run(report.scenario(), &shown(&self.request.file))?;
            check_file(file, self.force)?;
        }
        let mut written = String::new();
        if let Some((file, format)) = &target {
            let shaft = report.scenario().shaft();
            let table = required(report.samples(), report.rotor(), report.points(), shaft);
            self.write(&table, file, *format)?;
            written = format!("wrote {}\n", shown(file));
        }
        if self.json {
            return print(&(pretty(&report.to_json()) + "\n"));
        }
        print(&(report.to_text() + &written))
    }

    /// Returns the path and format of the table, if one is requested.
    fn target(&self) -> Option<(PathBuf, Format)> {
        let by_name = |file: &Path| {
            let parquet = file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("parquet"));
            if parquet { Format::Parquet } else { Format::Csv }
        };
        match (&self.output, self.table) {
            (Some(file), format) => Some((file.clone(), format.unwrap_or_else(|| by_name(file)))),
            (None, Some(format)) => {
                let name = self.request.file.file_stem().unwrap_or_default().to_string_lossy();
                let ending = if format == Format::Csv { "csv" } else { "parquet" };
                Some((PathBuf::from(format!("{name}-torque.{ending}")), format))
            }
            (None, None) => None,
        }
    }

    /// Writes the table, completely or not at all.
    fn write(&self, table: &Table<'_>, file: &Path, format: Format) -> Result<(), Failure> {
        let source = ("polhode.source".to_owned(), self.request.file.display().to_string());
        partial::write(file, self.force, |out| match format {
            Format::Csv => table.write_csv(out),
            Format::Parquet => table.write_parquet(&[source], out),
        })
    }
}

fn require_run(scenario: &Scenario, path: &str) -> Result<(), Failure> {
    match scenario.run() {
        Some(_) => Ok(()),
        None => Err(Failure::usage(
            format!("{path} has no [run] section, so a table would have no rows"),
            "add [run] with duration = \"10 s\" and samples = 1001",
        )),
    }
}
