//! Parts lists and what is asked of them, for `polhode budget`: CSV, XLSX, or TOML that names one of these.
//!
//! ```csv
//! # title = "A CubeSat"
//! # products = "positive integrals"
//! name,          parent, mass [g], x [mm], y [mm], z [mm]
//! cubesat,       ,       ,         ,       ,
//! battery,       cubesat, 270 ± 5, 0,      12,     -3.5
//! ```
//!
//! Lines in front of the table that begin with `#` are TOML after that. Whatever is unknown, impossible or ambiguous is an error that names its line and column, or its
//! sheet and cell.

mod access;
mod assemble;
mod blame;
mod cell;
mod cells;
mod csv;
mod decimal;
mod fields;
mod head;
mod heading;
mod joined;
mod key;
mod measured;
mod named;
mod number;
mod part;
mod place;
mod plan;
mod prescribed;
mod printed;
mod rows;
mod sections;
mod shape;
mod sheet;
mod taken;
mod tensor;
mod unused;
mod workbook;
mod xlsx;

use std::path::{Path, PathBuf};

use polhode::math::{Body, Part, Position, Rotation};
use polhode_source::FormatError;
use polhode_source::file;
use polhode_source::files::Files;
use polhode_source::toml::reader::Table;
use polhode_source::toml::source::Source;
use polhode_source::toml::{list_units, tree};
use polhode_source::{ContentError, shown};

use crate::{Ballast, Basis, Budget, Limit};
pub use access::Access;
pub(crate) use cell::column_name;
use heading::Columns;
use plan::Plan;
use rows::Rows;
pub(crate) use shape::quoted;
use sheet::Sheet;

pub use plan::sequence::{OverTime, PlannedChange};
pub use prescribed::{FilledTank, Prescribed};

/// A parts list as files give it, and what is asked of it.
#[derive(Clone, Debug, PartialEq)]
pub struct BudgetFile {
    /// Its title.
    pub title: Option<String>,
    /// One of each configuration, in the order of the file; one without a name where the file has none.
    pub configurations: Vec<NamedBudget>,
    /// What is asked.
    pub questions: Questions,
    /// What numbers of the whole have to be.
    pub limits: Vec<Limit>,
    /// Where ballast may be by which they are.
    pub ballast: Option<Ballast>,
    /// Tanks, and what is to happen over time.
    pub prescribed: Option<Prescribed>,
    /// What was read, and what was taken as given.
    pub read: Vec<ReadParts>,
}

/// The parts of one configuration.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedBudget {
    /// The configuration.
    pub name: Option<String>,
    /// Its parts, and what is in its tanks.
    pub budget: Budget,
}

/// What is asked of a parts list.
#[derive(Clone, Debug, PartialEq)]
pub struct Questions {
    /// The point that the tensor is wanted about, besides the centre of mass.
    pub about: Option<Position<Body>>,
    /// The axes that it is wanted along: R_body_axes.
    pub axes: Option<Rotation<Body, Part>>,
    /// How many possible bodies are drawn, if the file says so.
    pub draws: Option<usize>,
    /// Of the draws.
    pub seed: u64,
    /// Which masses count in the headline numbers.
    pub basis: Basis,
}

impl Default for Questions {
    fn default() -> Self {
        Self { about: None, axes: None, draws: None, seed: 1, basis: Basis::Predicted }
    }
}

/// Least number of draws, other than 0.
pub(crate) const LEAST_DRAWS: usize = 10;

/// The most bodies that can be asked for: they take 800 MB.
pub const MOST_DRAWS: usize = 10_000_000;

/// What was read of a file, and what was taken as given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadParts {
    /// Where it is.
    pub path: PathBuf,
    /// A sentence each.
    pub lines: Vec<String>,
}

impl BudgetFile {
    /// Returns what was read and taken as given, line by line.
    pub fn sources(&self) -> Vec<String> {
        let of = |read: &ReadParts| -> Vec<String> {
            read.lines.iter().map(|line| format!("{}: {line}", shown(&read.path))).collect()
        };
        self.read.iter().flat_map(of).collect()
    }
}

/// Reads a parts list, or a plan that names one; its files lie in its own folder.
///
/// # Errors
/// [`FormatError`], with the place, if it, or a file that it names, cannot be read or makes no possible body.
pub fn read(path: &Path) -> Result<BudgetFile, FormatError> {
    read_in(Access::BESIDE, path)
}

