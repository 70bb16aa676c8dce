//! Surface of a body that touches the ground.

use polhode::motion::contact::{BodySurface, SurfaceShape};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::{all_keys, not_negative};
use crate::read::placement::Placement;

/// Example for a missing surface.
pub(crate) const EXAMPLE: &str = "surface = { shape = \"sphere\", radius = \"20 mm\" }";

const COMMON: [&str; 3] = ["shape", "position", "rotate"];

/// Shapes of surfaces, each with its own keys.
const SHAPES: [(&str, &[&str]); 4] = [
    ("sphere", &["radius"]),
    ("ellipsoid", &["semi_axes"]),
    ("rim", &["radius", "tube", "thickness"]),
    ("cylinder", &["radius", "length"]),
];

/// Reads `{ shape = "ellipsoid", semi_axes = [3], position = [3], rotate = { … } }`.
pub(crate) fn surface(value: &Value<'_>) -> Result<BodySurface, FormatError> {
    let table = value.table()?;
    if table.get("shape").is_none() {
        // This reports a misspelt `shape` as an unknown key.
        table.allow(&all_keys(&COMMON, &SHAPES))?;
    }
    let kind = table.require("shape", EXAMPLE)?.choice(&SHAPES.map(|(name, _)| name))?;
    let own = SHAPES.iter().find(|(name, _)| *name == kind).map_or(&[][..], |(_, keys)| keys);
    let keys: Vec<_> = COMMON.iter().chain(own).copied().collect();
    let table = table.called(format!("a surface of shape \"{kind}\""));
    table.allow(&keys)?;
    let radius = || table.require("radius", "radius = \"20 mm\"")?.positive(Dimension::LENGTH);
    let length = |key| match table.get(key) {
        Some(length) => not_negative(&length, Dimension::LENGTH),
        None => Ok(0.0),
    };
    let shape = match kind {
        "sphere" => SurfaceShape::Sphere { radius: radius()? },
        "ellipsoid" => {
            let axes = table.require("semi_axes", "semi_axes = [\"200 mm\", \"30 mm\", \"20 mm\"]")?;
            SurfaceShape::Ellipsoid { semi_axes: axes.positives(Dimension::LENGTH)? }
        }
        "rim" => {
            let (tube, thickness) = (length("tube")?, length("thickness")?);
            SurfaceShape::Rim { radius: radius()?, tube, thickness }
        }
        _ => {
            let length = table.get("length").map(|length| length.positive(Dimension::LENGTH)).transpose()?;
            SurfaceShape::Cylinder { radius: radius()?, length }
        }
    };
    placed(value, &table, shape)
}

fn placed(value: &Value<'_>, table: &Table<'_>, shape: SurfaceShape) -> Result<BodySurface, FormatError> {
    let Placement { position, rotation } = Placement::read(table)?;
    BodySurface::new(shape, position, rotation).map_err(|error| value.motion(error))
}
