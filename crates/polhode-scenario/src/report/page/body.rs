//! Body: mass, inertia about the reference point, and shape for display.

use polhode_document::json::{finite, numbers};
use serde_json::{Value, json};

use super::shapes::{self, Budget};
use super::turning::{Turning, ellipsoid, equivalent_box};

/// Returns the JSON of a body; without `budget` it has no shapes.
pub(crate) fn json(turning: &Turning<'_>, budget: Option<&mut Budget>) -> Value {
    let moments = turning.principal.moments();
    let central = turning.central.moments();
    let quaternion = numbers(&turning.central.rotation().canonical_quaternion());
    let size = turning.mass.and_then(|mass| equivalent_box(central, mass));
    json!({
        "mass": turning.mass,
        "inertia": turning.tensor.iter().map(|row| numbers(&row.map(finite))).collect::<Value>(),
        "about": turning.about(),
        "lever": numbers(&turning.lever.to_array().map(finite)),
        "principal": {
            "moments": numbers(&moments.map(finite)),
            "quaternion": numbers(&turning.principal.rotation().canonical_quaternion()),
        },
        "ellipsoid": {
            "half": numbers(&ellipsoid(central, turning.mass.unwrap_or(1.0))),
            "quaternion": quaternion,
        },
        "box": size.map(|size| json!({ "size": numbers(&size), "quaternion": quaternion })),
        "shapes": budget.map_or_else(|| json!([]), |budget| shapes::json(turning, budget)),
    })
}
