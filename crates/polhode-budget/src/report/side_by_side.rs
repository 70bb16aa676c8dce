//! Table that compares configurations.

use polhode_document::Section;
use polhode_document::layout::printable;
use polhode_document::number::with_error;

use super::case::Case;
use super::numbers::{shown, ten, tidied};
use super::principal;
use super::whole::unit_of_length;
use crate::Basis;

pub(crate) fn section(cases: &[Case], basis: Basis) -> Section {
    let mut section = Section::new(1, "Configurations");
    let names: Vec<String> =
        cases.iter().map(|case| case.name.as_deref().map_or_else(String::new, printable)).collect();
    let mut headers = vec!["quantity"];
    headers.extend(names.iter().map(String::as_str));
    headers.push("unit");
    // All lengths have one unit: that of the configuration with the longest.
    let length = cases
        .iter()
        .map(|case| unit_of_length(case.estimate(basis)))
        .fold(("mm", 1e3), |all, one| if one.1 < all.1 { one } else { all });
    let mut rows: Vec<Vec<String>> = Vec::new();
    let mut row = |name: &str, unit: &str, cell: &dyn Fn(&Case) -> String| {
        let cells = cases.iter().map(cell);
        rows.push([name.to_owned()].into_iter().chain(cells).chain([unit.to_owned()]).collect());
    };
    for k in 0..10 {
        let (name, unit, scale) = shown(k, length);
        row(name, unit, &|case| {
            let estimate = case.estimate(basis);
            with_error(scale * tidied(ten(&estimate.properties))[k], scale * estimate.sd(k))
        });
    }
    for k in 0..3 {
        row(&format!("i{}", k + 1), "kg·m²", &|case| principal::moment(case, &case.principal(basis), k));
    }
    section.table(&headers, rows);
    section
}
