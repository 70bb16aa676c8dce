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

mod csv;
mod heading;
mod number;
mod plan;
mod row;
mod sheet;

use std::path::{Path, PathBuf};

use polhode::math::{Body, Part, Position, Rotation};
use polhode_budget::{Basis, Budget, PartsList};

use crate::error::{FormatError, FormatErrorKind};
use crate::scenario::source::Source;
use crate::scenario::text_of;
use sheet::Sheet;

/// A parts list as files give it, and what is asked of it.
#[derive(Clone, Debug, PartialEq)]
pub struct BudgetFile {
    /// Its title.
    pub title: Option<String>,
    /// One of each configuration, in the order of the file; one without a name where the file has none.
    pub configurations: Vec<NamedBudget>,
    /// What is asked.
    pub questions: Questions,
    /// What was read, and what was taken as given.
    pub read: Vec<ReadParts>,
}

/// The parts of one configuration.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedBudget {
    /// The configuration.
    pub name: Option<String>,
    /// Its parts.
    pub budget: Budget,
}

/// What is asked of a parts list.
#[derive(Clone, Debug, PartialEq)]
pub struct Questions {
    /// The point that the tensor is wanted about, besides the centre of mass.
    pub about: Option<Position<Body>>,
    /// The axes that it is wanted along: R_body_axes.
    pub axes: Option<Rotation<Body, Part>>,
    /// How many possible bodies are drawn.
    pub draws: usize,
    /// Of the draws.
    pub seed: u64,
    /// Which masses count in the headline numbers.
    pub basis: Basis,
}

impl Default for Questions {
    fn default() -> Self {
        Self { about: None, axes: None, draws: 10_000, seed: 1, basis: Basis::Predicted }
    }
}

/// What was read of a file, and what was taken as given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReadParts {
    /// Where it is.
    pub path: PathBuf,
    /// A sentence each.
    pub lines: Vec<String>,
}

impl BudgetFile {
    /// What was read and taken as given, line by line; `shown` writes a path.
    pub fn sources(&self, shown: &dyn Fn(&Path) -> String) -> Vec<String> {
        let of = |read: &ReadParts| -> Vec<String> {
            read.lines.iter().map(|line| format!("{}: {line}", shown(&read.path))).collect()
        };
        self.read.iter().flat_map(of).collect()
    }
}

/// Reads a parts list.
///
/// # Errors
/// [`FormatError`], with the place, if it, or a file that it names, cannot be read or makes no possible body.
pub fn read(path: &Path) -> Result<BudgetFile, FormatError> {
    from_text(path, &text_of(path)?)
}

/// Reads a parts list from its text, CSV; files that it names are relative to the path, which errors name.
///
/// # Errors
/// As [`read()`].
pub fn from_text(path: &Path, text: &str) -> Result<BudgetFile, FormatError> {
    let source = Source::new(path, text);
    let (plan, table) = plan::of_head(source)?;
    let sheet = csv::sheet(source, table)?;
    budget_of(plan, &sheet)
}

fn budget_of(plan: plan::Plan, sheet: &Sheet<'_>) -> Result<BudgetFile, FormatError> {
    let (rows, origins) = row::rows(sheet, &plan)?;
    let list = PartsList { rows, groups: plan.groups, growth: plan.growth };
    let budget = list.budget().map_err(|error| {
        let row = error.row().and_then(|row| origins.get(row)).copied();
        sheet.row_error(row, FormatErrorKind::Budget(error))
    })?;
    let read = ReadParts { path: sheet.path().to_owned(), lines: Vec::new() };
    Ok(BudgetFile {
        title: plan.title,
        configurations: vec![NamedBudget { name: None, budget }],
        questions: plan.questions,
        read: vec![read],
    })
}
