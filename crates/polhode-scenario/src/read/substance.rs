//! Substance of a part: a density, a mass, or a named material.

use polhode::body::Material;
use polhode::body::shape::{Extent, Substance};
use polhode_shape::material;
use polhode_shape::material::UnknownMaterial;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::{Dimension, UnitError};
use polhode_source::{FormatError, FormatErrorKind};

use super::formula::{self, Formula};

/// Keys of every part with a shape; a thin surface also has `thickness`.
pub(crate) const KEYS: [&str; 4] = ["density", "mass", "material", "density_tolerance"];

/// Substance of a part.
pub(crate) enum Matter {
    /// The same density everywhere.
    Uniform(Substance),
    /// Density as a formula of position.
    Varying(Formula),
}

const THIN_ROD: &str = "give density = \"0.3 kg/m\" or mass = \"12 g\", or make it a cylinder";

/// Reads the substance of a part of this extent; returns it with the value that gives it.
pub(crate) fn matter<'a>(table: &Table<'a>, extent: Extent) -> Result<(Matter, Value<'a>), FormatError> {
    let density = table.get("density");
    if let Some((given, formula)) = density.and_then(|given| Some((given, formula::text(&given)?))) {
        table.at_most_one(&KINDS, ALONE)?;
        let formula = Formula::read(table, &given, formula, extent)?;
        return Ok((Matter::Varying(formula), given));
    }
    if let Some(tolerance) = table.get("density_tolerance") {
        return Err(tolerance
            .invalid("left out unless the density is a formula")
            .with_hint("write density = \"2700*(1 + 0.1*x)\", or leave out density_tolerance"));
    }
    let (substance, given) = substance(table, extent)?;
    Ok((Matter::Uniform(substance), given))
}

const KINDS: [&str; 3] = ["density", "mass", "material"];

const ALONE: &str = "each of them alone defines the mass of the part";

/// Reads a uniform substance of a part of this extent; returns it with the value that gives it.
///
/// The density of a thin part is per area, or per volume with a `thickness`; a material needs a
/// thickness.
fn substance<'a>(table: &Table<'a>, extent: Extent) -> Result<(Substance, Value<'a>), FormatError> {
    let given = table.at_most_one(&KINDS, ALONE)?;
    let Some(given) = given else {
        return Err(table.missing(
            "density",
            "density = \"2700 kg/m^3\", or mass = \"12 g\", or material = \"aluminium\"",
        ));
    };
    let thickness = table.get("thickness");
    if given.key() == "mass" {
        table.at_most_one(&["mass", "thickness"], "the mass alone is sufficient")?;
    }
    let thickness = thickness.map(|t| t.positive(Dimension::LENGTH)).transpose()?;
    let substance = match (given.key(), extent, thickness) {
        ("mass", ..) => Substance::Mass(given.positive(Dimension::MASS)?),
        ("density", Extent::Volume(_), _) => Substance::Density(given.positive(Dimension::DENSITY)?),
        ("density", Extent::Length(_), _) => {
            Substance::LineDensity(density(&given, Dimension::LINE_DENSITY, THIN_ROD)?)
        }
        ("density", Extent::Area(_), None) => {
            let hint =
                "a thin part has a density per area; with thickness = \"2 mm\" the density is per volume";
            Substance::AreaDensity(density(&given, Dimension::AREA_DENSITY, hint)?)
        }
        ("density", Extent::Area(_), Some(t)) => {
            let hint =
                "with a thickness the density is per volume; without it, per area: leave out the thickness";
            Substance::AreaDensity(density(&given, Dimension::DENSITY, hint)? * t)
        }
        (_, Extent::Volume(_), _) => Substance::Density(material(&given)?.density),
        (_, Extent::Area(_), Some(t)) => Substance::AreaDensity(material(&given)?.density * t),
        (_, Extent::Area(_), None) => {
            material(&given)?;
            return Err(table
                .missing("thickness", "thickness = \"2 mm\", because a material has a density per volume"));
        }
        (_, Extent::Length(_), _) => {
            material(&given)?;
            return Err(given.invalid("left out for a rod, which has no cross-section").with_hint(THIN_ROD));
        }
    };
    Ok((substance, given))
}

/// Reads a density of this dimension; a density of another kind of part is refused with this hint.
fn density(value: &Value<'_>, dimension: Dimension, hint: &str) -> Result<f64, FormatError> {
    value.positive(dimension).map_err(|error| match error.kind() {
        FormatErrorKind::Unit(UnitError::WrongDimension {
            found: Dimension::DENSITY | Dimension::AREA_DENSITY | Dimension::LINE_DENSITY,
            ..
        }) => error.with_hint(hint),
        _ => error,
    })
}

fn material(value: &Value<'_>) -> Result<Material, FormatError> {
    material::named(value.string()?).map_err(|unknown| {
        let hint = unknown.hint_or("give density = \"2700 kg/m^3\" for a material without a name");
        value.invalid(format!("a known material: {}", UnknownMaterial::known())).with_hint(hint)
    })
}
