//! The body: its mass, its inertia about the point that it turns about, and its shape for display.

use serde_json::{Value, json};

use super::shapes::{self, Budget};
use super::turning::{Turning, ellipsoid};
use crate::json::{finite, numbers};

/// Without `budget` it has no shapes.
pub(super) fn json(turning: &Turning<'_>, budget: Option<&mut Budget>) -> Value {
    let moments = turning.principal.moments();
    json!({
        "mass": turning.mass,
        "inertia": turning.tensor.iter().map(|row| numbers(&row.map(finite))).collect::<Value>(),
        "about": turning.about(),
        "lever": numbers(&turning.lever.to_array().map(finite)),
        "principal": {
            "moments": numbers(&moments.map(finite)),
            "quaternion": numbers(&turning.principal.rotation().canonical_quaternion()),
        },
        "ellipsoid": numbers(&ellipsoid(moments, turning.mass.unwrap_or(1.0))),
        "shapes": budget.map_or_else(|| json!([]), |budget| shapes::json(turning, budget)),
    })
}
