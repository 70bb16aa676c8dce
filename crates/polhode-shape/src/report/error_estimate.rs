//! Error estimate of computed mass properties.

use polhode::body::density::FieldError;
use polhode_document::Extra;
use polhode_document::layout::labelled;
use polhode_document::number::error;
use serde_json::json;

/// Returns the block `error_estimate`: errors of the mass (kg), of the centre of mass (m), and of
/// the tensor elements relative to half the trace. `by` names the source of the estimate.
pub fn error_estimate(estimate: &FieldError, by: &str) -> Extra {
    let FieldError { mass, center_of_mass, inertia } = *estimate;
    let [x, y, z] = [mass, center_of_mass, inertia].map(error);
    let text = format!("mass {x} kg, centre of mass {y} m, inertia {z} of half its trace, {by}",);
    let json = json!({ "mass": mass, "center_of_mass": center_of_mass, "inertia": inertia });
    Extra { key: "error_estimate", json, text: labelled("error estimate", &text) }
}
