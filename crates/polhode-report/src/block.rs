//! The mass properties of a body: the part that every report has.

use polhode::body::{BodyPart, MassProperties, PrincipalFrame};
use polhode::math::{Body, Frame};
use polhode_document::json::{matrix, numbers, vector};
use serde_json::{Map, Value, json};

/// What the shape of a body gives besides its mass properties.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Geometry {
    /// m³
    pub(crate) volume: Option<f64>,
    /// m²
    pub(crate) surface_area: Option<f64>,
    /// kg/m³
    pub(crate) density: Option<f64>,
}

impl Geometry {
    /// Volumes add (parts that overlap count twice, as their masses do); areas do not, so only a single part has one.
    pub(crate) fn of_parts(parts: &[BodyPart], mass: f64) -> Self {
        let volumes: Option<Vec<f64>> = parts.iter().map(|part| part.extent?.volume()).collect();
        let volume = volumes.filter(|v| !v.is_empty()).map(|v| v.iter().sum::<f64>());
        let surface_area = match parts {
            [part] => part.surface_area,
            _ => None,
        };
        Self { volume, surface_area, density: volume.map(|v| mass / v) }
    }
}

/// `mass`, `volume`, `surface_area`, `density`, `center_of_mass`, `inertia`, `principal`, `gyration_radii`
pub(crate) fn insert(object: &mut Map<String, Value>, body: &MassProperties<Body>, geometry: Geometry) {
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

/// `{"moments": …, "axes": …, "quaternion_wxyz": …, "symmetry": …}`
pub(crate) fn principal<F: Frame>(principal: &PrincipalFrame<F>) -> Value {
    json!({
        "moments": numbers(&principal.moments()),
        "axes": principal.axes().into_iter().map(vector).collect::<Value>(),
        "quaternion_wxyz": numbers(&principal.rotation().canonical_quaternion()),
        "symmetry": principal.symmetry().name(),
    })
}
