//! URDF: a robot of one link.
//!
//! URDF assumes the negative convention of products: `ixy` is the tensor's element −∫xy dm (wiki.ros.org/urdf/XML/link).

use super::xml::{attribute, check_names, comment};
use super::{ExportBody, ExportError, ExportFormat, elements, number, numbers, warning};
use crate::VERSION;

/// The whole file.
pub(super) fn write(bodies: &[ExportBody]) -> Result<String, ExportError> {
    let format = ExportFormat::Urdf;
    let [body] = bodies else { return Err(ExportError::Several { format, bodies: bodies.len() }) };
    check_names(format, bodies)?;
    let name = attribute(&body.name);
    Ok("<?xml version=\"1.0\"?>\n".to_owned()
        + &comment(
            "",
            &format!("polhode {VERSION}: mass properties of one body as a URDF link, in kg, m, kg m^2"),
        )
        + &format!("<robot name=\"{name}\">\n  <link name=\"{name}\">\n")
        + &inertial(body)
        + "  </link>\n</robot>\n")
}

fn inertial(body: &ExportBody) -> String {
    let properties = &body.properties;
    let center = numbers(&properties.center_of_mass().to_array(), " ");
    let mass = number(properties.mass());
    let [ixx, ixy, ixz, iyy, iyz, izz] = elements(properties).map(number);
    let warning = warning(properties).map(|text| comment("      ", text)).unwrap_or_default();
    "    <inertial>\n".to_owned()
        + &comment(
            "      ",
            "centre of mass from the link's origin; rpy 0: the inertia is along the link's axes",
        )
        + &format!("      <origin xyz=\"{center}\" rpy=\"0 0 0\"/>\n")
        + &format!("      <mass value=\"{mass}\"/>\n")
        + &comment(
            "      ",
            "tensor about the centre of mass; products are negative integrals: ixy = -integral(x y dm)",
        )
        + &warning
        + &format!(
            "      <inertia ixx=\"{ixx}\" ixy=\"{ixy}\" ixz=\"{ixz}\" iyy=\"{iyy}\" iyz=\"{iyz}\" izz=\"{izz}\"/>\n"
        )
        + "    </inertial>\n"
}
