//! What can be wrong with a parts list.

use core::fmt;

use polhode::body::BodyError;

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

/// Why a parts list is no budget.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum BudgetError {
    /// No row has a mass.
    Empty,
    /// A row without a name.
    Nameless {
        /// Its place in the list, from 0.
        row: usize,
    },
    /// Two rows of one name.
    Duplicate {
        /// The first.
        first: RowName,
        /// The other's place in the list, from 0.
        row: usize,
    },
    /// Two rows that stand in no other.
    TwoRoots {
        /// The first.
        first: RowName,
        /// The other.
        second: RowName,
    },
    /// Rows that stand in each other, so in nothing.
    Cycle {
        /// Each stands in the next, and the last in the first.
        rows: Vec<RowName>,
    },
    /// A frame that a row names, and that is no row.
    MissingFrame {
        /// The row that names it.
        row: RowName,
        /// What it names.
        frame: String,
    },
    /// A part that cannot exist.
    Part {
        /// Its row.
        row: RowName,
        /// Why not.
        error: BodyError,
    },
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
    },
    /// A standard deviation that is negative or not finite.
    Deviation {
        /// Its row.
        row: RowName,
        /// Of what it is.
        what: &'static str,
        /// As it was given.
        value: f64,
    },
    /// A matrix that is no covariance: some combination of the numbers would have a negative variance.
    Covariance {
        /// Its row.
        row: RowName,
        /// Of what it is.
        what: &'static str,
        /// The row and column, from 1, of the element that cannot be.
        element: [usize; 2],
    },
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
    },
    /// A maturity code that the table of growth allowances does not have.
    MaturityCode {
        /// The row.
        row: RowName,
        /// The code.
        code: String,
    },
    /// A group that the list does not have.
    MissingGroup {
        /// The row.
        row: RowName,
        /// The group.
        group: String,
    },
    /// Two groups of one name.
    DuplicateGroup {
        /// The name.
        group: String,
    },
    /// A part with the errors of a liquid, which is not so much of that in its tank.
    NotTheLiquid {
        /// The row.
        row: RowName,
    },
    /// Copies whose errors are independent, of a row in which other rows stand.
    IndependentAssembly {
        /// The row.
        row: RowName,
        /// A row in it.
        inside: RowName,
    },
    /// More copies of independent errors than can be drawn one by one.
    Copies {
        /// The row.
        row: RowName,
        /// How many.
        given: u32,
        /// The most.
        most: u32,
    },
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
    },
    /// The sum is no body: it overflows.
    Sum(BodyError),
    /// A variance of the whole that no double holds.
    Variance {
        /// Of which number of the whole.
        of: &'static str,
    },
    /// More rows than a list can have.
    Rows {
        /// Largest number of rows.
        most: u32,
    },
    /// Fewer draws than it takes.
    Draws {
        /// How many were asked for.
        given: usize,
        /// The least that is of use.
        needed: usize,
    },
    /// More draws than the number of uncertain rows allows.
    TooManyDraws {
        /// Requested draws.
        given: usize,
        /// The rows that vary.
        rows: usize,
        /// The largest number of draws.
        most: usize,
    },
}

