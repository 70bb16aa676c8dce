//! Rows of cells as rows of a parts list.

use polhode::math::{Part, Position};
use polhode_budget::{CopyErrors, GivenPart, GivenTensor, Place, ProductSign, Quantity, Row, TensorPoint};

use super::heading::{self, Column, KEYS, Key, NAMES};
use super::number;
use super::plan::Plan;
use super::sheet::{Cell, Sheet};
use crate::error::{FormatError, FormatErrorKind};
use crate::unit::Dimension;

/// The rows of a table, and which of the table each is.
pub(super) fn rows(sheet: &Sheet<'_>, _plan: &Plan) -> Result<(Vec<Row>, Vec<usize>), FormatError> {
    let (mut rows, mut origins) = (Vec::new(), Vec::new());
    let Some(headings) = sheet.rows.first() else { return Ok((rows, origins)) };
    let columns = heading::columns(sheet, sheet.row(headings))?;
    for (k, row) in sheet.rows.iter().enumerate().skip(1) {
        let cells = Cells::of(sheet, &columns, sheet.row(row));
        rows.push(cells.row()?);
        origins.push(k);
    }
    Ok((rows, origins))
}

/// The cells of a row by what they hold.
struct Cells<'a, 'b> {
    sheet: &'b Sheet<'a>,
    columns: &'b [Option<Column>],
    by_key: [Option<&'b Cell<'a>>; KEYS],
}

impl<'a, 'b> Cells<'a, 'b> {
    fn of(sheet: &'b Sheet<'a>, columns: &'b [Option<Column>], cells: &'b [Cell<'a>]) -> Self {
        let mut by_key = [None; KEYS];
        for cell in cells {
            if let Some(Some(column)) = columns.get(cell.column) {
                by_key[column.key] = Some(cell);
            }
        }
        Self { sheet, columns, by_key }
    }

    fn text(&self, key: Key) -> Option<&str> {
        self.by_key[key as usize].map(|cell| cell.text.as_ref())
    }

    fn number(&self, key: Key) -> Result<Option<f64>, FormatError> {
        let Some(cell) = self.by_key[key as usize] else { return Ok(None) };
        let unit = self.columns.get(cell.column).and_then(|column| column.as_ref()?.unit.as_ref());
        let dimension = NAMES[key as usize].1.unwrap_or(Dimension::NONE);
        let number = number::number(&cell.text, unit, dimension);
        number.map(Some).map_err(|error| self.sheet.error(cell, FormatErrorKind::Unit(error)))
    }

    fn numbers<const N: usize>(&self, keys: [Key; N]) -> Result<[f64; N], FormatError> {
        let mut all = [0.0; N];
        for (slot, key) in all.iter_mut().zip(keys) {
            *slot = self.number(key)?.unwrap_or(0.0);
        }
        Ok(all)
    }

    fn row(&self) -> Result<Row, FormatError> {
        let name = self.text(Key::Name).unwrap_or_default().to_owned();
        let quantity = match self.number(Key::Quantity)? {
            None => Quantity::ONE,
            Some(count) => Quantity { count: count as u32, errors: CopyErrors::Alike },
        };
        let mass = self.number(Key::Mass)?;
        let center: Position<Part> = Position::from_array(self.numbers([Key::X, Key::Y, Key::Z])?);
        let tensor = GivenTensor {
            moments: self.numbers([Key::Ixx, Key::Iyy, Key::Izz])?,
            products: self.numbers([Key::Ixy, Key::Ixz, Key::Iyz])?,
            sign: ProductSign::NegativeIntegral,
            about: TensorPoint::CenterOfMass,
        };
        let position = Position::from_array(self.numbers([Key::AtX, Key::AtY, Key::AtZ])?);
        Ok(Row {
            parent: self.text(Key::Parent).map(str::to_owned),
            quantity,
            place: Place { position, ..Place::default() },
            part: mass.map(|mass| GivenPart { mass, center_of_mass: center, tensor }),
            ..Row::frame(name)
        })
    }
}
