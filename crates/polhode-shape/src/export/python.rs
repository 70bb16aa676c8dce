//! RocketPy and Basilisk: arguments of their classes, as Python code.

use polhode_document::VERSION;

use super::xml::check_names;
use super::{ExportBody, ExportError, ExportFormat, elements, number, numbers};

/// Returns the only body, and the comment with its name in ASCII.
fn one(format: ExportFormat, bodies: &[ExportBody]) -> Result<(&ExportBody, String), ExportError> {
    let [body] = bodies else { return Err(ExportError::Several { format, bodies: bodies.len() }) };
    check_names(format, bodies)?;
    let name: String = body.name.chars().flat_map(char::escape_default).collect();
    let remark = body.remark().map(|remark| format!("# {remark}\n")).unwrap_or_default();
    Ok((body, format!("{name}\n{remark}")))
}

/// Returns the arguments of `rocketpy.Rocket` without a motor.
///
/// The tensor is about the centre of mass, with the third axis along the rocket. I_12 is an element
/// of the tensor, according to RocketPy's documentation and the parallel-axis theorem in its
/// `tools`. The coordinate along the axis is positive towards the nose, as with `tail_to_nose`.
pub(crate) fn rocketpy(bodies: &[ExportBody]) -> Result<String, ExportError> {
    let (body, name) = one(ExportFormat::RocketPy, bodies)?;
    let properties = &body.properties;
    let [i11, i12, i13, i22, i23, i33] = elements(properties);
    let inertia = numbers(&[i11, i22, i33, i12, i13, i23], ", ");
    let mass = number(properties.mass());
    let [x, y, z] = properties.center_of_mass().to_array().map(number);
    Ok(format!(
        r#"# polhode {VERSION}: mass properties for rocketpy.Rocket, without a motor, in kg, m, kg m^2: {name}# the body's z axis is the rocket's axis, towards the nose; x and y are its e_1 and e_2
mass = {mass}
# I_11, I_22, I_33, I_12, I_13, I_23 about the centre of mass; products are negative integrals: I_12 = -integral(x y dm)
inertia = ({inertia})
# coordinate of the centre of mass along the axis, from the body's origin
center_of_mass_without_motor = {z}
coordinate_system_orientation = "tail_to_nose"
# where the centre of mass is across the axis: Rocket.add_cm_eccentricity(*center_of_mass_eccentricity)
center_of_mass_eccentricity = ({x}, {y})
"#
    ))
}

/// Returns the hub of Basilisk's `spacecraft.Spacecraft()`.
///
/// `IHubPntBc_B` is the matrix of the tensor about the hub's centre of mass Bc in the frame B
/// (documentation of HubEffector). `r_BcB_B` is the vector from B's origin to Bc.
pub(crate) fn basilisk(bodies: &[ExportBody]) -> Result<String, ExportError> {
    let (body, name) = one(ExportFormat::Basilisk, bodies)?;
    let properties = &body.properties;
    let mass = number(properties.mass());
    let center = numbers(&properties.center_of_mass().to_array(), "], [");
    let [first, second, third] = properties.inertia().matrix().map(|row| numbers(&row, ", "));
    Ok(format!(
        r#"# polhode {VERSION}: mass properties for the hub of a Basilisk spacecraft, in kg, m, kg m^2: {name}# the body's axes and origin are those of the hub's frame B
def set_hub(spacecraft):
    spacecraft.hub.mHub = {mass}
    # from the origin of B to the centre of mass Bc, in B
    spacecraft.hub.r_BcB_B = [[{center}]]
    # tensor about Bc in B; products are negative integrals: I[0][1] = -integral(x y dm)
    spacecraft.hub.IHubPntBc_B = [[{first}], [{second}], [{third}]]
"#
    ))
}
