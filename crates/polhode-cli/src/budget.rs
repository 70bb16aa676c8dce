//! `polhode budget`

use std::io::{Cursor, Write as _};
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use polhode::math::{Body, Part, Position, Rotation};
use polhode_budget::read as budget;
use polhode_budget::read::{Access, BudgetFile, OverTime, Questions};
use polhode_budget::report::{
    BudgetDiff, BudgetOptions, BudgetReport, Cell as BudgetCell, NoConfiguration, PlanOptions,
    Sheet as BudgetSheet,
};
use polhode_budget::{Basis, LimitError};
use polhode_document::Document;
use polhode_document::json::pretty;
use polhode_document::layout::printable;
use polhode_source::files::Disk;
use polhode_source::given::{point, rotation};
use polhode_source::shown;
use polhode_table::output::workbook;
use serde_json::Value;

use crate::budget_history;
use crate::budget_statements::statements;
use crate::failure::Failure;
use crate::partial;
use crate::progress::DrawProgress;
use crate::same_file::is_same;
use crate::stdout::{self, columns, print, print_exact};

/// What is printed instead of a workbook: without naming them `requires` would let these pass.
const PRINTED: [&str; 8] = ["json", "markdown", "html", "csv", "body", "diff", "about", "along"];

/// The same of a scenario.
const NO_SCENARIO: [&str; 3] = ["diff", "configuration", "strict"];

/// What is of the list as it is given, along its own axes.
const TABLES: [&str; 4] = ["csv", "xlsx", "body", "scenario"];

/// The same where draws may be asked for: the members of a plan are some.
const GIVEN: [&str; 5] = ["csv", "xlsx", "body", "scenario", "sweep"];

/// What is said of a plan of a list to which something happens, and what its reader may do.
const CHANGES: (&str, &str) = (
    "the list has [[burn]], [[drop]] or [[deploy]], and the members of a plan have bodies that do not change",
    "--scenario writes what happens to the body as it is listed; without these sections the plan is of the body at first",
);

/// What stands above the body of a list to which something happens.
const AT_FIRST: &str = "# As it is at first: polhode budget --scenario writes what happens to it\n";

/// What a parts list comes to: mass, centre of mass and inertia with their uncertainties.
///
/// A row a part, as CSV or XLSX, or a plan in TOML that names the table: the reference of the format is in the book. Basic, predicted and allowable mass of everything in the tree;
/// mass properties about any point and along any axes; the covariance of all ten numbers to first order, beside draws of bodies that can exist; principal axes and their tilt;
/// whose errors matter.
///
/// The default is 10,000 draws. Lists of more than 2,000 rows get fewer: rows times draws is 20
/// million, and 200 draws are the least. A number of draws that the file or --draws states is never
/// changed. --draws 0 draws none.
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
    /// A parts list, CSV or XLSX; or a plan that names one, TOML.
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Folder that files which the parts list names may lie in, besides its own folder.
    #[arg(long = "root", value_name = "DIR")]
    roots: Vec<PathBuf>,
    /// Which masses count: as they are known, or with their growth allowance [default: the file's, else predicted].
    #[arg(long, value_enum, value_name = "BASIS")]
    basis: Option<BasisName>,
    /// Also the tensor about this point: x,y,z from the origin, each with its unit or in metres.
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true, conflicts_with_all = GIVEN)]
    about: Option<Position<Body>>,
    /// Also the tensor along axes turned by this unit quaternion (scalar first, turned axes to body axes), from which tilts are then.
    #[arg(long, value_name = "W,X,Y,Z", value_parser = rotation::<Body, Part>, allow_hyphen_values = true, conflicts_with_all = GIVEN)]
    along: Option<Rotation<Body, Part>>,
    /// How many possible bodies are drawn: 0, or from 10 to 10,000,000. Of --sweep, how many members the plan has.
    #[arg(long, value_name = "N", conflicts_with_all = TABLES, value_parser = draws)]
    draws: Option<usize>,
    /// Draw others [default: 1].
    #[arg(long, value_name = "N", conflicts_with_all = TABLES)]
    seed: Option<u64>,
    /// Only this configuration.
    #[arg(long, value_name = "NAME")]
    configuration: Option<String>,
    /// Say what changed since another parts list: row by row, and in the whole.
    #[arg(long, value_name = "OTHER", conflicts_with_all = ["csv", "xlsx", "body", "sweep", "scenario", "about", "along", "draws", "seed", "strict"])]
    diff: Option<PathBuf>,
    /// Print JSON: all numbers, with the covariance.
    #[arg(long, group = "form")]
    json: bool,
    /// Print Markdown.
    #[arg(long, group = "form")]
    markdown: bool,
    /// Print one HTML page with pictures, which needs nothing else.
    #[arg(long, group = "form")]
    html: bool,
    /// Print CSV: a row for each row of the list, with the masses and mass properties of all in it; or the whole over time, or by how full its tanks are.
    #[arg(long, group = "form", value_enum, value_name = "TABLE", num_args = 0..=1, require_equals = true, default_missing_value = "parts")]
    csv: Option<Table>,
    /// Write all these as a workbook, with sheets of the whole and its covariance.
    #[arg(long, groups = ["form", "written"], value_name = "OUT")]
    xlsx: Option<PathBuf>,
    /// Print the whole as a part of a scenario file, for simulate, stability and sweep.
    #[arg(long, group = "form")]
    body: bool,
    /// Write a plan that sweep runs: members whose mass, centre of mass and tensor have the list's errors, with their correlations.
    #[arg(long, groups = ["form", "written"], value_name = "OUT.toml")]
    sweep: Option<PathBuf>,
    /// Write what happens over time as a scenario that simulate runs, with the table of the mass properties beside it.
    #[arg(long, groups = ["form", "written"], value_name = "OUT.toml", conflicts_with_all = NO_SCENARIO)]
    scenario: Option<PathBuf>,
    /// Replace the files of --xlsx, --sweep and --scenario.
    #[arg(long, requires = "written", conflicts_with_all = PRINTED)]
    force: bool,
    /// Exit with status 1 if a limit is not met, or something is heavier than allowed.
    #[arg(long)]
    strict: bool,
}

