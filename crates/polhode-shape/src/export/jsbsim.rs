//! JSBSim: the `<mass_balance>` of an aircraft.
//!
//! Positions are in the structural frame: x aft, y right, z up. `ixx` … `iyz` are elements of the
//! tensor about the centre of mass in the axes of this frame. The body frame has x forward and z
//! down; it results from a rotation by 180° about y. JSBSim transfers ixy and iyz with the opposite
//! sign and ixz unchanged (FGMassBalance.cpp), if `negated_crossproduct_inertia` is `true` or
//! missing. If it is `false`, JSBSim 1.3.3 interprets them as positive integrals.

use polhode_document::VERSION;

use super::xml::{attribute, check_names, warning};
use super::{ExportBody, ExportError, ExportFormat, elements, number};

/// Kilograms per avoirdupois pound: 0.453 592 37 kg.
const POUND: f64 = 0.453_592_37;

/// Inch, m.
const INCH: f64 = 0.0254;

/// Unit slug·ft², kg·m². A slug is a pound-force (g₀ = 9.806 65 m/s²) per ft/s², 14.593 902 937 206
/// kg; a square foot is 0.3048² m².
const SLUG_FT2: f64 = POUND * 9.806_65 * 0.3048;

/// Returns the whole file.
pub(crate) fn write(bodies: &[ExportBody]) -> Result<String, ExportError> {
    let format = ExportFormat::JsbSim;
    let [body] = bodies else { return Err(ExportError::Several { format, bodies: bodies.len() }) };
    check_names(format, bodies)?;
    let properties = &body.properties;
    let name = attribute(&body.name);
    let [ixx, ixy, ixz, iyy, iyz, izz] = elements(properties).map(|element| number(element / SLUG_FT2));
    let weight = number(properties.mass() / POUND);
    let [x, y, z] = properties.center_of_mass().to_array().map(|x| number(x / INCH));
    let warning = warning("  ", body);
    Ok(format!(
        r#"<?xml version="1.0"?>
<!-- polhode {VERSION}: mass properties for JSBSim, in lb, in, slug ft^2 -->
<!-- the body's axes are taken as the structural frame: x towards the tail, y to the right, z up -->
<mass_balance name="{name}" negated_crossproduct_inertia="true">
  <!-- tensor about the centre of mass along the structural frame; products are negative integrals: ixy = -integral(x y dm) -->
{warning}  <ixx unit="SLUG*FT2">{ixx}</ixx>
  <iyy unit="SLUG*FT2">{iyy}</iyy>
  <izz unit="SLUG*FT2">{izz}</izz>
  <ixy unit="SLUG*FT2">{ixy}</ixy>
  <ixz unit="SLUG*FT2">{ixz}</ixz>
  <iyz unit="SLUG*FT2">{iyz}</iyz>
  <emptywt unit="LBS">{weight}</emptywt>
  <!-- centre of mass from the origin of the structural frame -->
  <location name="CG" unit="IN">
    <x>{x}</x>
    <y>{y}</y>
    <z>{z}</z>
  </location>
</mass_balance>
"#
    ))
}
