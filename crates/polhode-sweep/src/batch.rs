//! Tables of members in columns: inputs and outcomes of a computation.

use std::fmt;

/// Table of columns of equal length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Batch {
    columns: Vec<Column>,
}

/// Column of a table: name, SI unit, description and values.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name, such as `omega_body_x_rad_s`.
    pub name: String,
    /// SI unit, such as `rad/s`; empty for a dimensionless number.
    pub unit: String,
    /// Description for people.
    pub description: String,
    /// Values, one per row.
    pub values: Values,
}

/// Values of a column. A missing value, such as the period of a motion without one, is `None`,
/// never NaN.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Integers, without missing values.
    Whole(Vec<u64>),
    /// Numbers, without missing values.
    Numbers(Vec<f64>),
    /// Numbers, with `None` for missing values.
    Perhaps(Vec<Option<f64>>),
    /// Text, with `None` for missing values.
    Text(Vec<Option<String>>),
}

/// Name of the column with member numbers.
pub(crate) const MEMBER: &str = "member";

/// Reason why columns do not form a table.
#[derive(Clone, Debug, PartialEq)]
pub enum BatchError {
    /// Column whose length differs from that of the first.
    Length {
        /// Name of the column.
        column: String,
        /// Number of rows in the column.
        rows: usize,
        /// Number of rows in the first column.
        expected: usize,
    },
    /// Name that two columns share.
    Twice {
        /// Duplicate name.
        column: String,
    },
    /// Column that is absent.
    Missing {
        /// Name of the column.
        column: String,
    },
    /// Column with values of the wrong kind.
    Kind {
        /// Name of the column.
        column: String,
        /// Description of the right kind.
        expected: &'static str,
    },
}

impl Column {
    /// Creates a column from name, unit, description and values.
    pub(crate) fn new([name, unit, description]: [&str; 3], values: Values) -> Self {
        let [name, unit, description] = [name, unit, description].map(str::to_owned);
        Self { name, unit, description, values }
    }

    /// Creates the column of member numbers.
    pub(crate) fn of_members(numbers: Vec<u64>) -> Self {
        Self::new([MEMBER, "", "number of the member, from 0"], Values::Whole(numbers))
    }
}

impl Batch {
    /// Creates a table.
    ///
    /// # Errors
    /// [`BatchError`] if columns differ in length, or two have the same name.
    pub fn new(columns: Vec<Column>) -> Result<Self, BatchError> {
        let expected = columns.first().map_or(0, |column| column.values.len());
        for (k, column) in columns.iter().enumerate() {
            let rows = column.values.len();
            if rows != expected {
                return Err(BatchError::Length { column: column.name.clone(), rows, expected });
            }
            if columns.iter().take(k).any(|other| other.name == column.name) {
                return Err(BatchError::Twice { column: column.name.clone() });
            }
        }
        Ok(Self { columns })
    }

    /// Returns the columns in order.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// Returns the number of rows, 0 without columns.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }

    /// Returns the column with a name.
    ///
    /// # Errors
    /// [`BatchError::Missing`] if there is none.
    pub fn column(&self, name: &str) -> Result<&Column, BatchError> {
        let missing = || BatchError::Missing { column: name.to_owned() };
        self.columns.iter().find(|column| column.name == name).ok_or_else(missing)
    }
}

impl Values {
    /// Returns the number of values, including missing ones.
    pub fn len(&self) -> usize {
        match self {
            Self::Whole(values) => values.len(),
            Self::Numbers(values) => values.len(),
            Self::Perhaps(values) => values.len(),
            Self::Text(values) => values.len(),
        }
    }

    /// Returns the number in a row; `None` for a missing value and for other kinds.
    pub(crate) fn number(&self, row: usize) -> Option<f64> {
        match self {
            Self::Numbers(values) => values.get(row).copied(),
            Self::Perhaps(values) => values.get(row).copied().flatten(),
            Self::Whole(_) | Self::Text(_) => None,
        }
    }

    /// Returns true if there are no rows.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl fmt::Display for BatchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { column, rows, expected } => {
                write!(f, "column {column} has {rows} rows, but the first column has {expected}")
            }
            Self::Twice { column } => write!(f, "duplicate column {column}"),
            Self::Missing { column } => write!(f, "missing column {column}"),
            Self::Kind { column, expected } => write!(f, "column {column} must contain {expected}"),
        }
    }
}

impl std::error::Error for BatchError {}
