//! `polhode torque`

use std::path::{Path, PathBuf};

use clap::Args;
use polhode::body::Particle;
use polhode::math::{Body, Position};
use polhode::motion::Scenario;
use polhode_document::SourceInfo;
use polhode_document::json::pretty;
use polhode_scenario::read as scenario;
use polhode_scenario::report::RequiredReport;
use polhode_source::given::{Times, positive, quantity, times};
use polhode_source::shown;
use polhode_source::unit;
use polhode_source::unit::Dimension;
use polhode_table::output::parquet;
use polhode_table::output::required::RequiredTable;

use crate::failure::Failure;
use crate::page::check_file;
use crate::partial;
use crate::stdout::print;
use crate::table::Format;

/// The torque, the power and the forces that a given motion needs.
///
/// The scenario prescribes the motion: a fixed axis, Euler angles, a quaternion or ω as formulas of t, a table, or a shaft on two
/// bearings, whose reactions and correction masses are printed too. Nothing is integrated but ω.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode torque examples/notes/11-10-dumbbell.toml
  polhode torque examples/slew.toml --at \"0 s, 30 s\" --table csv -o slew-torque.csv
  polhode torque examples/shaft.toml --json | jq .shaft.correction_masses",
    group = clap::ArgGroup::new("written").args(["table", "output"]).multiple(true)
)]
pub(crate) struct Torque {
    /// The scenario, a TOML file with [prescribed] or [shaft].
    file: PathBuf,
    /// Print the torque at these times too: in s, or each with its unit; 0:1:0.1 are those from 0 to 1 in steps of 0.1.
    #[arg(long, value_name = "T,…", value_parser = times, allow_hyphen_values = true)]
    at: Vec<Times>,
    /// Print the force on a mass fixed to the body here too: mass, x, y, z in body axes, in SI or each with its unit.
    #[arg(long, value_name = "M,X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    point: Vec<Particle<Body>>,
    /// Write a table with a row for each sample of [run], in this format [default: by the name of -o, else csv].
    #[arg(long, value_enum, value_name = "FORMAT")]
    table: Option<Format>,
    /// The table to write [default, with --table: the scenario's name and -torque, here].
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Replace an earlier table.
    #[arg(long, requires = "written")]
    force: bool,
    /// Print JSON.
    #[arg(long)]
    json: bool,
}

impl Torque {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let scenario = scenario::read(&self.file)?;
        let path = shown(&self.file);
        require_motion(&scenario, &path)?;
        let target = self.target();
        if let Some((file, _)) = &target {
            require_run(&scenario, &path)?;
            check_file(file, self.force)?;
        }
        let title = scenario.title().unwrap_or("scenario");
        let source = SourceInfo::new(self.file.display().to_string(), "scenario").described(title);
        let at: Vec<f64> = self.at.iter().flat_map(|Times(times)| times.iter().copied()).collect();
        let report = RequiredReport::new(source, &scenario, &at, &self.point)
            .map_err(|error| Failure::motion(path, error))?;
        let mut written = String::new();
        if let Some((file, format)) = &target {
            let table =
                RequiredTable::new(report.samples(), report.rotor(), report.points(), scenario.shaft());
            self.write(&table, file, *format)?;
            written = format!("wrote {}\n", shown(file));
        }
        if self.json {
            return print(&(pretty(&report.to_json()) + "\n"));
        }
        print(&(report.to_text() + &written))
    }

    /// The table to write, if one is wanted.
    fn target(&self) -> Option<(PathBuf, Format)> {
        let by_name = |file: &Path| {
            let parquet = file.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("parquet"));
            if parquet { Format::Parquet } else { Format::Csv }
        };
        match (&self.output, self.table) {
            (Some(file), format) => Some((file.clone(), format.unwrap_or_else(|| by_name(file)))),
            (None, Some(format)) => {
                let name = self.file.file_stem().unwrap_or_default().to_string_lossy();
                let ending = if format == Format::Csv { "csv" } else { "parquet" };
                Some((PathBuf::from(format!("{name}-torque.{ending}")), format))
            }
            (None, None) => None,
        }
    }

    /// Writes the table, whole or not at all.
    fn write(&self, table: &RequiredTable, file: &Path, format: Format) -> Result<(), Failure> {
        let source = ("polhode.source".to_owned(), self.file.display().to_string());
        partial::write(file, self.force, |out| match format {
            Format::Csv => table.write_csv(out),
            Format::Parquet => parquet::write_required(table, &[source], out),
        })
    }
}

/// Says what is missing where no motion is given.
fn require_motion(scenario: &Scenario, path: &str) -> Result<(), Failure> {
    if scenario.prescribed().is_some() {
        return Ok(());
    }
    let hint = "write [prescribed] with axis = [0, 0, 1] and rate = \"3 rad/s\", or [shaft]";
    Err(if scenario.run().is_some() {
        let message =
            format!("{path} has a [run] but no [prescribed] motion: its motion is computed, not given");
        Failure::usage(
            message,
            format!("`polhode simulate` computes it; for the torque of a given motion {hint}"),
        )
    } else {
        Failure::usage(format!("{path} has no [prescribed] motion, so no torque is asked for"), hint)
    })
}

fn require_run(scenario: &Scenario, path: &str) -> Result<(), Failure> {
    match scenario.run() {
        Some(_) => Ok(()),
        None => Err(Failure::usage(
            format!("{path} has no [run] section, so a table has no rows"),
            "write [run] with duration = \"10 s\" and samples = 1001",
        )),
    }
}

/// `0.5 kg, 0, 10 cm, 0`
fn point(text: &str) -> Result<Particle<Body>, String> {
    let parts: Vec<&str> = text.split(',').map(str::trim).collect();
    let [mass, place @ ..] = parts.as_slice() else {
        return Err("a mass and a place belong here".to_owned());
    };
    if place.len() != 3 {
        return Err(format!(
            "a mass and three coordinates belong here (m,x,y,z), not {} numbers",
            parts.len()
        ));
    }
    let mass = positive(quantity(mass, Dimension::MASS)?)?;
    if let Some((bare, with)) = unit::bare_beside_units(parts.iter().copied()) {
        return Err(format!("{with:?} has a unit and {bare:?} has none (hint: give each its own, or none)"));
    }
    let mut at = [0.0; 3];
    for (slot, text) in at.iter_mut().zip(place) {
        *slot = quantity(text, Dimension::LENGTH)?;
    }
    Particle::new(mass, Position::from_array(at)).map_err(|error| error.to_string())
}
