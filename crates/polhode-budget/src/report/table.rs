//! Rows of a budget as a table, for spreadsheets.

use std::io;

use polhode_document::csv_name;
use polhode_document::number::exact;

use super::BudgetReport;
use super::case::Case;
use super::numbers::ten;
use super::workbook::{Cell, Sheet};
use crate::{Basis, NUMBERS};

/// Headings of the columns.
const COLUMNS: [&str; 19] = [
    "configuration",
    "name",
    "parent",
    "quantity",
    "basic_mass_kg",
    "predicted_mass_kg",
    "allowable_mass_kg",
    "margin_kg",
    "basis",
    "mass_of_one_kg",
    "center_of_mass_x_m",
    "center_of_mass_y_m",
    "center_of_mass_z_m",
    "ixx_kg_m2",
    "iyy_kg_m2",
    "izz_kg_m2",
    "ixy_kg_m2",
    "ixz_kg_m2",
    "iyz_kg_m2",
];

impl BudgetReport {
    /// Writes CSV with a line for each row of each configuration. Masses count all copies. Mass
    /// properties are those of one copy with its descendants, along the axes of the body. The
    /// tensor is about the row's own centre of mass, with Ixy = −∫ x y dm.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write_csv(&self, out: &mut dyn io::Write) -> io::Result<()> {
        out.write_all(line(&headings(&COLUMNS)).as_bytes())?;
        self.each_row(&mut |row| out.write_all(line(&row).as_bytes()))
    }

    /// Returns the sheets of a workbook. They have the same rows, and the ten numbers of each
    /// configuration with their errors and covariance. If known, they also have the body over time
    /// and by tank fill.
    ///
    /// # Errors
    /// None for a report: all its rows were summed before.
    pub(crate) fn to_sheets(&self) -> io::Result<Vec<Sheet>> {
        let mut parts = vec![headings(&COLUMNS)];
        self.each_row(&mut |row| {
            parts.push(row);
            Ok(())
        })?;
        let mut whole = vec![headings(&["configuration", "basis", "number", "unit", "value", "sd"])];
        let mut names = vec!["configuration", "basis", "covariance of", "unit"];
        names.extend(NUMBERS.iter().map(|(name, _)| *name));
        let mut covariance = vec![headings(&names)];
        let mut numbers = |case: &Case, basis| {
            let estimate = case.estimate(basis);
            let values = ten(&estimate.properties);
            for (k, (name, unit)) in NUMBERS.iter().enumerate() {
                let row = [
                    Cell::of_option(case.name.as_deref()),
                    Cell::of(basis.name()),
                    Cell::of(name),
                    Cell::of(unit),
                ];
                whole.push([&row[..], &[values[k], estimate.sd(k)].map(Cell::Number)].concat());
                covariance.push([&row[..], &estimate.covariance[k].map(Cell::Number)].concat());
            }
        };
        for case in &self.cases {
            numbers(case, Basis::Basic);
            if case.grows() {
                numbers(case, Basis::Predicted);
            }
        }
        let sheet = |name, rows| Sheet { name, rows };
        let mut all = vec![sheet("parts", parts), sheet("whole", whole), sheet("covariance", covariance)];
        all.extend(self.over_time().map(|rows| sheet("over time", rows)));
        all.extend(self.by_fill().map(|rows| sheet("by fill", rows)));
        Ok(all)
    }

    fn each_row(&self, each: &mut dyn FnMut(Vec<Cell>) -> io::Result<()>) -> io::Result<()> {
        let basis = self.options.basis;
        for case in &self.cases {
            let subtrees = case.budget.subtrees(basis).map_err(io::Error::other)?;
            let rows = case.budget.rows();
            for (k, statement) in case.statements.iter().enumerate() {
                let number = |number: Option<f64>| number.map_or(Cell::Empty, Cell::Number);
                let parent = case.budget.parent(k).map(|parent| rows.name(parent));
                let mut cells = vec![
                    Cell::of_option(case.name.as_deref()),
                    Cell::of(rows.name(k)),
                    Cell::of_option(parent),
                    Cell::Number(f64::from(rows.quantity(k).count)),
                    Cell::Number(statement.basic),
                    Cell::Number(statement.predicted),
                    number(statement.allowable),
                    number(statement.margin()),
                    Cell::of(basis.name()),
                ];
                let numbers = subtrees.of(k).map_err(io::Error::other)?.as_ref().map(ten);
                cells.extend((0..10).map(|k| number(numbers.map(|numbers| numbers[k]))));
                each(cells)?;
            }
        }
        Ok(())
    }
}

fn headings(names: &[&str]) -> Vec<Cell> {
    names.iter().map(|name| Cell::of(name)).collect()
}

/// Returns CSV with a line for each row.
pub(crate) fn to_csv(rows: &[Vec<Cell>]) -> String {
    rows.iter().map(|row| line(row)).collect()
}

fn line(row: &[Cell]) -> String {
    row.iter().map(Cell::to_csv).collect::<Vec<_>>().join(",") + "\n"
}

impl Cell {
    pub(crate) fn of(text: &str) -> Self {
        Self::Text(text.to_owned())
    }

    pub(crate) fn of_option(text: Option<&str>) -> Self {
        text.map_or(Self::Empty, Self::of)
    }

    fn to_csv(&self) -> String {
        match self {
            Self::Empty => String::new(),
            Self::Text(text) => csv_name(text),
            Self::Number(number) => exact(*number),
        }
    }
}
