//! Rows of members, column by column: what goes into a computation, and what comes out.

use std::fmt;

/// A table of columns of equal length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Batch {
    columns: Vec<Column>,
}

/// A column, its name, its unit in SI ("" for a number without one), and what it holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// The name, as `omega_body_x_rad_s`.
    pub name: String,
    /// The unit, as `rad/s`; empty if there is none.
    pub unit: String,
    /// What it is, for people.
    pub description: String,
    /// What it holds.
    pub values: Values,
}

/// What a column holds. What there is not (a period of a motion that has none) is `None`, never NaN.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// Whole numbers.
    Whole(Vec<u64>),
    /// Numbers, all there.
    Numbers(Vec<f64>),
    /// Numbers, where there are any.
    Perhaps(Vec<Option<f64>>),
    /// Text, where there is any.
    Text(Vec<Option<String>>),
}

/// Name of the column with the numbers of members.
pub(crate) const MEMBER: &str = "member";

/// Why columns are no table.
#[derive(Clone, Debug, PartialEq)]
pub enum BatchError {
    /// A column is longer or shorter than the first.
    Length {
        /// Its name.
        column: String,
        /// How many rows it has.
        rows: usize,
        /// How many the first has.
        expected: usize,
    },
    /// Two columns have the same name.
    Twice {
        /// The name.
        column: String,
    },
    /// A column is missing.
    Missing {
        /// Its name.
        column: String,
    },
    /// A column holds something else.
    Kind {
        /// Its name.
        column: String,
        /// What belongs there.
        expected: &'static str,
    },
}

impl Column {
    /// A column of this name, unit and description.
    pub(crate) fn new([name, unit, description]: [&str; 3], values: Values) -> Self {
        let [name, unit, description] = [name, unit, description].map(str::to_owned);
        Self { name, unit, description, values }
    }

    /// The column with the numbers of members.
    pub(crate) fn of_members(numbers: Vec<u64>) -> Self {
        Self::new([MEMBER, "", "the member's number, from 0"], Values::Whole(numbers))
    }
}

impl Batch {
    /// A table.
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

    /// The columns, in their order.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// How many rows there are.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }

    /// The column of a name.
    ///
    /// # Errors
    /// [`BatchError::Missing`]
    pub fn column(&self, name: &str) -> Result<&Column, BatchError> {
        let missing = || BatchError::Missing { column: name.to_owned() };
        self.columns.iter().find(|column| column.name == name).ok_or_else(missing)
    }
}

impl Values {
    /// How many there are.
    pub fn len(&self) -> usize {
        match self {
            Self::Whole(values) => values.len(),
            Self::Numbers(values) => values.len(),
            Self::Perhaps(values) => values.len(),
            Self::Text(values) => values.len(),
        }
    }

    /// The number of a row, if there is one.
    pub(crate) fn number(&self, row: usize) -> Option<f64> {
        match self {
            Self::Numbers(values) => values.get(row).copied(),
            Self::Perhaps(values) => values.get(row).copied().flatten(),
            Self::Whole(_) | Self::Text(_) => None,
        }
    }

    /// True if there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl fmt::Display for BatchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { column, rows, expected } => {
                write!(f, "column {column} has {rows} rows where the first has {expected}")
            }
            Self::Twice { column } => write!(f, "there are two columns {column}"),
            Self::Missing { column } => write!(f, "there is no column {column}"),
            Self::Kind { column, expected } => write!(f, "column {column} should hold {expected}"),
        }
    }
}

impl std::error::Error for BatchError {}