/// Reads a parts list, or a plan that names one.
///
/// # Errors
/// As [`read()`].
pub fn read_in(access: Access<'_>, path: &Path) -> Result<BudgetFile, FormatError> {
    file::require_folders(access.files, access.roots)?;
    from_bytes(access, path, &bytes_of(access.files, path)?)
}

/// Reads a parts list from the bytes of its file; files that it names are relative to the path, which errors name.
///
/// # Errors
/// As [`read()`].
pub fn from_bytes(access: Access<'_>, path: &Path, bytes: &[u8]) -> Result<BudgetFile, FormatError> {
    if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml")) {
        return named::of_plan(path, text(path, bytes)?, access);
    }
    if xlsx::is_archive(bytes) {
        return workbook::read(path, bytes, None, access);
    }
    of_text(path, text(path, bytes)?, access)
}

/// Reads a parts list from its text, CSV.
///
/// ```
/// use polhode_budget::read;
/// let text = "name,mass [g],x [mm]\nbattery,270 ± 5,12\nradio,94,-20\n";
/// let file = read::from_text("list.csv".as_ref(), text)?;
/// assert_eq!(file.configurations[0].budget.mass_properties(file.questions.basis).unwrap().mass(), 0.364);
///
/// let error = read::from_text("list.csv".as_ref(), &text.replace("94", "94 mm")).unwrap_err();
/// assert_eq!(error.to_string(), "list.csv:3:7: \"mm\" is a length where a mass belongs");
/// # Ok::<(), polhode_source::FormatError>(())
/// ```
///
/// # Errors
/// As [`read()`].
pub fn from_text(path: &Path, text: &str) -> Result<BudgetFile, FormatError> {
    of_text(path, text, Access::BESIDE)
}

fn of_text(path: &Path, text: &str, access: Access<'_>) -> Result<BudgetFile, FormatError> {
    let files = access.of(path);
    let source = Source::new(&files, path, text);
    let (toml, from) = head::toml(source)?;
    let entries = tree::parse(&toml).map_err(|error| source.syntax(&error).with_hint(head::SYNTAX))?;
    list_units::check(source, &entries)?;
    let plan = plan::plan(&Table::root(source, &entries), &[], None)?;
    of_csv(source, from, plan, access)
}

/// Bytes of a file: a larger one is no parts list.
const LARGEST_FILE: u64 = 256 << 20;

fn bytes_of(files: &dyn Files, path: &Path) -> Result<Vec<u8>, FormatError> {
    file::bytes(files, path, &path.to_string_lossy(), LARGEST_FILE)
        .map_err(|kind| FormatError::new(path, None, kind))
}

fn text<'a>(path: &Path, bytes: &'a [u8]) -> Result<&'a str, FormatError> {
    if xlsx::is_compound(bytes) {
        let error = ContentError::unsupported("workbooks of this kind: XLS, or XLSX with a password");
        return Err(FormatError::of_content(path, bytes, error.hint("save it as XLSX, without a password")));
    }
    str::from_utf8(bytes).map_err(|error| FormatError::not_utf8(path, bytes, error.valid_up_to()))
}

fn of_csv(
    source: Source<'_>,
    from: usize,
    plan: Plan,
    access: Access<'_>,
) -> Result<BudgetFile, FormatError> {
    let (mut sheet, separator) = csv::sheet(source, from, heading::is_of_names)?;
    let columns = Columns::of(&sheet, &plan.ignore)?;
    unused::ignored(&columns, &plan, &[])?;
    sheet.decimal_comma = decimal::comma(&sheet, &columns, &plan, separator)?;
    of_table(plan, &sheet, &columns, Vec::new(), access)
}

fn of_table(
    plan: Plan,
    sheet: &Sheet<'_>,
    columns: &Columns,
    mut lines: Vec<String>,
    access: Access<'_>,
) -> Result<BudgetFile, FormatError> {
    let mut rows = Rows::new(sheet, columns, &plan, access);
    let all = rows.all()?;
    let configurations = assemble::budgets(all, &plan, &rows, &mut lines)?;
    unused::declared(columns, &plan, &configurations)?;
    let (configurations, prescribed) = prescribed::with_liquid(configurations, &plan, &mut lines)?;
    lines.extend(taken::of_sheet(sheet, columns, &plan, &rows.reader));
    lines.extend(rows.taken.lines());
    let read = taken::files(sheet, &plan, lines);
    let Plan { title, questions, limits, ballast, .. } = plan;
    Ok(BudgetFile { title, configurations, questions, limits, ballast, prescribed, read })
}
