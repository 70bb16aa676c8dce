//! The page: its text in `page.md`, with the numbers inserted.

use crate::accuracy::Measured;
use crate::accuracy::distant::DISTANT;
use crate::accuracy::elliptic::{FUNCTIONS, Function};
use crate::accuracy::free_motion::{self, Worst};
use crate::accuracy::meshes;
use crate::accuracy::principal_axes;

/// Text of the page without its numbers.
const PAGE: &str = include_str!("page.md");

/// Returns the page with its numbers.
pub(crate) fn page(measured: &Measured) -> String {
    let Measured { groups, distant, functions, meshes, axes } = measured;
    let mut far = String::new();
    let errors = DISTANT.iter().zip(distant).filter(|(_, error)| **error > free_motion::PROMISED);
    for (case, error) in errors {
        far += &row([case.what.into(), case.periods.into(), up(*error)]);
    }
    let mut elliptic = String::new();
    for (name, function) in FUNCTIONS.iter().zip(functions) {
        let Function { values, nearest, ulps } = function;
        elliptic +=
            &row([(*name).into(), values.to_string(), (values - nearest).to_string(), ulps.to_string()]);
    }
    let [early, .., late] = free_motion::SPANS;
    let (cases, rows): (usize, usize) =
        groups.iter().fold((0, 0), |(c, r), w| (c + w.cases, r + w.rows.iter().sum::<usize>()));
    PAGE.replace("{cases}", &cases.to_string())
        .replace("{rows}", &rows.to_string())
        .replace("{spans}", &[early.0, late.0].join(" | "))
        .replace("{bodies}", &bodies(groups))
        .replace("{distant}", &distant.len().to_string())
        .replace("{far}", &far)
        .replace("{elliptic}", &elliptic)
        .replace("{meshes}", &mesh_rows(meshes))
        .replace("{mesh_bound}", &bound(meshes::PROMISED))
        .replace("{tensors}", &principal_axes::TENSORS.to_string())
        .replace("{axes_bound}", &bound(principal_axes::PROMISED))
        .replace("{axes}", &axes_rows(axes))
}

fn mesh_rows(meshes: &[meshes::Row]) -> String {
    let line = |mesh: &meshes::Row| {
        let error = mesh.errors.into_iter().flatten().fold(0.0, f64::max);
        row([mesh.triangles.to_string(), mesh.meshes.to_string(), up(error)])
    };
    meshes.iter().map(line).collect()
}

fn axes_rows(axes: &[principal_axes::Worst]) -> String {
    let line = |((name, _), worst): (&principal_axes::Group, &principal_axes::Worst)| {
        row([(*name).to_owned(), up(worst.rebuilt), up(worst.orthonormal)])
    };
    principal_axes::GROUPS.iter().zip(axes).map(line).collect()
}

fn bound(promised: f64) -> String {
    format!("{promised:e}")
}

/// Formats with two significant digits, rounded up; a number below double precision is given as a
/// bound.
pub(crate) fn up(x: f64) -> String {
    if x < 1e-17 {
        return "< 1e-17".into();
    }
    let mut exponent = x.log10().floor() as i32;
    let mut digits = (x / 10f64.powi(exponent - 1)).ceil();
    if digits >= 100.0 {
        (digits, exponent) = (10.0, exponent + 1);
    }
    format!("{:.1}e{exponent}", digits / 10.0)
}

fn row(cells: impl IntoIterator<Item = String>) -> String {
    format!("| {} |\n", cells.into_iter().collect::<Vec<_>>().join(" | "))
}

/// Returns rows of group, bodies, number of cases, errors of the attitude in the first and last
/// span, and largest errors of ω in all and of the constants.
fn bodies(groups: &[Worst]) -> String {
    let line = |((name, bodies), worst): (&(&str, &str), &Worst)| {
        let [early, .., late] = worst.attitude;
        let omega = worst.omega.into_iter().fold(0.0, f64::max);
        let head = [(*name).to_owned(), (*bodies).to_owned(), worst.cases.to_string()];
        let constants = worst.constants.into_iter().flatten().reduce(f64::max);
        row(head.into_iter().chain([early, late, omega].map(up)).chain([constants.map_or("–".into(), up)]))
    };
    free_motion::GROUPS.iter().zip(groups).map(line).collect()
}

#[test]
fn errors_are_rounded_up_to_two_digits() {
    let texts = [1.01e-16, 9.91e-16, 2.45e-9, 1.0, 2e-304].map(up);
    assert_eq!(texts, ["1.1e-16", "1.0e-15", "2.5e-9", "1.0e0", "< 1e-17"]);
}
