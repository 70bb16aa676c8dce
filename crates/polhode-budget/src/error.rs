//! Errors of a parts list.

use core::fmt;

use polhode::body::BodyError;

use crate::errors::errors;

/// Row of a parts list, as named in an error.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RowName {
    /// Index in [`PartsList::rows`](crate::PartsList::rows), from 0.
    pub row: usize,
    pub name: String,
}

impl fmt::Display for RowName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\"{}\"", self.name)
    }
}

errors! {
    /// Error of a parts list that does not make a physically possible body.
    BudgetError;

    /// No row has a mass.
    Empty => ("no row has a mass"), hint: "give a part a mass";
    /// A row has no name.
    Nameless {
        /// Index of the row in the list, from 0.
        row: usize,
    } => ("row {} has no name", row + 1), hint: "give it a name";
    /// Two rows have the same name.
    Duplicate {
        /// First row with the name.
        first: RowName,
        /// Index of the second row in the list, from 0.
        row: usize,
    } => ("rows {} and {} have the same name, {first}", first.row + 1, row + 1),
        hint: "give one of them another name, or count copies by the quantity";
    /// Two rows have no parent.
    TwoRoots {
        first: RowName,
        second: RowName,
    } => ("{first} and {second} both have no parent: only one row can be the root"),
        hint: "make one the parent of the other, or give both the same parent";
    /// The parents of rows form a cycle.
    Cycle {
        /// Rows of the cycle. Each is in the next, and the last is in the first.
        rows: Vec<RowName>,
    } => ("parents form a cycle: {}", way_around(rows)),
        hint: "give one of them another parent, or none";
    /// A row refers to a frame that is not a row.
    MissingFrame {
        /// Row that refers to the frame.
        row: RowName,
        /// Name of the missing frame.
        frame: String,
    } => ("{row} refers to the frame \"{frame}\", which is not a row"),
        hint: "add a row with this name; a frame needs no mass";
    /// A part is not physically possible.
    Part {
        row: RowName,
        /// Condition that the part violates.
        error: BodyError,
    } => ("{row} cannot exist: {error}"), hint: error.hint().unwrap_or(SIZES);
    /// A number is out of range.
    Value {
        row: RowName,
        /// Name of the quantity.
        what: &'static str,
        value: f64,
        /// Condition that the value has to meet.
        rule: &'static str,
    } => ("{what} of {row} is {value}, but must be {rule}"), hint: NUMBER;
    /// A standard deviation is negative or not finite.
    Deviation {
        row: RowName,
        /// Name of the quantity.
        what: &'static str,
        value: f64,
    } => ("the standard deviation of {what} of {row} is {value}, but must be zero or positive, and finite"),
        hint: "write the standard deviation without a sign";
    /// A matrix is not a covariance: some combination of the numbers would have a negative
    /// variance.
    Covariance {
        row: RowName,
        /// Names of the quantities.
        what: &'static str,
        /// Row and column of the invalid element, from 1.
        element: [usize; 2],
    } => ("the covariance of {what} of {row} is not a covariance matrix: check element {}, {}", element[0], element[1]),
        hint: "a covariance matrix is symmetric and positive semidefinite";
    /// A correlation or an allowance in a table is out of range.
    Table {
        /// Name of the group, or the maturity code.
        name: String,
        /// Name of the quantity.
        what: &'static str,
        value: f64,
        /// Condition that the value has to meet.
        rule: &'static str,
    } => ("{what} of \"{name}\" is {value}, but must be {rule}"), hint: NUMBER;
    /// A maturity code is not in the table of growth allowances.
    MaturityCode {
        row: RowName,
        code: String,
    } => ("{row} has the maturity code \"{code}\", which has no growth allowance"),
        hint: "add the code to the table of growth allowances";
    /// A row refers to a group that is not declared.
    MissingGroup {
        row: RowName,
        group: String,
    } => ("{row} is in the group \"{group}\", which is not declared"),
        hint: "declare the group, or leave it out";
    /// Two groups have the same name.
    DuplicateGroup {
        group: String,
    } => ("duplicate group \"{group}\""), hint: "give one of them another name";
    /// A part has the errors of a liquid, but not the mass properties of this mass of liquid in its
    /// tank.
    NotTheLiquid {
        row: RowName,
    } => ("{row} has the errors of a liquid, but is not the contents of a tank"),
        hint: "create the row from the tank";
    /// Copies of a row with children have independent errors.
    IndependentAssembly {
        row: RowName,
        /// Child of that row.
        inside: RowName,
    } => ("copies of {row} have independent errors, but {inside} is inside it"),
        hint: "give each copy its own row, or set copies to alike";
    /// A row has more copies with independent errors than can be drawn one by one.
    Copies {
        row: RowName,
        /// Number of copies.
        given: u32,
        /// Largest allowed number of copies.
        most: u32,
    } => ("{given} copies of {row} have independent errors, but at most {most} can be drawn"),
        hint: "set copies to alike, or enter their sum as one part with the error of the sum";
    /// A stated subtotal differs from the sum of its rows.
    Subtotal {
        /// Row that states the subtotal.
        row: RowName,
        /// Stated mass, kg.
        stated: f64,
        /// Sum of the rows, kg.
        sum: f64,
        /// Largest allowed difference, kg.
        tolerance: f64,
    } => ("{row} states {stated} kg, but its rows add up to {sum} kg, which differs by more than {tolerance} kg"),
        hint: "check for a missing row, a row counted twice, or a wrong quantity or unit";
    /// The sum of all parts is not a body: a number overflows.
    Sum(error: BodyError) => ("the sum of all parts is not a physical body: {error}"),
        hint: error.hint().unwrap_or(SIZES);
    /// A variance of the whole overflows.
    Variance {
        /// Name of the quantity.
        of: &'static str,
    } => ("the variance of {of} of the total overflows"), hint: SIZES;
    /// The list has too many rows.
    Rows {
        /// Largest number of rows.
        most: u32,
    } => ("more than {most} rows"), hint: "write a separate list for each assembly";
    /// Too few draws are requested.
    Draws {
        /// Requested number of draws.
        given: usize,
        /// Least useful number of draws.
        needed: usize,
    } => ("{given} draws, but at least {needed} are needed"),
        hint: "request more: 10000 draws determine a standard deviation to 1 %";
    /// More draws are requested than the number of uncertain rows allows.
    TooManyDraws {
        /// Requested number of draws.
        given: usize,
        /// Number of uncertain rows.
        rows: usize,
        /// Largest allowed number of draws.
        most: usize,
    } => ("{given} draws of {rows} uncertain rows are too many: at most {most}"),
        hint: "request fewer draws: 10000 determine a standard deviation to 1 %";
}

