//! URDF: a robot with one link.
//!
//! URDF uses the negative convention of products: `ixy` is the tensor element −∫xy dm
//! (wiki.ros.org/urdf/XML/link).

use polhode_document::VERSION;

use super::xml::{attribute, check_names, warning};
use super::{ExportBody, ExportError, ExportFormat, elements, number, numbers};

/// Returns the whole file.
pub(crate) fn write(bodies: &[ExportBody]) -> Result<String, ExportError> {
    let format = ExportFormat::Urdf;
    let [body] = bodies else { return Err(ExportError::Several { format, bodies: bodies.len() }) };
    check_names(format, bodies)?;
    let properties = &body.properties;
    let name = attribute(&body.name);
    let mass = number(properties.mass());
    let center = numbers(&properties.center_of_mass().to_array(), " ");
    let [ixx, ixy, ixz, iyy, iyz, izz] = elements(properties).map(number);
    let warning = warning("      ", body);
    Ok(format!(
        r#"<?xml version="1.0"?>
<!-- polhode {VERSION}: mass properties of one body as a URDF link, in kg, m, kg m^2 -->
<robot name="{name}">
  <link name="{name}">
    <inertial>
      <!-- centre of mass from the link's origin; rpy 0: the inertia is along the link's axes -->
      <origin xyz="{center}" rpy="0 0 0"/>
      <mass value="{mass}"/>
      <!-- tensor about the centre of mass; products are negative integrals: ixy = -integral(x y dm) -->
{warning}      <inertia ixx="{ixx}" ixy="{ixy}" ixz="{ixz}" iyy="{iyy}" iyz="{iyz}" izz="{izz}"/>
    </inertial>
  </link>
</robot>
"#
    ))
}
