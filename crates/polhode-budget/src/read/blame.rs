//! Positions in a table of errors of its parts list.

use polhode::body::BodyError;
use polhode_source::nearest;
use polhode_source::{FormatError, FormatErrorKind};

use super::cell::Cell;
use super::cells::Cells;
use super::key::{
    ABOUT, CAD, COPIES, FILE, GROUP, IXX, IXY, IXZ, IYY, IYZ, IZZ, MASS, MATURITY, MESH, NAME, PARENT, PATH,
    QUANTITY, SCENARIO, SHAPE, SUBTOTAL, X, Y, Z,
};
use super::plan::Plan;
use super::rows::Rows;
use crate::BudgetError;

/// Table from which a list was read.
pub(crate) struct Blame<'r, 's, 'a> {
    pub reader: &'r Rows<'s, 'a>,
    pub plan: &'r Plan,
    /// Index in the table of each row of the list.
    pub origins: &'r [u32],
    pub configuration: Option<&'r str>,
    /// Names of rows, for suggestions.
    pub names: Vec<String>,
}

const FORM: [usize; 6] = [SHAPE, MESH, CAD, SCENARIO, FILE, MASS];
const TENSOR: [usize; 12] = [IXX, IYY, IZZ, IXY, IXZ, IYZ, SHAPE, MESH, CAD, SCENARIO, FILE, MASS];

impl<'a> Blame<'_, '_, 'a> {
    /// Returns the error at the cell that causes it.
    pub(crate) fn of(&self, error: &BudgetError) -> FormatError {
        let keys: &[usize] = match error {
            BudgetError::MissingFrame { frame, row } => {
                let is_about = self.cell(row.row, &[ABOUT]).is_some_and(|cell| cell.text == *frame);
                if is_about { &[ABOUT] } else { &[PARENT, NAME, PATH, ABOUT] }
            }
            BudgetError::Cycle { .. } | BudgetError::TwoRoots { .. } => &[PARENT, NAME, PATH],
            BudgetError::Part { error, .. } => part_keys(error),
            BudgetError::MaturityCode { .. } => &[MATURITY],
            BudgetError::MissingGroup { .. } => &[GROUP],
            BudgetError::IndependentAssembly { .. } => &[COPIES, QUANTITY],
            BudgetError::Copies { .. } => &[QUANTITY],
            BudgetError::Subtotal { .. } => &[SUBTOTAL],
            _ => &[NAME, PATH],
        };
        let near = self.near(error);
        let cell = error.row().and_then(|row| self.cell(row, keys).or_else(|| self.cell(row, &[NAME, PATH])));
        let hint = error.hint();
        let kind = FormatErrorKind::subject(error, error.hint());
        let sheet = self.reader.reader.sheet;
        let error = match cell {
            Some(cell) => sheet.error(&cell, kind),
            None => FormatError::new(sheet.path(), None, kind),
        };
        let suggestion = near.map(|near| format!("did you mean \"{near}\"?"));
        let within = self.configuration.map(|name| format!("this is in the configuration \"{name}\""));
        let rest: Vec<String> = hint.map(str::to_owned).into_iter().chain(within).collect();
        let rest = Some(rest.join("; ")).filter(|rest| !rest.is_empty());
        let hints: Vec<String> = suggestion.into_iter().chain(rest).collect();
        if hints.is_empty() { error } else { error.with_hint(hints.join(" ")) }
    }

    /// Returns the first cell with one of these keys in a row of the list.
    pub(crate) fn cell(&self, row: usize, keys: &[usize]) -> Option<Cell<'a>> {
        let reader = &self.reader.reader;
        let row = reader.sheet.rows.get(*self.origins.get(row)? as usize)?;
        let cells = reader.sheet.row(row);
        let cells = Cells::of(reader.sheet, reader.columns, &cells).ok()??;
        keys.iter().find_map(|key| cells.cell(*key)).cloned()
    }

    /// Returns the name that was probably meant.
    fn near(&self, error: &BudgetError) -> Option<String> {
        let near = |word: &str, all: &mut dyn Iterator<Item = &str>| nearest(word, all).map(str::to_owned);
        match error {
            BudgetError::MaturityCode { code, .. } => {
                near(code, &mut self.plan.growth.codes().map(|(code, _)| code))
            }
            BudgetError::MissingGroup { group, .. } => {
                near(group, &mut self.plan.groups.iter().map(|group| group.name.as_str()))
            }
            BudgetError::MissingFrame { frame, .. } => {
                near(frame, &mut self.names.iter().map(String::as_str))
            }
            _ => None,
        }
    }
}

/// Returns the columns that can cause an error of a body.
fn part_keys(error: &BodyError) -> &'static [usize] {
    match error {
        BodyError::Parameter { what, .. } if what.contains("mass") => &FORM,
        BodyError::Parameter { what, .. } if what.contains("centre") => &[X, Y, Z],
        _ => &TENSOR,
    }
}
