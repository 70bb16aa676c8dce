//! Declarations that are not used. They have no effect, so they are probably mistakes.

use std::collections::HashSet;

use polhode_source::{FormatError, FormatErrorKind};

use super::NamedBudget;
use super::heading::{Columns, plain};
use super::key::{CAD, FILE};
use super::plan::Plan;

/// Refuses names of `ignore` that are neither columns nor sheets.
pub(crate) fn ignored(columns: &Columns, plan: &Plan, sheets: &[&str]) -> Result<(), FormatError> {
    let is_known = |name: &str| {
        sheets.contains(&name) || columns.ignored.values().any(|heading| plain(heading) == plain(name))
    };
    match plan.ignore.iter().zip(&plan.places.ignore).find(|(name, _)| !is_known(name)) {
        Some((name, place)) => {
            Err(unused(place, "ignore", name, "the heading of a column, or the name of a sheet"))
        }
        None => Ok(()),
    }
}

/// Refuses groups that no row refers to, and `[cad]` without reports.
pub(crate) fn declared(
    columns: &Columns,
    plan: &Plan,
    configurations: &[NamedBudget],
) -> Result<(), FormatError> {
    let of_rows: HashSet<&str> = configurations
        .iter()
        .map(|one| one.budget.rows())
        .flat_map(|rows| (0..rows.len()).filter_map(move |k| rows.group(k)))
        .chain(plan.tanks.iter().filter_map(|tank| tank.group.as_deref()))
        .collect();
    let mut groups = plan.groups.iter().zip(&plan.places.groups);
    if let Some((group, place)) = groups.find(|(group, _)| !of_rows.contains(group.name.as_str())) {
        return Err(unused(place, "group", &group.name, "the group of a row, or of a tank"));
    }
    let has_reports = [CAD, FILE].iter().any(|key| columns.places.get(*key).is_some_and(Option::is_some));
    match &plan.places.cad {
        Some(place) if !has_reports => Err(unused(place, "cad", "[cad]", "given with a column cad or file")),
        _ => Ok(()),
    }
}

/// Returns an error at the place of another error.
fn unused(place: &FormatError, key: &str, value: &str, rule: &str) -> FormatError {
    let (key, value, rule) = (key.to_owned(), format!("{value:?}"), rule.to_owned());
    place
        .clone()
        .replaced(FormatErrorKind::Value { key, value, rule })
        .with_hint("it has no effect: delete it, or check its name")
}
