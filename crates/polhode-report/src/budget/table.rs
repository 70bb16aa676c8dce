//! The rows of a budget as a table, for spreadsheets.

use polhode_budget::{Basis, BudgetError};

use super::BudgetReport;
use super::case::ten;

/// What stands in a cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// Nothing.
    Empty,
    /// Words.
    Text(String),
    /// A number.
    Number(f64),
}

/// What stands above the columns.
pub const COLUMNS: [&str; 19] = [
    "configuration",
    "part",
    "in",
    "quantity",
    "basic mass [kg]",
    "predicted mass [kg]",
    "allowable mass [kg]",
    "margin [kg]",
    "mass of one [kg]",
    "x [m]",
    "y [m]",
    "z [m]",
    "Ixx [kg·m²]",
    "Iyy [kg·m²]",
    "Izz [kg·m²]",
    "Ixy [kg·m²]",
    "Ixz [kg·m²]",
    "Iyz [kg·m²]",
    "masses",
];

impl BudgetReport {
    /// A row for each row of each configuration: its masses, all copies counted, and the mass properties of one copy with all in it, along the axes of the body, the
    /// tensor about its own centre of mass with Ixy = −∫ x y dm.
    ///
    /// # Errors
    /// As [`polhode_budget::Budget::subtrees`].
    pub fn rows(&self) -> Result<Vec<[Cell; 19]>, BudgetError> {
        let basis = self.options.basis;
        let mut all = Vec::new();
        for case in &self.cases {
            let subtrees = case.budget.subtrees(basis)?;
            let rows = &case.budget.list().rows;
            for (k, row) in rows.iter().enumerate() {
                let text = |text: Option<&str>| text.map_or(Cell::Empty, |text| Cell::Text(text.to_owned()));
                let number = |number: Option<f64>| number.map_or(Cell::Empty, Cell::Number);
                let statement = &case.statements[k];
                let parent = case.budget.parents()[k].map(|parent| rows[parent].name.as_str());
                let numbers = subtrees[k].as_ref().map(ten);
                let [mass, x, y, z, xx, yy, zz, xy, xz, yz] =
                    core::array::from_fn(|k| number(numbers.map(|numbers| numbers[k])));
                let words = match basis {
                    Basis::Basic => "basic",
                    Basis::Predicted => "predicted",
                };
                all.push([
                    text(case.name.as_deref()),
                    text(Some(&row.name)),
                    text(parent),
                    Cell::Number(f64::from(row.quantity.count)),
                    Cell::Number(statement.basic),
                    Cell::Number(statement.predicted),
                    number(statement.allowable),
                    number(statement.margin()),
                    mass,
                    x,
                    y,
                    z,
                    xx,
                    yy,
                    zz,
                    xy,
                    xz,
                    yz,
                    text(Some(words)),
                ]);
            }
        }
        Ok(all)
    }
}
