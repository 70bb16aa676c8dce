//! Density as a formula of position: `density = "2700*(1 + 0.1*x)"`.

use polhode::body::density::{Cubature, FieldError, mass_properties_of_field};
use polhode::body::shape::Extent;
use polhode::body::{BodyError, Finding, MassProperties, Severity};
use polhode::math::Part;
use polhode_source::FormatError;
use polhode_source::expression::Expression;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit;
use polhode_source::unit::Dimension;

use super::shape::Geometry;

/// Variables: coordinates along the axes of the part, m.
const VARIABLES: [&str; 3] = ["x", "y", "z"];

const UNREACHED: &str = "give a larger density_tolerance, or divide the part where the density jumps";

/// Density ρ(x, y, z), kg/m³, with its integration tolerance.
pub(crate) struct Formula {
    expression: Expression,
    cubature: Cubature,
}

/// Returns the text of a density that is, or is meant as, a formula.
///
/// A text that can be read as a quantity, or that names a symbol, is a quantity. Otherwise it is a formula if it contains a
/// variable or a sum, or does not begin with a number; a mistyped unit has none of these.
pub(crate) fn text<'a>(value: &Value<'a>) -> Option<&'a str> {
    let text = value.string().ok().filter(|_| !value.names_symbol())?;
    let error = [Dimension::DENSITY, Dimension::AREA_DENSITY, Dimension::LINE_DENSITY]
        .into_iter()
        .map(|dimension| unit::parse(text, dimension).err())
        .collect::<Option<Vec<_>>>()?;
    let mut words = text.split(|c: char| !c.is_alphanumeric() && c != '_');
    let numberless = !text.trim_start().starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
    let meant = words.any(|word| VARIABLES.contains(&word)) || text.contains('+') || numberless;
    let quantity = error.iter().any(|error| matches!(error, unit::UnitError::WrongDimension { .. }));
    let formula = Expression::parse(text, &VARIABLES).is_ok();
    ((meant && !quantity) || formula).then_some(text)
}

impl Formula {
    /// Reads the formula in `density` and its `density_tolerance`, for a part of this extent.
    pub(crate) fn read(
        table: &Table<'_>,
        value: &Value<'_>,
        text: &str,
        extent: Extent,
    ) -> Result<Self, FormatError> {
        let expression = Expression::parse(text, &VARIABLES).map_err(|error| {
            let fail = value.invalid(format!("a quantity such as 2700 kg/m^3, or a formula ({error})"));
            match error.hint() {
                Some(hint) => fail.with_hint(hint),
                None => fail,
            }
        })?;
        if !matches!(extent, Extent::Volume(_)) {
            return Err(value
                .invalid("one number for a thin shell, plate or rod: only a solid can have a formula")
                .with_hint("make it a box, a cylinder or another solid, or a mesh"));
        }
        let mut cubature = Cubature::default();
        if let Some(tolerance) = table.get("density_tolerance") {
            cubature.tolerance = tolerance.number()?;
            if !(1e-14..=0.1).contains(&cubature.tolerance) {
                return Err(tolerance.invalid("from 1e-14 to 0.1"));
            }
        }
        Ok(Self { expression, cubature })
    }

    /// Returns the mass properties of a solid of this density; the error estimate is added to
    /// `findings`.
    pub(crate) fn integrate(
        &self,
        form: &Geometry,
        value: &Value<'_>,
        part: &str,
        findings: &mut Vec<Finding>,
    ) -> Result<MassProperties<Part>, FormatError> {
        let solid = form.as_solid().ok_or_else(|| value.invalid("one number for thin or united meshes"))?;
        let body = mass_properties_of_field(solid, &self.expression, self.cubature).map_err(|e| {
            let unreached = matches!(e, BodyError::Cubature { .. });
            let error = value.body(e);
            if unreached { error.with_hint(UNREACHED) } else { error }
        })?;
        let FieldError { mass, center_of_mass, inertia } = body.error_estimate;
        findings.push(Finding {
            code: "density.cubature",
            severity: Severity::Info,
            message: format!(
                "integrated by cubature: mass within {mass:.1e} kg, centre of mass within {center_of_mass:.1e} m, \
                 inertia within {inertia:.1e} of half its trace"
            ),
            place: Some(format!("part \"{part}\"")),
        });
        Ok(body.properties)
    }
}
