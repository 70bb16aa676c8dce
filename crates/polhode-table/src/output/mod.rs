//! Tables of numbers: one row for each sample or point, one column for each number.
//!
//! Each kind of table defines its columns in a separate file, and each format writes any table.
//! Units are SI. The name of a column contains its unit, if it has one.

mod csv;
pub mod curve;
#[cfg(feature = "parquet")]
mod parquet;
mod required;
mod trajectory;

use std::borrow::Cow;
use std::fmt;

#[cfg(feature = "parquet")]
pub use parquet::{io_error, parquet_properties};
pub use required::required;
pub use trajectory::Surroundings;

/// Table of numbers, whose rows are computed while they are written.
#[derive(Debug)]
pub struct Table<'a> {
    #[cfg_attr(not(feature = "parquet"), allow(dead_code, reason = "only Parquet names its table"))]
    name: &'static str,
    rows: usize,
    columns: Vec<Column<'a>>,
}

/// Column of a table.
pub struct Column<'a> {
    /// Name, with the unit as a suffix.
    pub name: Cow<'static, str>,
    /// Unit in SI symbols; `1` for a dimensionless number.
    pub unit: &'static str,
    /// Description of the numbers, in words.
    pub description: &'static str,
    value: Box<dyn Fn(usize) -> f64 + 'a>,
}

impl<'a> Table<'a> {
    const fn new(name: &'static str, rows: usize) -> Self {
        Self { name, rows, columns: Vec::new() }
    }

    /// Returns the name of the table.
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// Returns all columns in their order.
    pub fn columns(&self) -> &[Column<'a>] {
        &self.columns
    }

    /// Returns the number of rows.
    pub const fn rows(&self) -> usize {
        self.rows
    }

    fn number(
        &mut self,
        name: impl Into<Cow<'static, str>>,
        unit: &'static str,
        description: &'static str,
        value: impl Fn(usize) -> f64 + 'a,
    ) {
        self.columns.push(Column { name: name.into(), unit, description, value: Box::new(value) });
    }

    /// Adds three columns: `NAME_x_SUFFIX` and so on.
    fn vector(
        &mut self,
        [name, suffix]: [&str; 2],
        unit: &'static str,
        description: &'static str,
        value: impl Fn(usize) -> [f64; 3] + Clone + 'a,
    ) {
        for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let value = value.clone();
            self.number(format!("{name}_{axis}{suffix}"), unit, description, move |row| value(row)[k]);
        }
    }
}

impl Column<'_> {
    /// Returns the number in a row, from 0; NaN beyond the last row.
    pub fn value(&self, row: usize) -> f64 {
        (self.value)(row)
    }
}

impl fmt::Debug for Column<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} [{}]: {}", self.name, self.unit, self.description)
    }
}

/// Conventions for signs, orders and frames, for formats that have metadata.
pub const CONVENTIONS: &str = "SI units; attitude = R_space_body (v_space = R v_body), unit quaternion, Hamilton, \
    scalar first (w, x, y, z), continuous in time; omega is the body's angular velocity relative to space; inertia, \
    momentum, torque and rotational kinetic energy are about the centre of mass of a free body, about the pivot of a \
    held one";
