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
    } => ("{first} and {second} both stand in no other row: there can be one such row"),
        hint: "put one into the other, or both into a row that is the frame of all";
    /// The parents of rows form a cycle.
    Cycle {
        /// Rows of the cycle. Each is in the next, and the last is in the first.
        rows: Vec<RowName>,
    } => ("rows stand in each other: {}", way_around(rows)),
        hint: "one of them has to stand in another row, or in none";
    /// A row refers to a frame that is not a row.
    MissingFrame {
        /// Row that refers to the frame.
        row: RowName,
        /// Name of the missing frame.
        frame: String,
    } => ("{row} names the frame \"{frame}\", which is no row"),
        hint: "a frame is a row: add one with this name, without mass if it has none";
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
    } => ("{what} of {row} is {value}, and has to be {rule}"), hint: NUMBER;
    /// A standard deviation is negative or not finite.
    Deviation {
        row: RowName,
        /// Name of the quantity.
        what: &'static str,
        value: f64,
    } => ("the standard deviation of {what} of {row} is {value}, and has to be zero or positive, and finite"),
        hint: "write how far the number may be off, without a sign";
    /// A matrix is not a covariance: some combination of the numbers would have a negative
    /// variance.
    Covariance {
        row: RowName,
        /// Names of the quantities.
        what: &'static str,
        /// Row and column of the invalid element, from 1.
        element: [usize; 2],
    } => ("the covariance of {what} of {row} is none, by its element {}, {}", element[0], element[1]),
        hint: "a covariance is symmetric, and its correlations are such that they can all hold";
    /// A correlation or an allowance in a table is out of range.
    Table {
        /// Name of the group, or the maturity code.
        name: String,
        /// Name of the quantity.
        what: &'static str,
        value: f64,
        /// Condition that the value has to meet.
        rule: &'static str,
    } => ("{what} of \"{name}\" is {value}, and has to be {rule}"), hint: NUMBER;
    /// A maturity code is not in the table of growth allowances.
    MaturityCode {
        row: RowName,
        code: String,
    } => ("{row} has the maturity code \"{code}\", for which there is no growth allowance"),
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
    } => ("there are two groups \"{group}\""), hint: "give one of them another name";
    /// A part has the errors of a liquid, but not the mass properties of this mass of liquid in its
    /// tank.
    NotTheLiquid {
        row: RowName,
    } => ("{row} has the errors of a liquid, but is not what so much of it is in its tank"),
        hint: "make the row of the tank";
    /// Copies of a row with children have independent errors.
    IndependentAssembly {
        row: RowName,
        /// Child of that row.
        inside: RowName,
    } => ("copies of {row} are to have independent errors, but {inside} stands in it"),
        hint: "give each copy a row of its own, or say that the copies are alike";
    /// A row has more copies with independent errors than can be drawn one by one.
    Copies {
        row: RowName,
        /// Number of copies.
        given: u32,
        /// Largest allowed number of copies.
        most: u32,
    } => ("{given} copies of {row} are to have independent errors, where {most} at most can be drawn"),
        hint: "say that the copies are alike, or give their sum as one part with the error of the sum";
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
    } => ("{row} states {stated} kg, but its rows come to {sum} kg, which differs by more than {tolerance} kg"),
        hint: "look for a row that is missing, counted twice, or has another quantity or unit";
    /// The sum of all parts is not a body: a number overflows.
    Sum(error: BodyError) => ("the sum of all parts is no body: {error}"),
        hint: error.hint().unwrap_or(SIZES);
    /// A variance of the whole overflows.
    Variance {
        /// Name of the quantity.
        of: &'static str,
    } => ("the variance of {of} of the whole is no number"), hint: SIZES;
    /// The list has too many rows.
    Rows {
        /// Largest number of rows.
        most: u32,
    } => ("more than {most} rows"), hint: "give each assembly a list of its own";
    /// Too few draws are requested.
    Draws {
        /// Requested number of draws.
        given: usize,
        /// Least useful number of draws.
        needed: usize,
    } => ("{given} draws, where {needed} at least are needed"),
        hint: "ask for more: 10000 say what a standard deviation is to 1 %";
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

const SIZES: &str = "check the units and the exponents of masses, places and errors: a number has to be possible, and of a size that a double holds";
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