/// A table of --csv.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Table {
    /// The rows of the list.
    Parts,
    /// The whole over time, with its rates.
    Time,
    /// The whole by what is in each tank.
    Fill,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum BasisName {
    /// As they are known today.
    Basic,
    /// With the growth allowance.
    Predicted,
}

impl BudgetCommand {
    pub(crate) fn run(self) -> Result<(), Failure> {
        let access = Access { files: &Disk, roots: &self.roots };
        if let Some(target) = &self.scenario {
            let file = budget::read_in(access, &self.file)?;
            let basis = self.basis.map_or(file.questions.basis, BasisName::basis);
            require_not_read(&self.file, &file, &[target, &target.with_extension("csv")])?;
            return budget_history::write(&file, &self.file, basis, target, self.force);
        }
        let file = budget::read_in(access, &self.file)?;
        let plan = self.plan_options(&file)?;
        let changes = self.over_time(&file).is_some_and(OverTime::has_changes);
        let over_time = file.prescribed.as_ref().and_then(|all| all.over_time.as_ref());
        let begins = over_time.and_then(|all| all.configuration.clone());
        let report = self.report(&self.file, file, false)?;
        if let Some(other) = &self.diff {
            let before = self.report(other, budget::read_in(access, other)?, true)?;
            let diff = BudgetDiff::new(&before, &report);
            return print(&self.printed(|| diff.to_json(), || diff.to_document()));
        }
        if let Some(target) = &self.xlsx {
            self.write_workbook(target, &report)?;
        } else if let Some(table) = self.csv {
            self.print_table(table, &report, begins.as_deref())?;
        } else if let Some(target) = &self.sweep {
            let plan = report.to_plan(self.configuration.as_deref(), &plan);
            let plan = plan.map_err(|why| Failure::usage(why.to_string(), why.hint()).about(&self.file))?;
            if changes {
                let (message, hint) = CHANGES;
                return Err(Failure::usage(message, hint).about(&self.file));
            }
            partial::write(target, self.force, |out| out.write_all(plan.as_bytes()))?;
        } else if self.body {
            let body = report.to_scenario(self.configuration.as_deref());
            let body = body.map_err(|why| Failure::usage(why.to_string(), why.hint()).about(&self.file))?;
            let at_first = if changes { AT_FIRST } else { "" };
            print(&format!("{at_first}{body}"))?;
        } else if self.json {
            stdout::write(|out| report.write_json(out).and_then(|()| out.write_all(b"\n")))?;
        } else {
            print(&self.printed(|| report.to_json(), || report.to_document()))?;
        }
        if self.strict && report.is_beyond() { Err(Failure::Findings) } else { Ok(()) }
    }

