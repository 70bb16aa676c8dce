//! MJCF, the XML format of MuJoCo: one `<body>` for each body, at the world's origin and without a
//! joint.
//!
//! `fullinertia` contains M11 M22 M33 M12 M13 M23 of the tensor; `quat` has the scalar first
//! (MuJoCo's XML reference, `inertial`).

use polhode_document::VERSION;

use super::xml::{attribute, check_names, model, warning};
use super::{ExportBody, ExportError, ExportFormat, elements, number, numbers};

/// Returns the whole file.
pub(crate) fn write(format: ExportFormat, bodies: &[ExportBody]) -> Result<String, ExportError> {
    check_names(format, bodies)?;
    if let Some(ExportBody { name, .. }) = bodies.iter().find(|body| body.name == "world") {
        let rule = "it is the name of MuJoCo's own first body";
        return Err(ExportError::Name { format, name: name.clone(), rule });
    }
    let model = model(bodies);
    let elements: String = bodies.iter().map(|body| element(format, body)).collect();
    Ok(format!(
        r#"<?xml version="1.0"?>
<!-- polhode {VERSION}: mass properties as MuJoCo bodies, in kg, m, kg m^2 -->
<mujoco model="{model}">
  <worldbody>
{elements}  </worldbody>
</mujoco>
"#
    ))
}

fn element(format: ExportFormat, body: &ExportBody) -> String {
    let properties = &body.properties;
    let (said, inertia) = if format == ExportFormat::MjcfPrincipal { principal(body) } else { full(body) };
    let name = attribute(&body.name);
    let mass = number(properties.mass());
    let center = numbers(&properties.center_of_mass().to_array(), " ");
    let warning = warning("      ", body);
    format!(
        r#"    <body name="{name}">
      <!-- pos: centre of mass from the body's origin, along the body's axes -->
      <!-- {said} -->
{warning}      <inertial pos="{center}" mass="{mass}" {inertia}/>
    </body>
"#
    )
}

/// Returns a comment on the tensor, and its attribute.
fn full(body: &ExportBody) -> (&'static str, String) {
    let [ixx, ixy, ixz, iyy, iyz, izz] = elements(&body.properties);
    let inertia = numbers(&[ixx, iyy, izz, ixy, ixz, iyz], " ");
    (
        "fullinertia: M11 M22 M33 M12 M13 M23 of the tensor about pos, along the body's axes; M12 = -integral(x y dm)",
        format!(r#"fullinertia="{inertia}""#),
    )
}

/// Returns a comment on the principal moments, and their attributes.
fn principal(body: &ExportBody) -> (&'static str, String) {
    let principal = body.properties.principal();
    // Quaternion R_body_principal.
    let quaternion = numbers(&principal.rotation().canonical_quaternion(), " ");
    let moments = numbers(&principal.moments(), " ");
    (
        "diaginertia: principal moments about pos; quat: w x y z, turns principal components into the body's",
        format!(r#"quat="{quaternion}" diaginertia="{moments}""#),
    )
}
