//! SDFormat 1.7: a model with a link for each body.
//!
//! The convention of products is −∫xy dm (the description of `ixy` in SDFormat's own specification); the pose is relative
//! to the link, at the centre of mass.

use super::xml::{attribute, check_names, comment};
use super::{ExportBody, ExportError, ExportFormat, elements, number, numbers, warning};
use crate::VERSION;

/// The names of the six elements, in the order of [`elements`].
const ELEMENTS: [&str; 6] = ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"];

/// The whole file.
pub(super) fn write(bodies: &[ExportBody]) -> Result<String, ExportError> {
    let format = ExportFormat::Sdf;
    check_names(format, bodies)?;
    for ExportBody { name, .. } in bodies {
        let reserved =
            name == "world" || name.contains("::") || (name.starts_with("__") && name.ends_with("__"));
        if reserved {
            let rule = "SDFormat keeps world, __names__ like this and :: for itself";
            return Err(ExportError::Name { format, name: name.clone(), rule });
        }
    }
    let model = match bodies {
        [body] => attribute(&body.name),
        _ => "bodies".to_owned(),
    };
    Ok("<?xml version=\"1.0\"?>\n".to_owned()
        + &comment("", &format!("polhode {VERSION}: mass properties as SDFormat links, in kg, m, kg m^2"))
        + &format!("<sdf version=\"1.7\">\n  <model name=\"{model}\">\n")
        + &bodies.iter().map(link).collect::<String>()
        + "  </model>\n</sdf>\n")
}

fn link(body: &ExportBody) -> String {
    let properties = &body.properties;
    let center = numbers(&properties.center_of_mass().to_array(), " ");
    let elements = ELEMENTS.iter().zip(elements(properties));
    let elements: String =
        elements.map(|(tag, x)| format!("          <{tag}>{}</{tag}>\n", number(x))).collect();
    format!("    <link name=\"{}\">\n      <inertial>\n", attribute(&body.name))
        + &comment(
            "        ",
            "centre of mass from the link's origin; no turn: the inertia is along the link's axes",
        )
        + &format!("        <pose>{center} 0 0 0</pose>\n")
        + &format!("        <mass>{}</mass>\n", number(properties.mass()))
        + &comment(
            "        ",
            "tensor about the centre of mass; products are negative integrals: ixy = -integral(x y dm)",
        )
        + &warning(properties).map(|text| comment("        ", text)).unwrap_or_default()
        + &format!("        <inertia>\n{elements}        </inertia>\n      </inertial>\n    </link>\n")
}
