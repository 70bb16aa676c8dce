//! `[[torque]]` of model `drag`.

use polhode::motion::torque::{Drag, DragLaw, TorqueModel};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value, each};
use polhode_source::unit::Dimension;

use super::allow;

/// Reads `law = "linear" | "quadratic"`; `coefficient`, a quantity, [3] along the body axes, or a
/// matrix.
pub(crate) fn drag(table: &Table<'_>) -> Result<TorqueModel, FormatError> {
    allow(table, &["law", "coefficient"])?;
    let law = match table.require("law", "law = \"linear\"")?.choice(&["linear", "quadratic"])? {
        "linear" => DragLaw::Linear,
        _ => DragLaw::Quadratic,
    };
    let value = table.require("coefficient", "coefficient = \"0.02 N m s\"")?;
    let drag = Drag::new(law, matrix(&value, law)?).map_err(|error| value.motion(error))?;
    Ok(TorqueModel::Drag(drag))
}

fn matrix(value: &Value<'_>, law: DragLaw) -> Result<[[f64; 3]; 3], FormatError> {
    let read = |value: &Value<'_>| coefficient(value, law);
    if !value.is_array() {
        let c = read(value)?;
        return Ok([[c, 0.0, 0.0], [0.0, c, 0.0], [0.0, 0.0, c]]);
    }
    let elements = value.fixed::<3>("quantities, one for each body axis, or of rows of three")?;
    if !elements.iter().any(Value::is_array) {
        let [a, b, c] = each(elements, read)?;
        return Ok([[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]]);
    }
    let mut matrix = [[0.0; 3]; 3];
    for (row, values) in matrix.iter_mut().zip(value.rows::<3, 3>()?) {
        *row = each(values, read)?;
    }
    Ok(matrix)
}

/// Reads a torque per angular velocity, or per its square, with or without rad in the unit.
fn coefficient(value: &Value<'_>, law: DragLaw) -> Result<f64, FormatError> {
    let [without, with] = match law {
        DragLaw::Linear => [Dimension::ANGULAR_MOMENTUM, Dimension::DRAG],
        DragLaw::Quadratic => [Dimension::INERTIA, Dimension::QUADRATIC_DRAG],
    };
    value.quantity(without).or_else(|_| value.quantity(with))
}
