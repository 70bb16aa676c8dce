//! CSV table: RFC 4180 with LF line ends, without comments.
//!
//! Separate columns state the meaning of the numbers, with the values of the JSON contract.

use polhode_document::csv_name;

use super::{ExportBody, elements, number};

/// Names of the columns, with their units.
const COLUMNS: &str = "name,mass_kg,center_of_mass_x_m,center_of_mass_y_m,center_of_mass_z_m,inertia_about,\
    inertia_axes,inertia_products,ixx_kg_m2,ixy_kg_m2,ixz_kg_m2,iyy_kg_m2,iyz_kg_m2,\
    izz_kg_m2,i1_kg_m2,i2_kg_m2,i3_kg_m2,principal_quaternion_w,principal_quaternion_x,\
    principal_quaternion_y,principal_quaternion_z,volume_m3,surface_area_m2,density_kg_m3";

/// Returns the whole table.
pub(crate) fn write(bodies: &[ExportBody]) -> String {
    // If a mesh was not used as a solid, the table has an additional column.
    let taken_as = bodies.iter().any(|body| body.taken_as.is_some()).then_some("mesh_taken_as");
    let columns: Vec<_> = [COLUMNS].into_iter().chain(taken_as).collect();
    let mut text = columns.join(",") + "\n";
    for body in bodies {
        let mut cells = row(body);
        cells.extend(taken_as.map(|_| body.taken_as.clone().unwrap_or_default()));
        text += &(cells.join(",") + "\n");
    }
    text
}

fn row(body: &ExportBody) -> Vec<String> {
    let properties = &body.properties;
    let principal = properties.principal();
    let known = |x: Option<f64>| x.filter(|x| x.is_finite()).map(number).unwrap_or_default();
    let mut cells = vec![csv_name(&body.name), number(properties.mass())];
    cells.extend(properties.center_of_mass().to_array().map(number));
    cells.extend(["center_of_mass", "body", "negative_integral"].map(str::to_owned));
    cells.extend(elements(properties).map(number));
    cells.extend(principal.moments().map(number));
    // Quaternion R_body_principal.
    cells.extend(principal.rotation().canonical_quaternion().map(number));
    cells.extend([body.volume, body.surface_area, body.density].map(known));
    cells
}
