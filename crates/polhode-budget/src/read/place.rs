//! Place of a row's frame in its parent's frame.

use polhode::math::{Part, Position, Rotation, RotationError};
use polhode_source::files::Memory;
use polhode_source::toml::reader::Table;
use polhode_source::toml::source::Source;
use polhode_source::toml::{document, rotation};
use polhode_source::{FormatError, FormatErrorKind};

use super::cell::Cell;
use super::cells::{Cells, Given, Reader};
use super::heading::Column;
use super::key::{AT_X, AT_Y, AT_Z, PITCH, QW, QX, QY, QZ, ROLL, ROTATE, TURN_X, TURN_Y, TURN_Z, YAW};
use crate::{Place, Spread};

const QUATERNION: [usize; 4] = [QW, QX, QY, QZ];
const ANGLES: [usize; 3] = [ROLL, PITCH, YAW];

impl<'s, 'a> Reader<'s, 'a> {
    /// Reads the place of a row's frame, with the errors of its position and its rotation.
    pub(crate) fn place(
        &mut self,
        cells: &Cells<'_, 'a>,
    ) -> Result<(Place, Spread<3>, Spread<3>), FormatError> {
        let (position, position_spread) = self.triple(cells, [AT_X, AT_Y, AT_Z], None)?;
        let place = Place {
            position: position.map_or(Position::ZERO, Position::from_array),
            rotation: self.rotation(cells)?,
        };
        let mut rotation_spread = [0.0; 3];
        for (slot, key) in rotation_spread.iter_mut().zip([TURN_X, TURN_Y, TURN_Z]) {
            if let Some(deviation) = self.deviation(cells, key, None)? {
                *slot = deviation.of(0.0, self)?;
            }
        }
        Ok((place, position_spread, spread(rotation_spread)))
    }

    /// Reads three numbers that belong together, with their errors. If they have no cells, the
    /// errors apply to the `known` numbers.
    pub(crate) fn triple(
        &mut self,
        cells: &Cells<'_, 'a>,
        keys: [usize; 3],
        known: Option<[f64; 3]>,
    ) -> Result<(Option<[f64; 3]>, Spread<3>), FormatError> {
        let values = self.all_or_none(cells, keys)?;
        let numbers = values.map(|values| values.map(|given| given.map_or(0.0, |given| given.value)));
        let of = numbers.or(known).unwrap_or_default();
        let mut deviations = [0.0; 3];
        for (k, (slot, key)) in deviations.iter_mut().zip(keys).enumerate() {
            let given = values.and_then(|values| values[k]);
            if let Some(deviation) = self.deviation(cells, key, given)? {
                *slot = deviation.of(of[k], self)?;
            }
        }
        Ok((numbers, spread(deviations)))
    }

    /// Reads numbers that belong together. If some of their cells are empty and others are not,
    /// that is an error. A missing column means zero.
    pub(crate) fn all_or_none<'c, const N: usize>(
        &mut self,
        cells: &Cells<'c, 'a>,
        keys: [usize; N],
    ) -> Result<Option<[Option<Given<'c, 'a>>; N]>, FormatError> {
        let Some(present) = keys.iter().find_map(|key| cells.cell(*key)) else { return Ok(None) };
        let mut all = [None; N];
        for (slot, key) in all.iter_mut().zip(keys) {
            *slot = self.number(cells, key)?;
            if let (None, Some(Column { heading, .. })) = (&slot, self.columns.of_key(key)) {
                let rule = format!("given with {heading}, which is empty in this row");
                return Err(self.invalid(present, rule).with_hint("write 0 if it is zero"));
            }
        }
        Ok(Some(all))
    }

    fn rotation(&mut self, cells: &Cells<'_, 'a>) -> Result<Rotation<Part, Part>, FormatError> {
        let forms = [
            cells.cell(ROTATE),
            ANGLES.iter().find_map(|key| cells.cell(*key)),
            QUATERNION.iter().find_map(|key| cells.cell(*key)),
        ];
        let mut given = forms.iter().flatten();
        if let (Some(_), Some(second)) = (given.next(), given.next()) {
            return Err(self.invalid(second, "left out where the rotation is given by another column"));
        }
        match forms {
            [Some(cell), ..] => self.written_rotation(cell),
            [_, Some(cell), _] => {
                // An angle that is not given is 0.
                let mut angles = [0.0; 3];
                for (slot, key) in angles.iter_mut().zip(ANGLES) {
                    *slot = self.number(cells, key)?.map_or(0.0, |angle| angle.value);
                }
                Rotation::from_roll_pitch_yaw(angles).map_err(|error| self.turned(cell, error))
            }
            [_, _, Some(cell)] => {
                let numbers = self.all_or_none(cells, QUATERNION)?.unwrap_or_default();
                let numbers = numbers.map(|number| number.map_or(0.0, |number| number.value));
                Rotation::from_quaternion(numbers).map_err(|error| self.turned(cell, error))
            }
            _ => Ok(Rotation::identity()),
        }
    }

    fn turned(&self, cell: &Cell<'_>, error: RotationError) -> FormatError {
        self.sheet.error(cell, FormatErrorKind::Rotation(error))
    }

    /// Reads `{ axis = [0, 0, 1], angle = '90 deg' }`, in all forms that scenarios have. The braces
    /// are optional.
    fn written_rotation(&self, cell: &Cell<'a>) -> Result<Rotation<Part, Part>, FormatError> {
        let inside = self.whole(cell)?;
        let braced = inside.starts_with('{');
        let (open, close) = if braced { ("", "") } else { ("{ ", " }") };
        let text = format!("rotate = {open}{inside}{close}");
        let nothing = Memory::default();
        let source = Source::new(&nothing, self.sheet.path(), &text);
        let read = || {
            let entries = document(source).map_err(|error| match error.kind() {
                FormatErrorKind::Toml { .. } => error
                    .with_hint("write axis = [0, 0, 1], angle = '90 deg'; or use columns roll, pitch, yaw"),
                _ => error,
            })?;
            rotation(&Table::root(source, &entries).require("rotate", "rotate")?)
        };
        read().map_err(|error| self.sheet.moved(error, &[], cell))
    }
}

/// Returns standard deviations, or exact numbers if all of these are 0.
pub(crate) fn spread<const N: usize>(deviations: [f64; N]) -> Spread<N> {
    if deviations == [0.0; N] { Spread::Exact } else { Spread::Deviations(deviations) }
}
