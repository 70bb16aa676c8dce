//! SDFormat 1.7: a model with one link for each body.
//!
//! Products are −∫xy dm, according to the description of `ixy` in the specification. The pose is
//! relative to the link, at the centre of mass.

use polhode_document::VERSION;

use super::xml::{attribute, check_names, model, warning};
use super::{ExportBody, ExportError, ExportFormat, elements, number, numbers};

/// Returns the whole file.
pub(crate) fn write(bodies: &[ExportBody]) -> Result<String, ExportError> {
    let format = ExportFormat::Sdf;
    check_names(format, bodies)?;
    for ExportBody { name, .. } in bodies {
        if name == "world" || name.contains("::") || (name.starts_with("__") && name.ends_with("__")) {
            let rule = "SDFormat reserves world, __names__ like this and ::";
            return Err(ExportError::Name { format, name: name.clone(), rule });
        }
    }
    let model = model(bodies);
    let links: String = bodies.iter().map(link).collect();
    Ok(format!(
        r#"<?xml version="1.0"?>
<!-- polhode {VERSION}: mass properties as SDFormat links, in kg, m, kg m^2 -->
<sdf version="1.7">
  <model name="{model}">
{links}  </model>
</sdf>
"#
    ))
}

fn link(body: &ExportBody) -> String {
    let properties = &body.properties;
    let name = attribute(&body.name);
    let mass = number(properties.mass());
    let center = numbers(&properties.center_of_mass().to_array(), " ");
    let [ixx, ixy, ixz, iyy, iyz, izz] = elements(properties).map(number);
    let warning = warning("        ", body);
    format!(
        r#"    <link name="{name}">
      <inertial>
        <!-- centre of mass from the link's origin; no turn: the inertia is along the link's axes -->
        <pose>{center} 0 0 0</pose>
        <mass>{mass}</mass>
        <!-- tensor about the centre of mass; products are negative integrals: ixy = -integral(x y dm) -->
{warning}        <inertia>
          <ixx>{ixx}</ixx>
          <ixy>{ixy}</ixy>
          <ixz>{ixz}</ixz>
          <iyy>{iyy}</iyy>
          <iyz>{iyz}</iyz>
          <izz>{izz}</izz>
        </inertia>
      </inertial>
    </link>
"#
    )
}
