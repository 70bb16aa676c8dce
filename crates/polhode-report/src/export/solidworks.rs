//! Text in the layout of a SolidWorks mass-properties report, in SI units.
//!
//! SolidWorks shows products in "positive tensor notation" unless it is told otherwise, Lxy = +∫xy dm, and says so in the
//! line above them; so does this. The report has two tensors: with the mass and the centre they prove the sign by the
//! parallel-axis theorem, Ixy = Lxy + M x y.

use polhode::Position;

use super::{ExportBody, ExportError, ExportFormat, number, numbers};
use crate::VERSION;
use crate::layout::printable;

/// The line above moments.
const MOMENTS: &str = "Moments of inertia: ( kilograms * square meters )";
/// SolidWorks' words.
const NOTATION: &str = "(Using positive tensor notation.)";

/// One report after the other.
pub(super) fn write(bodies: &[ExportBody]) -> Result<String, ExportError> {
    let mut text = format!(
        "polhode {VERSION}: mass properties in the layout of SolidWorks, SI units, along the body's own axes.\n\
         Positive tensor notation: Lxy = +integral(x y dm), the opposite of the inertia tensor's element.\n"
    );
    for body in bodies {
        text += &report(body)?;
    }
    Ok(text)
}

fn report(body: &ExportBody) -> Result<String, ExportError> {
    let properties = &body.properties;
    let [x, y, z] = properties.center_of_mass().to_array().map(number);
    let center = properties.inertia().matrix();
    let origin = properties.inertia_about(Position::ZERO).matrix();
    if let Some(&value) = origin.iter().flatten().find(|x| !x.is_finite()) {
        let (body, what) = (body.name.clone(), "an element of the tensor about the origin");
        let rule = "it has to be finite";
        return Err(ExportError::Range { format: ExportFormat::SolidWorks, body, what, value, rule });
    }
    let known = |label: &str, value: Option<f64>, unit: &str| match value {
        Some(x) if x.is_finite() => format!("{label} = {} {unit}\n\n", number(x)),
        _ => String::new(),
    };
    Ok(format!("\nMass properties of {}\n     Coordinate system: -- default --\n\n", printable(&body.name))
        + &known("Density", body.density, "kilograms per cubic meter")
        + &known("Mass", Some(properties.mass()), "kilograms")
        + &known("Volume", body.volume, "cubic meters")
        + &known("Surface area", body.surface_area, "square meters")
        + &format!("Center of mass: ( meters )\n\tX = {x}\n\tY = {y}\n\tZ = {z}\n\n")
        + "Principal axes of inertia and principal moments of inertia: ( kilograms * square meters )\n"
        + "Taken at the center of mass.\n"
        + &principal(body)
        + &format!(
            "\n{MOMENTS}\nTaken at the center of mass and aligned with the output coordinate system. {NOTATION}\n"
        )
        + &tensor('L', center)
        + &format!("\n{MOMENTS}\nTaken at the output coordinate system. {NOTATION}\n")
        + &tensor('I', origin))
}

/// The axes as unit vectors, and the moments, ascending.
fn principal(body: &ExportBody) -> String {
    let principal = body.properties.principal();
    let rows = ["x", "y", "z"].into_iter().zip(principal.axes()).zip(principal.moments());
    let row = |((label, axis), moment): ((&str, polhode::Direction<polhode::Body>), f64)| {
        let axis = numbers(&axis.to_array(), ",  ");
        format!("\t I{label} = ({axis})   \tP{label} = {}\n", number(moment))
    };
    rows.map(row).collect()
}

/// Three rows, with the products positive integrals.
fn tensor(letter: char, rows: [[f64; 3]; 3]) -> String {
    let names = ["x", "y", "z"];
    let cell = |i: usize, j: usize| {
        let element = if i == j { rows[i][j] } else { -rows[i][j] };
        format!("\t{letter}{}{} = {}", names[i], names[j], number(element))
    };
    (0..3).map(|i| (0..3).map(|j| cell(i, j)).collect::<String>() + "\n").collect()
}
