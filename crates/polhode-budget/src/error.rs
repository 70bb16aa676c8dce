//! What can be wrong with a parts list.

use core::fmt;

use polhode::body::BodyError;

use crate::errors::errors;

/// A row of a parts list, as an error names it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RowName {
    /// Its place in [`PartsList::rows`](crate::PartsList::rows), from 0.
    pub row: usize,
    /// Its name.
    pub name: String,
}

impl fmt::Display for RowName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\"{}\"", self.name)
    }
}

errors! {
    /// Error of a parts list that makes no possible body.
    BudgetError;

    /// No row has a mass.
    Empty => ("no row has a mass"), hint: "give a part a mass";
    /// A row without a name.
    Nameless {
        /// Its place in the list, from 0.
        row: usize,
    } => ("row {} has no name", row + 1), hint: "give it a name";
    /// Two rows of one name.
    Duplicate {
        /// The first.
        first: RowName,
        /// The other's place in the list, from 0.
        row: usize,
    } => ("rows {} and {} have the same name, {first}", first.row + 1, row + 1),
        hint: "give one of them another name, or count copies by the quantity";
    /// Two rows that stand in no other.
    TwoRoots {
        /// The first.
        first: RowName,
        /// The other.
        second: RowName,
    } => ("{first} and {second} both stand in no other row: there can be one such row"),
        hint: "put one into the other, or both into a row that is the frame of all";
    /// Rows that stand in each other, so in nothing.
    Cycle {
        /// Each stands in the next, and the last in the first.
        rows: Vec<RowName>,
    } => ("rows stand in each other: {}", way_around(rows)),
        hint: "one of them has to stand in another row, or in none";
    /// A frame that a row names, and that is no row.
    MissingFrame {
        /// The row that names it.
        row: RowName,
        /// What it names.
        frame: String,
    } => ("{row} names the frame \"{frame}\", which is no row"),
        hint: "a frame is a row: add one with this name, without mass if it has none";
    /// A part that cannot exist.
    Part {
        /// Its row.
        row: RowName,
        /// Why not.
        error: BodyError,
    } => ("{row} cannot exist: {error}"), hint: error.hint().unwrap_or(SIZES);
    /// A number that cannot be.
    Value {
        /// Its row.
        row: RowName,
        /// What it is.
        what: &'static str,
        /// As it was given.
        value: f64,
        /// What it has to be.
        rule: &'static str,
    } => ("{what} of {row} is {value}, and has to be {rule}"), hint: NUMBER;
    /// A standard deviation that is negative or not finite.
    Deviation {
        /// Its row.
        row: RowName,
        /// Of what it is.
        what: &'static str,
        /// As it was given.
        value: f64,
    } => ("the standard deviation of {what} of {row} is {value}, and has to be zero or positive, and finite"),
        hint: "write how far the number may be off, without a sign";
    /// A matrix that is no covariance: some combination of the numbers would have a negative variance.
    Covariance {
        /// Its row.
        row: RowName,
        /// Of what it is.
        what: &'static str,
        /// The row and column, from 1, of the element that cannot be.
        element: [usize; 2],
    } => ("the covariance of {what} of {row} is none, by its element {}, {}", element[0], element[1]),
        hint: "a covariance is symmetric, and its correlations are such that they can all hold";
    /// A correlation or an allowance of a table that cannot be.
    Table {
        /// The group or the maturity code.
        name: String,
        /// What it is.
        what: &'static str,
        /// As it was given.
        value: f64,
        /// What it has to be.
        rule: &'static str,
    } => ("{what} of \"{name}\" is {value}, and has to be {rule}"), hint: NUMBER;
    /// A maturity code that the table of growth allowances does not have.
    MaturityCode {
        /// The row.
        row: RowName,
        /// The code.
        code: String,
    } => ("{row} has the maturity code \"{code}\", for which there is no growth allowance"),
        hint: "add the code to the table of growth allowances";
    /// A group that the list does not have.
    MissingGroup {
        /// The row.
        row: RowName,
        /// The group.
        group: String,
    } => ("{row} is in the group \"{group}\", which is not declared"),
        hint: "declare the group, or leave it out";
    /// Two groups of one name.
    DuplicateGroup {
        /// The name.
        group: String,
    } => ("there are two groups \"{group}\""), hint: "give one of them another name";
    /// A part with the errors of a liquid, which is not so much of that in its tank.
    NotTheLiquid {
        /// The row.
        row: RowName,
    } => ("{row} has the errors of a liquid, but is not what so much of it is in its tank"),
        hint: "make the row of the tank";
    /// Copies whose errors are independent, of a row in which other rows stand.
    IndependentAssembly {
        /// The row.
        row: RowName,
        /// A row in it.
        inside: RowName,
    } => ("copies of {row} are to have independent errors, but {inside} stands in it"),
        hint: "give each copy a row of its own, or say that the copies are alike";
    /// More copies of independent errors than can be drawn one by one.
    Copies {
        /// The row.
        row: RowName,
        /// How many.
        given: u32,
        /// The most.
        most: u32,
    } => ("{given} copies of {row} are to have independent errors, where {most} at most can be drawn"),
        hint: "say that the copies are alike, or give their sum as one part with the error of the sum";
    /// A stated subtotal that is not the sum of its rows.
    Subtotal {
        /// The row that states it.
        row: RowName,
        /// As stated, kg.
        stated: f64,
        /// What its rows come to, kg.
        sum: f64,
        /// By how much they may differ, kg.
        tolerance: f64,
    } => ("{row} states {stated} kg, but its rows come to {sum} kg, which differs by more than {tolerance} kg"),
        hint: "look for a row that is missing, counted twice, or has another quantity or unit";
    /// The sum is no body: it overflows.
    Sum(error: BodyError) => ("the sum of all parts is no body: {error}"),
        hint: error.hint().unwrap_or(SIZES);
    /// A variance of the whole that no double holds.
    Variance {
        /// Of which number of the whole.
        of: &'static str,
    } => ("the variance of {of} of the whole is no number"), hint: SIZES;
    /// More rows than a list can have.
    Rows {
        /// Largest number of rows.
        most: u32,
    } => ("more than {most} rows"), hint: "give each assembly a list of its own";
    /// Fewer draws than it takes.
    Draws {
        /// How many were asked for.
        given: usize,
        /// The least that is of use.
        needed: usize,
    } => ("{given} draws, where {needed} at least are needed"),
        hint: "ask for more: 10000 say what a standard deviation is to 1 %";
    /// More draws than the number of uncertain rows allows.
    TooManyDraws {
        /// Requested draws.
        given: usize,
        /// The rows that vary.
        rows: usize,
        /// The largest number of draws.
        most: usize,
    } => ("{given} draws of {rows} uncertain rows are too many: at most {most}"),
        hint: "request fewer draws: 10000 determine a standard deviation to 1 %";
}

const SIZES: &str = "check the units and the exponents of masses, places and errors: a number has to be possible, and of a size that a double holds";
const NUMBER: &str = "check its sign, its unit and its exponent";

/// Each row in the next, and the last in the first.
fn way_around(rows: &[RowName]) -> String {
    rows.iter().chain(rows.first()).map(RowName::to_string).collect::<Vec<_>>().join(" in ")
}

impl BudgetError {
    /// The row that it is about, by its place in [`PartsList::rows`](crate::PartsList::rows); of several, the last.
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
