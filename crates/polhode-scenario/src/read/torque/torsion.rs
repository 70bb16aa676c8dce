//! `[[torque]]` of model `torsion`.

use polhode::math::{Attitude, Direction};
use polhode::motion::torque::{TorqueModel, Torsion};
use polhode_source::FormatError;
use polhode_source::toml::reader::Table;
use polhode_source::toml::rotation;
use polhode_source::unit::Dimension;

use super::allow;

/// Reads `stiffness`; `rest`, an attitude, by default the identity; and the `axis` of a wire, space
/// axes.
pub(crate) fn torsion(table: &Table<'_>) -> Result<TorqueModel, FormatError> {
    allow(table, &["stiffness", "rest", "axis"])?;
    let stiffness = table.require("stiffness", "stiffness = \"0.1 N m/rad\"")?;
    let rest = table.get("rest").map_or(Ok(Attitude::identity()), |rest| rotation(&rest))?;
    let kappa = stiffness.quantity(Dimension::STIFFNESS)?;
    let torsion = match table.get("axis") {
        None => Torsion::spring(kappa, rest).map_err(|error| stiffness.motion(error)),
        Some(axis) => Torsion::wire(kappa, rest, Direction::from_array(axis.numbers()?))
            .map_err(|error| axis.motion(error)),
    };
    torsion.map(TorqueModel::Torsion)
}
