//! Text in the layout of a SolidWorks mass-properties report, in SI units.
//!
//! SolidWorks by default prints products in "positive tensor notation", Lxy = +∫xy dm, and states
//! this in the line above them. This module does the same. The report has two tensors. With mass
//! and centre they prove the sign by the parallel-axis theorem, Ixy = Lxy + M x y.

use polhode::math::Position;
use polhode_document::VERSION;
use polhode_document::layout::printable;

use super::{ExportBody, ExportError, ExportFormat, number, numbers};

/// Returns the reports of all bodies, one after the other.
pub(crate) fn write(bodies: &[ExportBody]) -> Result<String, ExportError> {
    let reports: Vec<String> = bodies.iter().map(report).collect::<Result<_, _>>()?;
    let reports = reports.join("\n");
    Ok(format!(
        "polhode {VERSION}: mass properties in the layout of SolidWorks, SI units, along the body's own axes.
Positive tensor notation: Lxy = +integral(x y dm), the opposite of the inertia tensor's element.

{reports}"
    ))
}

fn report(body: &ExportBody) -> Result<String, ExportError> {
    let properties = &body.properties;
    let about_origin = properties.inertia_about(Position::ZERO).matrix();
    if let Some(&value) = about_origin.iter().flatten().find(|x| !x.is_finite()) {
        let (body, what) = (body.name.clone(), "an element of the tensor about the origin");
        let rule = "it has to be finite";
        return Err(ExportError::Range { format: ExportFormat::SolidWorks, body, what, value, rule });
    }
    let known = |label: &str, value: Option<f64>, unit: &str| match value {
        Some(x) if x.is_finite() => format!("{label} = {} {unit}\n\n", number(x)),
        _ => String::new(),
    };
    let name = printable(&body.name);
    let remark = body.remark().map(|text| format!("     Note: {text}\n")).unwrap_or_default();
    let density = known("Density", body.density, "kilograms per cubic meter");
    let mass = known("Mass", Some(properties.mass()), "kilograms");
    let volume = known("Volume", body.volume, "cubic meters");
    let area = known("Surface area", body.surface_area, "square meters");
    let [x, y, z] = properties.center_of_mass().to_array().map(number);
    let principal = principal(body);
    let central = tensor('L', properties.inertia().matrix());
    let about_origin = tensor('I', about_origin);
    Ok(format!(
        "Mass properties of {name}
     Coordinate system: -- default --
{remark}
{density}{mass}{volume}{area}Center of mass: ( meters )
\tX = {x}
\tY = {y}
\tZ = {z}

Principal axes of inertia and principal moments of inertia: ( kilograms * square meters )
Taken at the center of mass.
{principal}
Moments of inertia: ( kilograms * square meters )
Taken at the center of mass and aligned with the output coordinate system. (Using positive tensor notation.)
{central}
Moments of inertia: ( kilograms * square meters )
Taken at the output coordinate system. (Using positive tensor notation.)
{about_origin}"
    ))
}

/// Returns the principal axes as unit vectors, and the moments in ascending order.
fn principal(body: &ExportBody) -> String {
    let principal = body.properties.principal();
    let rows = ["x", "y", "z"].into_iter().zip(principal.axes()).zip(principal.moments());
    let row = |((label, axis), moment): ((&str, polhode::math::Direction<polhode::math::Body>), f64)| {
        let axis = numbers(&axis.to_array(), ",  ");
        format!("\t I{label} = ({axis})   \tP{label} = {}\n", number(moment))
    };
    rows.map(row).collect()
}

/// Returns three rows, with the products as positive integrals.
fn tensor(letter: char, rows: [[f64; 3]; 3]) -> String {
    let names = ["x", "y", "z"];
    let cell = |i: usize, j: usize| {
        let element = if i == j { rows[i][j] } else { -rows[i][j] };
        format!("\t{letter}{}{} = {}", names[i], names[j], number(element))
    };
    (0..3).map(|i| (0..3).map(|j| cell(i, j)).collect::<String>() + "\n").collect()
}
