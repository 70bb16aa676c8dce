//! A `[[torque]]` of model `magnetic`.

use polhode::math::Direction;
use polhode::motion::torque::{Magnetic, MagneticField, TorqueModel};

use super::allow;
use super::orbit::{SharedOrbit, orbit_of};
use crate::error::FormatError;
use crate::scenario::reader::Table;
use crate::unit::Dimension;

/// `moment = [3]` in the body; `field = [3]` in space, or `dipole = [3]` in space with `orbit = { … }`, if no torque before it has one.
pub(super) fn magnetic(
    table: &Table<'_>,
    shared: &mut Option<SharedOrbit>,
) -> Result<TorqueModel, FormatError> {
    allow(table, &["moment", "field", "dipole", "orbit"])?;
    let moment = table.require("moment", "moment = [0, 0, \"5 A m^2\"]")?;
    let moment = Direction::from_array(moment.quantities(Dimension::MAGNETIC_MOMENT)?);
    let Some(given) = table.at_most_one(&["field", "dipole"], "the field is given once")? else {
        return Err(table.missing("field", "field = [\"20 µT\", 0, \"-40 µT\"], or dipole and orbit"));
    };
    let field = if given.key() == "field" {
        table.at_most_one(&["field", "orbit"], "a uniform field is the same everywhere")?;
        MagneticField::Uniform(Direction::from_array(given.quantities(Dimension::MAGNETIC_FIELD)?))
    } else {
        let dipole = Direction::from_array(given.quantities(Dimension::MAGNETIC_MOMENT)?);
        MagneticField::Dipole { dipole, orbit: orbit_of(table, shared)? }
    };
    Ok(TorqueModel::Magnetic(Box::new(Magnetic { moment, field })))
}
