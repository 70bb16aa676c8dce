//! `[[torque]]` of model `magnetic`.

use polhode::math::Direction;
use polhode::motion::Orbit;
use polhode::motion::torque::{Magnetic, MagneticField, TorqueModel};
use polhode_source::FormatError;
use polhode_source::toml::reader::Table;
use polhode_source::unit::Dimension;

use super::allow;
use crate::read::orbit;

/// Reads `moment = [3]`, body axes, and `field = [3]`, space axes, or `dipole = [3]`, space axes,
/// at the centre of the `[orbit]`.
pub(crate) fn magnetic(table: &Table<'_>, orbit: Option<&Orbit>) -> Result<TorqueModel, FormatError> {
    allow(table, &["moment", "field", "dipole"])?;
    let moment = table.require("moment", "moment = [0, 0, \"5 A m^2\"]")?;
    let moment = Direction::from_array(moment.quantities(Dimension::MAGNETIC_MOMENT)?);
    let Some(given) = table.at_most_one(&["field", "dipole"], "give the field in one way only")? else {
        return Err(table.missing(
            "field",
            "field = [\"20 µT\", 0, \"-40 µT\"], or dipole = [0, 0, -7.7e22] and an [orbit]",
        ));
    };
    let field = if given.key() == "field" {
        MagneticField::Uniform(Direction::from_array(given.quantities(Dimension::MAGNETIC_FIELD)?))
    } else {
        let dipole = Direction::from_array(given.quantities(Dimension::MAGNETIC_MOMENT)?);
        MagneticField::Dipole { dipole, orbit: orbit::require(table, orbit)?.clone() }
    };
    Ok(TorqueModel::Magnetic(Box::new(Magnetic { moment, field })))
}
