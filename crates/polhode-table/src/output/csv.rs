//! Tables as CSV: RFC 4180 with LF line ends.
//!
//! Numbers are the shortest decimals that read back bit for bit, so no field needs quotes.

use std::io::{self, BufWriter, Write};

use super::{Column, Table};

impl Table<'_> {
    /// Writes the table as text: a line of column names, then a line per row.
    ///
    /// # Errors
    /// Errors of `out`.
    pub fn write_csv(&self, out: impl Write) -> io::Result<()> {
        let mut out = BufWriter::new(out);
        separated(&mut out, self.columns(), |out, column| write!(out, "{}", column.name))?;
        for row in 0..self.rows() {
            separated(&mut out, self.columns(), |out, column| write!(out, "{:?}", column.value(row)))?;
        }
        out.flush()
    }
}

/// Writes one line: the columns as formatted by `cell`, separated by commas.
fn separated<W: Write>(
    out: &mut W,
    columns: &[Column<'_>],
    cell: impl Fn(&mut W, &Column<'_>) -> io::Result<()>,
) -> io::Result<()> {
    for (k, column) in columns.iter().enumerate() {
        if k > 0 {
            out.write_all(b",")?;
        }
        cell(out, column)?;
    }
    out.write_all(b"\n")
}
