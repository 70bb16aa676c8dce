//! The trajectory table as text: RFC 4180 with LF line ends.
//!
//! Numbers are the shortest decimals that read back bit for bit, so nothing ever needs quoting.

use std::io::{self, BufWriter, Write};

use polhode::motion::Trajectory;

use super::{Surroundings, columns};

/// Writes a trajectory of a body in these surroundings: a line of column names, then a line per sample.
///
/// # Errors
/// Those of `out`.
pub fn write(trajectory: &Trajectory, surroundings: &Surroundings, out: impl Write) -> io::Result<()> {
    let mut out = BufWriter::new(out);
    let columns = columns(trajectory, surroundings);
    separated(&mut out, &columns, |out, column| write!(out, "{}", column.name))?;
    for row in 0..trajectory.samples().len() {
        separated(&mut out, &columns, |out, column| write!(out, "{:?}", column.value(trajectory, row)))?;
    }
    out.flush()
}

/// One line: each item by `cell`, commas between.
pub fn separated<W: Write, T>(
    out: &mut W,
    items: &[T],
    mut cell: impl FnMut(&mut W, &T) -> io::Result<()>,
) -> io::Result<()> {
    for (k, item) in items.iter().enumerate() {
        if k > 0 {
            out.write_all(b",")?;
        }
        cell(out, item)?;
    }
    out.write_all(b"\n")
}