const SIZES: &str = "check the units and exponents of masses, positions and errors: values must be physical and within the range of double precision";
const NUMBER: &str = "check its sign, its unit and its exponent";

/// Formats a cycle: each row is in the next, and the last is in the first.
fn way_around(rows: &[RowName]) -> String {
    rows.iter().chain(rows.first()).map(RowName::to_string).collect::<Vec<_>>().join(" in ")
}

impl BudgetError {
    /// Returns the index in [`PartsList::rows`](crate::PartsList::rows) of the row that the error
    /// is about. If it is about several rows, returns the last one.
    pub fn row(&self) -> Option<usize> {
        match self {
            Self::Nameless { row } | Self::Duplicate { row, .. } => Some(*row),
            Self::TwoRoots { second: row, .. }
            | Self::MissingFrame { row, .. }
            | Self::Part { row, .. }
            | Self::Value { row, .. }
            | Self::Deviation { row, .. }
            | Self::Covariance { row, .. }
            | Self::MaturityCode { row, .. }
            | Self::MissingGroup { row, .. }
            | Self::NotTheLiquid { row }
            | Self::IndependentAssembly { row, .. }
            | Self::Copies { row, .. }
            | Self::Subtotal { row, .. } => Some(row.row),
            Self::Cycle { rows } => rows.last().map(|row| row.row),
            Self::Empty
            | Self::Table { .. }
            | Self::DuplicateGroup { .. }
            | Self::Sum(_)
            | Self::Variance { .. }
            | Self::Rows { .. }
            | Self::Draws { .. }
            | Self::TooManyDraws { .. } => None,
        }
    }
}