    /// In the form that is asked for.
    fn printed(&self, json: impl Fn() -> Value, document: impl Fn() -> Document) -> String {
        if self.json {
            pretty(&json()) + "\n"
        } else if self.markdown {
            document().to_markdown()
        } else if self.html {
            document().to_html()
        } else {
            document().to_text(columns().unwrap_or(polhode_document::layout::WIDTH))
        }
    }

    fn print_table(&self, table: Table, report: &BudgetReport, begins: Option<&str>) -> Result<(), Failure> {
        let nothing = |(message, hint): (&str, &str)| Failure::usage(message, hint).about(&self.file);
        match table {
            Table::Parts => {
                let mut refused = None;
                stdout::write(|out| match report.write_csv(out) {
                    Ok(written) => written,
                    Err(error) => {
                        refused = Some(self.refused(&error.into()));
                        Ok(())
                    }
                })?;
                refused.map_or(Ok(()), Err)
            }
            Table::Time => print_exact(&report.to_time_csv().ok_or_else(|| match begins {
                None => nothing(budget_history::NOTHING),
                Some(name) => {
                    let message = format!(
                        "nothing happens in this configuration: the sequence begins as \"{}\"",
                        printable(name)
                    );
                    Failure::usage(message, "leave --configuration out").about(&self.file)
                }
            })?),
            Table::Fill => {
                let none = ("there is no tank in it", "add [[tank]] with what is in it");
                print_exact(&report.to_fill_csv().ok_or_else(|| nothing(none))?)
            }
        }
    }

    fn write_workbook(&self, target: &Path, report: &BudgetReport) -> Result<(), Failure> {
        let sheets = report.to_sheets().map_err(|error| self.refused(&error.into()))?;
        let sheets: Vec<_> = sheets.into_iter().map(sheet).collect();
        let mut bytes = Cursor::new(Vec::new());
        let failed = |error| Failure::Output { path: shown(target), error };
        workbook::write(&sheets, &mut bytes).map_err(failed)?;
        partial::write(target, self.force, |out| out.write_all(bytes.get_ref()))
    }

    fn report(&self, path: &Path, file: BudgetFile, is_other: bool) -> Result<BudgetReport, Failure> {
        if let Some(target) = self.xlsx.as_ref().or(self.sweep.as_ref()) {
            require_not_read(path, &file, &[target])?;
        }
        let sources = file.sources(&|path| shown(path));
        let stated = self.diff.is_some().then(|| statements(&file));
        let BudgetFile { title, configurations, questions, limits, ballast, prescribed, .. } = file;
        let mut all: Vec<_> = configurations.into_iter().map(|one| (one.name, one.budget)).collect();
        if let Some(wanted) = &self.configuration {
            let names: Vec<String> = all.iter().filter_map(|(name, _)| name.clone()).collect();
            // A list without configurations is the same in each.
            let is_in_each = is_other && names.is_empty();
            all.retain(|(name, _)| is_in_each || name.as_ref() == Some(wanted));
            if all.is_empty() {
                let why = NoConfiguration { asked: Some(wanted.clone()), names };
                return Err(Failure::usage(why.to_string(), why.hint()).about(path));
            }
        }
        if self.draws == Some(0) && !limits.is_empty() {
            let message = "the file has limits, which are tried by draws, and --draws is 0";
            return Err(Failure::usage(message, "leave --draws out").about(path));
        }
        let rows = all.iter().map(|(_, budget)| budget.rows().len()).max().unwrap_or(0);
        let options = self.options(&questions, rows, !limits.is_empty());
        let is_given = self.is_given();
        let basis = options.basis;
        let mut progress = DrawProgress::new(options.draws);
        let mut reached = |drawn| progress.reached(drawn);
        let report = BudgetReport::watched(title.as_deref(), sources, all, limits, options, &mut reached);
        drop(progress);
        let mut report = report.map_err(|error| self.refused(&error).about(path))?;
        if let Some(prescribed) = prescribed.filter(|_| !is_given || self.has_states()) {
            for name in report.names() {
                let Some(sequence) = prescribed.sequence(name.as_deref(), basis) else { continue };
                let over_time = prescribed.over_time.as_ref().filter(|all| all.configuration == name);
                let until = over_time.map(|all| all.until);
                report = report
                    .with_sequence(name.as_deref(), &sequence, until)
                    .map_err(|error| budget_history::refused(&error, path))?;
            }
        }
        if let Some(stated) = stated {
            return Ok(report.with_statements(stated));
        }
        match ballast.filter(|_| !is_given) {
            None => Ok(report),
            Some(ballast) => report.with_ballast(ballast).map_err(|error| {
                let hint = "leave [[site]] out to see what the limits come to without ballast";
                Failure::usage(error.to_string(), hint).about(path)
            }),
        }
    }

