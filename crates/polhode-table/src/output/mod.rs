//! Tables: one row per sample or point, one column per number.
//!
//! The columns of a table are defined in a file of their own, and each format writes any table. SI units, named in the
//! column's name where it has one.

mod csv;
pub mod curve;
mod parquet;
mod required;
mod trajectory;

use std::borrow::Cow;
use std::fmt;

pub use parquet::{io_error, parquet_properties};
pub use required::required;
pub use trajectory::Surroundings;

/// A table of numbers, whose rows are computed as they are written.
#[derive(Debug)]
pub struct Table<'a> {
    name: &'static str,
    rows: usize,
    columns: Vec<Column<'a>>,
}

/// One column of a table.
pub struct Column<'a> {
    /// The name, with its unit as suffix.
    pub name: Cow<'static, str>,
    /// The unit in SI symbols; `1` for a pure number.
    pub unit: &'static str,
    /// What it is.
    pub description: &'static str,
    value: Box<dyn Fn(usize) -> f64 + 'a>,
}

impl<'a> Table<'a> {
    const fn new(name: &'static str, rows: usize) -> Self {
        Self { name, rows, columns: Vec::new() }
    }

    /// All columns, in order.
    pub fn columns(&self) -> &[Column<'a>] {
        &self.columns
    }

    /// How many rows there are.
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

    /// Three columns: `NAME_x_SUFFIX` and so on.
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
    /// The number of a row, from 0; NaN beyond the last.
    pub fn value(&self, row: usize) -> f64 {
        (self.value)(row)
    }
}

impl fmt::Debug for Column<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} [{}]: {}", self.name, self.unit, self.description)
    }
}

/// How signs, orders and frames are to be read: for the metadata of formats that have any.
pub const CONVENTIONS: &str = "SI units; attitude = R_space_body (v_space = R v_body), unit quaternion, Hamilton, \
    scalar first (w, x, y, z), continuous in time; omega is the body's angular velocity relative to space; inertia, \
    momentum, torque and rotational kinetic energy are about the centre of mass of a free body, about the pivot of a \
    held one";
