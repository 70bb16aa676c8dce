//! Mass properties of a body: the block that every report contains.

use polhode::body::{BodyPart, MassProperties, PrincipalFrame};
use polhode::math::{Body, Frame};
use polhode_document::json::{matrix, numbers, vector};
use serde_json::{Map, Value, json};

/// Geometric properties in addition to the mass properties.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Geometry {
    /// Volume, m³.
    pub volume: Option<f64>,
    /// Surface area, m².
    pub surface_area: Option<f64>,
    /// Density, kg/m³.
    pub density: Option<f64>,
}

impl Geometry {
    /// Adds the volumes of parts; overlaps count twice, as their masses do. A surface area is known
    /// only for a single part.
    pub fn of_parts(parts: &[BodyPart], mass: f64) -> Self {
        let volumes: Option<Vec<f64>> = parts.iter().map(|part| part.extent?.volume()).collect();
        let volume = volumes.filter(|v| !v.is_empty()).map(|v| v.iter().sum::<f64>());
        let surface_area = match parts {
            [part] => part.surface_area,
            _ => None,
        };
        Self { volume, surface_area, density: volume.map(|v| mass / v) }
    }
}

/// Inserts the keys `mass`, `volume`, `surface_area`, `density`, `center_of_mass`, `inertia`,
/// `principal`, `gyration_radii`.
pub fn insert(object: &mut Map<String, Value>, body: &MassProperties<Body>, geometry: Geometry) {
    let mut put = |key: &str, value: Value| object.insert(key.to_owned(), value);
    put("mass", body.mass().into());
    put("volume", geometry.volume.into());
    put("surface_area", geometry.surface_area.into());
    put("density", geometry.density.into());
    put("center_of_mass", vector(body.center_of_mass()));
    put(
        "inertia",
        json!({
            "about": "center_of_mass",
            "axes": "body",
            "products": "negative_integral",
            "tensor": matrix(body.inertia().matrix()),
        }),
    );
    put("principal", principal(&body.principal()));
    put("gyration_radii", numbers(&body.gyration_radii()));
}

/// Returns `{"moments": …, "axes": …, "quaternion_wxyz": …, "symmetry": …}`.
pub fn principal<F: Frame>(principal: &PrincipalFrame<F>) -> Value {
    json!({
        "moments": numbers(&principal.moments()),
        "axes": principal.axes().into_iter().map(vector).collect::<Value>(),
        "quaternion_wxyz": numbers(&principal.rotation().canonical_quaternion()),
        "symmetry": principal.symmetry().name(),
    })
}