    /// A body, tables and differences are of the list as it is given, without draws and ballast.
    const fn is_given(&self) -> bool {
        self.body || self.sweep.is_some() || self.csv.is_some() || self.xlsx.is_some() || self.diff.is_some()
    }

    /// Of the members of a plan: their number and seed are those of the draws.
    fn plan_options(&self, file: &BudgetFile) -> Result<PlanOptions, Failure> {
        let members = self.draws.or(file.questions.draws).unwrap_or(BudgetReport::DRAWS);
        if self.sweep.is_some() && members == 0 {
            return Err(Failure::usage("a plan has members, and --draws is 0", "leave --draws out"));
        }
        let over_time = self.over_time(file);
        /// s
        const DURATION: f64 = 60.0;
        Ok(PlanOptions {
            members,
            seed: self.seed.unwrap_or(file.questions.seed),
            spin: over_time.and_then(|all| all.spin),
            duration: over_time.map_or(DURATION, |all| all.until),
        })
    }

    /// What happens to the configuration that is asked for, if it is the one that the sequence begins as.
    fn over_time<'a>(&self, file: &'a BudgetFile) -> Option<&'a OverTime> {
        let is_first = |name: &Option<String>| self.configuration.is_none() || self.configuration == *name;
        file.prescribed.as_ref()?.over_time.as_ref().filter(|all| is_first(&all.configuration))
    }

    /// Tables of the body over time, and by what is in its tanks, are asked for.
    fn has_states(&self) -> bool {
        self.xlsx.is_some() || matches!(self.csv, Some(Table::Time | Table::Fill))
    }

    /// What the file asks, and what the command line asks instead.
    fn options(&self, asked: &Questions, rows: usize, is_limited: bool) -> BudgetOptions {
        let needed = !self.is_given() || (self.strict && is_limited);
        let usual = || BudgetReport::affordable_draws(rows);
        BudgetOptions {
            basis: self.basis.map_or(asked.basis, BasisName::basis),
            about: self.about.or(asked.about),
            along: self.along.or(asked.axes),
            draws: if needed { self.draws.or(asked.draws).unwrap_or_else(usual) } else { 0 },
            seed: self.seed.unwrap_or(asked.seed),
        }
    }

    fn refused(&self, error: &LimitError) -> Failure {
        Failure::usage(error.to_string(), error.hint().unwrap_or_default()).about(&self.file)
    }
}

impl BasisName {
    const fn basis(self) -> Basis {
        match self {
            Self::Basic => Basis::Basic,
            Self::Predicted => Basis::Predicted,
        }
    }
}

/// Refuses to write over what is read, whatever --force says.
fn require_not_read(list: &Path, file: &BudgetFile, outputs: &[&Path]) -> Result<(), Failure> {
    let read = || [list].into_iter().chain(file.read.iter().map(|read| read.path.as_path()));
    match outputs.iter().find(|out| read().any(|file| is_same(out, file))) {
        Some(out) => {
            let message = format!("{} is read, and would be overwritten", shown(out));
            Err(Failure::usage(message, "choose another name for what is written"))
        }
        None => Ok(()),
    }
}

fn sheet(sheet: BudgetSheet) -> workbook::Sheet {
    let cell = |cell| match cell {
        BudgetCell::Empty => workbook::Cell::Empty,
        BudgetCell::Text(text) => workbook::Cell::Text(text),
        BudgetCell::Number(number) => workbook::Cell::Number(number),
    };
    let rows = sheet.rows.into_iter().map(|row| row.into_iter().map(cell).collect()).collect();
    workbook::Sheet { name: sheet.name.to_owned(), rows }
}

fn draws(text: &str) -> Result<usize, String> {
    const LEAST: usize = 10;
    match text.parse::<usize>() {
        Ok(0) => Ok(0),
        Ok(n) if (LEAST..=budget::MOST_DRAWS).contains(&n) => Ok(n),
        _ => Err(format!("it must be 0, or from {LEAST} to {}", budget::MOST_DRAWS)),
    }
}
