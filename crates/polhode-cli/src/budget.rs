//! `polhode budget`

use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use polhode_budget::{Budgeted, Output, Request, run_watched};
use polhode_document::Report as _;
use polhode_source::files::Disk;
use polhode_source::shown;

use crate::failure::Failure;
use crate::form::Form;
use crate::partial;
use crate::progress::DrawProgress;
use crate::same_file::is_same;
use crate::stdout::{self, print, print_exact};

/// Options that print the result. `--force` must name them as conflicts, because `requires` alone
/// would accept them.
const PRINTED: [&str; 8] = ["json", "markdown", "html", "csv", "body", "diff", "about", "along"];

/// Options that have no effect on the list as it is stated, along its own axes.
const GIVEN: [&str; 5] = ["about", "along", "draws", "seed", "diff"];

/// Options that have no effect on a sweep plan, whose members are random.
const DRAWN: [&str; 3] = ["about", "along", "diff"];

/// Options that have no effect on a scenario of the sequence over time.
const AT_FIRST: [&str; 7] = ["about", "along", "draws", "seed", "diff", "configuration", "strict"];

/// Sum a parts list: mass, centre of mass and inertia with uncertainties.
///
/// The list has one row per part, as CSV or XLSX; a TOML plan can name the table. The book
/// describes the format. The report contains basic, predicted and allowable masses of all rows;
/// mass properties about any point and along any axes; the first-order covariance of all ten
/// numbers, compared with random draws of physical bodies; principal axes and their tilt; and the
/// error breakdown.
///
/// The default is 10,000 draws. Lists of more than 2,000 rows get fewer, at least 200: rows times
/// draws is at most 20 million. A number of draws in the file or in --draws is never changed.
/// --draws 0 turns draws off.
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  polhode budget examples/budget/cubesat.csv
  polhode budget examples/budget/cubesat.csv --html > cubesat.html
  polhode budget examples/budget/sounding-rocket.xlsx --about \"0,0,1.2 m\" --json
  polhode budget examples/budget/cubesat.csv --basis basic --csv > parts.csv
  polhode budget examples/budget/sounding-rocket.xlsx --csv=time > over-time.csv
  polhode budget parts.csv --diff last-week.csv
  polhode budget examples/budget/cubesat.csv --configuration deployed --body > whole.toml
  polhode budget examples/budget/cubesat.csv --configuration deployed --sweep plan.toml && polhode sweep plan.toml
  polhode budget examples/budget/sounding-rocket.xlsx --scenario rocket.toml && polhode simulate rocket.toml")]
pub(crate) struct BudgetCommand {
    #[command(flatten)]
    request: Request,
    /// Print JSON: all results, with the covariance.
    #[arg(long, group = "form")]
    json: bool,
    /// Print Markdown.
    #[arg(long, group = "form")]
    markdown: bool,
    /// Print a self-contained HTML page with figures.
    #[arg(long, group = "form")]
    html: bool,
    /// Print CSV: masses and mass properties of each row of the list, or of the total over time or
    /// by fill level of the tanks.
    #[arg(long, group = "form", value_enum, value_name = "TABLE", num_args = 0..=1, require_equals = true, default_missing_value = "parts", conflicts_with_all = GIVEN)]
    csv: Option<Table>,
    /// Write all these tables to an XLSX workbook, with sheets for the total and its covariance.
    #[arg(long, groups = ["form", "written"], value_name = "OUT", conflicts_with_all = GIVEN)]
    xlsx: Option<PathBuf>,
    /// Print the total as a part of a scenario file, for simulate, stability and sweep.
    #[arg(long, group = "form", conflicts_with_all = GIVEN)]
    body: bool,
    /// Write a plan for sweep: mass, centre of mass and tensor of its members vary with the list's
    /// errors and their correlations.
    #[arg(long, groups = ["form", "written"], value_name = "OUT.toml", conflicts_with_all = DRAWN)]
    sweep: Option<PathBuf>,
    /// Write the sequence over time as a scenario for simulate, and the table of mass properties as
    /// a CSV file next to it.
    #[arg(long, groups = ["form", "written"], value_name = "OUT.toml", conflicts_with_all = AT_FIRST)]
    scenario: Option<PathBuf>,
    /// Overwrite existing files of --xlsx, --sweep and --scenario.
    #[arg(long, requires = "written", conflicts_with_all = PRINTED)]
    force: bool,
}

/// Table printed by `--csv`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Table {
    /// Rows of the list.
    Parts,
    /// Total over time, with its rates.
    Time,
    /// Total by the fill level of each tank.
    Fill,
}

impl BudgetCommand {
    pub(crate) fn run(mut self) -> Result<(), Failure> {
        self.request.output = self.output();
        let mut progress = DrawProgress::new();
        let found = run_watched(&self.request, &Disk, &mut |drawn, count| progress.reached(drawn, count))?;
        drop(progress);
        let form = Form { json: self.json, markdown: self.markdown, html: self.html };
        match (&self.request.output, found.report()) {
            // Long lists are written row by row.
            (None, Some(report)) if self.json => {
                stdout::write(|out| report.write_json(out).and_then(|()| out.write_all(b"\n")))?;
            }
            (None, _) => print(&form.text(&found))?,
            (Some(Output::Parts), Some(report)) => stdout::write(|out| report.write_csv(out))?,
            (Some(output), _) => self.write(output, &found)?,
        }
        if found.has_failed() { Err(Failure::Findings) } else { Ok(()) }
    }

    fn output(&mut self) -> Option<Output> {
        let table = self.csv.map(|table| match table {
            Table::Parts => Output::Parts,
            Table::Time => Output::Time,
            Table::Fill => Output::Fill,
        });
        let body = self.body.then_some(Output::Body);
        table
            .or(body)
            .or_else(|| self.xlsx.take().map(Output::Workbook))
            .or_else(|| self.sweep.take().map(Output::Plan))
            .or_else(|| self.scenario.take().map(Output::Scenario))
    }

    fn write(&self, output: &Output, found: &Budgeted) -> Result<(), Failure> {
        let files = found.files()?;
        if !matches!(output, Output::Time | Output::Fill | Output::Body) {
            require_not_read(files.iter().map(|(path, _)| &**path), found)?;
        }
        match (output, &files[..]) {
            (Output::Body, [(_, text)]) => print(&String::from_utf8_lossy(text)),
            (Output::Time | Output::Fill, [(_, text)]) => print_exact(&String::from_utf8_lossy(text)),
            (_, [(path, bytes)]) => partial::write(path, self.force, |out| out.write_all(bytes)),
            (_, [(beside, rows), (path, bytes)]) => {
                partial::write_pair([(beside, rows), (path, bytes)], self.force)
            }
            _ => Ok(()),
        }
    }
}

/// Refuses to overwrite a file that is read, even with `--force`.
fn require_not_read<'a>(
    mut outputs: impl Iterator<Item = &'a Path>,
    found: &Budgeted,
) -> Result<(), Failure> {
    match outputs.find(|out| found.read().iter().any(|file| is_same(out, file))) {
        Some(out) => {
            let message = format!("{} is an input file and would be overwritten", shown(out));
            Err(Failure::usage(message, "choose another name for the output file"))
        }
        None => Ok(()),
    }
}
