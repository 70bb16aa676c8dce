//! Input files of `polhode budget`: parts lists with the requested results, as CSV, XLSX, or TOML
//! that refers to one of these.
//!
//! ```csv
//! # title = "A CubeSat"
//! # products = "positive integrals"
//! name,          parent, mass [g], x [mm], y [mm], z [mm]
//! cubesat,       ,       ,         ,       ,
//! battery,       cubesat, 270 ± 5, 0,      12,     -3.5
//! ```
//!
//! Lines before the table that begin with `#` contain TOML. Everything that is unknown, impossible
//! or ambiguous is an error. Each error has its line and column, or its sheet and cell.

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
use polhode_source::toml::{list_units, root_names, tree};
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

/// Parts list with the requested results, as read from files.
#[derive(Clone, Debug, PartialEq)]
pub struct BudgetFile {
    pub title: Option<String>,
    /// Budget of each configuration, in the order of the file. A file without configurations has
    /// one budget without a name.
    pub configurations: Vec<NamedBudget>,
    /// Results that are requested.
    pub questions: Questions,
    /// Limits on quantities of the whole.
    pub limits: Vec<Limit>,
    /// Sites and options of a search for ballast.
    pub ballast: Option<Ballast>,
    /// Tanks, and changes of the body over time.
    pub prescribed: Option<Prescribed>,
    /// Files that were read, with the assumptions that were made.
    pub read: Vec<ReadParts>,
}

/// Budget of one configuration.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedBudget {
    /// Name of the configuration, if the file has any.
    pub name: Option<String>,
    /// Parts of the configuration, and the liquid in its tanks.
    pub budget: Budget,
}

/// Results that are requested for a parts list.
#[derive(Clone, Debug, PartialEq)]
pub struct Questions {
    /// Point about which the tensor is requested, besides the centre of mass.
    pub about: Option<Position<Body>>,
    /// Axes along which the tensor is requested: R_body_axes.
    pub axes: Option<Rotation<Body, Part>>,
    /// Number of possible bodies to draw, if it is given.
    pub draws: Option<usize>,
    /// Seed of the draws.
    pub seed: u64,
    /// Mass basis of the main results.
    pub basis: Basis,
}

impl Default for Questions {
    fn default() -> Self {
        Self { about: None, axes: None, draws: None, seed: 1, basis: Basis::Predicted }
    }
}

/// Least number of draws, other than 0.
pub(crate) const LEAST_DRAWS: usize = 10;

/// Largest number of draws. They take 800 MB.
pub const MOST_DRAWS: usize = 10_000_000;

/// File that was read, with the assumptions that were made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadParts {
    /// Path of the file.
    pub path: PathBuf,
    /// Statements for the report, one sentence each.
    pub lines: Vec<String>,
}

impl BudgetFile {
    /// Returns what was read and assumed, line by line.
    pub fn sources(&self) -> Vec<String> {
        let of = |read: &ReadParts| -> Vec<String> {
            read.lines.iter().map(|line| format!("{}: {line}", shown(&read.path))).collect()
        };
        self.read.iter().flat_map(of).collect()
    }
}

/// Reads a parts list, or a plan that refers to one. Its files must be in its own folder.
///
/// # Errors
/// [`FormatError`] with its position, if the list or a file that it refers to cannot be read or
/// does not make a possible body.
pub fn read(path: &Path) -> Result<BudgetFile, FormatError> {
    read_in(Access::BESIDE, path)
}

/// Reads a parts list, or a plan that refers to one, with the given file access.
///
/// # Errors
/// Same as [`read()`].
pub fn read_in(access: Access<'_>, path: &Path) -> Result<BudgetFile, FormatError> {
    file::require_folders(access.files, access.roots)?;
    from_bytes(access, path, &bytes_of(access.files, path)?)
}

/// Reads a parts list from the bytes of its file. Other files are relative to `path`, which errors
/// also report.
///
/// # Errors
/// Same as [`read()`].
pub fn from_bytes(access: Access<'_>, path: &Path, bytes: &[u8]) -> Result<BudgetFile, FormatError> {
    if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml")) {
        return named::of_plan(path, text(path, bytes)?, access);
    }
    if xlsx::is_archive(bytes) {
        return workbook::read(path, bytes, None, access);
    }
    of_text(path, text(path, bytes)?, access)
}

/// Reads a parts list from its CSV text.
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
/// Same as [`read()`].
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

/// Returns true for a workbook, and for a text with a heading of names, which [`read()`] requires.
pub fn is_list(bytes: &[u8]) -> bool {
    let has_names = |text: &str| csv::separator(text, 0, heading::is_of_names).is_some();
    xlsx::is_archive(bytes) || xlsx::is_compound(bytes) || str::from_utf8(bytes).is_ok_and(has_names)
}

/// Returns true for the text of a plan, which names a file of parts. It need not be valid.
pub fn is_plan(text: &str) -> bool {
    root_names(text).any(|name| name == "parts")
}

/// Largest size of a file, bytes. No parts list is larger.
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
