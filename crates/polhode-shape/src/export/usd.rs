//! OpenUSD as text: one prim for each body, with `PhysicsMassAPI` applied.
//!
//! The schema stores single precision, and 0 means "not given". Values that would become 0 or
//! infinite are refused.

use std::collections::BTreeSet;

use polhode_document::VERSION;
use polhode_document::layout::printable;

use super::{ExportBody, ExportError, ExportFormat, number, numbers};

/// Returns the whole file.
pub(crate) fn write(bodies: &[ExportBody]) -> Result<String, ExportError> {
    let mut taken = BTreeSet::new();
    let mut prims = String::new();
    let mut default = String::new();
    for body in bodies {
        check(body)?;
        let identifier = identifier(&body.name, &mut taken);
        prims += &prim(body, &identifier);
        if default.is_empty() {
            default = identifier;
        }
    }
    Ok(format!(
        r#"#usda 1.0
# polhode {VERSION}: mass properties as UsdPhysics attributes, in kg, m, kg m^2
# These attributes are single precision: USD rounds the numbers to f32 as it reads them.
(
    defaultPrim = "{default}"
    kilogramsPerUnit = 1
    metersPerUnit = 1
)
{prims}"#
    ))
}

fn prim(body: &ExportBody, identifier: &str) -> String {
    let properties = &body.properties;
    let principal = properties.principal();
    let name = quoted(&body.name);
    let mass = number(properties.mass());
    let remark = body.remark().map(|text| format!("    # {text}\n")).unwrap_or_default();
    let center = numbers(&properties.center_of_mass().to_array(), ", ");
    let moments = numbers(&principal.moments(), ", ");
    // Quaternion R_body_principal.
    let quaternion = numbers(&principal.rotation().canonical_quaternion(), ", ");
    format!(
        r#"
def Xform "{identifier}" (
    prepend apiSchemas = ["PhysicsRigidBodyAPI", "PhysicsMassAPI"]
    displayName = "{name}"
)
{{
{remark}    float physics:mass = {mass}
    # from the prim's origin, along its axes
    point3f physics:centerOfMass = ({center})
    # principal moments about the centre of mass; along principal axes there are no products
    float3 physics:diagonalInertia = ({moments})
    # (w, x, y, z): turns principal components into the prim's
    quatf physics:principalAxes = ({quaternion})
}}
"#
    )
}

/// Checks that single precision can represent the numbers, and that none becomes 0, which means
/// "not given".
fn check(body: &ExportBody) -> Result<(), ExportError> {
    let refused = |what, value, rule| {
        Err(ExportError::Range { format: ExportFormat::Usd, body: body.name.clone(), what, value, rule })
    };
    let finite = |x: f64| (x as f32).is_finite();
    let kept = |x: f64| x == 0.0 || (x as f32).is_normal();
    let (mass, moments) = (body.properties.mass(), body.properties.principal().moments());
    if !kept(mass) {
        return refused("the mass", mass, "USD's single precision holds 1.2e-38 to 3.4e38");
    }
    if let Some(x) = body.properties.center_of_mass().to_array().into_iter().find(|x| !finite(*x)) {
        return refused("the centre of mass", x, "USD's single precision holds up to 3.4e38");
    }
    if let Some(x) = moments.into_iter().find(|x| !kept(*x)) {
        return refused("a principal moment", x, "USD's single precision holds 1.2e-38 to 3.4e38");
    }
    if moments == [0.0; 3] {
        return refused("the greatest principal moment", 0.0, "USD treats moments of 0 as missing");
    }
    Ok(())
}

/// Returns a unique prim name of letters, digits and `_` that does not start with a digit.
fn identifier(name: &str, taken: &mut BTreeSet<String>) -> String {
    let mut stem: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    if !stem.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') {
        stem.insert(0, '_');
    }
    let mut identifier = stem.clone();
    let mut count = 1_u64;
    while !taken.insert(identifier.clone()) {
        count += 1;
        identifier = format!("{stem}_{count}");
    }
    identifier
}

/// Escapes the display name for double quotes.
fn quoted(name: &str) -> String {
    printable(name).replace('\\', r"\\").replace('"', "\\\"")
}
