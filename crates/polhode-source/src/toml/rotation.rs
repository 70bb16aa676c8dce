//! Rotations: `rotate` of a part, `attitude` of the start.

use polhode::math::{Direction, Frame, Rotation};

use super::reader::{Table, Value, each};
use super::tree::{Known, Replacement};
use crate::FormatError;
use crate::unit::Dimension;

const FORMS: [&str; 7] =
    ["axis", "quaternion", "quaternion_xyzw", "euler313", "roll_pitch_yaw", "mrp", "matrix"];

/// Reads the rotation R_AB, with v_A = R_AB v_B, from one of these forms:
///
/// `{ axis = [3], angle = "90 deg" }`, `{ quaternion = [w, x, y, z] }`,
/// `{ quaternion_xyzw = [x, y, z, w] }`,
/// `{ euler313 = [φ, θ, ψ] }`, `{ roll_pitch_yaw = [φ, θ, ψ] }`, `{ mrp = [σ1, σ2, σ3] }`,
/// `{ matrix = [[3], [3], [3]] }`.
pub fn rotation<A: Frame, B: Frame>(value: &Value<'_>) -> Result<Rotation<A, B>, FormatError> {
    if let Some(Replacement::Rotation(quaternion)) = value.replacement() {
        return Rotation::from_quaternion(*quaternion).map_err(|e| value.rotation(e));
    }
    let rotation = written(value)?;
    value.keep(Known::Rotation(rotation.quaternion()));
    Ok(rotation)
}

fn written<A: Frame, B: Frame>(value: &Value<'_>) -> Result<Rotation<A, B>, FormatError> {
    let table = value.table()?;
    table.allow(&[
        "axis",
        "angle",
        "quaternion",
        "quaternion_xyzw",
        "euler313",
        "roll_pitch_yaw",
        "mrp",
        "matrix",
    ])?;
    let form = table.at_most_one(&FORMS, "give the rotation in one way only")?;
    let Some(form) = form else {
        return Err(table.missing("axis", "{ axis = [0, 0, 1], angle = \"90 deg\" }"));
    };
    if form.key() != "axis" {
        table.at_most_one(&[form.key(), "angle"], "angle is used only with axis")?;
    }
    match form.key() {
        "axis" => about(&table, &form),
        "quaternion" => Rotation::from_quaternion(form.numbers()?).map_err(|e| form.rotation(e)),
        "quaternion_xyzw" => {
            let [x, y, z, w] = form.numbers()?;
            Rotation::from_quaternion([w, x, y, z]).map_err(|e| form.rotation(e))
        }
        "roll_pitch_yaw" => {
            let angles = form.quantities(Dimension::ANGLE)?;
            Rotation::from_roll_pitch_yaw(angles).map_err(|e| form.rotation(e))
        }
        "mrp" => Rotation::from_mrp(form.numbers()?).map_err(|e| form.rotation(e)),
        "euler313" => {
            Rotation::from_euler313(form.quantities(Dimension::ANGLE)?).map_err(|e| form.rotation(e))
        }
        _ => {
            let mut matrix = [[0.0; 3]; 3];
            for (row, values) in matrix.iter_mut().zip(form.rows::<3, 3>()?) {
                *row = each(values, Value::number)?;
            }
            Rotation::from_matrix(matrix).map_err(|e| form.rotation(e))
        }
    }
}

fn about<A: Frame, B: Frame>(table: &Table<'_>, axis: &Value<'_>) -> Result<Rotation<A, B>, FormatError> {
    let angle = table.require("angle", "angle = \"90 deg\"")?.quantity(Dimension::ANGLE)?;
    Rotation::from_axis_angle(Direction::from_array(axis.numbers()?), angle).map_err(|e| axis.rotation(e))
}
