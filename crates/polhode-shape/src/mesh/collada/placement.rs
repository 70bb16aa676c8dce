//! Transformation of a node relative to its parent.

use polhode_source::xml::Element;
use polhode_source::{ContentError, ContentErrorKind};

use super::value::{array, missing, start, unsupported};
use crate::mesh::affine::Affine;

/// Returns the transformation of an element; `None` for an element that is not a transformation.
pub(crate) fn of(element: Element<'_>) -> Result<Option<Affine>, ContentError> {
    const NO_TURN: [f64; 4] = [0.0, 0.0, 0.0, 1.0];
    Ok(Some(match element.name() {
        "matrix" => {
            // The matrix is written by rows.
            let [a, b, c, x, d, e, f, y, g, h, i, z, last @ ..] = array::<16>(element)?;
            // Programs write rounded products of such matrices.
            let is_usual = last.iter().zip([0.0, 0.0, 0.0, 1.0]).all(|(e, usual)| (e - usual).abs() <= 1e-6);
            if !is_usual {
                let (what, value) = ("the last row of the matrix", format!("{last:?}"));
                let rule = "0, 0, 0 and 1";
                return Err(ContentError::new(ContentErrorKind::value(what, value, rule), start(element)));
            }
            Affine { columns: [[a, d, g], [b, e, h], [c, f, i]], origin: [x, y, z] }
        }
        "translate" => Affine { origin: array(element)?, ..Affine::IDENTITY },
        "scale" => Affine::of_parts([0.0; 3], NO_TURN, array(element)?),
        "rotate" => {
            let [x, y, z, degrees] = array(element)?;
            let turn = match about_axis([x, y, z], degrees.to_radians()) {
                Some(turn) => turn,
                None if degrees == 0.0 => NO_TURN,
                None => return Err(missing("axis of the rotation", element)),
            };
            Affine::of_parts([0.0; 3], turn, [1.0; 3])
        }
        "skew" | "lookat" => return Err(unsupported(element, "")),
        _ => return Ok(None),
    }))
}

/// Returns the rotation about a vector of any length, scalar last; `None` for the zero vector.
fn about_axis(axis: [f64; 3], angle: f64) -> Option<[f64; 4]> {
    // Scaling the components to size 1 keeps the square of a small vector from vanishing.
    let size = axis.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
    let [x, y, z] = axis.map(|c| c / size);
    let length = (x * x + y * y + z * z).sqrt();
    let (sin, cos) = libm::sincos(0.5 * angle);
    let turn = [sin * x / length, sin * y / length, sin * z / length, cos];
    turn.iter().all(|c| c.is_finite()).then_some(turn)
}
