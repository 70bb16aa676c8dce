//! `[[torque]]` of model `energy_sink`: internal dissipation of the body.

use polhode::motion::torque::{EnergySink, TorqueModel};
use polhode_source::FormatError;
use polhode_source::toml::reader::Table;
use polhode_source::unit::Dimension;

use super::allow;

/// Dimension of 1/(N·m·s).
const PER_ANGULAR_MOMENTUM: Dimension = Dimension::new(-1, -2, 1, 0);

/// Reads `coefficient`.
pub(crate) fn energy_sink(table: &Table<'_>) -> Result<TorqueModel, FormatError> {
    allow(table, &["coefficient"])?;
    let value = table.require("coefficient", "coefficient = \"0.002 /(N m s)\"")?;
    let hint =
        "it damps nutation in 1/(coefficient L^2 (1/i1 - 1/i3)) seconds; without loss, leave the torque out";
    let sink = EnergySink::new(value.quantity(PER_ANGULAR_MOMENTUM)?);
    sink.map(TorqueModel::EnergySink).map_err(|e| value.motion(e).with_hint(hint))
}