const SIZES: &str = "check the units and the exponents of masses, places and errors: a number has to be possible, and of a size that a double holds";

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

    /// What its reader may do.
    pub fn hint(&self) -> Option<&'static str> {
        match self {
            Self::TwoRoots { .. } => {
                Some("put one into the other, or both into a row that is the frame of all")
            }
            Self::MissingFrame { .. } => {
                Some("a frame is a row: add one with this name, without mass if it has none")
            }
            Self::Part { error, .. } | Self::Sum(error) => Some(error.hint().unwrap_or(SIZES)),
            Self::Variance { .. } => Some(SIZES),
            Self::Covariance { .. } => {
                Some("a covariance is symmetric, and its correlations are such that they can all hold")
            }
            Self::MaturityCode { .. } => Some("add the code to the table of growth allowances"),
            Self::NotTheLiquid { .. } => Some("make the row of the tank"),
            Self::IndependentAssembly { .. } => {
                Some("give each copy a row of its own, or say that the copies are alike")
            }
            Self::Subtotal { .. } => {
                Some("look for a row that is missing, counted twice, or has another quantity or unit")
            }
            Self::Copies { .. } => {
                Some("say that the copies are alike, or give their sum as one part with the error of the sum")
            }
            Self::Empty => Some("give a part a mass"),
            Self::Nameless { .. } => Some("give it a name"),
            Self::Duplicate { .. } => Some("give one of them another name, or count copies by the quantity"),
            Self::Cycle { .. } => Some("one of them has to stand in another row, or in none"),
            Self::Value { .. } | Self::Table { .. } => Some("check its sign, its unit and its exponent"),
            Self::Deviation { .. } => Some("write how far the number may be off, without a sign"),
            Self::MissingGroup { .. } => Some("declare the group, or leave it out"),
            Self::DuplicateGroup { .. } => Some("give one of them another name"),
            Self::Rows { .. } => Some("give each assembly a list of its own"),
            Self::TooManyDraws { .. } => {
                Some("request fewer draws: 10000 determine a standard deviation to 1 %")
            }
            Self::Draws { .. } => Some("ask for more: 10000 say what a standard deviation is to 1 %"),
        }
    }
}

impl fmt::Display for BudgetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "no row has a mass"),
            Self::Nameless { row } => write!(f, "row {} has no name", row + 1),
            Self::Duplicate { first, row } => {
                write!(f, "rows {} and {} have the same name, {first}", first.row + 1, row + 1)
            }
            Self::TwoRoots { first, second } => {
                write!(f, "{first} and {second} both stand in no other row: there can be one such row")
            }
            Self::Cycle { rows } => {
                f.write_str("rows stand in each other: ")?;
                for row in rows {
                    write!(f, "{row} in ")?;
                }
                rows.first().map_or(Ok(()), |row| row.fmt(f))
            }
            Self::MissingFrame { row, frame } => {
                write!(f, "{row} names the frame \"{frame}\", which is no row")
            }
            Self::Part { row, error } => write!(f, "{row} cannot exist: {error}"),
            Self::Value { row, what, value, rule } => {
                write!(f, "{what} of {row} is {value}, and has to be {rule}")
            }
            Self::Deviation { row, what, value } => write!(
                f,
                "the standard deviation of {what} of {row} is {value}, and has to be zero or positive, and finite"
            ),
            Self::DuplicateGroup { group } => write!(f, "there are two groups \"{group}\""),
            Self::Covariance { row, what, element: [i, j] } => {
                write!(f, "the covariance of {what} of {row} is none, by its element {i}, {j}")
            }
            Self::Table { name, what, value, rule } => {
                write!(f, "{what} of \"{name}\" is {value}, and has to be {rule}")
            }
            Self::MaturityCode { row, code } => {
                write!(f, "{row} has the maturity code \"{code}\", for which there is no growth allowance")
            }
            Self::MissingGroup { row, group } => {
                write!(f, "{row} is in the group \"{group}\", which is not declared")
            }
            Self::NotTheLiquid { row } => {
                write!(f, "{row} has the errors of a liquid, but is not what so much of it is in its tank")
            }
            Self::IndependentAssembly { row, inside } => {
                write!(f, "copies of {row} are to have independent errors, but {inside} stands in it")
            }
            Self::Copies { row, given, most } => write!(
                f,
                "{given} copies of {row} are to have independent errors, where {most} at most can be drawn"
            ),
            Self::Subtotal { row, stated, sum, tolerance } => write!(
                f,
                "{row} states {stated} kg, but its rows come to {sum} kg, which differs by more than {tolerance} kg"
            ),
            Self::Sum(error) => write!(f, "the sum of all parts is no body: {error}"),
            Self::Variance { of } => write!(f, "the variance of {of} of the whole is no number"),
            Self::Rows { most } => write!(f, "more than {most} rows"),
            Self::Draws { given, needed } => write!(f, "{given} draws, where {needed} at least are needed"),
            Self::TooManyDraws { given, rows, most } => {
                write!(f, "{given} draws of {rows} uncertain rows are too many: at most {most}")
            }
        }
    }
}

impl std::error::Error for BudgetError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Part { error, .. } | Self::Sum(error) => Some(error),
            _ => None,
        }
    }
}
